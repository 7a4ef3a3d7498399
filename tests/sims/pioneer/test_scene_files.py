"""Broken scene files: every message says what was found, where, and what is allowed."""

from __future__ import annotations

import re

import pytest

from tests.sims.pioneer.scenes import SQUARE, box, robot, scene
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.layout import load_layout

SCENE_KEYS = "Allowed: boxes, description, robots, side_m, units, walls."


def complaint(scene_name, **options):
    with pytest.raises(PipelineError) as caught:
        load_layout(str(scene_name), **options)
    return str(caught.value)


def test_an_unknown_scene_is_answered_with_the_shipped_ones():
    assert complaint("cave-boks") == (
        "world 'pioneer': there is no scene 'cave-boks' (did you mean 'cave-box'?). "
        "Shipped scenes: cave-box, cave-predator-prey, cave-predator-prey-box, chase-avoid; "
        "or give the path of a YAML file."
    )


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (
            {"robot": []},
            f"robot: unknown key (did you mean 'robots'?). {SCENE_KEYS}",
        ),
        ({"description": ""}, "description: string should have at least 1 character, found ''."),
        ({"units": "feet"}, "units: input should be 'metres' or 'percent', found 'feet'."),
        ({"units": "meters"}, "units: input should be 'metres' or 'percent', found 'meters' (did you mean 'metres'?)."),
        ({"side_m": -1}, "side_m: input should be greater than 0, found -1."),
        ({"side_m": 1001}, "side_m: input should be less than or equal to 1000, found 1001."),
        ({"side_m": float("nan")}, "side_m: input should be a finite number, found nan."),
        ({"boxes": [box("pink", 1, 1)]}, "boxes.0.colour: input should be 'red', "),
        ({"boxes": [box("red", 1, 1, side_m=0)]}, "boxes.0.side_m: input should be greater than 0, found 0."),
        ({"boxes": [box("red", 1, 1, side_m=1e9)]}, "boxes.0.side_m: input should be less than or equal to 100, found"),
        ({"boxes": [{"colour": "red", "x": 1, "side_m": 1}]}, "boxes.0.y: this is required, but it is missing."),
        ({"boxes": [box("red", "here", 1)]}, "boxes.0.x: input should be a valid number"),
        (
            {"boxes": [box("red", 1, 1) | {"sides": 4}]},
            "boxes.0.sides: unknown key (did you mean 'side_m'?). Allowed: ",
        ),
        ({"robots": []}, "robots: list should have at least 1 item"),
        ({"robots": [robot("prey", "red", 1, 1)]}, "robots: exactly one robot has the controller 'learner', not 0."),
        ({"robots": [robot("learner", "red", 1, i) for i in (1, 2)]}, "the controller 'learner', not 2."),
        ({"robots": [robot("pray", "red", 1, 1)]}, "robots.0.controller: input should be 'learner', 'prey' or "),
        ({"robots": [robot("pray", "red", 1, 1)]}, "found 'pray' (did you mean 'prey'?)."),
        (
            {"robots": [robot("prey", "red", 1, 1) | {"nom": 1}]},
            "Allowed: colour, controller, heading_deg, name, x, y.",
        ),
        (
            {"others": [robot("prey", "red", 1, 1)] * 2},
            "robots: 2 robots are named 'prey at 1 1'; give each its own name.",
        ),
        ({"walls": {}}, "walls.arena: this is required, but it is missing."),
        (
            {"walls": {"arena": SQUARE, "isles": {}}},
            "walls.isles: unknown key (did you mean 'islands'?). Allowed: arena, islands, units.",
        ),
        ({"walls": {"arena": [[0, 0], [1, 1]]}}, "walls.arena: list should have at least 3 items"),
        ({"walls": {"arena": {"centre": [0, 0]}}}, "walls.arena.radius: this is required, but it is missing."),
        ({"walls": {"arena": [[0, 0], [1], [2, 2]]}}, "walls.arena.1.1: this is required, but it is missing."),
        (
            {"walls": {"arena": SQUARE, "islands": {"boxes": {"centre": [0, 0], "radius": 1, "radios": 2}}}},
            "walls.islands.boxes.radios: unknown key (did you mean 'radius'?). Allowed: centre, radius.",
        ),
        (
            {"walls": {"arena": SQUARE, "islands": {"circle": {"centre": [0, 0], "radius": 0}}}},
            "walls.islands.circle.radius: input should be greater than 0",
        ),
        ({"walls": {"ros_map": "a.yaml", "arena": SQUARE}}, "walls.arena: unknown key. Allowed: ros_map."),
        ({"walls": 5}, "walls: input should be a mapping of keys and values, found 5."),
        ({"robots": 7}, "robots: input should be a valid list, found 7."),
    ],
)
def test_a_mistake_is_named_with_file_line_column_and_key(write_yaml, change, sentence):
    path = write_yaml(scene(**change))
    message = complaint(path)
    assert re.match(rf"{re.escape(str(path))}:\d+:\d+: ", message)
    assert sentence in message


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"units": "percent"}, "units are percent, so side_m is required."),
        ({"walls": {"arena": SQUARE, "units": "percent"}}, "the walls are in percent, so side_m is required."),
    ],
)
def test_what_does_not_fit_together_is_named_with_the_file(write_yaml, change, sentence):
    path = write_yaml(scene(**change))
    assert complaint(path) == f"{path}: {sentence}"


