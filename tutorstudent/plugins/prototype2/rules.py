"""The rule table of prototype 2 (Thesis 3.3.1), in order of priority. The thesis names the states and the types of
rules; the single rules are a choice, see docs/fidelity.md.
"""

from __future__ import annotations

from typing import Final

from tutorstudent.plugins.prototype2.pilot import Pilot
from tutorstudent.plugins.prototype2.planner import Rule, RuleTable
from tutorstudent.sims.pioneer.types import DriveAction

SUBSUMPTION: Final = "Subsumption"
FORWARD: Final = "Forward"
AVOID_SPIN: Final = "Avoid Spin"
PREY_SPIN: Final = "Prey Spin"
PREDATOR_SPIN: Final = "Predator Spin"

# name, condition, action (None: the next state decides at once), transition
RULES: Final[RuleTable[Pilot, DriveAction]] = {
    SUBSUMPTION: (
        Rule("avoid: recover from a stall", Pilot.is_refused, Pilot.recover, AVOID_SPIN),
        Rule("avoid: obstacle ahead", Pilot.obstacle_ahead, Pilot.spin_to_open_side, AVOID_SPIN),
        Rule("avoid: obstacle beside", Pilot.obstacle_beside, Pilot.spin_from_near_side, AVOID_SPIN),
        Rule("avoid: predator near", Pilot.predator_near, Pilot.spin_from_predator, PREDATOR_SPIN),
        Rule("flee: prey near", Pilot.prey_near, Pilot.spin_from_prey, PREY_SPIN),
        Rule("seek: prey to the left", Pilot.prey_left, Pilot.turn_left, SUBSUMPTION),
        Rule("seek: prey to the right", Pilot.prey_right, Pilot.turn_right, SUBSUMPTION),
        Rule("seek: prey ahead", Pilot.prey_ahead, Pilot.drive_forward, SUBSUMPTION),
        Rule("wander: little space ahead", Pilot.little_space_ahead, Pilot.spin_to_open_side, AVOID_SPIN),
        Rule("wander: turn on to an open area", Pilot.is_turning, Pilot.keep_turning, SUBSUMPTION),
        Rule("wander: turn to an open area", Pilot.is_restless, Pilot.turn_to_open_area, SUBSUMPTION),
        Rule("wander: forward", Pilot.always, Pilot.drive_forward, SUBSUMPTION),
    ),
    FORWARD: (
        Rule("recover from a stall", Pilot.is_refused, Pilot.recover, AVOID_SPIN),
        Rule("obstacle close", Pilot.is_too_close, None, SUBSUMPTION),
        Rule("predator near", Pilot.is_at_predator, None, SUBSUMPTION),
        Rule("arrived", Pilot.has_arrived, None, SUBSUMPTION),
        Rule("drive on", Pilot.always, Pilot.drive_on, FORWARD),
    ),
    AVOID_SPIN: (
        Rule("recover from a stall", Pilot.is_refused, Pilot.recover, AVOID_SPIN),
        Rule("keep recovering", Pilot.is_recovering, Pilot.keep_recovering, AVOID_SPIN),
        Rule("way is clear", Pilot.way_is_clear, Pilot.leave, FORWARD),
        Rule("spun enough", Pilot.has_spun_enough, Pilot.break_out, FORWARD),
        Rule("keep spinning", Pilot.always, Pilot.keep_spinning, AVOID_SPIN),
    ),
    PREY_SPIN: (
        Rule("recover from a stall", Pilot.is_refused, Pilot.recover, PREY_SPIN),
        Rule("keep recovering", Pilot.is_recovering, Pilot.keep_recovering, PREY_SPIN),
        Rule("prey lost", Pilot.prey_lost, Pilot.flee, FORWARD),
        Rule("spun enough", Pilot.has_spun_enough, Pilot.break_out, FORWARD),
        Rule("keep spinning", Pilot.always, Pilot.keep_spinning, PREY_SPIN),
    ),
    PREDATOR_SPIN: (
        Rule("recover from a stall", Pilot.is_refused, Pilot.recover, PREDATOR_SPIN),
        Rule("keep recovering", Pilot.is_recovering, Pilot.keep_recovering, PREDATOR_SPIN),
        Rule("predator lost", Pilot.predator_lost, Pilot.flee, FORWARD),
        Rule("spun enough", Pilot.has_spun_enough, Pilot.break_out, FORWARD),
        Rule("keep spinning", Pilot.always, Pilot.keep_spinning, PREDATOR_SPIN),
    ),
}
