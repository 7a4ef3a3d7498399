"""A study goes on where it stopped: complete runs stay, all others are run, and nothing else is mixed in."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from tests.command.test_compare import app
from tests.study.conftest import results
from tutorstudent.core.files.durable import lock_folder, remove_partial, replace_folder, write_whole
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study import Plan, Study, load_plan, read_study, run_plan, save_plan
from tutorstudent.study.runs import jobs as jobs_module

Planned = Callable[..., Plan]


def resume(*arguments: object) -> Any:
    return CliRunner().invoke(app, ["--resume", *map(str, arguments)])


def best_level(study: Study) -> int:
    assert study.search is not None
    chosen = study.search.chosen("short")
    assert chosen is not None
    return chosen.level


def inodes(folder: Path) -> dict[Path, int]:
    return {path: path.stat().st_ino for path in folder.rglob("run.json")}


@pytest.mark.study
def test_a_complete_study_is_left_as_it_is(planned: Planned, folder: Path) -> None:
    study = run_plan(planned(), folder)
    before, there = results(folder), inodes(folder)
    assert study == run_plan(planned(), folder)
    assert (before, there) == (results(folder), inodes(folder))


@pytest.mark.study
def test_runs_that_failed_are_run_again_and_the_others_stay(
    planned: Planned, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    undisturbed = run_plan(planned(), folder / "undisturbed")
    level = next(level for level in (1, 2) if level != best_level(undisturbed))

    def unreliable(pipeline: Any, *given: Any, **named: Any) -> Any:
        if "ramp" in pipeline.document.name or f"level-{level}" in pipeline.document.name:
            raise RuntimeError("no room")
        return keep_run(pipeline, *given, **named)

    keep_run = jobs_module.keep_run
    monkeypatch.setattr(jobs_module, "keep_run", unreliable)
    out = folder / "out"
    study = run_plan(planned(), out)
    assert {"ramp", f"search: level-{level}"} == {failure.variant for failure in study.failures}
    there = inodes(out)
    monkeypatch.setattr(jobs_module, "keep_run", keep_run)
    study = run_plan(planned(), out)
    assert () == study.failures
    assert there == {path: inode for path, inode in inodes(out).items() if path in there}
    assert results(folder / "undisturbed") == results(out)
    assert undisturbed.plan == study.plan


@pytest.mark.study
def test_the_runs_of_a_level_that_is_no_longer_the_best_go(
    planned: Planned, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    best = best_level(run_plan(planned(), folder / "undisturbed"))

    def unreliable(pipeline: Any, *given: Any, **named: Any) -> Any:
        if f"level-{best}" in pipeline.document.name:
            raise RuntimeError("no room")
        return keep_run(pipeline, *given, **named)

    keep_run = jobs_module.keep_run
    monkeypatch.setattr(jobs_module, "keep_run", unreliable)
    assert best != best_level(run_plan(planned(), folder / "out"))
    monkeypatch.setattr(jobs_module, "keep_run", keep_run)
    run_plan(planned(), folder / "out")
    assert results(folder / "undisturbed") == results(folder / "out")


def shorten(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-200])


def flip(path: Path) -> None:
    content = bytearray(path.read_bytes())
    middle = slice(len(content) * 2 // 5, len(content) * 3 // 5)
    content[middle] = bytes(byte ^ 0xFF for byte in content[middle])
    path.write_bytes(content)


def empty(path: Path) -> None:
    path.write_text("{}")


@pytest.mark.study
@pytest.mark.parametrize(
    ("name", "harm"),
    [
        ("run.json", shorten),
        ("run.json", empty),
        ("decisions.npz", shorten),
        ("decisions.npz", flip),
        ("decisions.npz", Path.unlink),
    ],
)
def test_a_run_that_is_damaged_is_a_failure_and_is_run_again(
    planned: Planned, folder: Path, name: str, harm: Callable[[Path], None]
) -> None:
    plan = planned("alone")
    run_plan(plan, folder)
    before = results(folder)
    harm(folder / plan.jobs()[1].folder / name)
    study = read_study(folder, plan)
    assert [1] == [failure.seed for failure in study.failures]
    assert study.failures[0].problem.startswith("damaged: ")
    assert study.failures[0].problem.endswith("; go on with 'compare --resume' to run it again.")
    assert () == run_plan(plan, folder).failures
    assert before == results(folder)


@pytest.mark.study
def test_what_was_not_finished_writing_is_removed(planned: Planned, folder: Path) -> None:
    plan = planned("alone")
    run_plan(plan, folder)
    before = results(folder)
    rubbish = folder / plan.jobs()[0].folder.parent / ".1.abc.partial"
    rubbish.mkdir()
    (rubbish / "run.json").write_text("{")
    (folder / ".plan.json.partial").write_text("{")
    run_plan(plan, folder)
    assert before == results(folder)
    assert not list(folder.rglob(".*"))


@pytest.mark.study
def test_two_processes_do_not_work_on_one_study(planned: Planned, folder: Path) -> None:
    pytest.importorskip("fcntl")
    with (
        lock_folder(folder),
        pytest.raises(PipelineError, match="another process works on this study; wait for it, or end"),
    ):
        run_plan(planned("alone"), folder)
    assert () == run_plan(planned("alone"), folder).failures


@pytest.mark.study
def test_a_plan_that_was_not_finished_writing_is_no_study(planned: Planned, folder: Path) -> None:
    (folder / ".plan.json.partial").write_text("{")
    assert () == run_plan(planned("alone"), folder).failures


def test_another_plan_is_refused_with_what_differs(planned: Planned, folder: Path) -> None:
    save_plan(planned(), folder)
    with pytest.raises(PipelineError) as caught:
        run_plan(planned(runs=3, decisions=30, controls=False), folder)
    message = str(caught.value)
    assert "plan.json is that of another study. What differs: decisions: 20 there, 30 now; seeds: [0, 1] " in message
    assert "environments.short.variants.ramp: only there" in message
    assert "Leave the pipelines out to go on with the one that is there, or give another folder." in message
    assert ["plan.json"] == [path.name for path in folder.iterdir()]


def test_other_versions_are_refused_with_their_names(planned: Planned, folder: Path) -> None:
    save_plan(planned(), folder)
    data = json.loads((folder / "plan.json").read_text())
    data["versions"]["numpy"] = "1.0"
    (folder / "plan.json").write_text(json.dumps(data))
    with pytest.raises(PipelineError, match=r"the study was begun with numpy 1.0 \(now .*install those versions again"):
        run_plan(planned(), folder)


# The command


@pytest.mark.study
@pytest.mark.usefixtures("registry")
def test_the_command_goes_on_without_the_pipelines(planned: Planned, folder: Path) -> None:
    save_plan(planned("alone"), folder)
    result = resume("--out", folder)
    assert 0 == result.exit_code, result.output
    assert "2 runs, 0 failed." in result.output


@pytest.mark.study
@pytest.mark.usefixtures("registry")
def test_the_command_goes_on_with_the_same_pipelines_and_begins_where_there_is_nothing(
    files: dict[str, Path], folder: Path
) -> None:
    for _ in range(2):
        result = resume(files["alone"], "--runs", 1, "--decisions", 5, "--out", folder / "out")
        assert 0 == result.exit_code, result.output
    result = resume(files["alone"], "--runs", 1, "--decisions", 6, "--out", folder / "out")
    assert "What differs: decisions: 5 there, 6 now." in str(result.exception)


@pytest.mark.parametrize(
    ("said", "named"),
    [
        (["--runs", 3], "--runs"),
        (["--seed", 0, "--goal", "turns"], "--goal, --seed"),
        (["--no-controls"], "--controls"),
    ],
)
def test_what_the_plan_says_is_not_said_again(folder: Path, said: list[object], named: str) -> None:
    result = resume("--out", folder, *said)
    assert isinstance(result.exception, PipelineError)
    assert f"--resume with {named}: the plan in {folder} already decides that; leave " in str(result.exception)


def test_there_is_nothing_to_go_on_with_without_a_plan(folder: Path) -> None:
    result = resume("--out", folder)
    assert "there is no plan.json; give the folder that 'compare --out' wrote" in str(result.exception)


@pytest.mark.usefixtures("registry")
def test_a_study_in_the_folder_is_left_alone_without_resume(
    planned: Planned, files: dict[str, Path], folder: Path
) -> None:
    save_plan(planned(), folder)
    result = CliRunner().invoke(app, [str(files["full"]), "--out", str(folder)])
    assert "it holds a study. Add --resume to go on with it, or give a new folder." in str(result.exception)


# The plan's file


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", r"plan.json: cannot be read: .*The study cannot be read; begin it again in another folder"),
        ('{"decisions": 5, "environ', r"plan.json: cannot be read: "),
        ("[]", r"plan.json: this is no plan: it holds a list"),
        ("{}", r"plan.json: this is no plan \(KeyError: 'environments'\)"),
        ('{"environments": [{"name": 3}]}', r"plan.json: this is no plan \(KeyError: 'variants'\)"),
        ('{"environments": 7}', r"plan.json: this is no plan \(TypeError: "),
        ('{"format": 2}', r"it has format 2, and this version of tutorstudent reads format 1. Use the version that "),
    ],
)
def test_a_plan_that_cannot_be_read_is_told_in_a_sentence(folder: Path, text: str, message: str) -> None:
    (folder / "plan.json").write_text(text)
    with pytest.raises(PipelineError, match=message):
        load_plan(folder)


def test_a_plan_with_its_search_can_be_read_again(planned: Planned, folder: Path) -> None:
    plan = planned()
    assert plan.search is not None
    save_plan(plan, folder)
    assert plan == load_plan(folder)


# Files


def test_a_folder_takes_its_place_whole_or_not_at_all(folder: Path) -> None:
    place = folder / "deep" / "place"
    for text in ("one", "two"):
        with replace_folder(place) as partial:
            (partial / "a").write_text(text)
            assert partial.name.startswith(".place.")
        assert {"a": text} == {path.name: path.read_text() for path in place.iterdir()}
    with pytest.raises(FileNotFoundError), replace_folder(place) as partial:
        (partial / "b" / "c").write_text("three")
    assert ["place"] == [path.name for path in place.parent.iterdir()]
    assert ["a"] == [path.name for path in place.iterdir()]


def test_what_is_partial_is_removed_at_any_depth_and_nothing_else(folder: Path) -> None:
    (folder / "runs" / ".x.partial").mkdir(parents=True)
    (folder / "runs" / ".x.partial" / ".y.partial").write_text("")
    (folder / "runs" / "z.partial").write_text("mine")
    write_whole(folder / "runs" / "a", "text")
    remove_partial(folder)
    assert ["a", "z.partial"] == sorted(path.name for path in (folder / "runs").iterdir())
