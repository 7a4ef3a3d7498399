"""A plan: which pipelines run in which environments, with which seeds. Plain values; `planfile` writes and reads it."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple


class Variant(NamedTuple):
    """One pipeline in one environment: a row of a table."""

    name: str
    about: str
    """One sentence for people: the file, or what the control does."""
    control: bool
    pipeline: dict[str, Any]
    """Every value written out; can be read as a pipeline again."""
    counters: dict[str, str]
    """What is counted, such as ``attractors``, the goal first, and the situation whose entries that is; empty for any
    other number of a run's summary, such as the world's event ``encounters``."""


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
    search: Search | None = None
    """What is run first, where a control's level has to be looked for."""

    @property
    def goal(self) -> str:
        """What a run should maximise, of its summary; empty where nothing counts that."""
        counters = [key for environment in self.environments for key in environment.counters()]
        return self.search.goal if self.search else next(iter(counters), "")

    def jobs(self) -> list[Job]:
        """Return all runs but the search's, seed by seed, so that an interrupted study leaves complete pairs."""
        return [
            Job(environment.name, variant.name, seed, self.decisions, variant.pipeline)
            for seed in self.seeds
            for environment in self.environments
            for variant in environment.variants
        ]

    def variants(self) -> list[Variant]:
        """Return one variant of each name over all environments: those that were given, then controls.

        Where its sentence differs between environments, such as by a level, it says what holds in which.
        """
        found: dict[str, dict[str, Variant]] = {}
        for environment in self.environments:
            for variant in environment.variants:
                found.setdefault(variant.name, {})[environment.name] = variant
        return sorted(map(_merge, found.values()), key=lambda variant: variant.control)


class Search(NamedTuple):
    """The search for the level of the control ``best-constant``: the tutor alone and constant levels."""

    goal: str
    """Of a run's summary; the level with the highest mean is the best."""
    harm_budget: float
    """Share of decisions that may be violated, 0 to 1."""
    plan: Plan
    """On seeds of its own."""


def _merge(variants: dict[str, Variant]) -> Variant:
    """Return one variant for all environments; `variants` are by environment."""
    *_, last = variants.values()
    if len({variant.about for variant in variants.values()}) == 1:
        return last
    return last._replace(about=" ".join(f"In {name}: {variant.about}" for name, variant in variants.items()))
