"""The deliberative tutor: its grid, its search and its arcs, each against something independent."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding
from tutorstudent_controllers.planner.grid import Grid
from tutorstudent_controllers.planner.pursuit import target
from tutorstudent_controllers.planner.search import STEPS, shortest_path
from tutorstudent_controllers.planner.state import ArcAction, LocatedState, Outlines, Pose
from tutorstudent_controllers.planner.tutor import GridPlanner
from tutorstudent_controllers.planner.world import LocatedWorld

ROOM: Outlines = (((0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)),)
WITH_WALL: Outlines = (*ROOM, ((4.0, 0.0), (4.1, 0.0), (4.1, 6.5), (4.0, 6.5)))


def located(x_m: float, y_m: float, heading_rad: float = 0.0, outlines: Outlines = ROOM, **more: bool) -> LocatedState:
    return LocatedState(np.full(16, 5.0), (), more.get("stalled", False), Pose(x_m, y_m, heading_rad), outlines)


def planner(**options: float) -> GridPlanner:
    made = GridPlanner(**options)
    made.bind(Binding(seed=7, slot="tutor", action=ArcAction))
    return made


def length(path: list[tuple[int, int]]) -> float:
    return sum(math.dist(a, b) for a, b in pairwise(path))


@pytest.mark.parametrize("seed", range(8))
def test_paths_are_as_short_as_dijkstras(seed: int) -> None:
    free = np.random.default_rng(seed).random((12, 9)) > 0.3
    free[0, 0] = free[11, 8] = True
    path = shortest_path(free, (0, 0), (11, 8))
    cells = [(i, j) for i, j in np.argwhere(free).tolist()]
    number = {cell: k for k, cell in enumerate(cells)}
    edges = [
        (number[i, j], number[i + a, j + b], math.hypot(a, b))
        for i, j in cells
        for a, b in STEPS
        if (i + a, j + b) in number
    ]
    tails, heads, costs = zip(*edges, strict=True)
    graph = coo_array((costs, (tails, heads)), shape=(len(cells), len(cells)))
    expected = dijkstra(graph.tocsr(), indices=number[0, 0])[number[11, 8]]
    assert expected == pytest.approx(length(path) if path else math.inf)
    assert all(free[cell] for cell in path)
    assert all(math.dist(a, b) < 1.5 for a, b in pairwise(path))


def test_free_cells_keep_their_distance_from_every_wall() -> None:
    grid = Grid(WITH_WALL, cell_m=0.1, keep_m=0.45)
    middles = np.array([grid.middle((int(i), int(j))) for i, j in np.argwhere(grid.free)])
    inside = middles[(middles[:, 0] < 4) & (middles[:, 1] < 6)]
    assert 0.3 < inside.min()
    assert (4.0 - inside[:, 0]).min() > 0.3
    assert not grid.free[grid.cell((4.05, 3.0))]
    assert grid.free[grid.cell((2.0, 3.0))]
    assert not grid.sees((2.0, 3.0), (6.0, 3.0))
    assert grid.sees((2.0, 7.2), (6.0, 7.2))


def test_a_map_without_room_is_told() -> None:
    with pytest.raises(ts.ContractError, match=r"no place that is 6.0 m away from everything; lower keep_m"):
        Grid(ROOM, cell_m=0.1, keep_m=6.0)


def test_a_goal_that_cannot_be_far_enough_is_told() -> None:
    with pytest.raises(ts.ContractError, match=r"none of 200 places that are goal_m \(50.0\) away .* lower goal_m"):
        planner(goal_m=50.0).act(located(4.0, 4.0))


def test_the_target_lies_ahead_on_the_path() -> None:
    path = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0)]
    assert [(1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 1.0)] == [target(path, 0, ahead_m) for ahead_m in (0.5, 2, 3, 9)]


@pytest.mark.parametrize("outlines", [ROOM, WITH_WALL])
def test_it_reaches_goal_after_goal_without_touching_a_wall(outlines: Outlines) -> None:
    tutor = planner()
    x_m, y_m, heading_rad = 2.0, 2.0, 0.0
    arrivals = 0
    for _ in range(700):
        action = tutor.act(located(x_m, y_m, heading_rad, outlines))
        arrivals += tutor.situation == "Arrived"
        x_m += 0.2 * 0.9 * action.translation * math.cos(heading_rad)
        y_m += 0.2 * 0.9 * action.translation * math.sin(heading_rad)
        heading_rad += 0.2 * math.radians(65) * action.rotation
        assert 0.25 < x_m < 7.75
        assert 0.25 < y_m < 7.75
        assert outlines == ROOM or not (3.75 < x_m < 4.35 and y_m < 6.5)
    assert 3 <= arrivals


def test_amplified_arcs_keep_their_curvature() -> None:
    constant, additive = {"use": "constant", "level": 3}, {"use": "never", "change": "additive"}
    loop = ts.wrap(GridPlanner(), student=constant, amplifier=additive, factor=None, slew=None)
    for heading_rad in (0.0, 0.4, 0.8, 1.2, 1.6):
        executed = loop.step(located(2.0, 2.0, heading_rad))
        assert loop.engine.pending is not None
        said = loop.engine.pending.moment.tutor_action
        assert said.kind == executed.kind
        assert (said.translation, said.rotation) != (executed.translation, executed.rotation)
        assert said.rotation * executed.translation == pytest.approx(said.translation * executed.rotation)


def test_after_a_stall_it_backs_off_and_plans_anew() -> None:
    tutor = planner(back_off=2)
    tutor.act(located(2.0, 2.0))
    kinds = [tutor.act(located(2.0, 2.0, stalled=i == 0)).kind for i in range(4)]
    assert ["backward"] * 3 == kinds[:3]
    assert "backward" != kinds[3]


@pytest.mark.parametrize("broken", [math.nan, math.inf])
def test_without_a_pose_or_a_map_that_is_made_of_numbers_it_stands_still(broken: float) -> None:
    tutor = planner()
    assert "stop" == tutor.act(located(broken, 2.0)).kind
    assert "stop" == tutor.act(located(2.0, 2.0, outlines=(((0.0, 0.0), (broken, 0.0), (8.0, 8.0)),))).kind
    assert "Lost" == tutor.situation
    assert "stop" != tutor.act(located(2.0, 2.0)).kind


def test_the_localiser_says_where_the_robot_was_a_decision_ago() -> None:
    world = LocatedWorld(place_noise_m=0.0, heading_noise_rad=0.0)
    world.bind(Binding(seed=7, slot="world", action=ArcAction))
    try:
        first = world.reset(1)
        assert (1.5, 1.5, math.radians(45)) == pytest.approx((first.pose.x_m, first.pose.y_m, first.pose.heading_rad))
        before = first.pose
        for _ in range(5):
            step = world.step(ArcAction(kind="forward", translation=0.5))
            assert isinstance(step.state, LocatedState)
            assert before == step.state.pose
            assert first.outlines is step.state.outlines
            before = Pose(*(step.events[key] for key in ("x_m", "y_m", "heading_rad")))
    finally:
        world.close()


def test_a_map_with_other_robots_in_it_is_refused() -> None:
    world = LocatedWorld(scene="chase-avoid")
    world.bind(Binding(seed=7, slot="world", action=ArcAction))
    with pytest.raises(ts.PipelineError, match=r"world 'located-pioneer': the scene 'chase-avoid' has 3 robots"):
        world.reset(1)
    world.close()
