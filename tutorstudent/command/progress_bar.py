"""A progress bar over the decisions of a run."""

from __future__ import annotations

from types import TracebackType
from typing import Any, Self

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.observers import Begin, Observer
from tutorstudent.core.words.turn import Turn

EVERY = 100


class ProgressBar(Observer):
    """Shows how many decisions are done and how long the rest takes; on standard error, where that is a terminal."""

    name = "progress"

    def __init__(self, title: str) -> None:
        super().__init__()
        self._progress = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TimeRemainingColumn(),
            console=Console(stderr=True),
        )
        self._title = title

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        if self._progress.live.is_started:  # stopping a bar that never began prints an empty line
            self._progress.stop()

    def begin(self, begin: Begin) -> None:
        self._progress.start()
        self._task = self._progress.add_task(self._title, total=begin.decisions)
        self._done = 0

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        self._done += 1
        if self._done % EVERY == 0:
            self._progress.update(self._task, completed=self._done)
