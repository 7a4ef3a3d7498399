"""The tree itself."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tutorstudent_controllers.tree.cockpit import Cockpit
from tutorstudent_controllers.tree.leaves import (
    Asks,
    BacksOff,
    Drives,
    Faces,
    Turns,
    TurnsFromBlue,
    TurnsFromRed,
    Wanders,
    sees_no_blue,
    sees_red,
)
from tutorstudent_controllers.tree.percept import Percept

MEETING = "Turn from red"


def plant(cockpit: Cockpit) -> Behaviour:
    """Return the tree: what comes first has its way; a sequence that runs goes on until something before it begins."""
    branches = [_unstick(cockpit), _meet(cockpit), _flee(cockpit), _avoid(cockpit), _seek(cockpit)]
    return Selector("Pilot", memory=False, children=[*branches, Wanders("Wander", cockpit)])


def _unstick(cockpit: Cockpit) -> Behaviour:
    options = cockpit.options
    return _steps(
        "Unstick",
        Asks("Stalled?", cockpit, lambda seen: seen.stalled),
        BacksOff("Back off", cockpit, options.back_off, _never),
        Turns("Swing round", cockpit, options.swing, _never),
    )


def _meet(cockpit: Cockpit) -> Behaviour:
    options = cockpit.options
    return _steps(
        "Meet",
        Asks("Red near?", cockpit, lambda seen: seen.red_m < options.met_m),
        TurnsFromRed(MEETING, cockpit, options.patience, lambda seen: not sees_red(seen)),
    )


def _flee(cockpit: Cockpit) -> Behaviour:
    options = cockpit.options
    return _steps(
        "Flee",
        Asks("Blue near?", cockpit, lambda seen: seen.blue_m < options.afraid_m),
        TurnsFromBlue("Turn from blue", cockpit, options.patience, sees_no_blue),
    )


def _avoid(cockpit: Cockpit) -> Behaviour:
    options = cockpit.options
    return _steps(
        "Avoid",
        Asks("Obstacle?", cockpit, lambda seen: seen.ahead_m < options.obstacle_m),
        Turns("Turn from obstacle", cockpit, options.patience, lambda seen: seen.ahead_m > options.clear_m),
        Drives("Pass", cockpit, options.passing, lambda seen: seen.ahead_m < options.obstacle_m),
    )


def _seek(cockpit: Cockpit) -> Behaviour:
    options = cockpit.options

    def facing(seen: Percept) -> bool:
        return abs(seen.red_rad) < options.facing_rad

    turn = Faces("Face", cockpit, options.patience, facing)
    drive = Drives("Approach", cockpit, options.patience, _never)
    return Sequence("Seek", memory=False, children=[Asks("Red seen?", cockpit, sees_red), turn, drive])


def _steps(name: str, *children: Behaviour) -> Behaviour:
    return Sequence(name, memory=True, children=list(children))


def _never(_seen: Percept) -> bool:
    return False
