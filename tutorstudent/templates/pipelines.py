"""The example pipeline of a new plugin: the part in its slot, shipped parts in all others."""

from __future__ import annotations

PLAIN = {
    "world": "{use: pioneer, scene: cave-box}",
    "tutor": "prototype2",
    "student": "{use: backprop, encoder: prototype2-bits, codec: kind-level-ampbit}",
    "selector": "same-kind",
    "amplifier": "{use: learning-phase, decisions: 500}",
    "evaluator": "conditions",
    "conditions": "[bumped]",
    "observers": "[attractors]",
}
"""Every slot as it is where the new part does not go."""

_LEVELS = {"selector": "modifier"}

WITH: dict[str, dict[str, str]] = {
    "tutor": {"tutor": "$name", "observers": "[$name-approaches]"},
    "student": {"student": "$name"} | _LEVELS,
    "selector": {"selector": "$name"},
    "amplifier": {"amplifier": "$name"},
    "evaluator": {"evaluator": "$name"},
    "world": {"world": "$name", "observers": "[]"},
    "encoder": {"student": "{use: backprop, encoder: $name, codec: kind-level-ampbit}"},
    "codec": {"student": "{use: backprop, encoder: prototype2-bits, codec: $name}"} | _LEVELS,
    "change": {"amplifier": "{use: learning-phase, decisions: 500, change: $name}"},
    "condition": {"conditions": "[$name]"},
    "observer": {"observers": "[attractors, $name]"},
}
"""What differs, by the role of the new part."""


def fill_slots(role: str, name: str) -> dict[str, str]:
    """Return every slot of a pipeline that uses the part, as YAML.

    >>> fill_slots("tutor", "wall-follower")["tutor"]
    'wall-follower'
    """
    return PLAIN | {slot: value.replace("$name", name) for slot, value in WITH[role].items()}
