"""The options of the process tutor."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.roles.part import Field, Options
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.roles.world import World
from tutorstudent.plugins.process.vocabulary import ActionOptions


class ProcessOptions(Options):
    """What to start, what it commands, and how long to wait for it."""

    program: list[str] = Field(
        min_length=1, description="program and arguments, as in [./controller, --gain, '2']; no shell reads them"
    )
    cwd: str | None = Field(None, description="folder to start it in; none: the working directory")
    env: dict[str, str] = Field({}, description="environment variables to set beside the inherited ones")

    action_of: Part[World[Any, Any]] | None = Field(None, description="a world, to command the actions of its class")
    action: ActionOptions | None = Field(None, description="the actions that it commands, written out")

    deadline_s: float = Field(1.0, gt=0, le=3600, description="longest time for a decision, whatever happens, s")
    start_timeout_s: float = Field(10.0, gt=0, le=3600, description="longest time until it says hello, s")
    close_timeout_s: float = Field(1.0, ge=0, le=60, description="time to end by itself, and again after SIGTERM, s")
    patience: int = Field(3, ge=1, le=1000, description="late decisions in a row after which it counts as hung")
    restarts: int = Field(0, ge=0, le=1_000_000, description="how often it is started again in all")
    backoff_s: float = Field(0.5, ge=0, le=60, description="wait before the first restart, doubled for each further, s")
    max_line_bytes: int = Field(1_000_000, ge=100, le=1_000_000_000, description="longest line that it may say, bytes")
