"""What a run says about a learner that does nothing."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.watching import Notice, Watch
from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.observers import Begin, Observer
from tutorstudent.core.words.turn import Turn


class Noticer(Observer):
    """Watches a whole run; `notices` are what kept its learner from having any effect."""

    name = "noticer"

    def begin(self, begin: Begin) -> None:
        self._watch = Watch(begin.engine)

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        self._watch.observe(turn)

    def find_notices(self) -> tuple[Notice, ...]:
        """Return what can be told by now."""
        return tuple(self._watch.find_notices())
