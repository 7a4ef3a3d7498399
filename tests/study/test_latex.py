"""As strict as LaTeX: braces and environments are balanced, nothing special is left, rows are as wide as said."""

from __future__ import annotations

import re

import pytest

from tests.study.test_tables import study
from tutorstudent.study.tables.latex import escape, make_document, make_latex
from tutorstudent.study.tables.table import Row, Table
from tutorstudent.study.tables.tables import make_tables

SPECIAL = "\\ { } $ & # ^ _ ~ % < > | \" ' ` [ ] ± é"
HOSTILE = Table(
    r"\input{/etc/passwd} 100 % & more",
    ("a_b^c", "[*] #1 ~ $x$"),
    (
        Row(r"}\end{tabular}{", False, (r"\\", "& & &")),
        Row("[3cm]", True, ("-1.5 [-2.0, -1.0]", "<0.001 ± 猫\x00\n\n")),
    ),
    "50 % {of} what_was",
)

TOKEN = re.compile(
    r"\\begin\{(?P<begin>\w+)\}|\\end\{(?P<end>\w+)\}|\\(?:[a-zA-Z]+|.)|(?P<open>\{)|(?P<close>\})|(?P<char>.)",
    re.DOTALL,
)
COMMANDS = {
    *("\\section", "\\clearpage", "\\caption", "\\centering", "\\small", "\\footnotesize", "\\par", "\\smallskip"),
    *("\\fitted", "\\toprule", "\\midrule", "\\bottomrule", "\\textbf", "\\textit", "\\pm"),
    *("\\textbackslash", "\\textasciicircum", "\\textasciitilde", "\\textless", "\\textgreater", "\\textbar"),
    *("\\textquotedbl", "\\textquotesingle", "\\textasciigrave"),
    *("\\\\", "\\{", "\\}", "\\$", "\\&", "\\#", "\\%", "\\_"),
}


def body(text: str) -> str:
    """Return what is new in every document: all but the preamble."""
    return "\\begin{document}" + text.partition("\\begin{document}")[2]


def check(text: str) -> None:
    """Complain as LaTeX would: about what is not closed, unknown commands, and special characters that are left."""
    stack: list[str] = []
    maths = False
    for token in TOKEN.finditer(text):
        if name := token["begin"]:
            stack.append(name)
        elif name := token["end"]:
            assert name == stack.pop()
        elif token["open"]:
            stack.append("{")
        elif token["close"]:
            assert "{" == stack.pop()
        elif character := token["char"]:
            maths ^= character == "$"
            assert character not in "^_~%#"
            assert character != "&" or "tabular" in stack
            assert " " <= character <= "ÿ" or character == "\n"
        else:
            assert token[0] in COMMANDS
    assert [] == stack
    assert not maths


def rows(text: str) -> list[str]:
    return re.findall(r"^(.*) \\\\$", text, re.MULTILINE)


def test_a_whole_study_is_sound_latex() -> None:
    made = make_tables(study(), study().plan.environments[0])
    text = make_document([("cave", made)])
    check(body(text))
    assert len(made) == text.count("\\begin{table}") == text.count("\\toprule") == text.count("\\bottomrule")
    assert "25.0 $\\pm$ 5.0 (25; IQM 25.0)" in text
    assert "\\usepackage{booktabs}" in text.partition("\\begin{document}")[0]
    assert "\\section*{cave}" in text


def test_the_preamble_is_closed_where_it_was_opened() -> None:
    preamble = make_document([]).partition("\\begin{document}")[0]
    assert preamble.count("{") == preamble.count("}")
    assert preamble.count("[") == preamble.count("]")


def test_hostile_names_stay_text() -> None:
    text = make_document([(r"\end{document}$", [HOSTILE])])
    check(body(text))
    assert "\\textbackslash{}input\\{/etc/passwd\\} 100 \\% \\& more" in text
    assert "\\textit{{[}3cm{]}}" in text
    assert 1 == text.count("\\end{tabular}")
    assert 1 == text.count("\\end{document}")


@pytest.mark.parametrize("table", [HOSTILE, *make_tables(study(), study().plan.environments[0])])
def test_every_row_has_as_many_cells_as_there_are_columns(table: Table) -> None:
    text = make_latex(table)
    columns = re.search(r"\\begin\{tabular\}\{([lr]+)\}", text)
    assert columns is not None
    assert 1 + len(table.header) == len(columns[1])
    assert 1 + len(table.rows) == len(rows(text))
    for row in rows(text):
        assert len(table.header) == len(re.findall(r"(?<!\\)&", row))


def test_no_row_begins_with_what_a_line_end_takes_for_an_option() -> None:
    assert not re.search(r"\\\\\s*[\[*]", make_latex(HOSTILE))


def test_every_special_character_has_a_meaning() -> None:
    check(escape(SPECIAL))
    assert r"\textbackslash{}" == escape("\\")
    assert "a\\_b" == escape("a_b")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("-3.5", "$-$3.5"),
        ("[-3, -1]", "{[}$-$3, $-$1{]}"),
        ("constant-4", "constant-4"),
        ("2A-3", "2A-3"),
        ("a--b---c", "a-{}-b-{}-{}-c"),
        ("-", "-"),
        ("two\nlines", "two lines"),
        ("\x00", "{[}U+0000{]}"),
        ("Müller", "Müller"),
    ],
)
def test_minus_signs_hyphens_and_what_the_fonts_lack(text: str, expected: str) -> None:
    assert expected == escape(text)


def test_the_check_itself_finds_what_latex_would() -> None:
    for broken in (
        "{",
        "}",
        "\\begin{a}",
        "\\begin{a}\\end{b}",
        "$",
        "a_b",
        "a & b",
        "\\nosuchthing",
        "猫",
        "x^2",
        "50 %",
    ):
        with pytest.raises((AssertionError, IndexError)):
            check(broken)
