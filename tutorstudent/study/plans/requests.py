"""What a person asks to compare, as plain values: files, settings and environments."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.settings import read_key_value, split_setting
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.core.words.errors import PipelineError

ANY = "pipeline"
"""The stem of files that are named after their folder."""


class Setting(NamedTuple):
    """One value for a dotted key of a pipeline, as in ``world.scene=cave-box``."""

    key: str
    value: Any

    @property
    def label(self) -> str:
        """A word for an environment: the value itself where it is a word, else with its key."""
        if isinstance(self.value, str):
            return make_slug(Path(self.value).stem if "/" in self.value else self.value)
        return make_slug(f"{self.key.rpartition('.')[2]}-{self.value}")

    def apply(self, pipeline: Pipeline) -> Pipeline:
        """Return the pipeline with this value; PipelineError if it has no such key."""
        return pipeline.replaced({self.key: self.value})


class Request(NamedTuple):
    """What is to be compared."""

    pipelines: Mapping[str, Pipeline]
    """By name."""
    runs: int
    first_seed: int = 0
    """Run i has the seed ``first_seed + i``."""
    decisions: int | None = None
    """None: as many as all files say."""
    variations: Sequence[Setting] = ()
    """One environment for each; none: the world of the files."""
    controls: bool = True
    goal: str = ""
    """What a run should maximise, of its summary, such as ``attractors``; empty: what the learner's observers
    count first, else what its world says."""
    harm_budget: float = 0.001
    """Share of decisions that the best constant level may violate, 0 to 1."""
    search_runs: int = 2
    """Of each constant level in each environment, on seeds of their own; 0: no search."""


def make_slug(text: str) -> str:
    """Return a text as a word that names a folder.

    >>> make_slug("../my scene.yaml")
    'my-scene.yaml'
    """
    return re.sub(r"[^\w.+-]+", "-", text).strip("-.") or "unnamed"


def read_setting(option: str, text: str) -> Setting:
    """Read ``key=value``; the value is YAML."""
    return Setting(*read_key_value(option, text))


def read_variation(option: str, text: str) -> list[Setting]:
    """Read ``key=value,value,...`` into one setting for each value.

    Raises:
        PipelineError: if there is no value, or one twice.
    """
    key, values = split_setting(option, text)
    found = parse_yaml(f"[{values}]", f"{option} {text}").data
    settings = [Setting(key, value) for value in found]
    if not settings:
        raise PipelineError(f"{option} {text}: there are no values; write them with commas, as in {key}=a,b.")
    labels = [setting.label for setting in settings]
    twice = next((label for label in labels if labels.count(label) > 1), None)
    if twice is not None:
        raise PipelineError(f"{option} {text}: two environments would be named '{twice}'; give each value once.")
    return settings


def read_pipelines(paths: Sequence[Path], registry: Registry) -> dict[str, Pipeline]:
    """Read the pipelines by name: each is named after its file, or after the folder of a file ``pipeline.yaml``.

    Raises:
        PipelineError: if there is none, one cannot be read, or two have one name.
    """
    if not paths:
        raise PipelineError("compare: there is no pipeline; give at least one YAML file.")
    found: dict[str, tuple[Path, Pipeline]] = {}
    for path in paths:
        name = _find_name(path)
        if name in found:
            raise PipelineError(
                f"compare: {found[name][0]} and {path} would both be named '{name}'; rename one of the files."
            )
        found[name] = path, Pipeline.read(path, registry)
    return {name: pipeline for name, (_, pipeline) in found.items()}


def _find_name(path: Path) -> str:
    """Return the file's name, or its folder's where it is ``pipeline.yaml``, which is the name of many."""
    return make_slug(path.resolve().parent.name if path.stem == ANY else path.stem)
