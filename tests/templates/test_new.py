"""`tutorstudent plugins new`: what it writes works, and what it cannot do is a sentence."""

from __future__ import annotations

import importlib
import json
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from typer.testing import CliRunner

import tutorstudent
from tutorstudent.command.program import app
from tutorstudent.core.files.pipeline import KEYS, Pipeline
from tutorstudent.core.files.registry import ROLES, Registry
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.templates.naming import make_names
from tutorstudent.templates.writing import make_contents, write_plugin


@pytest.mark.process
@pytest.mark.parametrize("role", ROLES)
def test_the_example_of_every_role_passes_its_checks_and_runs(
    role: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = make_names(role, f"brand-new-{role}", Registry())
    write_plugin(names, tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path))
    module = importlib.import_module(names.module)
    cls, *others = module.tutorstudent_components()
    assert (names.class_name, names.name, role) == (cls.__name__, cls.name, cls.role)
    registry = Registry.discover()
    for part in (cls, *others):
        registry.add(part)
    tests = tmp_path / "tests" / f"test_{names.module}.py"
    assert 0 == pytest.main(["-q", "-p", "no:cacheprovider", "--rootdir", str(tmp_path), str(tests)])
    pipeline = Pipeline.read(tmp_path / "pipeline.yaml", registry).replaced({"decisions": 30, "on_incident": "raise"})
    finished = run_pipeline(pipeline)
    assert 30 == finished.summary["decisions"]
    assert 0 == finished.summary["incidents"]
    for name in [name for name in sys.modules if name.partition(".")[0] == names.module]:
        del sys.modules[name]


def test_the_example_of_a_tutor_counts_what_a_comparison_takes_for_achievement(tmp_path: Path) -> None:
    files = make_contents(make_names("tutor", "my-tutor", Registry()))
    assert "observers: [my-tutor-approaches]\n" in files["pipeline.yaml"]
    assert "return [MyTutor, Approaches]" in files["my_tutor/__init__.py"]
    assert '__all__ = ["Approaches", "MyTutor"]' in files["my_tutor/__init__.py"]


def test_it_says_what_it_wrote_and_what_comes_next(tmp_path: Path) -> None:
    out = tmp_path / "folder" / "my-tutor"
    result = CliRunner().invoke(app, ["plugins", "new", "tutor", "my-tutor", "--out", str(out)])
    assert 0 == result.exit_code
    written = sorted(path.relative_to(out).as_posix() for path in out.rglob("*") if path.is_file())
    assert [
        ".gitignore",
        "README.md",
        "my_tutor/__init__.py",
        "my_tutor/py.typed",
        "my_tutor/tutor.py",
        "pipeline.yaml",
        "pyproject.toml",
        "tests/test_my_tutor.py",
    ] == written
    for word in written:
        assert f"wrote {out / word}" in result.stdout
    assert f"  cd {out}\n" in result.stdout
    assert "  tutorstudent plugins check my-tutor\n" in result.stdout
    assert "  tutorstudent compare pipeline.yaml " in result.stdout


@pytest.mark.process
def test_an_editable_installation_needs_nothing_but_hatchling(tmp_path: Path) -> None:
    write_plugin(make_names("tutor", "my-tutor", Registry()), tmp_path)
    program = (
        "import sys; sys.modules['editables'] = None\n"
        "from hatchling.build import build_editable; print(build_editable('dist'))"
    )
    said = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "my_tutor-0.1.0-py3-none-any.whl" == said.stdout.strip()


def test_it_says_what_it_wrote_as_json(tmp_path: Path) -> None:
    out = tmp_path / "my folder"
    result = CliRunner().invoke(app, ["plugins", "new", "world", "my-world", "--out", str(out), "--json"])
    told = json.loads(result.stdout)
    assert ("world", "my-world", "my_world", "MyWorld") == tuple(
        told[key] for key in ("role", "name", "module", "class_name")
    )
    assert (str(out), {path for path in out.rglob("*") if path.is_file()}) == (
        told["folder"],
        set(map(Path, told["written"])),
    )


