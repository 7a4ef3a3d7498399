"""What can be measured of a run, and what comparisons make of it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal, get_args

from tutorstudent.core.words.errors import ContractError

Summary = Literal["sum", "max", "mean", "last"]
Better = Literal["more", "less"]


@dataclass(frozen=True)
class Measure:
    """A number that decisions have, and how a run sums it up.

    An observer declares what it measures (`Observer.measures`), a world what happens in it (`World.event_names`). In a
    comparison every measure has its column, its learning curve, its line in the legend and its differences to the tutor
    alone; where it says what is better, it is also tested, against the controls too.

    Raises:
        ContractError: if the name is empty, or `better` or `summed` is none of the words that are allowed.

    >>> Measure("energy_j", "energy", unit="J", better="less").heading
    'energy, J'
    """

    name: str
    """In summaries, files and options."""
    title: str = ""
    """In tables and pictures; the name where none is given."""
    unit: str = ""
    """Stands behind the title. ``%`` is for shares: numbers from 0 to 1, shown in percent."""
    better: Better | None = None
    """``more``: stands under what was found. ``less``: under what it cost. None: under what the parts did."""
    summed: Summary = "sum"
    """How the numbers of all decisions become the run's."""
    description: str = ""
    """What is counted, for the legend: a phrase without a full stop."""
    detail: bool = False
    """Whether the terminal's short table does without it."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "title", self.title or self.name)
        if not isinstance(self.name, str) or not self.name:
            raise ContractError(f"a measure has the name {self.name!r}; give a word, as in Measure('energy_j').")
        _check(self.name, "better", self.better, (*get_args(Better), None))
        _check(self.name, "summed", self.summed, get_args(Summary))

    @property
    def heading(self) -> str:
        """Title and unit."""
        return f"{self.title}, {self.unit}" if self.unit else self.title


def _check(name: str, key: str, value: object, allowed: tuple[object, ...]) -> None:
    if value not in allowed:
        words = ", ".join(map(repr, allowed))
        raise ContractError(f"measure '{name}': {key} is {value!r}; it is one of {words}.")


COMMON = {
    measure.name: measure
    for measure in (
        Measure(
            "collided",
            "collided decisions",
            better="less",
            description="decisions in which the learner's own motion was refused",
        ),
        Measure("contacts", better="less", description="how often a collision began"),
        Measure("distance_m", "distance", unit="m", description="way travelled"),
        Measure("time_s", "simulated time", unit="s", description="how long the decisions lasted", detail=True),
    )
}
"""Events that worlds have in common: what counts the same should have the same name, which is then all that it needs to
say. ``collided`` is the harm that comparisons judge by; rates refer to ``distance_m`` and ``time_s``; maps are drawn
from ``x_m``, ``y_m`` and ``heading_rad``, which are no measures."""


def as_measure(name: str, how: Summary | Measure) -> Measure:
    """Return what a world declares under a name: a measure, or only how it is summed.

    >>> as_measure("falls", "sum").better, as_measure("contacts", "sum").better
    (None, 'less')
    """
    if isinstance(how, Measure):
        return replace(how, name=name)
    return replace(COMMON.get(name, Measure(name)), summed=how)
