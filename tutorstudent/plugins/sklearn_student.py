"""A student made of a scikit-learn regressor that learns online (``pip install 'tutorstudent[sklearn]'``)."""

from __future__ import annotations

from typing import Any, Generic

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.leaves import Vector
from tutorstudent.core.roles.part import Component, Field, Learned
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.proposals import ProposalT
from tutorstudent.core.words.records import StateT
from tutorstudent.plugins import estimators
from tutorstudent.plugins.coded_student import CodedStudent, propose_untaught
from tutorstudent.plugins.estimator_state import export_state, fill_state


class SklearnStudent(CodedStudent[StateT, ActionT, ProposalT], Generic[StateT, ActionT, ProposalT]):
    """Any scikit-learn regressor with ``partial_fit`` ("any type of function approximator", Thesis 3.2.2.2).

    An estimator of one output is repeated for each. Before its first lesson it proposes as one that was taught nothing
    (see `propose_untaught`). What it learned can be saved if it is made of arrays and plain values, as that of
    ``MLPRegressor`` and ``SGDRegressor`` is.
    """

    name = "sklearn"

    class Options(CodedStudent.Options):
        """The estimator, by its import path."""

        estimator: str = Field(
            pattern=r"^[A-Za-z_]\w*(\.[A-Za-z_]\w*)+$",
            description="import path of the estimator's class, such as sklearn.neural_network.MLPRegressor",
        )
        params: dict[str, Any] = Field(default_factory=dict, description="parameters of the estimator, by name")
        teaching_rate: int = Field(3, ge=1, le=1000, description="iterations for each lesson")

    def setup(self) -> None:
        super().setup()
        self._untaught = propose_untaught(self.codec)
        self._widths = (self.encoder.width, self.codec.width)
        self._prototype = estimators.make_estimator(self.options.estimator, self.options.params, self._widths, self.rng)
        self._learner: Any = None
        """What was taught so far: None before the first lesson."""

    def answer(self, inputs: Vector) -> ProposalT:
        if self._learner is None:
            return self._untaught
        return self.codec.decode(estimators.ask(self._learner, inputs))

    def learn(self, inputs: Vector, targets: Vector) -> None:
        if self._learner is None:
            self._learner = estimators.copy_unfitted(self._prototype)
        for _ in range(self.options.teaching_rate):
            estimators.teach(self._learner, inputs, targets)

    def export(self) -> Learned:
        return {} if self._learner is None else {"estimator": export_state(self._learner, self._where)}

    def restore(self, learned: Learned) -> None:
        if not learned:
            self._learner = None
            return
        template = estimators.copy_fitted(self._prototype, self._widths)
        self._learner = fill_state({"estimator": template}, learned, self._where)["estimator"]

    @property
    def _where(self) -> str:
        return f"student '{self.name}', {self.options.estimator}"


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the scikit-learn student."""
    return [SklearnStudent]
