"""What a study needs beyond the package's own dependencies."""

from __future__ import annotations

from importlib.util import find_spec

from tutorstudent.core.errors import PipelineError

STUDY = ("joblib", "matplotlib", "scipy")


def check_extras(modules: tuple[str, ...] = STUDY) -> None:
    """Refuse to begin a study that could not be finished.

    Raises:
        PipelineError: if a module is missing, with the remedy.
    """
    missing = [module for module in modules if find_spec(module) is None]
    if missing:
        raise PipelineError(
            f"comparing pipelines needs {' and '.join(missing)}; install it with: pip install 'tutorstudent[study]'"
        )
