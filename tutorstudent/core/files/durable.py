"""Files and folders that are written completely or not at all, even if the process is killed."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from uuid import uuid4

from tutorstudent.core.words.errors import PipelineError

PARTIAL = ".partial"
"""The suffix of what is still being written; its name begins with a dot."""


def write_whole(path: Path, text: str) -> None:
    """Write a text file, in place of one of that name."""
    partial = path.with_name(f".{path.name}{PARTIAL}")
    with partial.open("w", encoding="utf-8") as stream:
        stream.write(text)
        stream.flush()
        os.fsync(stream.fileno())
    partial.replace(path)
    _sync_folder(path.parent)


@contextmanager
def replace_folder(folder: Path) -> Iterator[Path]:
    """Yield an empty folder beside `folder`; at the end it replaces whatever is there.

    It must hold files only, no folders. If an error ends the block, `folder` stays as it was.
    """
    partial = make_partial(folder)
    try:
        yield partial
        place_folder(partial, folder)
    finally:
        shutil.rmtree(partial, ignore_errors=True)


def make_partial(folder: Path) -> Path:
    """Make an empty folder beside `folder`, in which it is written."""
    # Another name each time: a process that outlived its study may still be writing the same run.
    partial = folder.with_name(f".{folder.name}.{uuid4().hex}{PARTIAL}")
    partial.mkdir(parents=True)
    return partial


def find_partial(folder: Path) -> list[Path]:
    """Return what `make_partial` made for a folder and is still there."""
    return sorted(folder.parent.glob(f".{folder.name}.*{PARTIAL}"))


def place_folder(partial: Path, folder: Path) -> None:
    """Move a folder of files to its place, durably, where another one may stand, which is removed afterwards."""
    for path in partial.iterdir():
        _sync_file(path)
    _sync_folder(partial)
    if folder.is_mount() or folder == Path.cwd():
        _replace_files(partial, folder)
        return
    old = folder.with_name(f".{folder.name}.{uuid4().hex}{PARTIAL}")
    if folder.exists():
        folder.replace(old)
    partial.replace(folder)
    shutil.rmtree(old, ignore_errors=True)
    _sync_folder(folder.parent)


def _replace_files(partial: Path, folder: Path) -> None:
    # A folder that somebody works in, or that is a disk by itself, stays where it is.
    names = {path.name for path in partial.iterdir()}
    for path in [path for path in folder.iterdir() if path.name not in names]:
        path.unlink()
    for name in sorted(names):
        shutil.move(partial / name, folder / name)
    _sync_folder(folder)


@contextmanager
def lock_folder(folder: Path, busy: str = "") -> Iterator[None]:
    """Keep a second process on this machine out of a folder, where the system can; leaves no file behind.

    Args:
        folder: Has to be there.
        busy: What is said where another process has it.

    Raises:
        PipelineError: if another one does.
    """
    if find_spec("fcntl") is None:
        yield
        return
    import fcntl

    descriptor = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield
    except BlockingIOError:
        raise PipelineError(
            busy or f"{folder}: another process works on this study; wait for it, or end it first."
        ) from None
    finally:
        os.close(descriptor)


def find_files(folder: Path, name: str) -> list[Path]:
    """Return every file of a name below a folder, sorted, but for what is still being written.

    Another process may be at work there: a folder that goes meanwhile is passed over.
    """
    found = []
    for parent, folders, files in os.walk(folder):
        folders[:] = [below for below in folders if not below.endswith(PARTIAL)]
        found += [Path(parent, name)] if name in files else []
    return sorted(found)


def remove_partial(folder: Path) -> None:
    """Remove what a killed process had not finished writing, at any depth."""
    for path in sorted(folder.rglob(f".*{PARTIAL}")):
        if path.is_dir():
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)


def _sync_file(path: Path) -> None:
    with path.open("rb+") as stream:
        os.fsync(stream.fileno())


def _sync_folder(path: Path) -> None:
    if not hasattr(os, "O_DIRECTORY"):  # systems on which a folder cannot be opened
        return
    descriptor = os.open(path, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
