"""The environments, registered with Gymnasium by being imported.

    import gymnasium, tutorstudent.sims.gym.envs
    gymnasium.make("tutorstudent/Pioneer-v0", scene="cave-box")

or, in one word, ``gymnasium.make("tutorstudent.sims.gym.envs:tutorstudent/Pioneer-v0")``. Importing Gymnasium alone
does not import this package.
"""

from __future__ import annotations

import gymnasium

from tutorstudent.sims.gym.amplification_env import AmplificationEnv
from tutorstudent.sims.gym.pioneer_env import PioneerEnv

__all__ = ["AmplificationEnv", "PioneerEnv"]

gymnasium.register("tutorstudent/Pioneer-v0", "tutorstudent.sims.gym.pioneer_env:PioneerEnv", max_episode_steps=1000)
gymnasium.register(
    "tutorstudent/Amplification-v0",
    "tutorstudent.sims.gym.amplification_env:AmplificationEnv",
    max_episode_steps=1000,
)
