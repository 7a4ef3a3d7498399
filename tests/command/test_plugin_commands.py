"""`plugins list`, `plugins info` and `schema`: what they print, what they write, how they say no."""

from __future__ import annotations

import json
import math
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from tests.core.toys import toy_registry
from tests.distributions import install
from tutorstudent.command import plugin_list
from tutorstudent.command.common_options import VERBOSE
from tutorstudent.command.plugin_info import find, format_page, format_yaml
from tutorstudent.command.program import app, main
from tutorstudent.core.files.loading import TRACE
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import TutorStudentError

COMMANDS = [
    [],
    ["run"],
    ["compare"],
    ["report"],
    ["schema"],
    ["plugins"],
    ["plugins", "list"],
    ["plugins", "info"],
    ["plugins", "check"],
    ["plugins", "new"],
]


@pytest.fixture(scope="module")
def registry() -> Registry:
    return toy_registry()


def printed(*words: str) -> str:
    result = CliRunner().invoke(app, list(words), catch_exceptions=False)
    assert 0 == result.exit_code
    return result.stdout


def refused(words: list[str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setattr(sys, "argv", ["tutorstudent", *words])
    with pytest.raises(SystemExit) as caught:
        main()
    assert 2 == caught.value.code
    return capsys.readouterr().err


@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_every_command_has_help_that_fits_a_terminal(words: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    shown = printed(*words, "--help")
    assert "Usage:" in shown
    assert [] == [line for line in shown.splitlines() if len(line) > 80]
    assert 4 <= len([line for line in shown.splitlines() if line.strip()])


@pytest.mark.parametrize("words", [*COMMANDS[1:], ["plugins", "inof"], ["rnu"]], ids=" ".join)
def test_an_option_that_is_not_there_exits_with_2(
    words: list[str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    said = refused([*words, "--no-such-option"], capsys, monkeypatch)
    assert "Usage:" in said
    assert "No such" in said


def test_info_tells_where_a_part_comes_from_its_options_and_the_line_for_a_pipeline() -> None:
    shown = printed("plugins", "info", "backprop")
    assert shown.startswith("student backprop\nplugin 'backprop' of tutorstudent ")
    assert "class tutorstudent.plugins.backprop.student.BackpropStudent" in shown
    assert "  hidden: integer, >= 1, <= 10000, default 30\n      hidden neurons\n" in shown
    assert "  encoder: encoder, required\n" in shown
    assert '  codec: codec, default "kind-level-ampbit"\n' in shown
    assert "one of: kind-level-ampbit, level-ampbit" in shown
    assert "In a pipeline:\n  student: {use: backprop, encoder: " in shown


def test_info_prints_json() -> None:
    known = json.loads(printed("plugins", "info", "near", "--role", "condition", "--json"))
    assert ("condition", "near", "conditions: [near]") == (known["role"], known["name"], known["yaml"])
    (option,) = known["options"]
    expected = {"name", "type", "bounds", "required", "default", "role", "description"}
    assert expected == set(option)
    assert ("clearance_m", "number", False) == (option["name"], option["type"], option["required"])


def test_every_part_can_be_shown(registry: Registry) -> None:
    for installed in registry:
        lines = list(format_page(installed, registry))
        assert lines[0] == f"{installed.cls.role} {installed.cls.name}"
        assert [] == [line for line in lines[lines.index("") :] if "Options" in line and len(line) > 80]


def test_the_line_of_a_part_names_parts_that_need_nothing_more(registry: Registry) -> None:
    assert "conditions: [{use: any-of, of: [bumped]}]" == format_yaml(find("any-of", None, registry), registry)
    assert "tutor: pusher" == format_yaml(find("pusher", None, registry), registry)


@pytest.mark.parametrize(
    ("name", "role", "message"),
    [
        ("bakprop", None, "no part is named 'bakprop' (did you mean 'backprop'?)"),
        ("backprop", "tutr", "there is no role 'tutr' (did you mean 'tutor'?). Roles: amplifier, change,"),
        ("backprop", "tutor", "no tutor named 'backprop'"),
        ("prototype3", "tutor", "no tutor named 'prototype3' (did you mean 'prototype2'?)"),
        ("twin", None, "several parts are named 'twin': condition, tutor. Choose one with --role."),
    ],
)
def test_info_about_what_is_not_there_says_what_is(name: str, role: str | None, message: str) -> None:
    registry = toy_registry()
    for item in (registry.get("tutor", "pusher"), registry.get("condition", "crashed")):
        registry.add(type("Twin", (item,), {"name": "twin"}))
    with pytest.raises(TutorStudentError) as caught:
        find(name, role, registry)
    assert message in str(caught.value)
    assert "twin" == find("twin", "tutor", registry).cls.name


@pytest.mark.parametrize("width", [30, 50, 80, 120, math.inf])
def test_the_list_never_cuts_a_name(width: float, registry: Registry) -> None:
    lines = list(plugin_list.format_page(registry, width))
    words = {word for line in lines for word in line.split()}
    assert {name for item in registry for name in (item.cls.name, item.entry_point)} <= words | {""}
    assert {item.distribution for item in registry} <= set(lines)


@pytest.mark.parametrize("width", [80, 120])
def test_the_list_fits_its_width_and_leaves_out_no_word(width: int, registry: Registry) -> None:
    lines = list(plugin_list.format_page(registry, width))
    assert [] == [line for line in lines if len(line) > width]
    expected = Counter(word for item in registry for word in plugin_list.read_first_line(item.cls).split())
    assert expected <= Counter(word for line in lines for word in line.split())


def test_a_list_that_is_piped_has_a_line_for_each_part() -> None:
    (line,) = [line for line in printed("plugins", "list").splitlines() if " observation-outside " in line]
    assert ["condition", "observation-outside", "gymnasium"] == line.split()[:3]
    assert line.endswith("Its margins are the distances from both ends.")


def broken_distribution(folder: Path) -> None:
    source = "import shapely_that_is_not_there\n"
    install(folder, "acme-robots", source, version="2.1", point="acme-nav", module="acme_nav_broken")


def test_a_strict_list_exits_with_1_if_a_plugin_is_broken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "backprop" in printed("plugins", "list", "--strict")
    broken_distribution(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path))
    lenient = CliRunner().invoke(app, ["plugins", "list"])
    strict = CliRunner().invoke(app, ["plugins", "list", "--strict", "--json"])
    monkeypatch.setenv(VERBOSE, "")
    loud = CliRunner().invoke(app, ["plugins", "list", "-v"])
    assert (0, 1, 0) == (lenient.exit_code, strict.exit_code, loud.exit_code)
    assert "not loaded: 'acme-nav' (acme-robots 2.1): No module named" in lenient.stdout
    assert ["acme-nav"] == [item["plugin"] for item in json.loads(strict.stdout)["broken"]]
    assert ("Traceback" in loud.stdout, "Traceback" in lenient.stdout) == (True, False)


@pytest.mark.parametrize("command", ["info", "check"])
@pytest.mark.parametrize(
    ("name", "message"),
    [
        (
            "acme-nav",
            "no part named 'acme-nav': the plugin 'acme-nav' (acme-robots 2.1) could not be loaded: No module",
        ),
        ("acme", "could not be loaded and may provide it: 'acme-nav' (acme-robots 2.1): No module named 'shapely"),
    ],
)
def test_asking_for_a_part_of_a_broken_plugin_says_why_it_is_not_there(
    command: str,
    name: str,
    message: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    broken_distribution(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path))
    assert message in refused(["plugins", command, name], capsys, monkeypatch)


def test_the_schema_is_written_with_the_line_that_names_it(tmp_path: Path) -> None:
    path = tmp_path / "tutorstudent.json"
    shown = printed("schema", "--out", str(path))
    assert "tutorstudent pipeline" == json.loads(path.read_text())["title"]
    assert "# yaml-language-server: $schema=tutorstudent.json\n" in shown


def test_a_schema_that_cannot_be_written_says_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    said = refused(["schema", "--out", str(tmp_path / "none" / "x.json")], capsys, monkeypatch)
    assert "cannot be written: No such file or directory." in said


@pytest.mark.parametrize(
    ("words", "traced"),
    [
        (["run", "absent.yaml"], False),
        (["-v", "run", "absent.yaml"], True),
        (["run", "-v", "absent.yaml"], True),
        (["run", "absent.yaml", "--verbose"], True),
    ],
)
def test_a_mistake_is_told_with_its_traceback_on_request(
    words: list[str], traced: bool, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(VERBOSE, "")
    said = refused(words, capsys, monkeypatch)
    assert traced == ("Traceback" in said)
    assert "tutorstudent: absent.yaml: there is no such file." in said


@pytest.mark.parametrize("words", [command for command in COMMANDS if command not in ([], ["plugins"])], ids=" ".join)
def test_every_command_takes_the_options_of_all(words: list[str]) -> None:
    shown = printed(*words, "--help")
    assert all(option in shown for option in ("--verbose", "-v", "--trace"))


@pytest.mark.parametrize("words", [["--trace", "plugins", "info", "never"], ["plugins", "info", "never", "--trace"]])
def test_hooks_are_traced_on_request(words: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(TRACE, "")
    result: Any = CliRunner().invoke(app, words)
    assert "amplifiers: tutorstudent_components [hook]" in result.output


def test_info_of_wrap_is_the_pipeline_that_does_the_same() -> None:
    shown = CliRunner().invoke(app, ["plugins", "info", "wrap"])
    assert 0 == shown.exit_code
    assert "  change: multiplicative\n" in shown.stdout
    assert "limits:\n  factor: 1.3\n  slew: 1\n" in shown.stdout
    values = json.loads(CliRunner().invoke(app, ["plugins", "info", "wrap", "--json"]).stdout)
    assert {"factor": 1.3, "slew": 1} == values["limits"]
