"""Ends a process group as soon as its standard input is closed, so even when its starter was killed.

Run as a script, with the number of the group; imports nothing of the package, so that it starts at once.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys


def main() -> None:
    """Wait for the end of standard input, then end the group."""
    sys.stdin.buffer.read()
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(int(sys.argv[1]), signal.SIGKILL)


if __name__ == "__main__":
    main()
