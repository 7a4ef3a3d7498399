"""Imports go one way, heavy packages stay where they belong, and nothing grows beyond what fits on a screen or two."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parent.parent / "tutorstudent"
FILES = sorted(PACKAGE.rglob("*.py"))

FLOORS = [
    "core/words",
    "core/roles",
    "core/deciding",
    "core/running",
    "core/files",
    "sims",
    "plugins",
    "checks",
    "templates",
    "study/plans",
    "study/runs",
    "study/numbers",
    "study/pictures",
    "study/tables",
    "study/page",
    "study",
    "command",
]
"""Every folder with code, lowest first: a file imports from its own folder and from those before it."""
APART = {
    "plugins": ("tutorstudent.core.files",),
    "sims": (),
    "checks": ("tutorstudent.plugins", "tutorstudent.sims"),
    "templates": ("tutorstudent.plugins", "tutorstudent.sims", "tutorstudent.checks"),
    "study": ("tutorstudent.plugins", "tutorstudent.sims", "tutorstudent.checks", "tutorstudent.templates"),
}
"""What an area must not import although it lies below."""
LONGEST_FILE, LONGEST_FUNCTION = 250, 40
"""In lines; of a function without its head and its docstring."""
HEAVY = ("pybullet", "sklearn", "joblib", "scipy", "matplotlib", "gymnasium")


def imports(path: Path) -> Iterator[str]:
    """Yield every name that a file imports, wherever in the file."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def area(path: Path) -> str:
    return path.relative_to(PACKAGE).parts[0]


def floor(words: Sequence[str]) -> int | None:
    """Return the floor of a file or module below the package; None for the package's own few modules."""
    return next(
        (i for i in reversed(range(len(FLOORS))) if tuple(words[: len(found := FLOORS[i].split("/"))]) == tuple(found)),
        None,
    )


def offences(forbidden: Callable[[Path, str], bool]) -> list[str]:
    return [
        f"{path.relative_to(PACKAGE)} imports {name}"
        for path in FILES
        for name in imports(path)
        if forbidden(path, name)
    ]


def test_every_folder_with_code_stands_on_a_floor() -> None:
    folders = {path.relative_to(PACKAGE).parent.parts[:2] for path in FILES}
    assert [] == [folder for folder in folders if folder and folder != ("core",) and floor(folder) is None]


def test_every_floor_is_a_folder_with_code() -> None:
    assert [] == [name for name in FLOORS if not any((PACKAGE / name).glob("*.py"))]


def test_folders_import_only_what_lies_below_them() -> None:
    def is_above(path: Path, name: str) -> bool:
        own, other = floor(path.relative_to(PACKAGE).parts), floor(name.split(".")[1:])
        return name.startswith("tutorstudent.") and own is not None and other is not None and other > own

    assert [] == offences(is_above)


def test_areas_that_stand_side_by_side_do_not_import_each_other() -> None:
    assert [] == offences(lambda path, name: name.startswith(APART.get(area(path), ()) or "-"))


def test_plugins_take_only_the_robots_vocabulary_from_the_simulator() -> None:
    def is_more(path: Path, name: str) -> bool:
        robot = name.startswith("tutorstudent.sims.pioneer.types")
        return area(path) == "plugins" and name.startswith("tutorstudent.sims") and not robot

    assert [] == offences(is_more)


def length(function: ast.FunctionDef | ast.AsyncFunctionDef) -> int:
    """Return the number of lines of a function's body without its docstring."""
    body = function.body[ast.get_docstring(function) is not None :]
    return function.end_lineno - body[0].lineno + 1 if body and function.end_lineno else 0


def test_no_file_is_longer_than_can_be_read_at_once() -> None:
    lengths = {path.relative_to(PACKAGE): len(path.read_text(encoding="utf-8").splitlines()) for path in FILES}
    assert {} == {str(path): lines for path, lines in lengths.items() if lines > LONGEST_FILE}


def test_no_function_is_longer_than_a_screen() -> None:
    functions = [
        (f"{path.relative_to(PACKAGE)}:{node.lineno} {node.name}", length(node))
        for path in FILES
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]
    assert {} == {name: lines for name, lines in functions if lines > LONGEST_FUNCTION}


def test_no_three_files_have_one_name() -> None:
    stems = Counter(path.stem for path in FILES)
    assert {} == {stem: count for stem, count in stems.items() if count > 2 and stem != "__init__"}


def test_pybullet_is_imported_in_one_file() -> None:
    pattern = re.compile(r"import pybullet|from pybullet|import_module\(\"pybullet")
    found = {path.relative_to(PACKAGE).as_posix() for path in FILES if pattern.search(path.read_text(encoding="utf-8"))}
    assert {"sims/pioneer/bullet.py"} == found


@pytest.mark.process
@pytest.mark.parametrize("module", ["tutorstudent", "tutorstudent.command.program"])
def test_importing_does_not_import_heavy_packages(module: str) -> None:
    code = f"import sys, {module}; print([name for name in {HEAVY!r} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "[]" == done.stdout.strip()


@pytest.mark.process
def test_discovering_all_plugins_does_not_import_heavy_packages() -> None:
    code = (
        "import sys; from tutorstudent.core.files.registry import Registry; r = Registry.discover(); "
        f"print(r.broken, [name for name in {HEAVY!r} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "[] []" == done.stdout.strip()


@pytest.mark.process
def test_the_engine_needs_neither_plugin_manager_nor_yaml() -> None:
    # The package's own __init__ re-exports everything, so the engine's module is loaded beside an empty one.
    code = (
        "import sys, types, pathlib; package = types.ModuleType('tutorstudent'); "
        f"package.__path__ = [{str(PACKAGE)!r}]; sys.modules['tutorstudent'] = package; "
        "import tutorstudent.core.deciding.engine; "
        "print([name for name in ('pluggy', 'ruamel.yaml', 'typer', 'rich') if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "[]" == done.stdout.strip()
