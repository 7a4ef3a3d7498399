"""A controller in Python whose environment holds what ours cannot: another version of a package that we use too."""

from __future__ import annotations

import json
import sys
from importlib import metadata

import gains


def torque(observation: list[float]) -> float:
    """Return the torque that damps the pendulum, within -2 and 2 N m."""
    _, _, speed_radps = observation
    return max(-2.0, min(2.0, -gains.DAMPING * speed_radps))


def main() -> None:
    """Answer every decision; whatever else is said needs no answer."""
    situation = f"gains {metadata.version('gains')}"
    for line in sys.stdin:
        message = json.loads(line)
        if message["type"] == "hello":
            say({"type": "hello", "protocol": 1})
        elif message["type"] == "decide":
            action = {"torque": torque(message["state"]["observation"])}
            say({"type": "action", "number": message["number"], "action": action, "situation": situation})


def say(message: dict[str, object]) -> None:
    """Write one line, at once."""
    sys.stdout.write(json.dumps(message) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
