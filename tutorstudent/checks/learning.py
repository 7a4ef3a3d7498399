"""Checks of what a part learned: handed out, stored and taken back."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from tutorstudent.checks.likeness import take_snapshot
from tutorstudent.checks.outcome import RAISED, CheckFailed, CheckSkipped, describe_error, expect
from tutorstudent.checks.subject import SEED, walk_family
from tutorstudent.checks.usage import Usage, collect_answers, make_fresh
from tutorstudent.core.roles.binding import make_stream
from tutorstudent.core.roles.part import Learned
from tutorstudent.core.running.arrays import flatten, load_arrays, nest, save_arrays
from tutorstudent.core.words.errors import TutorStudentError, list_names


def learned_state_is_plain(usage: Usage) -> None:
    """`state_dict` holds arrays, numbers, strings and mappings of these: nothing that would need pickle."""
    try:
        arrays = flatten(_learn(usage))
    except TutorStudentError as error:
        raise CheckFailed("the keys of state_dict() are strings", describe_error(error), "use strings") from error
    strange = [path for path, array in arrays.items() if array.dtype.hasobject]
    expect(
        not strange,
        "state_dict() holds arrays and plain values only",
        f"objects at {list_names(strange)}",
        "hand out np.asarray(...) of what the object holds, and build the object anew in load_state_dict()",
    )


def learned_state_is_a_copy(usage: Usage) -> None:
    """What `state_dict` handed out stays as it was when more is learned."""
    part = make_fresh(usage)
    collect_answers(usage, part)
    handed = _require_some(part.state_dict())
    before = take_snapshot(handed)
    collect_answers(usage, part)
    expect(
        before == take_snapshot(handed),
        "state_dict() hands out copies",
        "what it handed out changed when the part was used again",
        "copy arrays and mappings: {name: array.copy() for ...}",
    )


def remembers_through_a_file(usage: Usage) -> None:
    """A fresh part that takes back what was stored (an .npz without pickle) says the same from then on."""
    part = make_fresh(usage)
    collect_answers(usage, part)
    stored = _store(_require_some(part.state_dict()))
    other = make_fresh(usage)
    try:
        other.load_state_dict(stored)
    except RAISED as error:
        raise CheckFailed(
            "load_state_dict() takes back what state_dict() handed out, after a file",
            describe_error(error),
            "a file gives arrays back as arrays, and arrays without dimensions as plain values; read both",
        ) from error
    here, there = _recall(usage, part), _recall(usage, other)
    differing = [number for number, pair in enumerate(zip(here, there, strict=True)) if pair[0] != pair[1]]
    expect(
        not differing,
        "a fresh part with the learned state answers like the one that learned",
        f"{len(differing)} of {len(here)} answers differ",
        "hand out everything that answers depend on, and take all of it back",
    )


def refuses_foreign_learned_state(usage: Usage) -> None:
    """Learned state of another part is an error, not silently ignored."""
    part = make_fresh(usage)
    try:
        part.load_state_dict({"no_such_name": 1.0})
    except TutorStudentError:
        return
    except RAISED as error:
        raise CheckFailed(
            "a ContractError that says what is not known",
            describe_error(error),
            "raise ts.ContractError for names that it does not know",
        ) from error
    raise CheckFailed(
        "learned state with a name that it does not know is refused",
        "load_state_dict({'no_such_name': 1.0}) was taken",
        "raise ts.ContractError for names that it does not know, or call super().load_state_dict()",
    )


def hands_out_what_it_learned(usage: Usage) -> None:
    """A student that answers otherwise after its lessons hands out something in `state_dict`, or it would be lost."""
    taught, untaught = make_fresh(usage), make_fresh(usage)
    collect_answers(usage, taught)
    if _recall(usage, taught) == _recall(usage, untaught):
        raise CheckSkipped("it answers as before after its lessons")
    expect(
        bool(taught.state_dict()),
        "state_dict() holds what was learned",
        "lessons changed its answers, and state_dict() is empty",
        "implement state_dict() and load_state_dict()",
    )


def _learn(usage: Usage) -> Learned:
    part = make_fresh(usage)
    collect_answers(usage, part)
    return _require_some(part.state_dict())


def _require_some(learned: Learned) -> Learned:
    if not learned:
        raise CheckSkipped("it has learned nothing that it hands out in state_dict()")
    return learned


def _store(learned: Learned) -> Learned:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "learned.npz"
        try:
            save_arrays(path, flatten(learned))
        except (ValueError, TutorStudentError) as error:
            raise CheckSkipped(
                f"it cannot be stored, see the check 'learned_state_is_plain': {describe_error(error)}"
            ) from error
        return nest(load_arrays(path))


def _recall(usage: Usage, part: Any) -> list[Any]:
    # Both begin with the same random numbers: what is left to differ is what was learned.
    for member in walk_family(part):
        member.rng = make_stream(SEED, member.slot)
    usage.begin(part)
    return [take_snapshot(usage.recall(part, question)) for question in usage.make_usual()]
