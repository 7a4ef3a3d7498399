"""A reward from what a world counts, for learners that need one."""

from __future__ import annotations

from collections.abc import Mapping

from tutorstudent.core.words.errors import ContractError, list_names, suggest

Weights = Mapping[str, float]
"""What one unit of an event is worth, by name."""


def check_weights(weights: Weights, known: Mapping[str, object]) -> Weights:
    """Return the weights; ContractError if one is about an event that nobody reports."""
    for name in weights:
        if name not in known:
            raise ContractError(
                f"weights: there is no event '{name}'{suggest(name, known)}; events: {list_names(known)}."
            )
    return weights


def score(weights: Weights, events: Mapping[str, float]) -> float:
    """Return the sum of the events, each by its weight.

    >>> score({"collided": -1.0}, {"collided": 1.0, "distance_m": 0.2})
    -1.0
    """
    return float(sum(weight * events.get(name, 0.0) for name, weight in weights.items()))
