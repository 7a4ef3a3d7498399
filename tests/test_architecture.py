"""Imports go one way, and heavy packages stay where they belong."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parent.parent / "tutorstudent"
FILES = sorted(PACKAGE.rglob("*.py"))

CORE_ORDER = [
    {"errors", "freezing"},
    {"actions"},
    {"problems", "binding"},
    {"proposals", "records", "component"},
    {"limits", "leaves", "interfaces", "world", "forms"},
    {"rendering", "guard", "wiring", "namedform"},
    {"judging", "levels", "tutoring", "teaching", "grading"},
    {"corrections"},
    {"engine"},
    {"observers"},
    {"recording", "runner", "hookspecs", "commands", "yamlnodes", "yamlproblems"},
    {"yamlfile"},
    {"loading"},
    {"registry", "adapters", "settings", "transplanting", "extending", "plainvalues"},
    {"assembly"},
    {"pipeline"},
    {"rundir", "optiontable"},
    {"schema"},
]
RANK = {name: rank for rank, names in enumerate(CORE_ORDER) for name in names}
FORBIDDEN = {
    "core": ("tutorstudent.plugins", "tutorstudent.sims", "tutorstudent.study", "tutorstudent.cli"),
    "plugins": ("tutorstudent.study", "tutorstudent.cli"),
    "sims": ("tutorstudent.plugins", "tutorstudent.study", "tutorstudent.cli"),
    "study": ("tutorstudent.cli",),
    "checks": ("tutorstudent.plugins", "tutorstudent.sims", "tutorstudent.study", "tutorstudent.cli"),
    "templates": ("tutorstudent.plugins", "tutorstudent.sims", "tutorstudent.study", "tutorstudent.cli"),
}
HEAVY = ("pybullet", "sklearn", "joblib", "scipy", "matplotlib", "gymnasium")


def imports(path: Path) -> Iterator[tuple[str, bool]]:
    """Yield every imported module with whether it is imported as soon as the file is."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    top = {id(node) for node in ast.walk(tree) if isinstance(node, ast.Module) for node in node.body}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, id(node) in top) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from ((f"{node.module}.{alias.name}", id(node) in top) for alias in node.names)


def area(path: Path) -> str:
    return path.relative_to(PACKAGE).parts[0]


def test_areas_import_only_what_lies_below_them() -> None:
    offences = [
        f"{path.relative_to(PACKAGE)} imports {name}"
        for path in FILES
        for name, _ in imports(path)
        for forbidden in FORBIDDEN.get(area(path), ())
        if name.startswith(forbidden)
    ]
    assert [] == offences


def test_plugins_take_only_the_robots_vocabulary_from_the_simulator() -> None:
    offences = [
        f"{path.relative_to(PACKAGE)} imports {name}"
        for path in FILES
        for name, _ in imports(path)
        if area(path) == "plugins"
        and name.startswith("tutorstudent.sims")
        and not name.startswith("tutorstudent.sims.pioneer.types")
    ]
    assert [] == offences


def test_core_imports_in_one_order() -> None:
    offences = [
        f"{path.stem} imports {below}"
        for path in sorted((PACKAGE / "core").glob("*.py"))
        if path.stem != "__init__"
        for name, _ in imports(path)
        if name.startswith("tutorstudent.core.")
        and (below := name.split(".")[2]) != path.stem
        and RANK[below] > RANK[path.stem]
    ]
    assert [] == offences


def test_every_core_file_has_a_place_in_the_order() -> None:
    assert set(RANK) == {path.stem for path in (PACKAGE / "core").glob("*.py")} - {"__init__"}


def test_pybullet_is_imported_in_one_file() -> None:
    pattern = re.compile(r"import pybullet|from pybullet|import_module\(\"pybullet")
    found = {path.relative_to(PACKAGE).as_posix() for path in FILES if pattern.search(path.read_text(encoding="utf-8"))}
    assert {"sims/pioneer/bullet.py"} == found


@pytest.mark.parametrize("module", ["tutorstudent", "tutorstudent.cli"])
def test_importing_does_not_import_heavy_packages(module: str) -> None:
    code = f"import sys, {module}; print([name for name in {HEAVY!r} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "[]" == done.stdout.strip()


def test_discovering_all_plugins_does_not_import_heavy_packages() -> None:
    code = (
        "import sys; from tutorstudent.core.registry import Registry; r = Registry.discover(); "
        f"print(r.broken, [name for name in {HEAVY!r} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "[] []" == done.stdout.strip()


def test_the_engine_needs_neither_plugin_manager_nor_yaml() -> None:
    # The package's own __init__ re-exports everything, so the engine's module is loaded beside an empty one.
    code = (
        "import sys, types, pathlib; package = types.ModuleType('tutorstudent'); "
        f"package.__path__ = [{str(PACKAGE)!r}]; sys.modules['tutorstudent'] = package; "
        "import tutorstudent.core.engine; "
        "print([name for name in ('pluggy', 'ruamel.yaml', 'typer', 'rich') if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "[]" == done.stdout.strip()