def test_a_folder_with_a_space_is_quoted(tmp_path: Path) -> None:
    out = tmp_path / "my folder"
    shown = CliRunner().invoke(app, ["plugins", "new", "world", "my-world", "--out", str(out)]).stdout
    assert f"  cd '{out}'\n" in shown


def test_the_folder_is_the_name_unless_said_otherwise(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert 0 == CliRunner().invoke(app, ["plugins", "new", "change", "steep"]).exit_code
    assert (tmp_path / "steep" / "steep" / "change.py").is_file()


@pytest.mark.parametrize("role", ROLES)
def test_nothing_of_a_template_is_left_over(role: str) -> None:
    files = make_contents(make_names(role, "some-thing", Registry()))
    schema_line, _, rest = files["pipeline.yaml"].partition("\n")
    assert "# yaml-language-server: $schema=pipeline.schema.json" == schema_line
    assert [] == [path for path, text in (files | {"pipeline.yaml": rest}).items() if "$" in text]
    project = tomllib.loads(files["pyproject.toml"])
    assert {"some-thing": "some_thing"} == project["project"]["entry-points"]["tutorstudent"]
    assert f"tutorstudent>={tutorstudent.__version__}" in project["project"]["dependencies"]
    assert "license" not in project["project"]
    article = "An" if role in ("amplifier", "evaluator", "encoder", "observer") else "A"
    assert f"\n{article} {role} for tutorstudent.\n" in files["README.md"]
    keys = {line.partition(":")[0] for line in files["pipeline.yaml"].splitlines() if not line.startswith("#")}
    assert keys <= set(KEYS)


@pytest.mark.parametrize(
    ("name", "class_name"),
    [("wall-follower", "WallFollowerTutor"), ("my-tutor", "MyTutor"), ("pioneer-state", "PioneerStateTutor")],
)
def test_the_class_is_called_after_the_part_and_its_role(name: str, class_name: str) -> None:
    assert class_name == make_names("tutor", name, Registry()).class_name


@pytest.mark.parametrize(
    ("role", "name", "message"),
    [
        ("tuter", "x", "plugins new tuter: no such role (did you mean 'tutor'?). Roles: amplifier, "),
        ("tutor", "Wall Follower", "words joined by single hyphens (perhaps 'wall-follower')."),
        ("tutor", "WallFollower", "(perhaps 'wall-follower')."),
        ("tutor", "2fast", "(perhaps 'fast')."),
        ("tutor", "wall--follower", "(perhaps 'wall-follower')."),
        ("tutor", "...", "words joined by single hyphens."),
        ("tutor", "../evil", "(perhaps 'evil')."),
        ("tutor", "class", "'class' cannot be the name of a module; choose another, as in 'my-class'."),
        ("tutor", "tests", "'tests' cannot be the name of a module"),
        ("student", "random", "a module 'random' is installed already; choose another name, as in 'my-random'."),
        ("tutor", "tutorstudent", "a module 'tutorstudent' is installed already"),
        ("tutor", "prototype2", "there is a tutor of that name, from 'prototype2' (tutorstudent "),
        ("tutor", "scikit-learn", "the distribution 'scikit-learn' "),
    ],
)
def test_a_name_that_cannot_be_used_is_a_sentence(role: str, name: str, message: str) -> None:
    with pytest.raises(PipelineError) as caught:
        make_names(role, name, Registry.discover())
    assert message in str(caught.value)


def test_what_is_there_is_never_overwritten(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    names = make_names("tutor", "my-tutor", Registry())
    with pytest.raises(PipelineError, match="it exists and is not an empty folder; give another folder with --out"):
        write_plugin(names, tmp_path)
    with pytest.raises(PipelineError, match="it exists and is not an empty folder"):
        write_plugin(names, tmp_path / "notes.txt")
    assert ["notes.txt"] == [path.name for path in tmp_path.iterdir()]


def test_a_place_that_cannot_be_written_is_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(PipelineError, match="cannot be written: Not a directory. Name a directory that you may write"):
        write_plugin(make_names("tutor", "my-tutor", Registry()), tmp_path / "file" / "below")
