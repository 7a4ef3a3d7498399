"""Installs the corridor and the plant as distributions, so that studies find them as anybody's, in workers too."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from joblib.externals.loky import get_reusable_executor

from tests.distributions import install
from tutorstudent.core.files.registry import Registry
from tutorstudent.study import Plan, Request, make_plan, read_pipelines

FULL = """\
decisions: 60
world: {use: corridor, scene: short}
tutor: shuttle
student: {use: table, encoder: metre, codec: kind-level-ampbit}
selector: same-kind
amplifier: {use: learning-phase, decisions: 20, amount: 0.2}
conditions: [at-wall]
observers: [turns]
"""
STREAMLINED = FULL.replace("kind-level-ampbit", "level-ampbit").replace("same-kind", "modifier")
ALONE = """\
decisions: 60
world: corridor
tutor: shuttle
student: silent
selector: modifier
amplifier: never
conditions: [at-wall]
observers: [turns]
"""


PLANT = """\
decisions: 60
world: kettle
tutor: keeper
student: eager
selector: timid
amplifier: {use: jump, change: rooted}
evaluator: strict
conditions: [too-hot]
observers: [warmed]
limits: {cap: 0.3, factor: 1.5, slew: 2}
on_tutor_failure: {value: 0.0}
"""


@pytest.fixture(scope="session")
def corridor_distribution(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of installed distributions: the corridor's and the plant's."""
    place = tmp_path_factory.mktemp("site")
    for name in ("corridor", "plant"):
        source = Path(__file__).with_name(f"{name}.py").read_text(encoding="utf-8")
        install(place, f"{name}-plugin", source, version="0.1", point=name)
    return place


@pytest.fixture
def registry(corridor_distribution: Path, monkeypatch: pytest.MonkeyPatch) -> Registry:
    monkeypatch.syspath_prepend(str(corridor_distribution))
    return Registry.discover()


@pytest.fixture
def fresh_workers() -> Iterator[None]:
    """Worker processes inherit the path of the moment at which they begin."""
    get_reusable_executor().shutdown(wait=True)
    yield
    get_reusable_executor().shutdown(wait=True)


@pytest.fixture
def files(tmp_path: Path) -> dict[str, Path]:
    """Pipeline files by name."""
    folder = tmp_path / "pipelines"
    folder.mkdir()
    texts = {"full": FULL, "streamlined": STREAMLINED, "alone": ALONE, "plant": PLANT}
    for name, text in texts.items():
        (folder / f"{name}.yaml").write_text(text)
    return {name: folder / f"{name}.yaml" for name in texts}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Of a study, or of several."""
    made = tmp_path / "folder"
    made.mkdir()
    return made


@pytest.fixture
def planned(files: dict[str, Path], registry: Registry) -> Callable[..., Plan]:
    """Makes the plan of a small study of some of the files, with a search."""

    def plan(*names: str, **request: Any) -> Plan:
        given = read_pipelines([files[name] for name in names or ("full",)], registry)
        return make_plan(Request(given, **({"runs": 2, "decisions": 20, "search_runs": 1} | request)), registry)

    return plan


def results(folder: Path) -> dict[str, bytes]:
    """Return every file of a study that is no timing and no report, by its path."""
    paths = [
        path
        for name in ("plan.json", "results.csv", "runs", "search", "sketches")
        for path in [folder / name, *(folder / name).rglob("*")]
    ]
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in paths
        if path.is_file() and path.name != "timing.json"
    }
