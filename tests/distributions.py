"""Distributions as an installer leaves them: what third parties give tutorstudent, made for a test."""

from __future__ import annotations

from pathlib import Path


def install(
    folder: Path,
    distribution: str,
    source: str,
    *,
    version: str = "1",
    point: str = "",
    module: str = "",
    points: str = "",
) -> None:
    """Put a distribution with one module into a folder.

    Args:
        folder: Has to be on the path where it is to be found.
        distribution: Its name, such as ``acme-robots``.
        source: Of its module.
        version: Of the distribution.
        point: Name of its entry point; its own name where none is given.
        module: Name of the module; its own name where none is given.
        points: The whole text of its entry points, in place of that one.
    """
    name = distribution.replace("-", "_")
    information = folder / f"{name}-{version}.dist-info"
    information.mkdir()
    (information / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {distribution}\nVersion: {version}\n")
    entry_point = f"[tutorstudent]\n{point or distribution} = {module or name}\n"
    (information / "entry_points.txt").write_text(points or entry_point)
    (folder / f"{module or name}.py").write_text(source)
