"""Writes a new plugin: a package that can be installed, with a working part, its tests and a pipeline."""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from string import Template

import tutorstudent
from tutorstudent.core.files.rundir import explain_write_errors
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.templates.naming import Names
from tutorstudent.templates.pipelines import fill_slots

SUFFIX = ".in"
BESIDE = {"tutor": ("Approaches",)}
"""What an example adds to the part, by role: an observer, so that a comparison has something to count."""


def write_plugin(names: Names, out: Path) -> list[Path]:
    """Write the plugin's files into a folder, and return them.

    Args:
        names: What it is called.
        out: The folder; it must be new or empty.

    Raises:
        PipelineError: if it is neither, or cannot be written.
    """
    with explain_write_errors(out):
        if out.exists() and (not out.is_dir() or any(out.iterdir())):
            raise PipelineError(f"{out}: it exists and is not an empty folder; give another folder with --out.")
        return [_write(out / path, text) for path, text in make_contents(names).items()]


def make_contents(names: Names) -> dict[str, str]:
    """Return the plugin's files by path."""
    role, module = names.role, names.module
    sources = {
        "pyproject.toml": "common/pyproject.toml",
        "README.md": "common/README.md",
        ".gitignore": "common/gitignore",
        "pipeline.yaml": "common/pipeline.yaml",
        f"{module}/__init__.py": "common/init.py",
        f"{module}/{role}.py": f"{role}/part.py",
        f"tests/test_{module}.py": f"{role}/test.py",
    }
    values = _make_values(names)
    return {path: Template(_read_text(source)).substitute(values) for path, source in sources.items()} | {
        f"{module}/py.typed": ""
    }


def _make_values(names: Names) -> dict[str, str]:
    article = "an" if names.role[0] in "aeiou" else "a"
    words = {"article": article, "article_upper": article.capitalize(), "version": tutorstudent.__version__}
    return fill_slots(names.role, names.name) | names._asdict() | words | _list_classes(names)


def _list_classes(names: Names) -> dict[str, str]:
    """Return the plugin's classes as its files list them, sorted where a linter wants that."""
    provided = [names.class_name, *BESIDE.get(names.role, ())]
    exported = ", ".join(f'"{name}"' for name in sorted(provided))
    return {"provided": ", ".join(provided), "imported": ", ".join(sorted(provided)), "exported": exported}


def _read_text(source: str) -> str:
    file = resources.files(tutorstudent).joinpath("templates", "files", *f"{source}{SUFFIX}".split("/"))
    return file.read_text(encoding="utf-8")


def _write(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return path
