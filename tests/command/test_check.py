"""`tutorstudent plugins check`: what it prints, its exit codes, and how a third party's part is found."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from tests import distributions
from tutorstudent.checks import Report, checks_of, run_checks
from tutorstudent.command.check import find_role
from tutorstudent.command.program import app
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import PipelineError, UnknownPlugin

UNORDERED = """\
import tutorstudent as ts
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState

class Chooser(ts.Tutor[PioneerState, DriveAction]):
    "Takes whichever comes first."
    name = "{name}"
    action = DriveAction

    def act(self, state):
        order = "".join({{"forward", "backward", "left", "right", "stop", "a", "b", "c", "d", "e", "f", "g"}})
        return DriveAction(kind="forward", translation=(sum(map(ord, order[:9])) % 97) / 100)

class Halt(ts.Condition[PioneerState]):
    "Never violated."
    name = "{other}"

    def violated(self, state):
        return {answer}

@ts.hookimpl
def tutorstudent_components():
    return [Chooser, Halt]
"""


@pytest.fixture
def install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Return a function that installs a third party's module."""

    def write(module: str, text: str) -> None:
        distributions.install(tmp_path, module, text)
        monkeypatch.syspath_prepend(str(tmp_path))
        monkeypatch.setenv("PYTHONPATH", str(tmp_path))

    return write


def check(*words: str) -> Result:
    return CliRunner().invoke(app, ["plugins", "check", *words])


@pytest.mark.process
def test_it_counts_and_gives_every_reason() -> None:
    result = check("bumped")
    assert 0 == result.exit_code
    *lines, last = result.stdout.splitlines()
    assert last.startswith("condition 'bumped': 20 passed, 5 skipped, 0 failed in ")
    assert last.endswith(" s")
    assert any(line == "skipped has_its_own_random_numbers: it uses no random numbers" for line in lines)
    assert any(line.startswith("passed  says_how_long_it_takes: median ") for line in lines)


@pytest.mark.process
def test_options_are_set_and_a_world_gives_the_states() -> None:
    result = check("backprop", "--set", "encoder=prototype2-bits", "--set", "hidden=2", "--world", "pioneer", "--json")
    told = json.loads(result.stdout)
    assert (0, "student 'backprop'", 0) == (result.exit_code, told["part"], told["failed"])
    assert told["passed"] + told["skipped"] == len(told["results"])
    assert {"check", "about", "status"} <= set(told["results"][0])


@pytest.mark.process
def test_a_failure_says_what_was_expected_what_was_seen_and_what_to_do(install: Callable[..., None]) -> None:
    install("acme_words", UNORDERED.format(name="acme-words", other="acme-halt", answer="'no'"))
    result = check("acme-halt")
    assert 1 == result.exit_code
    lines = result.stdout.splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("FAILED  answers_are_sound: What it says is"))
    assert "        expected: violated() returns True or False" == lines[at + 1]
    assert "        seen:     'no'" == lines[at + 2]
    assert "        to do:    return bool(...)" == lines[at + 3]
    assert "1 failed" in lines[-1]


@pytest.mark.process
def test_what_depends_on_hash_values_is_found_in_another_process(install: Callable[..., None]) -> None:
    install("acme_sets", UNORDERED.format(name="acme-sets", other="acme-calm", answer="False"))
    part = Registry.discover().get("tutor", "acme-sets")()
    report = run_checks([check for check in checks_of(part) if "process" in check.name or check.name == "works"])
    (failure,) = report.of("failed")
    assert "same_answers_in_another_process" == failure.check
    assert "the same answers in another process" == failure.expected
    assert "sort sets" in failure.remedy


def test_states_that_were_given_by_hand_stay_in_this_process() -> None:
    (alone,) = [
        check
        for check in checks_of(Registry.discover().get("tutor", "prototype2")(), states=[1])
        if "process" in str(check)
    ]
    assert run_checks([alone]).results[0].note.startswith("states or action were given by hand;")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["prototipe2"], "no part named 'prototipe2' (did you mean 'prototype2'?). Installed: "),
        (["prototype2", "--role", "tuter"], "--role tuter: no such role (did you mean 'tutor'?). Roles: "),
        (["bumped", "--role", "tutor"], "no tutor named 'bumped'."),
        (
            ["backprop"],
            "student 'backprop' needs the options encoder; give each with --set, as in --set encoder=... (enc",
        ),
        (
            ["sklearn"],
            "needs the options encoder, estimator; give each with --set, as in --set encoder=... (encoders: ",
        ),
        (["backprop", "--set", "encodr=1"], "unknown option 'encodr' (did you mean 'encoder'?)"),
        (["near", "--set", "clearence_m=1"], "unknown option 'clearence_m' (did you mean 'clearance_m'?)"),
        (["near", "--set", "nonsense"], "--set nonsense: write key=value"),
        (["near", "--world", "pioner"], "no world named 'pioner' (did you mean 'pioneer'?)"),
    ],
)
def test_a_mistake_is_a_sentence(words: list[str], message: str) -> None:
    result = check(*words)
    assert isinstance(result.exception, PipelineError | UnknownPlugin)
    assert message in str(result.exception)


def test_the_role_is_asked_for_where_a_name_has_several(install: Callable[..., None]) -> None:
    install("acme_twins", UNORDERED.format(name="acme-twin", other="acme-twin", answer="False"))
    registry = Registry.discover()
    with pytest.raises(
        PipelineError, match="'acme-twin' is the name of parts of the roles condition, tutor; say which"
    ):
        find_role(registry, "acme-twin", None)
    assert "tutor" == find_role(registry, "acme-twin", "tutor")


def test_a_plugin_that_could_not_be_loaded_is_named(install: Callable[..., None]) -> None:
    install("acme_nothing", "import shapely_that_is_not_there\n")
    with pytest.raises(
        UnknownPlugin, match="could not be loaded and may provide it: 'acme_nothing' .*No module named 'shapely_that_is"
    ):
        find_role(Registry.discover(), "acme-somebody", None)


def test_a_report_counts() -> None:
    report = Report("tutor 'x'", [], 1.25)
    assert ["tutor 'x': 0 passed, 0 skipped, 0 failed in 1.2 s"] == report.lines()
    assert {
        "part": "tutor 'x'",
        "passed": 0,
        "skipped": 0,
        "failed": 0,
        "seconds": 1.25,
        "results": [],
    } == report.as_json()
