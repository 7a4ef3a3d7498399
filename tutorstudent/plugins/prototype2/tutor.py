"""Prototype 2: the tutor of the thesis's application (Thesis 3.3.1)."""

from __future__ import annotations

from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.plugins.prototype2.percept import perceive
from tutorstudent.plugins.prototype2.pilot import Pilot
from tutorstudent.plugins.prototype2.planner import StatePlanner
from tutorstudent.plugins.prototype2.planner_options import Tuning
from tutorstudent.plugins.prototype2.rules import RULES, SUBSUMPTION
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState


class Prototype2(Tutor[PioneerState, DriveAction]):
    """Wanders without hitting obstacles, seeks prey and turns from them when near, flees from predators.

    Its actions are one of four frozen objects: forward, backward, left or right at the tutor's own speed. Its situation
    is the state of its planner; each entry into ``Prey Spin`` is an attractor found (Thesis 4.2).
    """

    name = "prototype2"
    action = DriveAction
    Options = Tuning

    def setup(self) -> None:
        self._pilot = Pilot(self.options, self.rng)
        self._planner = StatePlanner(RULES, start=SUBSUMPTION)

    def reset(self) -> None:
        super().reset()
        self._pilot.forget()
        self._planner.reset()

    def act(self, state: PioneerState) -> DriveAction:
        self._pilot.look(perceive(state))
        action = self._planner.decide(self._pilot)
        self._pilot.remember(action)
        return action

    @property
    def situation(self) -> str:
        """The planner's state: Subsumption, Forward, Avoid Spin, Prey Spin or Predator Spin."""
        return self._planner.state

    @property
    def rule(self) -> str:
        """The rule that chose the last action; empty before the first."""
        return self._planner.rule
