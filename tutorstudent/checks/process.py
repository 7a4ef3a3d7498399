"""Asks the same part in another process, where hash values, addresses and import order differ."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from typing import Any

from tutorstudent.checks.likeness import digest
from tutorstudent.checks.outcome import CheckSkipped, expect
from tutorstudent.checks.roles import USAGES
from tutorstudent.checks.subject import Subject
from tutorstudent.checks.usage import Usage, collect_answers, make_fresh
from tutorstudent.core.files.assembly import Assembler
from tutorstudent.core.files.plainvalues import make_plain
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import Document
from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.errors import TutorStudentError

TIME_LIMIT_S = 120


def same_answers_in_another_process(usage: Usage) -> None:
    """A new process, in which strings hash otherwise, gives the same answers: runs can be repeated anywhere."""
    recipe = make_recipe(usage.subject)
    here = digest(collect_answers(usage, make_fresh(usage)))
    done = subprocess.run(  # noqa: S603 - this very interpreter
        [sys.executable, "-c", f"from {__name__} import main; main()"],
        input=json.dumps(recipe),
        env=os.environ | {"PYTHONHASHSEED": "1"},
        capture_output=True,
        text=True,
        timeout=TIME_LIMIT_S,
        check=False,
    )
    there = done.stdout.split()[-1:] if done.returncode == 0 else done.stderr.strip().splitlines()[-1:]
    expect(
        there == [here],
        "the same answers in another process",
        f"answers with the fingerprint {here} here, and there {there}",
        "sort sets before you walk through them; use no hash(), id(), clock or working directory",
    )


def make_recipe(subject: Subject) -> dict[str, Any]:
    """Return what another process needs to make the part.

    Raises:
        CheckSkipped: if it cannot make it.
    """
    cls = subject.cls
    if subject.given_states is not None or subject.given_action is not None:
        raise CheckSkipped("states or action were given by hand; `tutorstudent plugins check` makes this check")
    try:
        installed = Registry.discover().get(cls.role, cls.name)
        parts = {"part": subject.sample, "world": subject.world}
        made = {key: make_plain(part.describe(), key) for key, part in parts.items() if part is not None}
    except TutorStudentError as error:
        raise CheckSkipped(f"another process cannot make it: {error}") from error
    if installed is not cls:
        raise CheckSkipped(f"another process finds another {cls.role} named '{cls.name}'")
    return {"role": cls.role} | made


def make(registry: Registry, role: str, values: dict[str, Any], name: str = "part") -> Any:
    """Return the part that plain values name; `name` stands for where they come from."""
    part: Component = Assembler(Document(name, values, {}), registry).make_part(role, values, ())
    return part


def answer(recipe: dict[str, Any]) -> str:
    """Return the fingerprint of what the part of a recipe says."""
    registry = Registry.discover()
    world = make(registry, "world", recipe["world"]) if "world" in recipe else None
    subject = Subject(make(registry, recipe["role"], recipe["part"]), None, world)
    usage = USAGES[recipe["role"]](subject)
    return digest(collect_answers(usage, make_fresh(usage)))


def main() -> None:
    """Answer another process: a recipe on standard input, the fingerprint on standard output."""
    sys.stdout.write(answer(json.loads(sys.stdin.read())) + "\n")
