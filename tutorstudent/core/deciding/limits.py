"""How far an action may be amplified, whatever the parts say."""

from __future__ import annotations

from pydantic import Field

from tutorstudent.core.roles.part import Options


class Limits(Options):
    """The owner's statement of how far amplification may go; enforced on every decision."""

    cap: float = Field(0.8, gt=0, description="largest change of a component, in units of its scale (0.8 = 8 levels)")
    factor: float | None = Field(None, ge=1, description="largest ratio of a component's magnitude to the tutor's own")
    slew: int | None = Field(
        None, ge=1, description="largest step of the level up or down; down at once where more moves nothing"
    )
