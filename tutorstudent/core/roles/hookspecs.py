"""The one hook of the plugin system."""

from __future__ import annotations

from collections.abc import Iterable

import pluggy

from tutorstudent.core.roles.part import Component

PROJECT = "tutorstudent"
API = 1
"""The version of what plugins build on: the hook, the roles and their records. A plugin module may say which one it is
written for with ``tutorstudent_api = 1``; where it does not, that is taken to be this one."""
OLDEST_API = 1
"""The oldest version that is still understood."""
hookspec = pluggy.HookspecMarker(PROJECT)
hookimpl = pluggy.HookimplMarker(PROJECT)


@hookspec
def tutorstudent_components() -> Iterable[type[Component]]:  # type: ignore[empty-body]
    """Return the part classes that this plugin provides, of any roles.

    **Example:**

    .. code-block:: python

        import tutorstudent as ts

        @ts.hookimpl
        def tutorstudent_components():
            return [WallFollower]
    """
