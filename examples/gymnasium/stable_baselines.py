"""Stable-Baselines3 in the student's place, under the same behaviour contract.

    python stable_baselines.py PIPELINE [DECISIONS]

PPO chooses the amplification level of every decision of a pipeline and is rewarded for distance and punished for
violations; the engine goes on enforcing the pipeline's limits. Prints both per 100 decisions, for the tutor alone, a
random level, and what was learned. Reinforcement learners want far more decisions than a student; the figures say so.
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np

import tutorstudent.sims.gym.envs  # noqa: F401 - registers the environments

MISSING = "this example needs Stable-Baselines3; install it with: pip install stable-baselines3"
USAGE = "usage: python stable_baselines.py PIPELINE [DECISIONS], as in prototype2a.yaml 20000"
WEIGHTS = {"distance_m": 1.0, "violated": -1.0}
JUDGED = 1000


def judge(env: Any, choose: Callable[[Any], Any]) -> str:
    """Return what a way of choosing levels comes to, over a trial that nobody learns from."""
    seen, _ = env.reset(seed=1)
    distance_m = violated = 0.0
    for _ in range(JUDGED):
        seen, _, _, _, info = env.step(choose(seen))
        distance_m, violated = distance_m + info["distance_m"], violated + info["violated"]
    return f"{100 * distance_m / JUDGED:.1f} m, {100 * violated / JUDGED:.2f} violations per 100 decisions"


def main(arguments: list[str]) -> str | None:
    """Learn, then judge; return a sentence where something is missing."""
    if len(arguments) not in (1, 2):
        return USAGE
    try:
        ppo = importlib.import_module("stable_baselines3").PPO
    except ImportError:
        return MISSING
    make: dict[str, Any] = {"pipeline": arguments[0], "weights": WEIGHTS}
    model = ppo("MlpPolicy", gymnasium.make("tutorstudent/Amplification-v0", **make), seed=7, n_steps=512, device="cpu")
    model.learn(int(arguments[1]) if len(arguments) == 2 else 20_000)
    env = gymnasium.make("tutorstudent/Amplification-v0", **make)
    rng = np.random.default_rng(7)
    ways: dict[str, Callable[[Any], Any]] = {
        "tutor alone": lambda _: 0,
        "random level": lambda _: int(rng.integers(9)),
        "learned level": lambda seen: int(model.predict(seen, deterministic=True)[0]),
    }
    for name, choose in ways.items():
        print(f"{name}: {judge(env, choose)}")  # noqa: T201
    return None


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
