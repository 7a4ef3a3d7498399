"""The study's corridor and its pipelines, for the commands that compare them."""

from tests.study.conftest import corridor_distribution, files, registry

__all__ = ["corridor_distribution", "files", "registry"]
