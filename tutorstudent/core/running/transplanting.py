"""Carries what a student learned in one run into another (Thesis 5.2.3)."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator

from tutorstudent.core.roles.interfaces import Student
from tutorstudent.core.roles.part import Learned
from tutorstudent.core.running.arrays import Arrays, load_arrays, nest
from tutorstudent.core.words.errors import PipelineError, TutorStudentError

LearnedFile = Annotated[Path, AfterValidator(Path.absolute)]
"""The ``learned.npz`` of a run; a path is relative to the working directory, and absolute once it was read."""
LARGEST = 1_000_000_000
"""Bytes of what was learned, unpacked."""
REMEDY = "Give the learned.npz that a run of the same student left behind, by its path from the working directory."


def transplant(path: Path, student: Student[Any, Any, Any]) -> None:
    """Let a student begin with what the student of another run had learned; nothing else is taken from that run.

    Raises:
        PipelineError: the file holds nothing that this student can use; the message says why.
    """
    learned = _read_learned(path)
    try:
        student.load_state_dict(learned)
    except TutorStudentError as error:
        raise PipelineError(f"{path}: {error}") from None
    except Exception as error:  # what a third party's load_state_dict() thinks of strange values
        why = " ".join(f"{type(error).__name__}: {error}".split()).rstrip(".")
        raise PipelineError(f"{path}: student '{student.name}' cannot take it: {why}. {REMEDY}") from None


def _read_learned(path: Path) -> Learned:
    try:
        learned = nest(_read_arrays(path)).get("student")
    except (TypeError, AttributeError):  # one name leads through another that is an array
        learned = None
    if not isinstance(learned, Mapping) or not learned:
        raise PipelineError(f"{path}: it holds nothing that a student learned. {REMEDY}")
    return learned


def _read_arrays(path: Path) -> Arrays:
    try:
        _check_size(path)
        return load_arrays(path)
    except PipelineError:
        raise
    except FileNotFoundError:
        raise PipelineError(f"{path}: there is no such file. {REMEDY}") from None
    except OSError as error:
        raise PipelineError(f"{path}: cannot be read: {error.strerror or error}. {REMEDY}") from None
    except Exception as error:  # numpy, zipfile and zlib each have errors of their own for what is damaged
        raise PipelineError(f"{path}: this is no file of learned arrays ({type(error).__name__}). {REMEDY}") from None


def _check_size(path: Path) -> None:
    """Refuse what is no file, or would not fit into memory, before any of it is unpacked."""
    if not path.is_file() and path.exists() and not path.is_dir():
        raise PipelineError(f"{path}: this is no file but a pipe or a device. {REMEDY}")
    if not path.is_file():
        return
    with zipfile.ZipFile(path) as archive:
        size = sum(member.file_size for member in archive.infolist())
    if size > LARGEST:
        raise PipelineError(f"{path}: it unpacks to {size:,} bytes; {LARGEST:,} are allowed. {REMEDY}")
