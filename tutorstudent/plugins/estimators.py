"""Scikit-learn estimators by their import path. Imports scikit-learn only when asked for one."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Mapping
from typing import Any

import numpy as np

from tutorstudent.core.words.errors import PipelineError, list_names, suggest

_EXAMPLES = "for example sklearn.neural_network.MLPRegressor or sklearn.linear_model.SGDRegressor"


def find_estimator(path: str) -> type[Any]:
    """Return the class of an online regressor.

    Args:
        path: Import path such as ``sklearn.neural_network.MLPRegressor``.

    Raises:
        PipelineError: Scikit-learn is missing, or the path names no regressor of its kind with ``partial_fit``.
    """
    try:
        base: Any = importlib.import_module("sklearn.base")
    except ModuleNotFoundError:
        raise PipelineError(
            "student 'sklearn' needs scikit-learn; install it with: pip install 'tutorstudent[sklearn]'"
        ) from None
    found = _import(path)
    if not (isinstance(found, type) and issubclass(found, base.BaseEstimator) and hasattr(found, "partial_fit")):
        raise PipelineError(f"estimator '{path}' is no scikit-learn estimator with partial_fit; use {_EXAMPLES}.")
    return found


def _import(path: str) -> Any:
    module_name, _, name = path.rpartition(".")
    try:
        module = importlib.import_module(module_name)
    except ImportError as error:
        raise PipelineError(f"estimator '{path}': module '{module_name}' cannot be imported ({error}).") from None
    if not hasattr(module, name):
        online = [key for key, value in vars(module).items() if hasattr(value, "partial_fit")]
        raise PipelineError(
            f"estimator '{path}': module '{module_name}' has no '{name}'{suggest(name, online)}; "
            f"what has partial_fit there: {list_names(online)}."
        )
    return getattr(module, name)


def make_estimator(path: str, params: Mapping[str, Any], widths: tuple[int, int], rng: np.random.Generator) -> Any:
    """Return an estimator that has learned nothing and is known to learn the given widths.

    An estimator of one output is put into a ``MultiOutputRegressor``. One that has a ``random_state`` which `params`
    leave out is seeded from `rng`.

    Args:
        path: Import path of its class.
        params: Its parameters.
        widths: Number of inputs and of outputs.
        rng: Where a missing ``random_state`` comes from.

    Raises:
        PipelineError: There is no such estimator, or it does not take these parameters or learn these widths.
    """
    cls = find_estimator(path)
    known = inspect.signature(cls).parameters
    unknown = [name for name in params if name not in known]
    if unknown:
        raise PipelineError(
            f"estimator '{path}' has no parameter '{unknown[0]}'{suggest(unknown[0], known)}; "
            f"parameters: {list_names(known)}."
        )
    seeded = {"random_state": int(rng.integers(2**31 - 1))} if "random_state" in known else {}
    try:
        return _cover_outputs(cls(**{**seeded, **params}), widths)
    except (TypeError, ValueError) as error:
        raise PipelineError(f"estimator '{path}' cannot learn {widths[0]} -> {widths[1]} numbers: {error}") from None


def _cover_outputs(estimator: Any, widths: tuple[int, int]) -> Any:
    from sklearn.base import is_regressor

    if not is_regressor(estimator):
        raise TypeError(f"it is no regressor; use {_EXAMPLES}.")
    try:
        copy_fitted(estimator, widths)
    except ValueError as error:
        return _repeat(estimator, widths, error)
    return estimator


def _repeat(estimator: Any, widths: tuple[int, int], reason: ValueError) -> Any:
    from sklearn.multioutput import MultiOutputRegressor

    repeated = MultiOutputRegressor(estimator=estimator)
    try:
        copy_fitted(repeated, widths)
    except (TypeError, ValueError):
        raise reason from None
    return repeated


def copy_unfitted(estimator: Any) -> Any:
    """Return a copy of the estimator with its parameters and nothing learned."""
    from sklearn.base import clone

    return clone(estimator)


def copy_fitted(estimator: Any, widths: tuple[int, int]) -> Any:
    """Return a copy of the estimator that was taught one example of zeros: it has everything that it will ever have.

    Raises:
        ValueError: It does not learn the widths, or its parameters are wrong.
    """
    inputs, outputs = widths
    copy = copy_unfitted(estimator)
    teach(copy, np.zeros(inputs), np.zeros(outputs))
    answer = ask(copy, np.zeros(inputs))
    if answer.shape != (outputs,):
        raise ValueError(f"it answers with the shape {answer.shape}.")
    return copy


def teach(estimator: Any, inputs: np.ndarray[Any, Any], targets: np.ndarray[Any, Any]) -> None:
    """Teach one example; one target goes as scikit-learn wants it, without an axis of outputs."""
    estimator.partial_fit(inputs[None, :].copy(), targets[None, :].copy() if len(targets) > 1 else targets.copy())


def ask(estimator: Any, inputs: np.ndarray[Any, Any]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Return the answer to one example, shape (outputs,)."""
    return np.asarray(estimator.predict(inputs[None, :]), dtype=np.float64).reshape(-1)
