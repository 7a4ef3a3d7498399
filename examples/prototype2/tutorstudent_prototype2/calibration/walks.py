"""Random walks among the settings that agree with the thesis: approximate Bayesian computation by Markov chains.

A walk stands on a setting. In every round it looks at a neighbour, runs prototype 2 there in the four environments
with a new seed, and goes there if the neighbour agrees with the thesis in all of them; neighbours are as probable one
way as the other, so that a walk stands on settings that agree as often as their prior probability says (Marjoram et
al. 2003). They are no best fit: they show how much the thesis's rows of prototype 2 leave open.

A look depends on the rounds before, its walk and its round only: it is the same on any machine, with any number of
processes and after an interruption. Everything that was looked at is kept, with the environment that spoke against it.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from joblib import Parallel, delayed

from tutorstudent_prototype2.calibration.agreement import ENVIRONMENTS, agrees, limits
from tutorstudent_prototype2.calibration.choices import NARROW, START, WIDE, move, setting_of
from tutorstudent_prototype2.calibration.places import Floor, Point
from tutorstudent_prototype2.calibration.trials import Counts, run_under
from tutorstudent_prototype2.pipelines import load

FIRST_SEED = 100_000
"""Seeds of the search; the seeds of reports are below 1,000."""
WIDE_ROUNDS = 25
"""Walks begin with wide strides, to leave the start; then strides are narrow, so that more looks agree."""
SIDE_M = 15.0
START_PLACES = ((7, 58), (70, 8), (75, 82), (36, 83), (92, 35), (34, 17))
"""Where the boxes of the shipped scenes stand, percent of the side."""


class Look(NamedTuple):
    """A setting that a walk looked at."""

    walk: int
    round: int
    choices: dict[str, float]
    box_places: list[Point]
    counts: dict[str, Counts]
    """By environment, in the order in which they were tried; the last one may speak against the setting."""

    @property
    def agrees(self) -> bool:
        """Whether prototype 2 agrees with the thesis in every environment."""
        return len(self.counts) == len(ENVIRONMENTS) and all(
            agrees(scene, self.counts[scene]) for scene in ENVIRONMENTS
        )

    @property
    def seed(self) -> int:
        """Seed of its runs."""
        return FIRST_SEED + 1000 * self.walk + self.round

    def setting(self) -> dict[str, dict[str, Any]]:
        """Return the options that it stands for."""
        return setting_of(self.choices, self.box_places)


def start(walk: int) -> Look:
    """Return where a walk begins; it was not looked at and counts for nothing."""
    return Look(walk, 0, dict(START), [(float(x), float(y)) for x, y in START_PLACES], {})


def neighbour(here: Look, number: int) -> Look:
    """Return the setting that a walk looks at next, in round `number`."""
    rng = np.random.default_rng([FIRST_SEED, here.walk, number])
    stride = WIDE if number <= WIDE_ROUNDS else NARROW
    choices = move(here.choices, stride, rng)
    return Look(here.walk, number, choices, _floor().move(here.box_places, stride.changed / 2, rng), {})


def try_out(look: Look) -> Look:
    """Run prototype 2 under a setting, environment by environment, until one speaks against it."""
    counts: dict[str, Counts] = {}
    for scene in ENVIRONMENTS:
        counts[scene] = run_under(look.setting(), scene, look.seed, limits=limits(scene))
        if not agrees(scene, counts[scene]):
            break
    return look._replace(counts=counts)


def walk_on(folder: Path, walks: int, rounds: int, workers: int) -> Iterator[list[Look]]:
    """Bring every walk to `rounds` rounds and yield all looks of each round; what the folder holds is not run again."""
    folder.mkdir(parents=True, exist_ok=True)
    standing = [start(walk) for walk in range(walks)]
    with Parallel(n_jobs=workers, batch_size=1) as parallel:
        for number in range(1, rounds + 1):
            looks = parallel(delayed(_look)(folder, here, number) for here in standing)
            standing = [look if look.agrees else here for look, here in zip(looks, standing, strict=True)]
            yield looks


def stays(looks: Sequence[Look]) -> list[tuple[Look, int]]:
    """Return every setting that a walk stood on, and for how many rounds."""
    found: list[tuple[Look, int]] = []
    for walk in sorted({look.walk for look in looks}):
        here: Look | None = None
        rounds = 0
        for look in sorted((look for look in looks if look.walk == walk), key=lambda look: look.round):
            if look.agrees and here is not None:
                found.append((here, rounds))
            here, rounds = (look, 1) if look.agrees else (here, rounds + 1)
        if here is not None:
            found.append((here, rounds))
    return found


def keep_looks(folder: Path, looks: Sequence[Look]) -> None:
    """Put looks of earlier days where `walk_on` finds them."""
    folder.mkdir(parents=True, exist_ok=True)
    for look in looks:
        _file(folder, look).write_text(to_text(look), encoding="utf-8")


def read_looks(folder: Path) -> list[Look]:
    """Return everything that was looked at, round by round."""
    found = [from_text(path.read_text(encoding="utf-8")) for path in folder.glob("round-*.json")]
    return sorted(found, key=lambda look: (look.round, look.walk))


def save_looks(path: Path, looks: Sequence[Look]) -> None:
    """Write one line of JSON for each."""
    path.write_text("".join(to_text(look) for look in looks), encoding="utf-8")


def load_looks(path: Path) -> list[Look]:
    """Read what `save_looks` wrote."""
    return [from_text(line) for line in path.read_text(encoding="utf-8").splitlines()]


def _look(folder: Path, here: Look, number: int) -> Look:
    path = _file(folder, here._replace(round=number))
    if path.exists():
        return from_text(path.read_text(encoding="utf-8"))
    look = try_out(neighbour(here, number))
    partial = path.with_suffix(f".{os.getpid()}")
    partial.write_text(to_text(look), encoding="utf-8")
    partial.replace(path)
    return look


def _file(folder: Path, look: Look) -> Path:
    return folder / f"round-{look.round:04}-walk-{look.walk:02}.json"


def to_text(look: Look) -> str:
    """Return one line of JSON."""
    counts = {scene: counts._asdict() for scene, counts in look.counts.items()}
    return json.dumps(look._asdict() | {"counts": counts}) + "\n"


def from_text(text: str) -> Look:
    """Read what `to_text` wrote."""
    data = json.loads(text)
    counts = {scene: Counts(**values) for scene, values in data["counts"].items()}
    places = [(float(x), float(y)) for x, y in data["box_places"]]
    return Look(data["walk"], data["round"], data["choices"], places, counts)


@cache
def _floor() -> Floor:
    with load("prototype2", "cave-predator-prey").built() as (_, world, _observers):
        world.reset(0)
        sketch = world.sketch()
    outlines = [outline for outline, colour in sketch.polygons if colour == "black"]
    return Floor(outlines, [(pose[0], pose[1]) for pose in sketch.poses], SIDE_M)
