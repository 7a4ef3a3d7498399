"""Which branches of guard, limits, corrections and last gate a soak has passed, and how often."""

from __future__ import annotations

from collections import Counter
from typing import Any

KINDS = {
    "student": ("raised", "wrong-return", "mutated"),
    "selector": ("raised", "wrong-return", "mutated", "out-of-bounds"),
    "amplifier": ("raised", "wrong-return", "mutated", "out-of-bounds"),
    "conditions.flag": ("raised", "wrong-return", "not-finite"),
    "evaluator": ("raised", "wrong-return", "mutated", "out-of-bounds"),
}
LIMITED = ("cap", "factor", "slew", "highest level", "bounds", "nothing to move", "executed")
TOLD = ("dropped", "an emergency stop", "something else was executed")
BOTH = (
    *(f"incident: {part} {kind}" for part, kinds in KINDS.items() for kind in kinds),
    *(f"limited by: {name}" for name in LIMITED),
    *(f"teaches nothing: {reason}" for reason in TOLD),
    "executed: another level",
)
ENGINE = (*BOTH, "incident: action raised")
GATE = {
    "changed the controller's own": "gate: the controller's own was changed",
    "which is not declared": "gate: something else was changed",
    "so the controller's own": "gate: the controller's own was changed",
    "the command that was written says": "gate: a number was refused",
}
"""Words of an incident of the action, and the refusal that they come from."""
WRAP = (
    *BOTH,
    "incident: action raised",
    "incident: action mutated",
    "incident: action not-finite",
    "incident: action out-of-bounds",
    *dict.fromkeys(GATE.values()),
    "gate: it could not be read or written",
    "gate: passed as it was written",
    "the controller failed",
)


def count_turn(hits: Counter[str], turn: Any) -> None:
    """Count what became of a decision that is over."""
    for incident in turn.incidents:
        hits[f"incident: {incident.part} {incident.kind}"] += 1
        if incident.part == "action":
            hits[name_refusal(incident.message)] += 1
    if turn.limited_by:
        hits[f"limited by: {turn.limited_by}"] += 1
    if turn.void:
        hits[f"teaches nothing: {turn.void}"] += 1
    elif turn._asked.resulting.level != turn.decision.resulting.level:
        hits["executed: another level"] += 1


def name_refusal(message: str) -> str:
    """Return which refusal of the last gate an incident's message comes from."""
    return next((name for words, name in GATE.items() if words in message), "gate: it could not be read or written")


def find_missing(hits: Counter[str], expected: tuple[str, ...], least: int) -> list[str]:
    """Return the branches that were passed too rarely."""
    return [f"only {hits[name]} of {least} times: {name}" for name in expected if hits[name] < least]
