"""The package is what a third party would publish: a wheel with its data, and public names only."""

from __future__ import annotations

import ast
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import tutorstudent as ts
import tutorstudent.study
from tutorstudent.sims.pioneer import types

EXAMPLE = Path(__file__).parents[1]
PACKAGE = EXAMPLE / "tutorstudent_prototype2"
PUBLIC = {
    "tutorstudent": set(ts.__all__),
    "tutorstudent.study": set(tutorstudent.study.__all__),
    "tutorstudent.sims.pioneer.types": {name for name in vars(types) if not name.startswith("_")},
}


@pytest.mark.process
def test_the_wheel_holds_every_pipeline_scene_setting_and_number(tmp_path: Path) -> None:
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
    subprocess.run(build, cwd=EXAMPLE, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        packed = set(archive.namelist())
        information = next(name for name in packed if name.endswith("entry_points.txt"))
        assert b"tutorstudent-prototype2 = tutorstudent_prototype2.cli:main" in archive.read(information)
    data = {
        path.relative_to(EXAMPLE).as_posix()
        for suffix in ("yaml", "csv", "pgm", "py")
        for path in PACKAGE.rglob(f"*.{suffix}")
    }
    assert {"setting.yaml", "thesis.csv", "improvements.csv", "cave-12m-map.pgm", "prototype2a.yaml"} <= {
        Path(name).name for name in data
    }
    assert set() == data - packed


def test_only_public_names_are_used() -> None:
    offences = [
        f"{path.relative_to(PACKAGE)}: {node.module}.{alias.name}"
        for path in sorted(PACKAGE.rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ImportFrom) and (node.module or "").partition(".")[0] == "tutorstudent"
        for alias in node.names
        if alias.name not in PUBLIC.get(node.module or "", set())
    ]
    assert [] == offences
