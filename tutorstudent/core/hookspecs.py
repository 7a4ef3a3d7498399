"""The one hook of the plugin system."""

from __future__ import annotations

from collections.abc import Iterable

import pluggy

from tutorstudent.core.component import Component

PROJECT = "tutorstudent"
hookspec = pluggy.HookspecMarker(PROJECT)
hookimpl = pluggy.HookimplMarker(PROJECT)


@hookspec
def tutorstudent_components() -> Iterable[type[Component]]:  # type: ignore[empty-body]
    """Return the component classes that this plugin provides, of any roles.

    **Example:**

    .. code-block:: python

        import tutorstudent as ts

        @ts.hookimpl
        def tutorstudent_components():
            return [WallFollower]
    """
