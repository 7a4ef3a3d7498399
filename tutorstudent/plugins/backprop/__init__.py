"""Incremental backpropagation: the thesis's student, and the same network for scikit-learn.

`tutorstudent.plugins.backprop.regressor` needs scikit-learn and is imported on its own.
"""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.part import Component
from tutorstudent.plugins.backprop.network import Network
from tutorstudent.plugins.backprop.student import BackpropStudent

__all__ = ["BackpropStudent", "Network"]


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the thesis's student."""
    return [BackpropStudent]
