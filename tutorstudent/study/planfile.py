"""Writes a plan into the folder of its study and reads it again."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from tutorstudent.core.errors import PipelineError
from tutorstudent.core.rundir import versions
from tutorstudent.study.durable import write_whole
from tutorstudent.study.plan import Environment, Plan, Search, Variant

FILE = "plan.json"
FORMAT = 1
"""Of the file; another number is another version's."""


def save_plan(plan: Plan, folder: Path) -> None:
    """Write the plan into the folder of its study, completely or not at all."""
    data = {"format": FORMAT, "versions": versions()} | as_data(plan)
    write_whole(folder / FILE, json.dumps(data, indent=1) + "\n")


def load_plan(folder: Path) -> Plan:
    """Read the plan of a study.

    Raises:
        PipelineError: if the folder holds none, or one that is damaged or another version's.
    """
    data = _read(folder)
    try:
        return _plan(data)
    except (KeyError, TypeError, AttributeError, ValueError) as error:
        raise PipelineError(f"{folder / FILE}: this is no plan ({type(error).__name__}: {error}). {_REMEDY}") from None


def check_versions(folder: Path) -> None:
    """Refuse to add runs to a study that was begun with other versions: its runs could not be compared.

    Raises:
        PipelineError: if one of them is another now.
    """
    there = _read(folder).get("versions", {})
    changed = [f"{name} {there[name]} (now {now})" for name, now in versions().items() if there.get(name, now) != now]
    if changed:
        raise PipelineError(
            f"{folder}: the study was begun with {', '.join(changed)}. Runs of different versions cannot be compared; "
            "install those versions again, or begin a new study in another folder."
        )


def as_data(plan: Plan) -> dict[str, Any]:
    """Return the plan as what JSON can hold."""
    search = plan.search
    return {
        "decisions": plan.decisions,
        "seeds": list(plan.seeds),
        "environments": [
            environment._asdict() | {"variants": [variant._asdict() for variant in environment.variants]}
            for environment in plan.environments
        ],
        "search": search and search._asdict() | {"plan": as_data(search.plan)},
    }


_REMEDY = "The study cannot be read; begin it again in another folder."


def _read(folder: Path) -> dict[str, Any]:
    try:
        data = json.loads((folder / FILE).read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise PipelineError(f"{folder}: there is no {FILE}; give the folder that 'compare --out' wrote.") from None
    except (OSError, ValueError) as error:
        raise PipelineError(f"{folder / FILE}: cannot be read: {error}. {_REMEDY}") from None
    if not isinstance(data, dict):
        raise PipelineError(f"{folder / FILE}: this is no plan: it holds a {type(data).__name__}. {_REMEDY}")
    found = data.get("format", FORMAT)
    if found != FORMAT:
        raise PipelineError(
            f"{folder / FILE}: it has format {found!r}, and this version of tutorstudent reads format {FORMAT}. "
            "Use the version that wrote it, or make the study again."
        )
    return data


def _plan(data: dict[str, Any]) -> Plan:
    environments = tuple(
        Environment(item["name"], tuple(Variant(**variant) for variant in item["variants"]), item["reference"])
        for item in data["environments"]
    )
    search = data.get("search")
    return Plan(
        environments,
        tuple(map(int, data["seeds"])),
        int(data["decisions"]),
        search and Search(search["goal"], search["harm_budget"], _plan(search["plan"])),
    )
