"""A program that keeps the protocol is a tutor like any other."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any

import pytest

import tutorstudent as ts
from tests.plugins.process.programs import UNIT, answering, python, tutor
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.plugins.process import ProcessTutor
from tutorstudent.sims.pioneer.types import DriveAction


def logging_program(path: Path) -> list[str]:
    """Return a program that answers 0.5 and writes down all that it is told."""
    script = f"""\
import json, sys
log = open({str(path)!r}, "a", buffering=1)
for line in iter(sys.stdin.readline, ""):
    log.write(line)
    message = json.loads(line)
    if message["type"] == "hello":
        print('{{"type":"hello","protocol":1}}', flush=True)
    if message["type"] == "decide":
        answer = {{"type": "action", "number": message["number"], "action": {{"value": 0.5}}, "situation": "warming"}}
        print(json.dumps(answer), flush=True)
    if message["type"] == "close":
        break
"""
    return python(script)


def told(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


@pytest.mark.process
def test_it_is_asked_once_for_every_decision_in_order() -> None:
    part = tutor(answering(), deadline_s=20.0)
    assert [0.1, 0.2, -0.3] == [part.act(state).value for state in (10, 20.0, -30)]
    part.close()


@pytest.mark.process
def test_it_is_told_what_was_executed_and_when_a_trial_begins_and_when_all_is_over(tmp_path: Path) -> None:
    log = tmp_path / "log"
    part = tutor(logging_program(log), deadline_s=20.0, close_timeout_s=20.0)
    part.reset()
    part.act(1.0)
    part.executed(part.action(value=0.75))
    part.act(2.0)
    part.close()
    hello, *rest = told(log)
    assert ("hello", 1) == (hello["type"], hello["protocol"])
    assert [
        {"type": "reset"},
        {"type": "decide", "number": 0, "state": 1.0},
        {"type": "executed", "number": 0, "action": {"kind": "command", "value": 0.75}},
        {"type": "decide", "number": 1, "state": 2.0},
        {"type": "close"},
    ] == rest


@pytest.mark.process
def test_the_first_message_states_the_vocabulary_and_a_seed(tmp_path: Path) -> None:
    log = tmp_path / "log"
    for _ in range(2):
        tutor(logging_program(log)).close()
    hello, again = [message for message in told(log) if message["type"] == "hello"]
    assert hello == again
    assert 0 <= hello["seed"] < 2**31
    assert {
        "name": "ProcessAction",
        "kinds": ["command"],
        "components": {"value": {"low": -1.0, "high": 1.0, "neutral": 0.0, "unit": "", "required": True}},
        "amplified": {"command": [{"components": ["value"], "direction": "outward"}]},
    } == hello["action"]


@pytest.mark.process
def test_the_situation_is_the_programs(tmp_path: Path) -> None:
    part = tutor(logging_program(tmp_path / "log"), deadline_s=20.0)
    assert "" == part.situation
    part.act(1.0)
    assert "warming" == part.situation
    part.close()


@pytest.mark.process
def test_an_engine_amplifies_what_it_says_and_tells_it(tmp_path: Path) -> None:
    log = tmp_path / "log"
    part = ProcessTutor(program=logging_program(log), action=UNIT, deadline_s=20.0, close_timeout_s=20.0)
    loop = ts.wrap(part, student={"use": "constant", "level": 2})
    assert [0.55, 0.6] == pytest.approx([loop.step(0.0).value for _ in range(2)])
    loop.step(0.0)
    loop.engine.close()
    heard = [message["action"]["value"] for message in told(log) if message["type"] == "executed"]
    assert [0.55, 0.6] == pytest.approx(heard)


@pytest.mark.process
def test_environment_folder_and_arguments_reach_the_program_as_they_are(tmp_path: Path) -> None:
    body = "answer(number, 0.5, situation=' '.join([os.environ['GAIN'], os.getcwd(), *sys.argv[1:]]))"
    part = tutor([*answering(body), "$HOME; rm -rf *", "a  b"], env={"GAIN": "2"}, cwd=str(tmp_path), deadline_s=20.0)
    part.act(0.0)
    assert f"2 {tmp_path} $HOME; rm -rf * a  b" == part.situation
    part.close()


@pytest.mark.process
def test_a_world_lends_its_action_class_and_is_not_set_up() -> None:
    data = {
        "tutor": {
            "use": "process",
            "program": answering(
                "say(json.dumps(dict(type='action', number=number, action=dict(kind='forward', translation=0.4))))"
            ),
            "action_of": "pioneer",
            "deadline_s": 20,
        },
        "student": "silent",
        "selector": "modifier",
        "amplifier": "never",
    }
    engine = Pipeline(parse_yaml(json.dumps(data), "p.yaml")).engine()
    assert DriveAction(kind="forward", translation=0.4) == engine.step(None)
    assert "pioneer" == engine.tutor.describe()["action_of"]["use"]
    engine.close()


def test_kinds_and_directions_can_be_written_out() -> None:
    options = {
        "kinds": ["push", "rest"],
        "components": {"force": {"low": -2, "high": 2, "default": 0, "unit": "N"}},
        "amplified": {"push": {"force": "+"}},
    }
    part = ProcessTutor(program=["x"], action=options)
    words = part.action.vocabulary
    assert ("push", "rest") == words.kinds
    assert [("force",)] == [group.names for group in words.groups["push"]]
    assert () == words.groups["rest"]
    assert 0.0 == part.action(kind="rest").force  # type: ignore[attr-defined]


def test_several_numbers_keep_their_direction_by_default() -> None:
    part = ProcessTutor(
        program=["x"], action={"components": {"x": {"low": -1, "high": 1}, "y": {"low": -1, "high": 1}}}
    )
    assert [("x", "y")] == [group.names for group in part.action.vocabulary.groups["command"]]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "found neither of 'action' and 'action_of'; say which actions the program commands: either 'action_of:"),
        ({"program": []}, "option 'program': list should have at least 1 item"),
        ({"action": {}}, "option 'action.components' is required"),
        ({"action": {"components": {"kind": {}}}}, "'kind' cannot name a component; use another word"),
        ({"action": {"components": {"x y": {}}}}, "'x y' cannot name a component"),
        ({"action": {"components": {"copy": {}}}}, "'copy' cannot name a component"),
        ({"action": {"components": {"x": {}}}}, "the component 'x' has no finite scale; give it bounds"),
        ({"action": {"components": {"x": {"lo": 1}}}}, "unknown option 'action.components.x.lo'"),
        (
            {"action": {"components": {"x": {"low": 0, "high": 1}}, "amplified": {"go": {"x": "+"}}}},
            "amplification names the kind 'go'; its kinds are command",
        ),
        ({"action": UNIT, "deadline_s": 0}, "option 'deadline_s': input should be greater than 0"),
        ({"action": UNIT, "comand": "x"}, "unknown option 'comand'"),
    ],
)
def test_a_mistake_in_the_options_is_told_with_the_remedy(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.TutorStudentError, match=re.escape(message)):
        ProcessTutor(**{"program": ["x"]} | options)


def test_a_world_without_actions_of_its_own_lends_none() -> None:
    class Anything(ts.World[Any, Any]):
        name = "anything"
        action = ts.Action

        def reset(self, seed: int) -> None: ...
        def step(self, action: Any) -> Any: ...

    with pytest.raises(ts.PipelineError, match="world 'anything' has no actions of its own, it takes those that fit"):
        ProcessTutor(program=["x"], action_of=Anything())
    with pytest.raises(ts.PipelineError, match="found both of 'action' and 'action_of'"):
        ProcessTutor(program=["x"], action=UNIT, action_of=Anything())


def test_a_world_that_is_not_installed_is_told_like_any_other_part() -> None:
    document = parse_yaml("tutor: {use: process, program: [x], action_of: pionier}\nstudent: silent", "p.yaml")
    with pytest.raises(
        ts.UnknownPlugin, match=r"p.yaml:1:37: tutor.action_of: no world named 'pionier' \(did you mean"
    ):
        Pipeline(document).engine()


def test_elsewhere_than_on_posix_it_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(os, "killpg")
    with pytest.raises(ts.PipelineError, match="tutor 'process' needs a POSIX system"):
        tutor(["x"])


def blocks(language: str) -> list[str]:
    page = Path(__file__).parents[3] / "docs" / "process-protocol.md"
    return re.findall(rf"```{language}\n(.*?)```", page.read_text(encoding="utf-8"), flags=re.DOTALL)


@pytest.mark.process
def test_the_pages_smallest_program_keeps_the_protocol() -> None:
    part = tutor(python(blocks("python")[0]), deadline_s=20.0)
    assert [0.5, -0.25] == pytest.approx([part.act(state).value for state in (10.0, 85.0)])
    part.reset()
    part.executed(part.action(value=0.5))
    assert 0.1 == pytest.approx(part.act(50).value)
    part.close()


def test_the_pages_pipelines_are_sound() -> None:
    whole, action = (parse_yaml(text, "page").data for text in blocks("yaml"))
    assert DriveAction is Pipeline(parse_yaml("{}", "page")).registry.get("world", whole["tutor"]["action_of"])().action
    options = {key: value for key, value in whole["tutor"].items() if key not in ("use", "action_of")}
    assert ("push", "rest") == ProcessTutor(**options, **action).action.vocabulary.kinds


def test_an_unbound_tutor_says_so() -> None:
    part = ProcessTutor(program=["x"], action=UNIT)
    part.reset()
    part.executed(part.action(value=0.5))
    part.close()
    with pytest.raises(ts.ContractError, match="the program was not started; bind the tutor, or give it to an engine"):
        part.act(0.0)
