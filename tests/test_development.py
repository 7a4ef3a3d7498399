"""The page for those who change the code names what is really there."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[1] / "docs"
sys.path.append(str(DOCS))

import blocks  # noqa: E402 - stands beside the pages

PAGE = (DOCS / "development.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| ([^|]+) \| ([^|]+) \|([^|]*)\|$", PAGE, flags=re.MULTILINE)[1:]


def test_every_path_on_the_page_exists() -> None:
    named = set(re.findall(r"`((?:tutorstudent|tests|docs|examples)/[^`]+|[A-Z]+\.md)`", PAGE))
    assert len(named) > 50
    assert [] == [path for path in sorted(named) if not (DOCS.parent / path).exists()]


@pytest.mark.parametrize(("change", "where"), [row[:2] for row in ROWS], ids=[row[0] for row in ROWS])
def test_every_change_names_a_file_to_open(change: str, where: str) -> None:
    assert "`tutorstudent/" in where, change


def test_the_table_of_folders_is_what_the_folders_say() -> None:
    assert blocks.renewed("development.md") == PAGE, "run python docs/blocks.py"


def test_every_folder_begins_with_a_sentence() -> None:
    sentences = re.findall(r"^\| `tutorstudent[\w/]*` \| (.*) \|$", blocks.folders(), flags=re.MULTILINE)
    assert len(sentences) > 20
    assert [] == [sentence for sentence in sentences if not sentence.endswith(".") and not sentence.endswith(").")]


def test_a_page_without_the_block_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "development.md").write_text("# Development\n", encoding="utf-8")
    monkeypatch.setattr(blocks, "DOCS", tmp_path)
    with pytest.raises(ValueError, match="no block 'folders'"):
        blocks.renewed("development.md")
