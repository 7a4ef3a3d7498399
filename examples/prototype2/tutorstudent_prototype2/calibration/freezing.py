"""The setting that all reports use: of the settings that agree, the one that fits the thesis's prototype 2 best."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from joblib import Parallel, delayed
from ruamel.yaml import YAML

from tutorstudent_prototype2.calibration.agreement import ENVIRONMENTS, admissible, misfit
from tutorstudent_prototype2.calibration.trials import Counts, run_under
from tutorstudent_prototype2.calibration.walks import FIRST_SEED, Look, from_text, to_text

AFTER_ROUNDS = 40
"""The setting was frozen when the walks had come this far; later rounds serve the predictions."""
CANDIDATES = 10
RUNS = 3
"""Of each candidate in each environment, with seeds that no walk used."""
AGAIN = FIRST_SEED + 500_000


class Candidate(NamedTuple):
    """A setting that agreed, run again."""

    look: Look
    runs: Mapping[str, Sequence[Counts]]
    """By environment; not the run by which it was chosen."""

    @property
    def misfit(self) -> float:
        """How far its means are from the thesis's, see `agreement.misfit`; infinite if a robot was trapped."""
        if not all(admissible(run) for runs in self.runs.values() for run in runs):
            return float("inf")
        return misfit(
            {scene: (_mean(runs, "attractors"), _mean(runs, "collided")) for scene, runs in self.runs.items()}
        )


def most_promising(looks: Sequence[Look], count: int = CANDIDATES) -> list[Look]:
    """Return the settings of the first `AFTER_ROUNDS` that agree and whose one run in each environment fits best."""
    agreeing = [look for look in looks if look.agrees and look.round <= AFTER_ROUNDS]
    return sorted(agreeing, key=_misfit_of_one)[:count]


def run_again(looks: Sequence[Look], workers: int) -> list[Candidate]:
    """Run prototype 2 anew under each setting and return the candidates, the best first."""
    jobs = [(i, scene, AGAIN + run) for i in range(len(looks)) for scene in ENVIRONMENTS for run in range(RUNS)]
    counts = Parallel(n_jobs=workers, batch_size=1)(
        delayed(run_under)(looks[i].setting(), scene, seed) for i, scene, seed in jobs
    )
    found: list[dict[str, list[Counts]]] = [{scene: [] for scene in ENVIRONMENTS} for _ in looks]
    for (i, scene, _), counted in zip(jobs, counts, strict=True):
        found[i][scene].append(counted)
    candidates = [Candidate(look, runs) for look, runs in zip(looks, found, strict=True)]
    return sorted(candidates, key=lambda candidate: candidate.misfit)


def freeze(candidate: Candidate, path: Path, looked_at: int) -> None:
    """Write the setting with a line that says where it comes from."""
    look = candidate.look
    with path.open("w", encoding="utf-8") as stream:
        stream.write(
            "# The free choices of world and tutor, one setting for all environments: the best of "
            f"{looked_at} settings on\n# prototype 2's rows of tables 2, 4, 6 and 8 alone "
            f"(walk {look.walk}, round {look.round}). See docs/fidelity.md.\n"
        )
        yaml = YAML()
        yaml.default_flow_style = None
        yaml.dump(look.setting(), stream)


def save_candidates(path: Path, candidates: Sequence[Candidate]) -> None:
    """Write one line of JSON for each: the look, then its new runs by environment."""
    with path.open("w", encoding="utf-8") as stream:
        for candidate in candidates:
            runs = {scene: [run._asdict() for run in found] for scene, found in candidate.runs.items()}
            stream.write(json.dumps({"look": json.loads(to_text(candidate.look)), "runs": runs}) + "\n")


def load_candidates(path: Path) -> list[Candidate]:
    """Read what `save_candidates` wrote."""
    found = []
    for line in path.read_text(encoding="utf-8").splitlines():
        data = json.loads(line)
        runs = {scene: [Counts(**run) for run in counted] for scene, counted in data["runs"].items()}
        found.append(Candidate(from_text(json.dumps(data["look"])), runs))
    return found


def _misfit_of_one(look: Look) -> float:
    return misfit({scene: (counts.attractors, counts.collided) for scene, counts in look.counts.items()})


def _mean(runs: Sequence[Counts], name: str) -> float:
    return sum(float(getattr(run, name)) for run in runs) / len(runs)
