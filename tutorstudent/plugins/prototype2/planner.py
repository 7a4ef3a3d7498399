"""A state planner: states, each with its own rules in order of priority (Thesis 3.3.1)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Generic, NamedTuple, TypeVar

from tutorstudent.core.words.errors import ContractError, list_names, suggest

ContextT = TypeVar("ContextT")
CommandT = TypeVar("CommandT")


class Rule(NamedTuple, Generic[ContextT, CommandT]):
    """Condition, action and transition (Thesis 3.3.1)."""

    name: str
    condition: Callable[[ContextT], bool]
    """Whether the rule applies."""
    action: Callable[[ContextT], CommandT] | None
    """What to do; None leaves it to the rules of the next state, in the same decision."""
    transition: str
    """The state that the planner is in afterwards."""


RuleTable = Mapping[str, Sequence[Rule[ContextT, CommandT]]]


class StatePlanner(Generic[ContextT, CommandT]):
    """Acts by the first rule of its state that applies; the rule names the next state.

    >>> planner = StatePlanner({"up": [Rule("turn", bool, str, "down"), Rule("rise", lambda x: True, str, "up")],
    ...                         "down": [Rule("sink", lambda x: True, str, "down")]}, start="up")
    >>> planner.decide(0), planner.state, planner.rule
    ('0', 'up', 'rise')
    >>> planner.decide(1), planner.state, planner.rule
    ('1', 'down', 'turn')
    """

    state: str
    """The state after the last decision."""
    rule: str
    """The rule that acted in the last decision; empty before the first."""

    def __init__(self, table: RuleTable[ContextT, CommandT], start: str) -> None:
        self._table = {state: tuple(rules) for state, rules in table.items()}
        self._start = start
        self._check()
        self.reset()

    def reset(self) -> None:
        """Return to the start state."""
        self.state = self._start
        self.rule = ""

    def decide(self, context: ContextT) -> CommandT:
        """Return the action of the first rule that applies, and make its transition.

        Raises:
            ContractError: If no rule of a state applies, or the states hand the decision on in a circle.
        """
        visited = []
        while self.state not in visited:
            visited.append(self.state)
            rule = self._find_rule(context)
            self.state = rule.transition
            self.rule = rule.name
            if rule.action is not None:
                return rule.action(context)
        path = " -> ".join([*visited, self.state])
        raise ContractError(
            f"state planner: no rule acted; the states passed the decision on in a circle ({path}); "
            "give one of these rules an action."
        )

    def _find_rule(self, context: ContextT) -> Rule[ContextT, CommandT]:
        for rule in self._table[self.state]:
            if rule.condition(context):
                return rule
        raise ContractError(
            f"state planner: no rule of state '{self.state}' applies; end the state with a rule that always does."
        )

    def _check(self) -> None:
        if self._start not in self._table:
            raise ContractError(f"state planner: it starts in {self._explain_unknown(self._start)}.")
        for state, rules in self._table.items():
            if not rules:
                raise ContractError(f"state planner: state '{state}' has no rules; give it one that always applies.")
            for rule in rules:
                if rule.transition not in self._table:
                    where = f"rule '{rule.name}' of state '{state}'"
                    raise ContractError(f"state planner: {where} goes to {self._explain_unknown(rule.transition)}.")

    def _explain_unknown(self, state: str) -> str:
        return f"the unknown state '{state}'{suggest(state, self._table)}; its states are {list_names(self._table)}"
