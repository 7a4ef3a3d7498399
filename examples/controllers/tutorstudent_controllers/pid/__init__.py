"""simple-pid's PID on a thermal plate with dead time."""

from __future__ import annotations

import tutorstudent as ts
from tutorstudent_controllers.pid.parts import Approach, Overshoot, StepsDone
from tutorstudent_controllers.pid.plate import Plate
from tutorstudent_controllers.pid.tutor import SimplePid


@ts.hookimpl
def tutorstudent_components() -> list[type[ts.Component]]:
    """Return world, tutor, encoder, condition and observer."""
    return [Plate, SimplePid, Approach, Overshoot, StepsDone]
