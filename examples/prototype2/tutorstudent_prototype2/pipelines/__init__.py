"""The controllers of chapter 4 as pipelines, and the one setting of world and tutor that all of them share.

The YAML files beside this module name no number that the thesis leaves open. Those stand in ``setting.yaml``, one
setting for all environments, and `load` lays it over a pipeline; a calibration gives `load` settings of its own.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML

import tutorstudent as ts

Setting = Mapping[str, Mapping[str, Any]]
"""Options of ``world``, ``tutor`` and ``encoder``, each by name; what is left out keeps its default."""

FOLDER = Path(__file__).parent
NAMES = ("prototype2", "prototype2a", "prototype2a-5000", "prototype2a-7500", "streamlined", "budgeted")
"""The pipelines; ``prototype2a`` has the learning phase of 2500 decisions."""
ENVIRONMENTS = ("chase-avoid", "cave-box", "cave-predator-prey", "cave-predator-prey-box")
"""The scenes of Thesis 4.3.2 to 4.3.5."""
PARTS = {"world": "world", "tutor": "tutor", "encoder": "student.encoder"}
"""Where the options of each part of a setting stand in a pipeline."""
SHARED = ("front_m", "side_m", "clear_m", "prey_m", "predator_m")
"""Thresholds of the tutor that its encoder has too; the student sees what the tutor reacts to."""


def load(name: str, scene: str, setting: Setting | None = None) -> ts.Pipeline:
    """Return a controller in an environment, under a setting.

    Args:
        name: One of `NAMES`.
        scene: A shipped scene, or the path of a scene's file.
        setting: Free choices of world and tutor; None takes the frozen ones.

    Raises:
        PipelineError: There is no such pipeline, or the setting says something that no part takes.
    """
    if name not in NAMES:
        raise ts.PipelineError(f"there is no pipeline '{name}'. Pipelines: {', '.join(NAMES)}.")
    pipeline = _read(name)
    changes = {
        f"{PARTS[part]}.{key}": value
        for part, options in _complete(read_frozen_setting() if setting is None else setting).items()
        if part != "encoder" or _has_encoder(pipeline)
        for key, value in options.items()
    }
    return pipeline.replaced({**changes, "world.scene": scene})


def load_all(names: tuple[str, ...], scene: str, setting: Setting | None = None) -> dict[str, ts.Pipeline]:
    """Return several controllers by name, see `load`."""
    return {name: load(name, scene, setting) for name in names}


def read_frozen_setting() -> Setting:
    """Return the setting that all reports use."""
    return read_setting(FOLDER.parent / "setting.yaml")


def read_setting(path: Path) -> Setting:
    """Return the setting of a YAML file.

    Raises:
        PipelineError: It cannot be read, or says something else.
    """
    try:
        setting = YAML(typ="safe", pure=True).load(path.read_text(encoding="utf-8"))
    except Exception as error:  # of the operating system, or one of YAML's many
        raise ts.PipelineError(f"{path}: the setting cannot be read: {' '.join(str(error).split())}") from None
    if not isinstance(setting, dict) or not all(isinstance(options, dict) for options in setting.values()):
        raise ts.PipelineError(f"{path}: a setting is a mapping of {', '.join(PARTS)}, each a mapping of options.")
    return setting


def _complete(setting: Setting) -> dict[str, dict[str, Any]]:
    unknown = [part for part in setting if part not in PARTS]
    if unknown:
        raise ts.PipelineError(f"a setting has no part '{unknown[0]}'. Parts: {', '.join(PARTS)}.")
    world, tutor, encoder = (dict(setting.get(part, {})) for part in PARTS)
    shared = {key: tutor[key] for key in SHARED if key in tutor}
    for key in SHARED:
        if key in encoder and encoder[key] != shared.get(key):
            raise ts.PipelineError(
                f"setting: encoder.{key} is {encoder[key]}, but tutor.{key} is {shared.get(key, 'not given')}; the "
                "encoder has the tutor's thresholds. Leave it out of the encoder, or give both the same."
            )
    return {"world": world, "tutor": tutor, "encoder": shared | encoder}


def _has_encoder(pipeline: ts.Pipeline) -> bool:
    student = pipeline.document.data["student"]
    return isinstance(student, dict) and "encoder" in student


@cache
def _read(name: str) -> ts.Pipeline:
    return ts.Pipeline.read(FOLDER / f"{name}.yaml")
