"""Reads what was written down before the first run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from copy import deepcopy
from importlib import resources
from importlib.util import find_spec
from typing import Any, NamedTuple

from ruamel.yaml import YAML

import tutorstudent as ts

FILE = resources.files("tutorstudent_controllers.regimes") / "registered.yml"
LEVELS = range(1, 9)


class Cell(NamedTuple):
    """One controller in one regime."""

    name: str
    goal: str
    """What a run's summary counts, more of it being better."""
    values: dict[str, Any]
    """A pipeline without a student."""
    levels: tuple[int, ...]
    """The constant levels that are tried."""


class Registered(NamedTuple):
    """A whole study."""

    cells: tuple[Cell, ...]
    seeds: tuple[int, ...]
    decisions: int
    budget: float
    within: float
    share: float
    blind_share: float


def read(study: str) -> Registered:
    """Return the study ``controllers`` or ``pioneer``.

    Raises:
        PipelineError: There is no such study, or prototype 2's example is not installed.
    """
    data = YAML(typ="safe").load(FILE.read_text(encoding="utf-8"))
    kinds = {"controllers": _list_controllers, "pioneer": _list_pioneer}
    if study not in kinds:
        raise ts.PipelineError(f"there is no study '{study}'. Studies: {', '.join(kinds)}.")
    own = data[study]
    seeds = tuple(range(data["first_seed"], data["first_seed"] + own["runs"]))
    numbers = (data[key] for key in ("decisions", "budget", "within", "share", "blind_share"))
    return Registered(tuple(kinds[study](own)), seeds, *numbers)


def _list_controllers(own: Mapping[str, Any]) -> Iterator[Cell]:
    for family, said in own["families"].items():
        for regime, changes in said["regimes"].items():
            values = change(said["values"], changes)
            yield Cell(f"{family} {regime}", said["goal"], values, tuple(LEVELS)[: _find_highest(values)])


def _list_pioneer(own: Mapping[str, Any]) -> Iterator[Cell]:
    setting = read_setting()
    for scene in own["scenes"]:
        for regime, changes in own["regimes"].items():
            values = deepcopy(dict(own["values"]))
            values["world"] |= setting["world"] | {"scene": scene}
            values["tutor"] |= setting["tutor"] | own["tutor"]
            yield Cell(f"{scene} {regime}", own["goal"], change(values, changes), tuple(own["levels"]))


def read_setting() -> dict[str, Any]:
    """Return the frozen free choices of world and tutor.

    Raises:
        PipelineError: Prototype 2's example is not installed.
    """
    if find_spec("tutorstudent_prototype2") is None:
        raise ts.PipelineError("the Pioneer's setting is in examples/prototype2: pip install -e examples/prototype2.")
    text = (resources.files("tutorstudent_prototype2") / "setting.yaml").read_text(encoding="utf-8")
    return dict(YAML(typ="safe").load(text))


def change(values: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return a pipeline with some values changed, named as in ``world.gain_k``.

    >>> change({"world": {"use": "plate"}}, {"world.gain_k": 20.0})
    {'world': {'use': 'plate', 'gain_k': 20.0}}
    """
    changed = deepcopy(dict(values))
    for key, value in changes.items():
        *path, last = key.split(".")
        place = changed
        for name in path:
            place = place[name]
        place[last] = value
    return changed


def _find_highest(values: Mapping[str, Any]) -> int:
    """Return the highest level that the factor allows: those beyond it are one and the same."""
    factor = values["limits"].get("factor")
    return len(LEVELS) if factor is None else round((factor - 1) / values["amplifier"]["amount"])
