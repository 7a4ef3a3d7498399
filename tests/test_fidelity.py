"""The page of free choices says what the frozen setting and the defaults really are; so does the reproduction."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

from tutorstudent.plugins.prototype2.tutor import Prototype2
from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld
from tutorstudent_prototype2.calibration.choices import CHOICES
from tutorstudent_prototype2.calibration.command import LOOKS, PREDICTIONS
from tutorstudent_prototype2.calibration.dependence import correlations, learner_cases, tutor_cases
from tutorstudent_prototype2.calibration.predictive import load_predictions
from tutorstudent_prototype2.calibration.walks import load_looks
from tutorstudent_prototype2.pipelines import read_frozen_setting

DOCS = Path(__file__).parents[1] / "docs"
sys.path.append(str(DOCS))

import blocks  # noqa: E402 - stands beside the pages

PAGE = (DOCS / "fidelity.md").read_text(encoding="utf-8")
ROW = re.compile(r"^\| `([\w.]+)`(?:, `(\w+)`)? \| ([^|]+) \| ([^|]+) \|", flags=re.MULTILINE)


DEPENDENCE = re.compile(r"^\| `([\w.]+)`.* \| ([^|]+) \|$", flags=re.MULTILINE)
SHORT = {"cave-box": "CB", "cave-predator-prey": "CPP", "cave-predator-prey-box": "CPPB", "chase-avoid": "CA"}
SEARCHED_AS = {"tutor.clear_m": "tutor.free_beyond_front_m", "world.sensor_latency": "world.latency_ticks"}


def frozen_section() -> str:
    return PAGE.partition("## The free choices of chapter 4, frozen")[2].partition("\n## ")[0]


def printed() -> dict[str, tuple[str, str]]:
    """Return frozen and default value of every choice of the page, as printed."""
    found = {}
    for name, second, frozen, default in ROW.findall(frozen_section()):
        found[name] = frozen.strip(), default.strip()
        if second:
            found[f"{name.partition('.')[0]}.{second}"] = found[name]
    return found


def flat(values: dict[str, Any], above: str) -> dict[str, Any]:
    """Return the leaves of a setting by the names of the page."""
    leaves: dict[str, Any] = {}
    for key, value in values.items():
        leaves |= flat(value, key) if isinstance(value, dict) else {f"{above}.{key}": value}
    return leaves


def named(leaves: dict[str, Any]) -> dict[str, Any]:
    """Return them with the choice that prey and predators share under its own name."""
    prey, predator = leaves.pop("prey.front_m"), leaves.pop("predator.front_m")
    assert prey == predator
    return leaves | {"others.front_m": prey}


def test_every_frozen_choice_is_on_the_page_with_its_value() -> None:
    setting = read_frozen_setting()
    frozen = named(flat(dict(setting["world"]), "world") | flat(dict(setting["tutor"]), "tutor"))
    assert 6 == len(frozen.pop("world.box_places"))
    page = {name: values[0] for name, values in printed().items()}
    assert "six places" == page.pop("world.box_places")
    assert {name: f"{value:g}" if isinstance(value, int) else f"{value:.5g}" for name, value in frozen.items()} == page


def test_what_results_depend_on_is_what_the_calibration_shows() -> None:
    looks, predictions = load_looks(LOOKS), load_predictions(PREDICTIONS)
    tutor = {scene: correlations(tutor_cases(looks, scene), "attractors") for scene in SHORT}
    learner = {scene: correlations(learner_cases(looks, predictions, scene), "attractors") for scene in SHORT}
    there = {SEARCHED_AS.get(name, name): printed for name, printed in DEPENDENCE.findall(frozen_section())}
    assert 10 < len(there.keys() & set(CHOICES))
    for choice, printed_there in there.items():
        if choice in CHOICES:
            found = [
                f"{short} {learner[scene][choice]:+.2f} ({tutor[scene][choice]:+.2f})"
                for scene, short in SHORT.items()
                if max(abs(learner[scene][choice]), abs(tutor[scene][choice])) >= 0.3
            ]
            assert (", ".join(found) or "nothing that shows") == printed_there, choice


def test_every_default_beside_it_is_the_parts_own() -> None:
    world = PioneerWorld.Options().model_dump()
    defaults = named(flat(world, "world")) | flat(Prototype2.Options().model_dump(), "tutor")
    page = {name: values[1] for name, values in printed().items()}
    assert {name: f"{defaults[name]:g}" if defaults[name] else "as drawn" for name in page} == page


def test_what_the_reproduction_prints_of_the_calibration_is_what_is_stored() -> None:
    page = (DOCS / "reproduction.md").read_text(encoding="utf-8")
    assert blocks.renewed("reproduction.md") == page, "run python docs/blocks.py"
