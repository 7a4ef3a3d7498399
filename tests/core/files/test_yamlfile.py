"""YAML is read into plain values; every key knows its place; nothing in it can run."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tutorstudent.core.files.yamlfile import parse_yaml, read_yaml
from tutorstudent.core.words.errors import PipelineError


def test_values_are_plain() -> None:
    document = parse_yaml("a: 1\nb: [0.5, yes, no, 'x', null, true]\nc: {d: 1e-3}\n", "f.yaml")
    assert {"a": 1, "b": [0.5, "yes", "no", "x", None, True], "c": {"d": 0.001}} == document.data
    assert [float, str, str, str, type(None), bool] == [type(item) for item in document.data["b"]]


def test_every_key_knows_its_place() -> None:
    document = parse_yaml("a: 1\nstudent:\n  use: x\n  list:\n  - one\n  - two\n", "f.yaml")
    assert "f.yaml:3:3: student.use" == document.locate(("student", "use"))
    assert "f.yaml:6:5: student.list.1" == document.locate(("student", "list", 1))


def test_a_key_that_is_not_there_has_the_place_of_its_parent() -> None:
    document = parse_yaml("a: 1\nstudent:\n  use: x\n", "f.yaml")
    assert "f.yaml:2:1: student.hidden" == document.locate(("student", "hidden"))
    assert "f.yaml: world" == document.locate(("world",))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a: [1", "f.yaml:1:4: not valid YAML: the '[' that opens here is not closed, or a comma is missing."),
        (
            "a: [1,\nb: 2",
            "f.yaml:1:4: not valid YAML: the '[' that opens here is not closed, or a comma is missing before",
        ),
        ("a: {b: 1\nc: 2}", "f.yaml:1:4: not valid YAML: the '{' that opens here is not closed, or a comma is missing"),
        ("a:\n\tb: 1", "f.yaml:2:1: not valid YAML: there is a tab here; indent with spaces."),
        ("\na: 'b\n\nc: 1", "f.yaml:2:4: not valid YAML: the quote that opens here is never closed."),
        ("a: 1\nb:2\nc: 3", "f.yaml:2:1: not valid YAML: a ':' with a space after it is missing here."),
        ("a 1\nb: 2", "f.yaml:2:2: not valid YAML: a ':' is not expected here; is this line indented further than"),
        (
            "a:\n  b: 1\n c: 2",
            "f.yaml:3:2: not valid YAML: this is not indented like what it belongs to, which begins i",
        ),
        ("a: *b", "f.yaml:1:4: not valid YAML: found undefined alias 'b'; quote a value that begins with '*'."),
        ("a: @b", "f.yaml:1:4: not valid YAML: found character '@' that cannot start any token; quote the value."),
        (
            'a: "b\\q"',
            "f.yaml:1:7: not valid YAML: found unknown escape character 'q'; write the value in single quotes",
        ),
        (
            "a: 1\n---\nb: 2\n",
            "f.yaml:2:1: not valid YAML: another document begins here; a file holds one. Remove the '---'",
        ),
        ("a: 1\nb: \0\n", "f.yaml:2:4: not valid YAML: the character #x0000 is not allowed. Remove it."),
        ("%YAML 3.0\n---\na: 1", "f.yaml:1:1: not valid YAML: found incompatible YAML document"),
        ("a: {b: 1, c: 2,\nb: 2}\n", "f.yaml:2:1: a.b: this key is in line 1 too; keep one of them."),
        (
            "a: !!python/object/apply:os.system [echo]\n",
            "f.yaml:1:4: a: the tag '!!python/object/apply:os.system' is not",
        ),
        ("a:\n  b: !thing {}\n", "f.yaml:2:6: a.b: the tag '!thing' is not allowed; write plain YAML without tags."),
        ("a: !thing x\n", "f.yaml:1:4: a: the tag '!thing' is not allowed"),
        ("1: x\n", "f.yaml:1:1: the key 1 is not a word; quote it."),
        ("a: {null: x}\n", "f.yaml:1:5: a: the key null is not a word; quote it."),
        ("? [a]\n: x\n", "f.yaml:1:3: the key in brackets is not a word; quote it."),
        ("a: 1\nb: !!omap [x: 1]\n", "f.yaml:2:4: b: the tag '!!omap' is not allowed; write plain YAML without tags."),
        ("b: !!set {x, y}\n", "f.yaml:1:4: b: the tag '!!set' is not allowed"),
        ("b: !!pairs [x: 1]\n", "f.yaml:1:4: b: the tag '!!pairs' is not allowed"),
        ("b: !!binary aGVsbG8=\n", "f.yaml:1:4: b: the tag '!!binary' is not allowed"),
        ("b: !!seq x\n", "f.yaml:1:4: b: the tag '!!seq' is not allowed"),
        ("!!omap [x: 1]\n", "f.yaml:1:1: the tag '!!omap' is not allowed"),
        ("a: {<<: 5}\n", "f.yaml:1:9: a: '<<' merges mappings; name one by its alias, as in <<: *name."),
        ("a: {<<: [{}, 5]}\n", "f.yaml:1:14: a: '<<' merges mappings;"),
        ("a: {<<: {1: x}}\n", "f.yaml:1:10: a: the key 1 is not a word; quote it."),
        ("a: !!bool x\n", "f.yaml:1:4: a: 'x' is no bool that can be read."),
        ("a: !!int x\n", "f.yaml:1:4: a: 'x' is no int that can be read."),
        ("a: [1_]\n", "f.yaml:1:5: a.0: '1_' is no int that can be read."),
        (
            f"a: {'9' * 5000}\n",
            "f.yaml:1:4: a: '9999999999999999999999999999999999999...' is no int: with 5,000 digits; 1000 are allowed.",
        ),
        (
            "a: 017\n",
            "f.yaml:1:4: a: '017' is no int: with a leading zero some read it as octal; write 17, or 0o17 if that",
        ),
        (
            "a: -00\n",
            "f.yaml:1:4: a: '-00' is no int: with a leading zero some read it as octal; write 0, or 0o0 if that",
        ),
        (f"a: {'[' * 300}{']' * 300}\n", "f.yaml:1:53: not valid YAML: it is nested too deeply; make it"),
        (f"a: {'{a: ' * 300}1{'}' * 300}\n", "f.yaml:1:197: not valid YAML: it is nested too deeply"),
        (f"{'- ' * 60}x\n", "f.yaml:1:101: not valid YAML: it is nested too deeply; make it flatter."),
        ("a: &a {<<: *a}\n", "f.yaml: it is nested too deeply, or contains itself; make it flatter."),
        ("&a {b: *a}\n", "f.yaml:1:1: b.b.b: it is nested too deeply, or contains itself; make it flatter."),
        ("#" * 500_001, "f.yaml: it has 500,001 characters; 500,000 are allowed."),
    ],
)
def test_what_is_not_plain_yaml_is_refused_with_its_place(text: str, message: str) -> None:
    with pytest.raises(PipelineError) as caught:
        parse_yaml(text, "f.yaml")
    assert str(caught.value).startswith(message)


def bomb(begin: str, line: str) -> str:
    """Return a text in which each of 40 lines names the one before it ten times."""
    return begin + "".join(line.format(here=i, before=",".join([f"*a{i - 1}"] * 10)) for i in range(1, 40))


@pytest.mark.parametrize(
    ("text", "place"),
    [
        (bomb("a0: &a0 [x]\n", "a{here}: &a{here} [{before}]\n"), "f.yaml:6:1: a5: there"),
        (bomb("a0: &a0 {x: 1}\n", "a{here}: &a{here} {{<<: [{before}]}}\n"), "f.yaml:6:1: a5: there"),
    ],
)
def test_aliases_cannot_stand_for_more_than_a_file_may_hold(text: str, place: str) -> None:
    with pytest.raises(PipelineError, match="there are more than 100,000 values, counting repeated ones") as caught:
        parse_yaml(text, "f.yaml")
    assert str(caught.value).startswith(place)


def test_a_name_of_an_anchor_may_be_given_again() -> None:
    assert {"a": 1, "b": 2, "c": 2} == parse_yaml("a: &x 1\nb: &x 2\nc: *x\n", "f.yaml").data


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2024-13-45", "2024-13-45"),
        ("2001-12-14t21:59:43.10-05:00", "2001-12-14t21:59:43.10-05:00"),
        ("12:30:45", "12:30:45"),
        ("=", "="),
        ("<<", "<<"),
        ("yes", "yes"),
        ("off", "off"),
        ("1_000", 1000),
        ("0o17", 15),
        ("0x1F", 31),
        ("0b11", 3),
        ("-0", 0),
        ("0", 0),
        ("!!int 3", 3),
        ("!!str 3", "3"),
        ("-.inf", -math.inf),
        ("1e3", 1000.0),
        ("00.5", 0.5),
        ("~", None),
        ("", None),
        ("True", True),
    ],
)
def test_a_scalar_is_what_yaml_1_2_says(text: str, value: object) -> None:
    found = parse_yaml(f"a: {text}\n", "f.yaml").data["a"]
    assert (value, type(value)) == (found, type(found))


def test_no_number_stays_one() -> None:
    assert math.isnan(parse_yaml("a: .NaN\n", "f.yaml").data["a"])


def test_merged_keys_have_the_place_where_they_stand() -> None:
    document = parse_yaml("base: &base {x: 1, y: 2}\nc:\n  <<: *base\n  y: 3\n", "f.yaml")
    assert {"x": 1, "y": 3} == document.data["c"]
    assert "f.yaml:1:14: c.x" == document.locate(("c", "x"))
    assert "f.yaml:4:3: c.y" == document.locate(("c", "y"))
    assert {"w": 2, "q": 1} == parse_yaml("<<: {q: 1}\nw: 2\n", "f.yaml").data


def test_the_first_of_several_merged_mappings_wins() -> None:
    text = "a: &a {x: 1}\nb: &b {x: 2, y: 2}\nc: {<<: [*a, *b]}\n"
    document = parse_yaml(text, "f.yaml")
    assert {"x": 1, "y": 2} == document.data["c"]
    assert "f.yaml:1:8: c.x" == document.locate(("c", "x"))


def test_what_was_set_from_elsewhere_stands_nowhere_and_is_named() -> None:
    document = parse_yaml("a: {b: {c: 1, d: 2}}\ne: 3\n", "f.yaml")
    changed = document.replace(("a", "b", "c"), {}, "a.b.c=7")
    assert "f.yaml (with a.b.c=7): a.b.c" == changed.locate(("a", "b", "c"))
    assert "f.yaml:1:5 (with a.b.c=7): a.b" == changed.locate(("a", "b"))
    assert "f.yaml:1:15: a.b.d" == changed.locate(("a", "b", "d"))
    assert "f.yaml:2:1: e" == changed.locate(("e",))
    assert "f.yaml (with a.b.c=7)" == changed.locate(())
    again = changed.replace(("a",), {}, "a=8").replace(("a", "b"), {}, "a.b=9")
    assert "f.yaml (with a=8, a.b=9): a.b.d" == again.locate(("a", "b", "d"))
    assert "f.yaml (with a=8): a.x" == again.locate(("a", "x"))


def test_a_missing_file_says_so(tmp_path: Path) -> None:
    with pytest.raises(PipelineError, match="there is no such file. Give the path of a YAML file."):
        read_yaml(tmp_path / "absent.yaml")


def test_a_directory_says_so(tmp_path: Path) -> None:
    with pytest.raises(PipelineError, match="cannot be read: Is a directory. Give the path of a YAML file."):
        read_yaml(tmp_path)


def test_bytes_that_are_not_utf_8_say_where(tmp_path: Path) -> None:
    path = tmp_path / "bytes.yaml"
    path.write_bytes("a: 1\nb: ü\n".encode("latin-1"))
    with pytest.raises(PipelineError) as caught:
        read_yaml(path)
    assert f"{path}:2:4: cannot be read: this is not UTF-8. Save the file in UTF-8." == str(caught.value)
