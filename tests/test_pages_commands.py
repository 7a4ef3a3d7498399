"""Every command line that a page shows is one: sub-commands, options and values are what the parsers take."""

from __future__ import annotations

import itertools
import re
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import typer.main

from tutorstudent.command.program import app
from tutorstudent_prototype2.cli import app as prototype2

ROOT = Path(__file__).parents[1]
GENERATED = {"_build", "reference"}
PAGES = [
    *ROOT.glob("*.md"),
    *(ROOT / "examples").glob("*/README.md"),
    *(page for page in (ROOT / "docs").rglob("*.md") if not GENERATED & set(page.parts)),
]
FENCE = re.compile(r"^```([^\n]*)\n(.*?)^```", flags=re.DOTALL | re.MULTILINE)
PROGRAMS = {"tutorstudent": app, "tutorstudent-prototype2": prototype2}
OPERATORS = set("();<>|&")


def commands(line: str) -> list[list[str]]:
    """The words of each command of our own in a line of shell; what follows a redirection is another's."""
    lexer = shlex.shlex(line, posix=True, punctuation_chars=True)
    lexer.whitespace_split = True
    parts = itertools.groupby(lexer, lambda word: set(word) <= OPERATORS)
    found = [list(words) for is_operator, words in parts if not is_operator]
    return [words for words in found if words[0] in PROGRAMS]


def shown(text: str) -> Iterator[str]:
    """The lines of shell: of blocks in `sh`, and behind the prompts of blocks in `console`."""
    for language, block in FENCE.findall(text):
        lines = block.replace("\\\n", " ").splitlines()
        if language in ("sh", "console"):
            yield from (line.removeprefix("$ ") for line in lines if language == "sh" or line.startswith("$ "))


def mentioned(text: str) -> list[str]:
    """What is said of commands outside blocks, as in `tutorstudent plugins list`."""
    return re.findall(rf"`((?:{'|'.join(PROGRAMS)}) [^`]+)`", FENCE.sub("", text))


def without_effect(command: Any) -> Any:
    """The command, which now takes its words and does nothing."""
    command.callback = lambda **_: None
    for child in getattr(command, "commands", {}).values():
        without_effect(child)
    return command


def taken(words: list[str], capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    """Exit code and standard error of the parser of a program."""
    parser = without_effect(typer.main.get_command(PROGRAMS[words[0]]))
    with pytest.raises(SystemExit) as ended:
        parser.main(words[1:], prog_name=words[0])
    return int(ended.value.code or 0), capsys.readouterr().err


def of_page(page: Path) -> list[list[str]]:
    return [words for line in shown(page.read_text(encoding="utf-8")) for words in commands(line)]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_command_of_a_page_parses(page: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for words in of_page(page):
        assert (0, "") == taken(words, capsys), words
    for words in itertools.chain.from_iterable(map(commands, mentioned(page.read_text(encoding="utf-8")))):
        code, said = taken(words, capsys)
        assert code == 0 or said == "" or "Missing argument" in said, (words, said)  # a sentence may leave words out


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_pipeline_that_a_command_names_with_its_folder_is_there(page: Path) -> None:
    named = [word for words in of_page(page) for word in words if "/" in word and word.endswith(".yaml")]
    assert [] == [word for word in named if not (ROOT / word).is_file()]


def test_the_commands_of_the_first_pages_are_found() -> None:
    assert {"run", "compare", "plugins", "schema"} == {words[1] for words in of_page(ROOT / "README.md")}
    tutorial = of_page(ROOT / "docs" / "guide" / "tutorial.md")
    assert ["new", "list", "info", "check"] == [words[2] for words in tutorial if words[1] == "plugins"]
    assert ["run", "compare"] == [words[1] for words in tutorial if words[1] != "plugins"]


@pytest.mark.parametrize(
    "line",
    [
        "tutorstudent rum p.yaml",
        "tutorstudent run p.yaml --decision 5",
        "tutorstudent run p.yaml --decisions 0",
        "tutorstudent run",
        "cd there && tutorstudent-prototype2 reproduce --fast > log",
    ],
)
def test_a_wrong_command_would_be_noticed(line: str, capsys: pytest.CaptureFixture[str]) -> None:
    (words,) = commands(line)
    code, said = taken(words, capsys)
    assert 2 == code
    assert "Error" in said
