"""Paired differences as a table for programs: a row for each comparison, numbers unrounded."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path

from tutorstudent.study.comparisons import Comparison, Family

HEADER = (
    "environment",
    "variant",
    "against",
    "measure",
    "pairs",
    "mean",
    "low",
    "high",
    "r",
    "p_improve",
    "p_improve_low",
    "p_improve_high",
    "p",
    "p_holm",
)


def write_differences(path: Path, families: Sequence[Family]) -> None:
    """Write all comparisons as CSV; what does not exist is empty.

    ``low`` and ``high`` are the 95 % BCa interval of the mean difference, ``p_improve`` is the share of pairs in which
    the variant was better, ``p_holm`` is corrected within the family, see `tutorstudent.study.comparisons`.
    """
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        writer.writerows(_row(item) for family in families for item in family.comparisons)


def _row(item: Comparison) -> list[str | float | None]:
    return [
        item.environment,
        item.variant.name,
        item.against,
        item.measure.title,
        item.difference.pairs,
        item.difference.mean,
        *(item.difference.interval or ("", "")),
        item.correlation,
        item.improvement.share,
        *item.improvement.interval,
        item.p,
        item.p_holm,
    ]
