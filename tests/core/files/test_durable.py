"""Files of a name are found in whole folders only, also while another process writes beside them."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tutorstudent.core.files.durable import find_files, make_partial


def put(folder: Path) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    (path := folder / "timing.json").write_text("{}")
    return path


def test_what_is_still_being_written_is_not_found(tmp_path: Path) -> None:
    expected = [put(tmp_path / "a" / "1"), put(tmp_path / "a" / "2"), put(tmp_path / "b")]
    put(make_partial(tmp_path / "a" / "3"))
    (tmp_path / "a" / "other.json").write_text("{}")
    assert expected == find_files(tmp_path, "timing.json")


def test_a_folder_that_goes_while_files_are_looked_for_is_passed_over(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = [put(tmp_path / "a"), put(tmp_path / "c")]
    put(tmp_path / "b")
    scan = os.scandir
    going = [str(tmp_path / "b")]

    def scan_later(path: Any) -> Iterator[os.DirEntry[str]]:
        if path in going:
            shutil.rmtree(going.pop())
        return scan(path)

    monkeypatch.setattr(os, "scandir", scan_later)
    assert expected == find_files(tmp_path, "timing.json")
    assert not going
