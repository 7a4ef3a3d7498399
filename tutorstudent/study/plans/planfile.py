"""Writes a plan into the folder of its study and reads it again."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tutorstudent.core.files.durable import write_whole
from tutorstudent.core.files.provenance import find_versions
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study.plans.plan import Environment, Plan, Search, Variant

FILE = "plan.json"
FORMAT = 1
"""Version of the file's format."""


def save_plan(plan: Plan, folder: Path) -> None:
    """Write the plan into the folder of its study, completely or not at all."""
    data = {"format": FORMAT, "versions": find_versions()} | make_data(plan)
    write_whole(folder / FILE, json.dumps(data, indent=1) + "\n")


def load_plan(folder: Path) -> Plan:
    """Read the plan of a study.

    Raises:
        PipelineError: if the folder holds none, or one that is damaged or another version's.
    """
    data = _read(folder)
    try:
        return _make_plan(data)
    except (KeyError, TypeError, AttributeError, ValueError) as error:
        raise PipelineError(f"{folder / FILE}: this is no plan ({type(error).__name__}: {error}). {_REMEDY}") from None


def check_versions(folder: Path) -> None:
    """Refuse to add runs to a study that was begun with other versions: its runs could not be compared.

    Raises:
        PipelineError: if one of them is another now.
    """
    there = _read(folder).get("versions", {})
    changed = [
        f"{name} {there[name]} (now {now})" for name, now in find_versions().items() if there.get(name, now) != now
    ]
    if changed:
        raise PipelineError(
            f"{folder}: the study was begun with {', '.join(changed)}. Runs of different versions cannot be compared; "
            "install those versions again, or begin a new study in another folder."
        )


def make_data(plan: Plan) -> dict[str, Any]:
    """Return the plan as what JSON can hold."""
    search = plan.search
    return {
        "decisions": plan.decisions,
        "seeds": list(plan.seeds),
        "environments": [
            environment._asdict() | {"variants": [variant._asdict() for variant in environment.variants]}
            for environment in plan.environments
        ],
        "search": search and search._asdict() | {"plan": make_data(search.plan)},
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


def _make_plan(data: dict[str, Any]) -> Plan:
    environments = tuple(
        Environment(item["name"], tuple(Variant(**variant) for variant in item["variants"]), item["reference"])
        for item in data["environments"]
    )
    search = data.get("search")
    return Plan(
        environments,
        tuple(map(int, data["seeds"])),
        int(data["decisions"]),
        search and Search(search["goal"], search["harm_budget"], _make_plan(search["plan"])),
    )


SHOWN = 5


def find_differences(there: Any, asked: Any) -> str:
    """Return the first few differences of two nested values; lists of named things are compared by name.

    Args:
        there: What stands in the folder.
        asked: What is asked for now.

    >>> find_differences({"seeds": [0, 1], "decisions": 60}, {"seeds": [0, 1], "decisions": 30})
    'decisions: 60 there, 30 now'
    """
    found = list(_walk(there, asked, ""))
    more = f"; and {len(found) - SHOWN} more" if len(found) > SHOWN else ""
    return "; ".join(found[:SHOWN]) + more


def _walk(there: Any, asked: Any, at: str) -> Iterator[str]:
    there, asked = _index_by_name(there), _index_by_name(asked)
    if not (isinstance(there, dict) and isinstance(asked, dict)):
        if there != asked:
            yield f"{at}: {_shorten(there)} there, {_shorten(asked)} now"
        return
    for key in there | asked:
        below = f"{at}.{key}" if at else str(key)
        if key not in asked:
            yield f"{below}: only there"
        elif key not in there:
            yield f"{below}: only now"
        else:
            yield from _walk(there[key], asked[key], below)


def _index_by_name(value: Any) -> Any:
    if isinstance(value, list) and value and all(isinstance(item, dict) and "name" in item for item in value):
        return {item["name"]: item for item in value}
    return value


def _shorten(value: Any) -> str:
    text = json.dumps(value, default=str)
    return text if len(text) <= 60 else f"{text[:57]}..."
