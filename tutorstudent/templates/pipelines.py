"""The example pipeline of a new plugin: the part in its slot, shipped parts in all others."""

from __future__ import annotations

PLAIN = {
    "world": "{use: pioneer, scene: cave-box}",
    "tutor": "prototype2",
    "student": "budgeted",
    "selector": "modifier",
    "amplifier": "never",
    "evaluator": "conditions",
    "conditions": "[bumped]",
    "observers": "[attractors]",
}
"""Every slot as it is where the new part does not go."""

_NETWORK = "{use: backprop, encoder: prototype2-bits, codec: kind-level-ampbit}"
_THESIS = {"student": _NETWORK, "selector": "same-kind", "amplifier": "{use: learning-phase, decisions: 500}"}
"""The thesis's student, for parts that it needs."""

WITH: dict[str, dict[str, str]] = {
    "tutor": {"tutor": "$name", "observers": "[$name-approaches]"},
    "student": _THESIS | {"student": "$name", "selector": "modifier"},
    "selector": _THESIS | {"selector": "$name"},
    "amplifier": _THESIS | {"amplifier": "$name"},
    "evaluator": _THESIS | {"evaluator": "$name"},
    "world": {"world": "$name", "observers": "[]"},
    "encoder": _THESIS | {"student": _NETWORK.replace("prototype2-bits", "$name")},
    "codec": _THESIS | {"student": _NETWORK.replace("kind-level-ampbit", "$name"), "selector": "modifier"},
    "change": _THESIS | {"amplifier": "{use: learning-phase, decisions: 500, change: $name}"},
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
