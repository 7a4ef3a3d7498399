"""Finding and reading scenes: a shipped name, or the path of a YAML file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError
from ruamel.yaml import YAML
from ruamel.yaml.error import YAMLError

from tutorstudent.core.errors import PipelineError, listing, suggestion
from tutorstudent.sims.pioneer.scene import Box, Circle, Robot, RosMap, SceneSpec, Spec, Walls

SCENES = Path(__file__).parent / "scenes"
"""The scenes that are shipped."""

_KEYS = {key for spec in (SceneSpec, Walls, RosMap, Circle, Box, Robot) for key in spec.model_fields}
ALTERNATIVES = ("circle", "polygon", "walls", "map", "file")
"""Names that pydantic puts into a location where several kinds of value are allowed."""
_SpecT = TypeVar("_SpecT", bound=Spec)


def shipped_scenes() -> list[str]:
    """Return the names of the scenes that come with the package."""
    return sorted(path.stem for path in SCENES.glob("*.yaml"))


def find_scene(name: str) -> Path:
    """Return the file of a shipped scene, or of one given by its path; PipelineError if there is none."""
    if name in shipped_scenes():
        return SCENES / f"{name}.yaml"
    if Path(name).is_file():
        return Path(name)
    raise PipelineError(
        f"world 'pioneer': there is no scene '{name}'{suggestion(name, shipped_scenes())}. "
        f"Shipped scenes: {listing(shipped_scenes())}; or give the path of a YAML file."
    )


def read_scene(path: Path) -> tuple[SceneSpec, Walls | RosMap]:
    """Return what a scene file says, and its walls, wherever they stand."""
    spec = checked(SceneSpec, read_yaml(path), path)
    if not isinstance(spec.walls, str):
        return spec, spec.walls
    file = path.parent / spec.walls
    return spec, checked(Walls, read_yaml(file), file)


def read_yaml(path: Path) -> Any:
    """Return the plain values of a YAML file; PipelineError if it cannot be read."""
    try:
        return YAML(typ="safe", pure=True).load(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise PipelineError(f"{path}: cannot be read: {error.strerror}.") from None
    except (YAMLError, UnicodeDecodeError) as error:
        raise PipelineError(f"{path}: is no YAML: {' '.join(str(error).split())}") from None


def checked(model: type[_SpecT], data: Any, path: Path) -> _SpecT:
    """Return the validated data; PipelineError with the file and the keys of every mistake."""
    try:
        return model.model_validate(data)
    except ValidationError as error:
        raise PipelineError("; ".join(_sentences(error, data, path))) from None


def _sentences(error: ValidationError, data: Any, path: Path) -> Iterator[str]:
    for item in error.errors(include_url=False):
        key = ".".join(_keys(item["loc"], data))
        yield f"{path}: {_problem(key, item)}"


def _keys(loc: tuple[int | str, ...], data: Any) -> Iterator[str]:
    """Yield the keys of a location as they stand in the file; the names of alternatives are not in it."""
    for i, key in enumerate(loc):
        known = isinstance(data, Mapping) and key in data
        if i > 0 and key in ALTERNATIVES and not known:
            continue
        data = _item(data, key)
        yield str(key)


def _item(data: Any, key: int | str) -> Any:
    if isinstance(data, Mapping):
        return data.get(key)
    return data[key] if isinstance(data, list) and isinstance(key, int) and key < len(data) else None


def _problem(key: str, item: Any) -> str:
    last = key.rpartition(".")[2]
    if item["type"] == "extra_forbidden":
        return f"unknown key '{key}'{suggestion(last, _KEYS)}."
    if item["type"] == "missing":
        return f"key '{key}' is required."
    if item["type"] == "value_error":
        return f"{item['ctx']['error']}."
    where = f"key '{key}': " if key else ""
    return f"{where}{item['msg'][0].lower()}{item['msg'][1:]}, found {item['input']!r}."
