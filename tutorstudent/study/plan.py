"""A plan: which pipelines run in which environments, with which seeds. Plain values, so that it can be read again."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

from tutorstudent.core.errors import PipelineError

FILE = "plan.json"


class Variant(NamedTuple):
    """One pipeline in one environment: a row of a table."""

    name: str
    about: str
    """One sentence for people: the file, or what the control does."""
    control: bool
    pipeline: dict[str, Any]
    """Every value written out; can be read as a pipeline again."""
    counters: dict[str, str]
    """What its observers count, such as ``attractors``, and the situation whose entries that is."""


class Environment(NamedTuple):
    """A world with everything that is compared in it."""

    name: str
    variants: tuple[Variant, ...]
    reference: str
    """Name of the tutor alone, to which the others are compared; empty where there is none."""

    def counters(self) -> dict[str, str]:
        """Return what any of the variants counts."""
        return {key: situation for variant in self.variants for key, situation in variant.counters.items()}


class Job(NamedTuple):
    """One run."""

    environment: str
    variant: str
    seed: int
    decisions: int
    pipeline: dict[str, Any]

    @property
    def folder(self) -> Path:
        """Where its results stand, below the folder of the study."""
        return Path("runs", self.environment, self.variant, str(self.seed))


class Plan(NamedTuple):
    """What a comparison is going to run."""

    environments: tuple[Environment, ...]
    seeds: tuple[int, ...]
    """Run i has the same seed for every variant and control."""
    decisions: int

    def jobs(self) -> list[Job]:
        """Return all runs, seed by seed, so that what an interrupted study leaves behind is paired."""
        return [
            Job(environment.name, variant.name, seed, self.decisions, variant.pipeline)
            for seed in self.seeds
            for environment in self.environments
            for variant in environment.variants
        ]

    def variants(self) -> list[Variant]:
        """Return one variant of each name over all environments: those that were given, then controls."""
        found = {variant.name: variant for environment in self.environments for variant in environment.variants}
        return sorted(found.values(), key=lambda variant: variant.control)


def save_plan(plan: Plan, folder: Path) -> None:
    """Write the plan into the folder of its study."""
    data = {
        "decisions": plan.decisions,
        "seeds": list(plan.seeds),
        "environments": [
            environment._asdict() | {"variants": [variant._asdict() for variant in environment.variants]}
            for environment in plan.environments
        ],
    }
    (folder / FILE).write_text(json.dumps(data, indent=1, default=str) + "\n", encoding="utf-8")


def load_plan(folder: Path) -> Plan:
    """Read the plan of a study.

    Raises:
        PipelineError: if the folder holds none.
    """
    try:
        data = json.loads((folder / FILE).read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise PipelineError(f"{folder}: there is no {FILE}; give the folder that 'compare --out' wrote.") from None
    except (OSError, ValueError) as error:
        raise PipelineError(f"{folder / FILE}: cannot be read: {error}.") from None
    return Plan(
        tuple(
            Environment(item["name"], tuple(Variant(**variant) for variant in item["variants"]), item["reference"])
            for item in data["environments"]
        ),
        tuple(data["seeds"]),
        data["decisions"],
    )
