"""Snippets for mypy; some are wrong on purpose and must not be imported."""

collect_ignore_glob = ["*.py"]