MISTAKEN = """\
description: a test
unit: metres
walls:
  arena: [[0, 0], [6, 0], [6, 6]]
boxes:
- colour: red
  x: 1
  side_m: 0
"""


def test_every_mistake_has_a_line_and_its_place_unknown_keys_first(tmp_path):
    path = tmp_path / "mistaken.yaml"
    path.write_text(MISTAKEN)
    assert complaint(path).splitlines() == [
        f"{path}:2:1: unit: unknown key (did you mean 'units'?). {SCENE_KEYS}",
        f"{path}:6:3: boxes.0.y: this is required, but it is missing.",
        f"{path}:8:3: boxes.0.side_m: input should be greater than 0, found 0.",
        f"{path}: robots: this is required, but it is missing.",
    ]


def test_a_long_value_is_cut_short(write_yaml):
    message = complaint(write_yaml(scene(robots="r" * 10_000)))
    assert "robots: input should be a valid list, found 'rrr" in message
    assert len(message) < 300


@pytest.mark.parametrize("content", [None, [], "a scene", 5])
def test_a_file_that_holds_no_scene(write_yaml, content):
    path = write_yaml(content)
    assert complaint(path) == f"{path}: input should be a mapping of keys and values, found {content!r}."


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("a: [1, 2", ":1:4"),
        ("a: 1\na: 2\n", ":2:1"),
        ("a: !!python/object/apply:os.system ['true']", ":1:4"),
        ("a: &x [*x]\nb: *y", ":2:4"),
        ("\t- 1", ":1:1"),
        ("1: 2", ":1:1"),
        ("\x00", ":1:1"),
    ],
)
def test_a_file_that_is_no_plain_yaml_is_refused_with_the_place_and_without_the_readers_own_words(
    tmp_path, text, place
):
    path = tmp_path / "broken.yaml"
    path.write_text(text)
    message = complaint(path)
    assert message.startswith(f"{path}{place}: ")
    assert "unicode string" not in message or not place
    assert "suppress" not in message


def test_a_list_that_holds_itself_is_no_scene(tmp_path):
    path = tmp_path / "endless.yaml"
    path.write_text("description: &x [*x]\n")
    assert complaint(path).startswith(f"{path}:1:14: description.0.0: it is nested too deeply, or contains itself")


def test_a_file_that_is_no_text(tmp_path):
    path = tmp_path / "picture.yaml"
    path.write_bytes(b"\xff\xfe\x00\x81")
    assert complaint(path).startswith(f"{path}:1:1: cannot be read: ")


@pytest.mark.parametrize(
    ("walls", "key"), [("nowhere.yaml", "walls"), ({"ros_map": "nowhere.yaml"}, "walls.ros_map"), ("n" * 5000, "walls")]
)
def test_a_file_that_is_missing_is_told_where_it_is_named(write_yaml, walls, key):
    path = write_yaml(scene(walls=walls))
    file = path.parent / (walls["ros_map"] if isinstance(walls, dict) else walls)
    message = complaint(path)
    assert message.startswith(f"{path}:")
    assert message.endswith(f": {key}: there is no file {file}; give the path of one, from the folder of this file.")


@pytest.mark.parametrize("name", ["", "\0", "n" * 5000, "/", "nowhere.yaml"])
def test_a_scene_that_no_file_can_be_is_answered_with_the_shipped_ones(name):
    assert complaint(name).startswith(f"world 'pioneer': there is no scene '{name}'. Shipped scenes: cave-box, ")


def test_a_mistake_in_the_walls_own_file_is_named_there(write_yaml):
    walls = write_yaml({"arena": SQUARE, "units": "inches"})
    message = complaint(write_yaml(scene(walls=walls.name)))
    assert message.startswith(f"{walls}:6:1: units: ")


def test_walls_may_stand_in_a_file_of_their_own(write_yaml):
    walls = write_yaml({"arena": SQUARE})
    assert load_layout(str(write_yaml(scene(walls=walls.name)))).arena == [(0, 0), (6, 0), (6, 6), (0, 6)]


def test_a_relative_scene_is_found_from_the_working_directory_and_its_walls_from_its_own(
    write_yaml, tmp_path, monkeypatch
):
    walls = write_yaml({"arena": SQUARE})
    path = write_yaml(scene(walls=walls.name))
    monkeypatch.chdir(tmp_path.parent)
    assert load_layout(f"{tmp_path.name}/{path.name}").arena == [(0, 0), (6, 0), (6, 6), (0, 6)]


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (scene(7, 3), "that is outside the arena"),
        (scene(2, 3, islands={"rock": {"centre": [2, 3], "radius": 1.5}}), "that is inside an island"),
        (scene(5.9, 3), "it touches a wall or a box"),
        (scene(3, 3, boxes=[box("red", 3.2, 3)]), "it touches a wall or a box"),
        (scene(3, 3, others=[robot("prey", "red", 3.2, 3)]), "it touches 'prey at 3.2 3'"),
    ],
)
def test_a_start_that_is_taken_is_refused_with_the_reason(make_world, content, why):
    with pytest.raises(
        PipelineError, match=re.escape(f"robot 'learner' cannot start at x {content['robots'][0]['x']:.2f} m")
    ) as caught:
        make_world(content).reset(1)
    assert why in str(caught.value)
