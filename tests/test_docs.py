"""The documentation is complete, its code runs, and its commands exist."""

from __future__ import annotations

import doctest
import inspect
import io
import re
import shlex
import sys
from pathlib import Path

import pytest
import typer.main

from tutorstudent.command.program import app, main
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.roles import hookspecs

DOCS = Path(__file__).parents[1] / "docs"
sys.path.append(str(DOCS))

import attributes  # noqa: E402 - stands beside the pages
import complete  # noqa: E402
import reference  # noqa: E402

PAGES = sorted(path for path in DOCS.rglob("*.md") if not {"reference", "_build"} & set(path.parts))
FENCE = re.compile(r"^```(\w+)\n(.*?)^```", flags=re.DOTALL | re.MULTILINE)
READMES = sorted((DOCS.parent / "examples").glob("*/README.md"))
PACKAGE = DOCS.parent / "tutorstudent"
INTERNAL = ("core", "checks/roles")
OWN = [installed.cls for installed in Registry.discover() if installed.distribution.split()[0] == "tutorstudent"]


def blocks(page: Path) -> list[tuple[str, str]]:
    return [(found.group(1), found.group(2)) for found in FENCE.finditer(page.read_text(encoding="utf-8"))]


def run_python(code: str, names: dict[str, object], page: Path) -> None:
    if code.lstrip().startswith(">>>"):
        example = doctest.DocTestParser().get_doctest(code, names, page.name, str(page), 0)
        assert 0 == doctest.DocTestRunner().run(example).failed
        names.update(example.globs)
    else:
        exec(compile(code, str(page), "exec", dont_inherit=True), names)


def run_commands(text: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    for line in text.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if words[:1] == ["tutorstudent"]:
            monkeypatch.setattr(sys, "argv", words)
            with pytest.raises(SystemExit) as ended:
                main()
            assert 0 == (ended.value.code or 0), (line, capsys.readouterr().err)


@pytest.mark.process
@pytest.mark.study
@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page)], ids=lambda page: str(page.relative_to(DOCS)))
def test_the_code_of_every_page_runs(page, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "stdin", io.StringIO())
    for other in PAGES:
        for language, text in blocks(other):
            if language == "yaml" and (name := re.match(r"# (\S+\.yaml)\n", text)):
                (tmp_path / name.group(1)).write_text(text, encoding="utf-8")
    names: dict[str, object] = {"__name__": "page"}
    for language, text in blocks(page):
        if language == "python":
            run_python(text, names, page)
        elif language == "sh":
            run_commands(text, capsys, monkeypatch)


@pytest.mark.parametrize("page", READMES, ids=lambda page: page.parent.name)
def test_the_python_of_every_examples_page_runs(page):
    names: dict[str, object] = {"__name__": "page"}
    for language, text in blocks(page):
        if language == "python":
            run_python(text, names, page)


def all_commands(command, name=""):
    children = getattr(command, "commands", {})
    for child in children:
        yield from all_commands(children[child], f"{name} {child}".strip())
    if not children:
        yield name, command


@pytest.fixture(scope="module")
def commands_page():
    return "\n".join(reference.commands())


@pytest.mark.parametrize(("name", "command"), list(all_commands(typer.main.get_command(app))))
def test_every_command_and_each_of_its_parameters_is_documented(name, command, commands_page):
    assert f"## `tutorstudent {name}`" in commands_page
    assert command.help
    for param in command.params:
        assert getattr(param, "help", None), f"{name}: {param.name} has no help"


@pytest.fixture(scope="module")
def parts_page():
    return "\n".join(reference.parts(Registry.discover()))


@pytest.mark.parametrize("cls", OWN, ids=lambda cls: f"{cls.role}-{cls.name}")
def test_every_part_and_each_of_its_options_is_documented(cls, parts_page):
    assert f"### {cls.role} `{cls.name}`" in parts_page
    assert inspect.getdoc(cls)
    for key, field in cls.Options.model_fields.items():
        assert field.description, f"{cls.role} {cls.name}: option {key} has no description"
        assert f"`{key}" in parts_page


def test_every_hook_is_documented():
    hooks = [name for name in vars(hookspecs) if name.startswith("tutorstudent_")]
    page = "\n".join(reference.hooks())

    assert hooks
    for hook in hooks:
        assert f"## {hook}" in page
        assert inspect.getdoc(getattr(hookspecs, hook))


def test_the_names_of_every_module_that_promises_some_are_held_against_the_site():
    promising = {
        path for path in PACKAGE.rglob("*.py") if re.search(r"^__all__ = ", path.read_text("utf-8"), re.MULTILINE)
    }
    public = {path for path in promising if not path.relative_to(PACKAGE).as_posix().startswith(INTERNAL)}
    modules = {
        ".".join(path.relative_to(DOCS.parent).with_suffix("").parts).removesuffix(".__init__") for path in public
    }

    assert modules | {"tutorstudent.sims.pioneer.types"} == set(complete.PUBLIC)


@pytest.mark.parametrize("module", complete.PUBLIC)
def test_every_name_that_a_module_promises_is_described(module):
    page = (DOCS / "api.md").read_text(encoding="utf-8")
    described = set(re.findall(r"^\.\. auto(?:class|function):: (\S+)$", page, flags=re.MULTILINE))

    if f".. automodule:: {module}\n" not in page:
        assert described >= set(complete.promised(module))
    for name in complete.promised(module):
        assert inspect.getdoc(getattr(sys.modules[module], name.rpartition(".")[2])), f"{name} has no docstring"


def test_a_name_that_no_page_describes_is_told():
    names = [name for module in complete.PUBLIC for name in complete.promised(module)]

    assert {"tutorstudent.wrap", "tutorstudent.study.write_report", "tutorstudent.sims.pioneer.types.Blob"} <= set(
        names
    )
    assert [] == complete.not_rendered(names)
    assert ["tutorstudent.wrap"] == complete.not_rendered(set(names) - {"tutorstudent.wrap"})


@pytest.mark.parametrize(
    ("what", "written", "rendered"),
    [
        ("attribute", ["None: as many as the files say.", ""], ["None: as many as the files say.", ""]),
        ("property", ["One: two.", "", "Raises:", "    E: if"], ["by Napoleon"]),
        ("function", ["One: two.", ""], ["by Napoleon"]),
        ("attribute", ["Alias for field number 3", ""], ["by Napoleon"]),
    ],
)
def test_the_sentence_of_an_attribute_is_rendered_as_it_is_written(what, written, rendered):
    handlers, lines = attributes.Attributes(), [*written]
    handlers.keep(None, what, "name", None, None, lines)
    assert lines == ([] if "Alias" in written[0] else written)
    lines[:] = ["by Napoleon"]
    handlers.give_back(None, what, "name", None, None, lines)
    assert rendered == lines


def test_every_page_is_in_the_table_of_contents():
    listed = set()
    for page in PAGES:
        for toctree in re.findall(r"```\{toctree\}\n(.*?)```", page.read_text(encoding="utf-8"), flags=re.DOTALL):
            lines = [line for line in toctree.splitlines() if line and not line.startswith(":")]
            for line in lines:
                listed |= {path.resolve() for path in page.parent.glob(f"{line}.md")}

    assert {page for page in PAGES if page.name != "index.md" or page.parent != DOCS} <= listed
