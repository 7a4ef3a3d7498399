"""What to say where a package that an example is about is not installed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import tutorstudent as ts


@contextmanager
def explain_missing(who: str, distribution: str) -> Iterator[None]:
    """Turn a failed import within into a sentence.

    Args:
        who: The part that cannot do without it.
        distribution: What to install.

    Raises:
        PipelineError: Something could not be imported.
    """
    try:
        yield
    except ImportError as error:
        raise ts.PipelineError(f"{who} needs {distribution}; install it with: pip install '{distribution}'") from error
