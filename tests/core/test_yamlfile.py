"""YAML is read into plain values; every key knows its place; nothing in it can run."""

from __future__ import annotations

from pathlib import Path

import pytest

from tutorstudent.core.errors import PipelineError
from tutorstudent.core.yamlfile import parse_yaml, read_yaml


def test_values_are_plain() -> None:
    document = parse_yaml("a: 1\nb: [0.5, yes, no, 'x', null, true]\nc: {d: 1e-3}\n", "f.yaml")
    assert {"a": 1, "b": [0.5, "yes", "no", "x", None, True], "c": {"d": 0.001}} == document.data
    assert [float, str, str, str, type(None), bool] == [type(item) for item in document.data["b"]]


def test_every_key_knows_its_place() -> None:
    document = parse_yaml("a: 1\nstudent:\n  use: x\n  list:\n  - one\n  - two\n", "f.yaml")
    assert "f.yaml:3:3: student.use" == document.where(("student", "use"))
    assert "f.yaml:6:5: student.list.1" == document.where(("student", "list", 1))


def test_a_key_that_is_not_there_has_the_place_of_its_parent() -> None:
    document = parse_yaml("a: 1\nstudent:\n  use: x\n", "f.yaml")
    assert "f.yaml:2:1: student.hidden" == document.where(("student", "hidden"))
    assert "f.yaml: world" == document.where(("world",))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a: [1", "f.yaml:1:6: not valid YAML: expected ',' or ']', but got '<stream end>'."),
        ("a: 1\na: 2\n", 'f.yaml:2:1: not valid YAML: found duplicate key "a" with value "2" (original value: "1").'),
        ("a: !!python/object/apply:os.system [echo]\n", "f.yaml:1:1: the tag"),
        ("a:\n  b: !thing {}\n", "f.yaml:2:3: the tag '!thing' is not allowed; write plain YAML without tags."),
        ("a: !thing x\n", "f.yaml:1:1: the tag '!thing' is not allowed"),
        ("1: x\n", "f.yaml:1:1: the key 1 is not a word; quote it."),
        ("a: 1\n--- \nb: 2\n", "f.yaml"),
        ("a: 1\nb: !!omap [x: 1]\n", "f.yaml:2:1: the tag '!!omap' is not allowed; write plain YAML without tags."),
        ("b: !!set {x, y}\n", "f.yaml:1:1: the tag '!!set' is not allowed"),
        ("b: !!pairs [x: 1]\n", "f.yaml:1:1: the tag '!!pairs' is not allowed"),
        ("b: !!binary aGVsbG8=\n", "f.yaml:1:1: the tag '!!binary' is not allowed"),
        ("!!omap [x: 1]\n", "f.yaml: the tag '!!omap' is not allowed"),
        ("a: {<<: 5}\n", "f.yaml:1:9: not valid YAML: expected a mapping or list of mappings for merging"),
        ("a: {<<: {1: x}}\n", "f.yaml:1:1: the key 1 is not a word; quote it."),
        (f"a: {'[' * 3000}{']' * 3000}\n", "f.yaml: it is nested too deeply, or in itself; write it flat."),
        (f"a: {'{a: ' * 3000}1{'}' * 3000}\n", "f.yaml: it is nested too deeply"),
        ("a: &a {<<: *a}\n", "f.yaml: it is nested too deeply, or in itself; write it flat."),
        ("&a {b: *a}\n", "f.yaml: it is nested too deeply, or in itself; write it flat."),
    ],
)
def test_what_is_not_plain_yaml_is_refused_with_its_place(text: str, message: str) -> None:
    with pytest.raises(PipelineError) as caught:
        parse_yaml(text, "f.yaml")
    assert str(caught.value).startswith(message)


def test_merged_keys_have_the_place_of_the_mapping_that_they_are_merged_into() -> None:
    document = parse_yaml("base: &base {x: 1, y: 2}\nc:\n  <<: *base\n  y: 3\n", "f.yaml")
    assert {"x": 1, "y": 3} == document.data["c"]
    assert "f.yaml:2:1: c.x" == document.where(("c", "x"))
    assert "f.yaml:4:3: c.y" == document.where(("c", "y"))
    assert {"w": 2, "q": 1} == parse_yaml("<<: {q: 1}\nw: 2\n", "f.yaml").data


def test_what_was_set_from_elsewhere_stands_nowhere_and_is_named() -> None:
    document = parse_yaml("a: {b: {c: 1, d: 2}}\ne: 3\n", "f.yaml")
    changed = document.replaced(("a", "b", "c"), {}, "a.b.c=7")
    assert "f.yaml (with a.b.c=7): a.b.c" == changed.where(("a", "b", "c"))
    assert "f.yaml:1:5 (with a.b.c=7): a.b" == changed.where(("a", "b"))
    assert "f.yaml:1:15: a.b.d" == changed.where(("a", "b", "d"))
    assert "f.yaml:2:1: e" == changed.where(("e",))
    assert "f.yaml (with a.b.c=7)" == changed.where(())
    again = changed.replaced(("a",), {}, "a=8").replaced(("a", "b"), {}, "a.b=9")
    assert "f.yaml (with a=8, a.b=9): a.b.d" == again.where(("a", "b", "d"))
    assert "f.yaml (with a=8): a.x" == again.where(("a", "x"))


def test_a_missing_file_says_so(tmp_path: Path) -> None:
    with pytest.raises(PipelineError, match="there is no such file. Give the path of a YAML file."):
        read_yaml(tmp_path / "absent.yaml")


def test_a_directory_and_bytes_say_so(tmp_path: Path) -> None:
    (tmp_path / "bytes.yaml").write_bytes(b"\xff\xfe\x00a")
    for path in (tmp_path, tmp_path / "bytes.yaml"):
        with pytest.raises(PipelineError, match="cannot be read"):
            read_yaml(path)
