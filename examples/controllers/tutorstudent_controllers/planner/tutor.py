"""Deliberation first (Thesis 2.1.2): plan a path to a goal, follow it, plan the next one."""

from __future__ import annotations

import math

import numpy as np

import tutorstudent as ts
from tutorstudent_controllers.planner.grid import Cell, Grid
from tutorstudent_controllers.planner.options import PlannerOptions
from tutorstudent_controllers.planner.pursuit import curvature_pm, progress, target
from tutorstudent_controllers.planner.search import shortest_path
from tutorstudent_controllers.planner.state import ArcAction, LocatedState, Outlines, Point, Pose

ARRIVED = "Arrived"
FOLLOW = "Follow"
TURN = "Turn"
BACK_OFF = "Back off"
NO_WAY = "No way"
LOST = "Lost"
TRIES = 200
"""Places that are drawn before it gives up looking for a goal."""


class GridPlanner(ts.Tutor[LocatedState, ArcAction]):
    """Drives to one place after another: A* over a grid of the map, pure pursuit along the path.

    The goals are drawn from the free cells, from the slot's random stream: the same goals in the same order for every
    run of one seed, however fast they are reached.
    """

    name = "grid-planner"
    action = ArcAction
    Options = PlannerOptions
    options: PlannerOptions

    def setup(self) -> None:
        self._outlines: Outlines = ()
        self.reset()

    def reset(self) -> None:
        super().reset()
        self._path: list[Point] = []
        self._at = 0
        self._backing = 0
        self._situation = ""

    @property
    def situation(self) -> str:
        return self._situation

    def act(self, state: LocatedState) -> ArcAction:
        if not _is_sound(state):
            return self._stop(LOST)
        if state.outlines != self._outlines:
            self._grid = Grid(state.outlines, self.options.cell_m, self.options.keep_m)
            self._outlines, self._path = state.outlines, []
        arrived = self._has_arrived(state.pose)
        if arrived or not self._path:
            self._plan(state.pose, self._new_goal(state.pose))
        action = self._recovery(state) or self._drive(state.pose)
        if arrived:
            self._situation = ARRIVED
        return action

    def _has_arrived(self, pose: Pose) -> bool:
        return bool(self._path) and pose.locate(self._path[-1])[0] < self.options.arrived_m

    def _new_goal(self, pose: Pose) -> Cell:
        cells = np.argwhere(self._grid.free)
        for _ in range(TRIES):
            i, j = self.rng.choice(cells)
            goal = (int(i), int(j))
            far = pose.locate(self._grid.middle(goal))[0] >= self.options.goal_m
            if far and self._way(pose, goal):
                return goal
        raise ts.ContractError(
            f"tutor '{self.name}': none of {TRIES} places that are goal_m ({self.options.goal_m}) away can be reached "
            f"from ({pose.x_m:.1f}, {pose.y_m:.1f}); lower goal_m or keep_m."
        )

    def _plan(self, pose: Pose, goal: Cell) -> None:
        self._path = self._way(pose, goal)
        self._at = 0

    def _way(self, pose: Pose, goal: Cell) -> list[Point]:
        start = self._grid.nearest_free(self._grid.cell((pose.x_m, pose.y_m)))
        return [self._grid.middle(cell) for cell in shortest_path(self._grid.free, start, goal)]

    def _recovery(self, state: LocatedState) -> ArcAction | None:
        """Back off after a stall, then plan the way to the same goal again."""
        if self._backing == 0 and not state.stalled:
            return None
        self._backing = self._backing - 1 if self._backing else self.options.back_off
        if self._backing == 0 and self._path:
            self._plan(state.pose, self._grid.cell(self._path[-1]))
        self._situation = BACK_OFF
        return ArcAction(kind="backward", translation=-self.options.translation)

    def _drive(self, pose: Pose) -> ArcAction:
        if not self._path:
            return self._stop(NO_WAY)
        self._at = progress(self._path, pose, self._at)
        distance_m, bearing_rad = pose.locate(target(self._path, self._at, self.options.ahead_m))
        if abs(bearing_rad) > self.options.turn_rad:
            return self._turn(bearing_rad)
        self._situation = FOLLOW
        return self._arc(curvature_pm(max(distance_m, self.options.cell_m), bearing_rad))

    def _stop(self, situation: str) -> ArcAction:
        self._situation = situation
        return ArcAction(kind="stop")

    def _turn(self, bearing_rad: float) -> ArcAction:
        self._situation = TURN
        rotation = math.copysign(self.options.rotation, bearing_rad)
        return ArcAction(kind="left" if rotation > 0 else "right", rotation=rotation)

    def _arc(self, curvature: float) -> ArcAction:
        """Return the arc at the path's speed; slower where it would turn faster than the robot may."""
        options = self.options
        turn = options.translation * options.full_speed_mps * curvature / math.radians(options.full_turn_degps)
        slower = min(1.0, options.rotation / abs(turn)) if turn else 1.0
        return ArcAction(kind="forward", translation=slower * options.translation, rotation=slower * turn)


def _is_sound(state: LocatedState) -> bool:
    """Return whether pose and map are numbers."""
    pose = state.pose
    corners = (number for outline in state.outlines for corner in outline for number in corner)
    return all(map(math.isfinite, (pose.x_m, pose.y_m, pose.heading_rad, *corners)))
