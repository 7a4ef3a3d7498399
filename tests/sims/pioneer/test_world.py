"""The world's contract: trials, states, life cycle, options."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from importlib import import_module

import numpy as np
import pytest
from annotated_types import Ge, Gt, Le, Lt
from pydantic import ValidationError

from tests.sims.pioneer.scenes import STOP, forward, robot, scene
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.world import World
from tutorstudent.core.words.errors import ContractError, PipelineError
from tutorstudent.sims.pioneer import bullet, tutorstudent_components
from tutorstudent.sims.pioneer.bullet import Bullet, load_pybullet
from tutorstudent.sims.pioneer.calls import CallLog, bind_calls
from tutorstudent.sims.pioneer.layout import load_layout
from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld
from tutorstudent.sims.pioneer.scene_files import SCENES
from tutorstudent.sims.pioneer.types import DriveAction
from tutorstudent.sims.pioneer.world_options import PioneerOptions

NUMBERS = (int, float, float | None)
BOUNDS = [{low, high} for low in (Ge, Gt) for high in (Le, Lt)]
ACTIONS = [
    forward(0.6),
    DriveAction(kind="left", rotation=0.7, duration_s=0.3),
    forward(1.0, 0.5),
    DriveAction(kind="backward", translation=-0.2),
    DriveAction(kind="right", rotation=-1.0),
]


def trace(world, seed, decisions=60):
    """Return everything that a trial shows, as bytes."""
    shown = hashlib.sha256()
    state, events = world.reset(seed), {}
    for i in range(decisions):
        shown.update(state.sonar_m.tobytes() + repr((state.blobs, state.stalled, sorted(events.items()))).encode())
        state, events, *_ = world.step(ACTIONS[i % len(ACTIONS)])
    return shown.hexdigest()


@pytest.mark.parametrize("drive", ["kinematic", "planar", "wheeled"])
def test_the_same_seed_is_the_same_trial_whatever_came_before(make_world, drive):
    decisions = 60 if drive == "kinematic" else 8
    first, second = (make_world("chase-avoid", drive=drive) for _ in range(2))
    alone = trace(first, 7, decisions)
    trace(second, 8, decisions)
    assert trace(second, 7, decisions) == alone
    assert trace(first, 7, decisions) == alone
    assert trace(first, 8, decisions) != alone


def test_the_same_seed_is_the_same_trial_in_another_process(make_world):
    program = (
        "from tests.sims.pioneer.test_world import trace\n"
        "from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld\n"
        "print(trace(PioneerWorld(scene='cave-predator-prey-box', pose_jitter_m=0.2), 11))"
    )
    runs = [subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True) for _ in "ab"]
    here = trace(make_world("cave-predator-prey-box", pose_jitter_m=0.2), 11)
    assert [run.stdout.split()[-1] for run in runs] == [here, here]


def test_one_more_robot_does_not_shift_the_others_random_numbers(make_world):
    """The prey and the predator of the cave meet nobody in the first decisions, with or without boxes and company."""
    near = [robot("prey", "red", 1, 1), robot("prey", "red", 28, 28)]
    arena = [[0, 0], [30, 0], [30, 30], [0, 30]]
    few = make_world(scene(15, 15, arena=arena, others=near[:1]), pose_jitter_m=0.3)
    many = make_world(scene(15, 15, arena=arena, others=[near[1], near[0]]), pose_jitter_m=0.3)
    assert few.reset(5).sonar_m.tolist() == many.reset(5).sonar_m.tolist()
    for _ in range(100):
        few.step(STOP)
        many.step(STOP)
    assert few.sketch().poses[1] == many.sketch().poses[2]


def test_every_state_is_new_and_read_only(make_world):
    world = make_world("chase-avoid")
    states = [world.reset(1), world.step(STOP).state, world.step(STOP).state]
    before = [state.sonar_m.copy() for state in states]
    world.step(forward(1.0))
    for state, was in zip(states, before, strict=True):
        assert state.sonar_m.shape == (16,)
        assert state.sonar_m.dtype == np.float64
        assert state.sonar_m.tolist() == was.tolist()
        with pytest.raises(ValueError, match="read-only"):
            state.sonar_m[0] = 0.0
        assert not np.shares_memory(state.sonar_m, world.step(STOP).state.sonar_m)
        assert isinstance(state.stalled, bool)
        assert isinstance(state.blobs, tuple)


def test_events_are_plain_floats_by_the_declared_names(make_world):
    world = make_world("chase-avoid")
    world.reset(1)
    for action in ACTIONS:
        step = world.step(action)
        assert type(step.events) is dict
        assert list(step.events) == list(world.event_names)
        assert {type(value) for value in step.events.values()} == {float}
        assert (step.done, step.truncated) == (False, False)


def test_jitter_moves_the_starts_with_the_seed_and_no_farther_than_it_says(make_world):
    world = make_world("cave-predator-prey", pose_jitter_m=0.4)
    plain = make_world("cave-predator-prey")
    plain.reset(1)
    starts = np.array([pose[:3] for pose in plain.sketch().poses])
    moved = []
    for seed in range(20):
        world.reset(seed)
        moved.append(np.array([pose[:3] for pose in world.sketch().poses]) - starts)
    moved = np.array(moved)
    assert np.abs(moved[:, :, :2]).max() <= 0.4
    assert moved[:, :, :2].std() == pytest.approx(0.4 / 3**0.5, rel=0.2)
    assert np.abs(moved[:, :, 2]).max() == 0.0


def test_jitter_that_leaves_no_free_start_is_refused(make_world):
    """A yard in which the robot just fits: no draw of this seed does."""
    arena = [[2.7, 2.8], [3.2, 2.8], [3.2, 3.2], [2.7, 3.2]]
    world = make_world(scene(3.0, 3.0, arena=arena), pose_jitter_m=1.0)
    with pytest.raises(PipelineError, match=r"'pose_jitter_m' is 1\.0, and 100 draws found no free start; lower it"):
        world.reset(1)


def test_a_step_before_the_first_reset_is_a_mistake(make_world):
    with pytest.raises(ContractError, match=r"no trial is running; call reset\(seed\) first"):
        make_world("chase-avoid").step(STOP)


def test_close_releases_the_client_and_a_reset_opens_a_new_one(make_world):
    pybullet = load_pybullet()
    world = make_world("chase-avoid")
    client = Bullet(pybullet)
    world.connect(client)
    first = world.reset(3)
    number = client.call("getNumBodies")
    assert number > 3
    world.close()
    with pytest.raises(pybullet.error, match="Not connected"):
        client.call("getNumBodies")
    with pytest.raises(ContractError, match="no trial is running"):
        world.step(STOP)
    world.close()
    assert world.reset(3).sonar_m.tolist() == first.sonar_m.tolist()


def test_two_worlds_do_not_share_anything(make_world):
    alone = trace(make_world("chase-avoid"), 3)
    one, other = make_world("chase-avoid"), make_world("cave-box")
    one.reset(3)
    other.reset(3)
    other.step(forward(1.0))
    assert trace(one, 3) == alone


def test_a_bound_world_is_ready(make_world):
    world = make_world("cave-box")
    world.bind(Binding(seed=7, slot="world", action=DriveAction))
    assert world.reset(1).stalled is False
    assert world.action is DriveAction


def test_an_unknown_scene_is_told_when_the_world_is_put_together(make_world):
    with pytest.raises(PipelineError, match=r"no scene 'chase-void' \(did you mean 'chase-avoid'\?\)"):
        make_world("chase-void").bind(Binding(seed=7, slot="world", action=DriveAction))


def test_without_pybullet_the_remedy_is_told(make_world, monkeypatch):
    monkeypatch.setitem(sys.modules, "pybullet", None)
    with pytest.raises(PipelineError) as caught:
        make_world("chase-avoid").reset(1)
    assert str(caught.value) == ("world 'pioneer' needs pybullet; install it with: pip install 'tutorstudent[bullet]'")


def test_without_pybullet_the_package_can_still_be_listed():
    program = (
        "import sys; sys.modules['pybullet'] = None\n"
        "from tutorstudent.sims.pioneer import tutorstudent_components\n"
        "print([component.name for component in tutorstudent_components()])"
    )
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "['pioneer']"
    assert "pybullet" not in run.stderr


def test_a_window_that_does_not_open_is_told():
    class Blind:
        GUI, DIRECT = 1, 2

        def connect(self, mode):
            return -1

    with pytest.raises(PipelineError, match=r"could not open its window \(option 'gui'\); run with gui: false"):
        Bullet(Blind(), gui=True)


@pytest.mark.parametrize("name", [path.stem for path in SCENES.glob("*.yaml")])
def test_a_shipped_scene_is_described_by_its_name(make_world, name):
    assert make_world(name).describe()["scene"] == name


def test_a_relative_scene_is_described_so_that_it_is_found_from_elsewhere(
    make_world, write_yaml, tmp_path, monkeypatch
):
    path = write_yaml(scene())
    monkeypatch.chdir(tmp_path)
    world = make_world(path.name, sonar_noise=0.0)
    described = world.describe()
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert described["scene"] == str(path)
    assert (described.pop("use"), described["sonar_noise"]) == ("pioneer", 0.0)
    assert PioneerWorld(**described).describe()["scene"] == str(path)
    assert load_layout(described["scene"]).learner == 0


def test_the_hook_names_the_world():
    assert tutorstudent_components() == [PioneerWorld]
    assert issubclass(PioneerWorld, World)


def every_option(model):
    """Yield name and field of every option, those of nested options too."""
    for name, field in model.model_fields.items():
        yield name, field
        if hasattr(field.annotation, "model_fields"):
            yield from every_option(field.annotation)


def test_every_option_is_described():
    assert [] == [name for name, field in every_option(PioneerOptions) if not field.description]


def test_every_number_has_a_lower_and_an_upper_bound():
    """An option without one could ask for a world that never answers."""
    numbers = [(name, field) for name, field in every_option(PioneerOptions) if field.annotation in NUMBERS]
    assert len(numbers) > 25
    assert [] == [name for name, field in numbers if {type(bound) for bound in field.metadata} not in BOUNDS]


def test_an_action_lasts_an_hour_at_most():
    assert DriveAction(kind="stop", duration_s=3600.0).duration_s == 3600.0
    with pytest.raises(ValidationError, match="less than or equal to 3600"):
        DriveAction(kind="stop", duration_s=3600.1)


def test_the_longest_latencies_are_remembered(make_world):
    world = make_world(scene(), sensor_latency=1000, stall_latency=1000, actor_ticks=1000)
    first = world.reset(1)
    assert world.step(STOP).state.stalled is first.stalled


@pytest.mark.parametrize(
    ("option", "sentence"),
    [
        ({"secne": "cave-box"}, "unknown option 'secne' (did you mean 'scene'?)"),
        (
            {"ticks_per_decision": 0},
            "option 'ticks_per_decision': input should be greater than or equal to 1, found 0.",
        ),
        ({"sensor_latency": -1}, "option 'sensor_latency': input should be greater than or equal to 0"),
        *(
            ({option: 1001}, f"option '{option}': input should be less than or equal to 1000, found 1001.")
            for option in ("ticks_per_decision", "sensor_latency", "stall_latency", "actor_ticks", "side_m")
        ),
        ({"sensor_latency": 10**30}, "option 'sensor_latency': input should be"),
        ({"tick_s": 1e-9}, "option 'tick_s': input should be greater than or equal to 0.01, found 1e-09."),
        ({"camera_fov_deg": 180}, "option 'camera_fov_deg': input should be less than or equal to 170"),
        ({"drive": "legs"}, "option 'drive': input should be 'kinematic', 'planar' or 'wheeled', found 'legs'."),
        ({"prey": {"fast": True}}, "unknown option 'prey.fast'"),
        ({"full_speed_mps": float("nan")}, "option 'full_speed_mps'"),
    ],
)
def test_a_wrong_option_is_named(option, sentence):
    with pytest.raises(PipelineError) as caught:
        PioneerWorld(**option)
    assert sentence in str(caught.value)


def test_the_logged_calls_can_be_made_again_without_the_world(make_world):
    log = CallLog(load_pybullet())
    client = Bullet(log)
    world = make_world("cave-predator-prey")
    world.connect(client)
    world.reset(7)
    log.clear()
    states = [world.step(forward(0.3)).state for _ in range(10)]
    calls = list(log.calls)
    assert {call.function for call in calls} == {
        "rayTestBatch",
        "resetBasePositionAndOrientation",
        "getClosestPoints",
    }
    same = make_world("cave-predator-prey")
    other = Bullet(load_pybullet())
    same.connect(other)
    same.reset(7)
    answers = [call() for call in bind_calls(calls, load_pybullet(), other.client)]
    casts = [answer for call, answer in zip(calls, answers, strict=True) if call.function == "rayTestBatch"]
    hits = np.array([hit[2] for hit in casts[-1]])
    assert len(answers) == len(calls)
    assert len(states) == 10
    assert np.isfinite(hits).all()


def test_only_one_file_imports_pybullet():
    assert "pybullet" not in vars(import_module("tutorstudent.sims.pioneer.pioneer_world"))
    assert bullet.load_pybullet() is sys.modules["pybullet"]
