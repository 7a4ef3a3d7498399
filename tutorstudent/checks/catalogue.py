"""All checks, in the order in which they are made, and the roles that each is for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from tutorstudent.checks import construction, learning, life, manners, process, randomness, special
from tutorstudent.checks.outcome import CheckSkipped, expect
from tutorstudent.checks.roles import USAGES
from tutorstudent.checks.subject import Subject
from tutorstudent.checks.usage import Usage
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.world import World
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import list_names

Function = Callable[[Usage], str | None]
"""A check: a function of how the part is used. Its name is the check's, its docstring what the check is about."""


@dataclass(frozen=True)
class Check:
    """One check of one part: call it.

    Raises, when it is called:
        CheckFailed: if the part does not do what its role promises.
        CheckSkipped: if the check does not apply; test runners count a skipped test.
    """

    name: str
    function: Function
    usage: Usage

    def __call__(self) -> str | None:
        """Make the check, and return what it has to report, if anything."""
        reason = self.usage.subject.waived.get(self.name)
        if reason is not None:
            raise CheckSkipped(f"waived by the part: {reason}")
        try:
            return self.function(self.usage)
        finally:
            self.usage.subject.close_all()

    def __str__(self) -> str:
        return self.name


def waives_with_reasons(usage: Usage) -> None:
    """Every check that the class waives in `waived_checks` exists, and has a reason."""
    known = {function.__name__ for functions in (COMMON, *SPECIAL.values()) for function in functions}
    wrong = [name for name, reason in usage.subject.waived.items() if name not in known or not str(reason).strip()]
    expect(
        not wrong,
        "waived_checks maps names of checks to reasons",
        f"{list_names(wrong)}: unknown, or without a reason; checks are {list_names(known)}",
        "correct the name, or say why the check does not apply",
    )


COMMON: tuple[Function, ...] = (
    construction.is_described,
    construction.options_are_described,
    construction.constructs_with_defaults,
    construction.refuses_unknown_options,
    construction.can_be_written_down,
    waives_with_reasons,
    life.works,
    manners.answers_are_sound,
    manners.changes_nothing_it_is_handed,
    manners.goes_on_after_an_exception,
    life.resets_twice,
    life.closes_twice,
    life.prints_nothing,
    randomness.same_seed_same_answers,
    process.same_answers_in_another_process,
    randomness.has_its_own_random_numbers,
    randomness.leaves_global_random_numbers_alone,
    learning.learned_state_is_plain,
    learning.learned_state_is_a_copy,
    learning.remembers_through_a_file,
    learning.refuses_foreign_learned_state,
    life.keeps_what_it_learned_over_trials,
    life.says_how_long_it_takes,
)
SPECIAL: dict[str, tuple[Function, ...]] = {
    "tutor": (manners.survives_broken_readings,),
    "student": (manners.survives_broken_readings, learning.hands_out_what_it_learned),
    "encoder": (manners.survives_broken_readings,),
    "condition": (manners.survives_broken_readings, special.margins_agree_with_the_condition),
    "codec": (special.says_back_what_it_was_told,),
    "change": (special.grows_with_the_amplification,),
    "world": (
        special.same_seed_same_trial,
        special.states_stay_as_they_were,
        special.draws_itself_with_finite_numbers,
    ),
}


def checks_of(
    part: Component | Callable[[], Component],
    *,
    states: Sequence[Any] | None = None,
    world: World[Any, Any] | None = None,
    action: type[Action] | None = None,
) -> list[Check]:
    """Return the conformance checks of a part, for a parametrized test or a loop of one's own.

    ::

        @pytest.mark.parametrize("check", checks_of(WallFollower(clearance_m=0.3)), ids=str)
        def test_conformance(check):
            check()

    A check that does not apply to a part is waived in its class: ``waived_checks = {"survives_broken_readings": "the
    driver delivers numbers only"}``; it is then reported as skipped, with the reason.

    Args:
        part: An instance that stands in no pipeline (it is copied, never used), or a callable that makes one, such as
            its class.
        states: States to try it with; without them `tutorstudent.checks.subject` says where they come from.
        world: An unbound world to take states from.
        action: The tutor's action class, where neither the part nor its type arguments say.

    Raises:
        PipelineError: if it cannot be made.
        ContractError: if it stands in a pipeline already.
    """
    subject = Subject(part, states, world, action)
    usage = USAGES[subject.cls.role](subject)
    functions = (*COMMON, *SPECIAL.get(subject.cls.role, ()))
    return [Check(function.__name__, function, usage) for function in functions]
