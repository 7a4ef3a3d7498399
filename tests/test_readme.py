"""What the README shows is what the package does."""

from __future__ import annotations

import re
import types
from pathlib import Path

import pytest

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.sims.pioneer.types import DriveAction

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")
EXAMPLES = Path(__file__).parents[1] / "examples" / "prototype2" / "tutorstudent_prototype2" / "pipelines"


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", README, flags=re.DOTALL)


class Heater:
    def __init__(self) -> None:
        self.written: list[float] = []

    def write(self, command: float) -> None:
        self.written.append(command)
        if len(self.written) == 10:
            raise StopIteration


def test_the_first_program_runs_as_printed() -> None:
    heater = Heater()
    names = {"pid": lambda y: 0.5, "heater": heater, "sensor": types.SimpleNamespace(read=lambda: 20.0)}
    with pytest.raises(StopIteration):
        exec(blocks("python")[0], names)
    assert [0.5 * 1.1] * 10 == pytest.approx(heater.written)


def test_the_plugin_is_complete() -> None:
    names: dict[str, object] = {}
    exec(blocks("python")[1], names)
    registry = Registry.discover()
    (tutor,) = names["tutorstudent_components"]()  # type: ignore[operator]
    registry.add(tutor)
    text = "tutor: {use: wall-follower, clearance_m: 0.3}\nstudent: silent\nselector: modifier\nworld: pioneer\n"
    assert DriveAction is Pipeline(parse_yaml(text, "readme"), registry).engine().tutor.action


def test_the_pipeline_is_the_shipped_one() -> None:
    shipped = Pipeline.read(EXAMPLES / "prototype2a.yaml").document.data
    assert shipped == parse_yaml(blocks("yaml")[0], "readme").data


def test_the_page_is_short() -> None:
    assert len(README.splitlines()) <= 120


def test_every_cell_of_the_table_is_one_of_the_study() -> None:
    study = (Path(__file__).parents[1] / "docs" / "student.md").read_text(encoding="utf-8")
    cells = re.findall(r"[\d.]+ / [\d.]+", README)
    assert len(cells) >= 20
    assert [] == [cell for cell in cells if f"| {cell} |" not in study and f": {cell} |" not in study]


def test_the_first_screen_comes_before_the_thesis_words() -> None:
    first = README[: README.index("## Three promises")]
    assert not re.search(r"\b(tutor|student|ampbit|prototype)\b", first.replace("tutorstudent", ""))


def test_every_make_target_that_the_pages_name_exists() -> None:
    root = Path(__file__).parents[1]
    targets = set(re.findall(r"^([a-z-]+):", (root / "Makefile").read_text(), flags=re.MULTILINE))
    pages = [*root.glob("*.md"), *(root / "examples").rglob("README.md"), *(root / "docs").rglob("*.md")]
    text = "\n".join(page.read_text(encoding="utf-8") for page in pages)
    named = set(re.findall(r"(?:`|^)make ([a-z-]+)", text, flags=re.MULTILINE))  # a command, not a verb
    assert {"demo", "reproduce", "test"} <= named <= targets
