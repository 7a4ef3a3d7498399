"""Tables as a LaTeX document that compiles by itself; of packages it needs booktabs, and what every LaTeX has."""

from __future__ import annotations

import re
from collections.abc import Iterable

from tutorstudent.study.tables.table import Row, Table

HEAD = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage{textcomp}
\usepackage[a4paper,landscape,margin=15mm]{geometry}
\usepackage{booktabs}
\usepackage{graphicx}
% A table that is wider than the page is made as wide as the page.
\newsavebox{\widetable}
\newcommand{\fitted}[1]{\sbox{\widetable}{#1}%
  \ifdim\wd\widetable>\linewidth\resizebox{\linewidth}{!}{\usebox{\widetable}}\else\usebox{\widetable}\fi}
\begin{document}
"""
FOOT = "\\end{document}\n"
# Brackets as well: after a line's end LaTeX would take them for an option.
MEANINGS = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "[": "{[}",
    "]": "{]}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    "'": r"\textquotesingle{}",
    "`": r"\textasciigrave{}",
    "±": r"$\pm$",
}
MINUS = re.compile(r"(?<![\w.-])-(?=\d)")
DASHES = re.compile("-(?=-)")


def make_document(sections: Iterable[tuple[str, Iterable[Table]]]) -> str:
    """Return a document with a section of tables for each title."""
    parts = [
        f"\\section*{{{escape(title)}}}\n{''.join(map(make_latex, tables))}\\clearpage\n" for title, tables in sections
    ]
    return HEAD + "".join(parts) + FOOT


def make_latex(table: Table) -> str:
    """Return one table with its title above and its note below; controls are set in italics."""
    header = " & ".join(["", *map(escape, table.header)])
    body = "".join(f"{_write_line(row)} \\\\\n" for row in table.rows)
    note = f"\n\\par\\smallskip\\footnotesize {escape(table.note)}" if table.note else ""
    return (
        f"\\begin{{table}}[htbp]\n\\centering\\small\n\\caption{{{escape(table.title)}}}\n"
        f"\\fitted{{\\begin{{tabular}}{{l{'r' * len(table.header)}}}\n\\toprule\n{header} \\\\\n\\midrule\n{body}"
        f"\\bottomrule\n\\end{{tabular}}}}{note}\n\\end{{table}}\n"
    )


def escape(text: str) -> str:
    r"""Return text that LaTeX sets as it stands; what its fonts lack is told by its code.

    >>> print(escape("50 % of a_b: -3.5 [-4, +1]"), escape("猫"))
    50 \% of a\_b: $-$3.5 {[}$-$4, +1{]} {[}U+732B{]}
    """
    pieces = ("".join(map(_escape_character, piece)) for piece in MINUS.split(text))
    return "$-$".join(DASHES.sub("-{}", piece) for piece in pieces)  # two hyphens would be set as a dash


def _write_line(row: Row) -> str:
    style = "textit" if row.control else "textbf"
    return " & ".join([f"\\{style}{{{escape(row.name)}}}", *map(escape, row.cells)])


def _escape_character(character: str) -> str:
    if character in MEANINGS:
        return MEANINGS[character]
    if character.isspace():
        return " "
    is_known = " " <= character <= "~" or "À" <= character <= "ÿ"
    return character if is_known else f"{{[}}U+{ord(character):04X}{{]}}"
