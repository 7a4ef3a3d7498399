"""To come."""

from __future__ import annotations

import tutorstudent as ts


@ts.hookimpl
def tutorstudent_components() -> list[type[ts.Component]]:
    """Return nothing yet."""
    return []
