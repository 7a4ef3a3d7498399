from __future__ import annotations

import pytest

from tutorstudent.core.words.errors import ContractError
from tutorstudent.plugins.prototype2.planner import Rule, StatePlanner

Seen = frozenset[str]


def when(*words: str) -> object:
    return lambda seen: seen >= set(words)


def say(word: str) -> object:
    return lambda seen: word


def planner(table: dict[str, list[Rule]], start: str = "a") -> StatePlanner:
    return StatePlanner(table, start=start)


def test_the_first_applicable_rule_acts_whatever_stands_behind_it() -> None:
    rules = [Rule(word, when(word), say(word), "a") for word in ("x", "y", "z")]
    plan = planner({"a": rules})
    assert plan.decide(frozenset("xyz")) == "x"
    assert plan.decide(frozenset("zy")) == "y"
    assert plan.decide(frozenset("z")) == "z"


def test_conditions_behind_the_first_applicable_rule_are_not_asked() -> None:
    asked = []
    rules = [Rule(word, lambda seen, word=word: not asked.append(word), say(word), "a") for word in "xy"]
    planner({"a": rules}).decide(frozenset())
    assert asked == ["x"]


def test_a_transition_takes_effect_in_the_next_decision() -> None:
    plan = planner({"a": [Rule("go", when(), say("from a"), "b")], "b": [Rule("stay", when(), say("from b"), "b")]})
    said = [plan.decide(frozenset()) for _ in range(3)]
    assert said == ["from a", "from b", "from b"]


def test_state_and_rule_tell_about_the_last_decision() -> None:
    plan = planner({"a": [Rule("go", when(), say("x"), "b")], "b": [Rule("stay", when(), say("y"), "b")]})
    assert (plan.state, plan.rule) == ("a", "")
    plan.decide(frozenset())
    assert (plan.state, plan.rule) == ("b", "go")


def test_a_rule_without_action_leaves_the_same_decision_to_the_next_state() -> None:
    plan = planner(
        {
            "a": [Rule("pass on", when("p"), None, "b"), Rule("act", when(), say("a"), "a")],
            "b": [Rule("pass on", when(), None, "c")],
            "c": [Rule("act", when(), say("c"), "a")],
        }
    )
    assert (plan.decide(frozenset("p")), plan.state, plan.rule) == ("c", "a", "act")


def test_reset_returns_to_the_start_state() -> None:
    plan = planner({"a": [Rule("go", when(), say("x"), "b")], "b": [Rule("stay", when(), say("y"), "b")]})
    plan.decide(frozenset())
    plan.reset()
    assert (plan.state, plan.rule) == ("a", "")


def test_later_changes_of_the_table_do_not_change_the_planner() -> None:
    table = {"a": [Rule("act", when(), say("x"), "a")]}
    plan = planner(table)
    table["a"].clear()
    assert plan.decide(frozenset()) == "x"


@pytest.mark.parametrize(
    ("table", "start", "message"),
    [
        (
            {"a": [Rule("go", when(), say("x"), "Avoid Spni")], "Avoid Spin": [Rule("spin", when(), say("y"), "a")]},
            "a",
            (
                "state planner: rule 'go' of state 'a' goes to the unknown state 'Avoid Spni' "
                "(did you mean 'Avoid Spin'?); its states are Avoid Spin, a."
            ),
        ),
        (
            {"a": [Rule("go", when(), say("x"), "a")]},
            "Forward",
            "state planner: it starts in the unknown state 'Forward'; its states are a.",
        ),
        (
            {"a": [Rule("go", when(), say("x"), "a")], "b": []},
            "a",
            "state planner: state 'b' has no rules; give it one that always applies.",
        ),
        ({}, "a", "state planner: it starts in the unknown state 'a'; its states are none."),
    ],
)
def test_a_broken_table_is_refused_with_what_is_wrong_and_where(
    table: dict[str, list[Rule]], start: str, message: str
) -> None:
    with pytest.raises(ContractError) as error:
        planner(table, start)
    assert str(error.value) == message


def test_a_decision_that_no_rule_takes_is_an_error_that_names_the_state() -> None:
    plan = planner({"a": [Rule("x", when("x"), say("x"), "a")]})
    with pytest.raises(ContractError) as error:
        plan.decide(frozenset("y"))
    assert str(error.value) == (
        "state planner: no rule of state 'a' applies; end the state with a rule that always does."
    )


def test_a_decision_handed_on_in_a_circle_is_an_error_that_shows_the_circle() -> None:
    plan = planner({"a": [Rule("on", when(), None, "b")], "b": [Rule("back", when(), None, "a")]})
    with pytest.raises(ContractError) as error:
        plan.decide(frozenset())
    assert str(error.value) == (
        "state planner: no rule acted; the states passed the decision on in a circle (a -> b -> a); "
        "give one of these rules an action."
    )
