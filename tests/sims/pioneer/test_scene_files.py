"""Broken scene files: every message says what was found, where, and what is allowed."""

from __future__ import annotations

import re

import pytest

from tests.sims.pioneer.scenes import SQUARE, box, robot, scene
from tutorstudent.core.errors import PipelineError
from tutorstudent.sims.pioneer.layout import load_layout


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
        ({"robot": []}, "unknown key 'robot' (did you mean 'robots'?)."),
        ({"description": ""}, "key 'description': string should have at least 1 character, found ''."),
        ({"units": "feet"}, "key 'units': input should be 'metres' or 'percent', found 'feet'."),
        ({"units": "percent"}, "units are percent, so side_m is required."),
        ({"side_m": -1}, "key 'side_m': input should be greater than 0, found -1."),
        ({"side_m": float("nan")}, "key 'side_m': input should be"),
        ({"boxes": [box("pink", 1, 1)]}, "key 'boxes.0.colour': input should be 'red', "),
        ({"boxes": [box("red", 1, 1, side_m=0)]}, "key 'boxes.0.side_m': input should be greater than 0, found 0."),
        ({"boxes": [{"colour": "red", "x": 1, "side_m": 1}]}, "key 'boxes.0.y' is required."),
        ({"boxes": [box("red", "here", 1)]}, "key 'boxes.0.x': input should be a valid number"),
        ({"robots": []}, "key 'robots': list should have at least 1 item"),
        ({"robots": [robot("prey", "red", 1, 1)]}, "exactly one robot has the controller 'learner', not 0."),
        ({"robots": [robot("learner", "red", 1, i) for i in (1, 2)]}, "the controller 'learner', not 2."),
        ({"robots": [robot("pray", "red", 1, 1)]}, "key 'robots.0.controller': input should be 'learner', 'prey' or"),
        ({"others": [robot("prey", "red", 1, 1)] * 2}, "2 robots are named 'prey at 1 1'; give each its own name."),
        ({"walls": {}}, "key 'walls.arena' is required."),
        ({"walls": {"arena": SQUARE, "isles": {}}}, "unknown key 'walls.isles'"),
        ({"walls": {"arena": [[0, 0], [1, 1]]}}, "key 'walls.arena': list should have at least 3 items"),
        ({"walls": {"arena": {"centre": [0, 0]}}}, "key 'walls.arena.radius' is required."),
        ({"walls": {"arena": [[0, 0], [1], [2, 2]]}}, "key 'walls.arena.1.1' is required."),
        (
            {"walls": {"arena": SQUARE, "islands": {"rock": {"centre": [0, 0], "radius": 0}}}},
            "key 'walls.islands.rock.radius': input should be greater than 0",
        ),
        ({"walls": {"ros_map": "a.yaml", "arena": SQUARE}}, "unknown key 'walls.arena'"),
        ({"walls": {"arena": SQUARE, "units": "percent"}}, "the walls are in percent, so side_m is required."),
        ({"walls": 5}, "key 'walls': input should be a valid dictionary"),
        ({"robots": 7}, "key 'robots': input should be a valid list, found 7."),
    ],
)
def test_a_mistake_is_named_with_file_and_key(write_yaml, change, sentence):
    path = write_yaml(scene(**change))
    message = complaint(path)
    assert message.startswith(f"{path}: ")
    assert sentence in message


def test_all_mistakes_are_told_at_once(write_yaml):
    message = complaint(write_yaml(scene(units="feet", side_m=-1)))
    assert "'units'" in message
    assert "'side_m'" in message


@pytest.mark.parametrize("content", [None, [], "a scene", 5])
def test_a_file_that_holds_no_scene(write_yaml, content):
    path = write_yaml(content)
    assert complaint(path).startswith(f"{path}: input should be a valid dictionary")


@pytest.mark.parametrize(
    "text",
    ["a: [1, 2", "a: 1\na: 2\n", "!!python/object/apply:os.system ['true']", "a: &x [*x]\nb: *y", "\t- 1", "\x00"],
)
def test_a_file_that_is_no_safe_yaml(tmp_path, text):
    path = tmp_path / "broken.yaml"
    path.write_text(text)
    assert complaint(path).startswith(f"{path}: is no YAML: ")


def test_a_file_that_is_no_text(tmp_path):
    path = tmp_path / "picture.yaml"
    path.write_bytes(b"\xff\xfe\x00\x81")
    assert complaint(path).startswith(f"{path}: is no YAML: ")


def test_walls_in_a_file_that_is_missing(write_yaml):
    path = write_yaml(scene(walls="nowhere.yaml"))
    assert complaint(path) == f"{path.parent / 'nowhere.yaml'}: cannot be read: No such file or directory."


def test_a_mistake_in_the_walls_own_file_is_named_there(write_yaml):
    walls = write_yaml({"arena": SQUARE, "units": "inches"})
    message = complaint(write_yaml(scene(walls=walls.name)))
    assert message.startswith(f"{walls}: key 'units': ")


def test_walls_may_stand_in_a_file_of_their_own(write_yaml):
    walls = write_yaml({"arena": SQUARE})
    assert load_layout(str(write_yaml(scene(walls=walls.name)))).arena == [(0, 0), (6, 0), (6, 6), (0, 6)]


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
