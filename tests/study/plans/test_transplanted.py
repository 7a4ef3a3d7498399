"""A learner that begins with what another one learned is compared like any other (Thesis 5.2.3)."""

from __future__ import annotations

from pathlib import Path

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.rundir import run_pipeline, write_run
from tutorstudent.study import Request, make_plan


def test_the_controls_begin_with_nothing_and_the_blind_learner_with_the_same(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    full = Pipeline.read(files["full"], registry)
    write_run(tmp_path / "donor", run_pipeline(full))
    learned = tmp_path / "donor" / "learned.npz"
    plan = make_plan(Request({"carried": full.replaced({"learned": str(learned)})}, runs=1, search_runs=0), registry)
    begin = {variant.name: variant.pipeline["learned"] for variant in plan.environments[0].variants}
    assert {"carried", "blind"} == {name for name, path in begin.items() if path == str(learned)}
    assert {None} == {path for name, path in begin.items() if name not in ("carried", "blind")}
    assert {"tutor-alone", "ramp", "random"} < set(begin)
