"""What the world's options say is true."""

from __future__ import annotations

from pathlib import Path

import tutorstudent.sims.pioneer
from tutorstudent.sims.pioneer.world_options import PioneerOptions

SCENES = Path(tutorstudent.sims.pioneer.__file__).parent / "scenes"


def test_the_option_names_every_shipped_scene() -> None:
    said = PioneerOptions.model_fields["scene"].description or ""
    assert {path.stem for path in SCENES.glob("*.yaml")} == set(said.partition(", or ")[0].split(", "))
