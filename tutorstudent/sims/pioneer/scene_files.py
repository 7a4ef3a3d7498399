"""Finding and reading scenes: a shipped name, or the path of a YAML file."""

from __future__ import annotations

from pathlib import Path

from tutorstudent.core.files.yamlfile import Document, Location, read_yaml
from tutorstudent.core.words.errors import PipelineError, list_names, suggest
from tutorstudent.sims.pioneer.checking import validate
from tutorstudent.sims.pioneer.scene import RosMap, SceneSpec, Walls

SCENES = Path(__file__).parent / "scenes"
"""The scenes that are shipped."""


def list_scenes() -> list[str]:
    """Return the names of the scenes that come with the package."""
    return sorted(path.stem for path in SCENES.glob("*.yaml"))


def find_scene(name: str) -> Path:
    """Return the file of a shipped scene, or of one given by its path; PipelineError if there is none."""
    if name in list_scenes():
        return SCENES / f"{name}.yaml"
    if _is_file(Path(name)):
        return Path(name)
    raise PipelineError(
        f"world 'pioneer': there is no scene '{name}'{suggest(name, list_scenes())}. "
        f"Shipped scenes: {list_names(list_scenes())}; or give the path of a YAML file."
    )


def make_lasting_name(name: str) -> str:
    """Return a name of the scene that is valid in any working directory: a shipped name, or an absolute path.

    >>> make_lasting_name("cave-box")
    'cave-box'
    """
    return name if name in list_scenes() else str(Path(name).absolute())


def read_scene(path: Path) -> tuple[SceneSpec, Walls | RosMap]:
    """Return a scene and its walls, which may be in another file; the name of a map is the path of its file.

    Raises:
        PipelineError: A file cannot be read, or is no scene.
    """
    document = read_yaml(path)
    spec = validate(SceneSpec, document)
    if isinstance(spec.walls, RosMap):
        file = find_beside(document, ("walls", "ros_map"), spec.walls.ros_map)
        return spec, RosMap(ros_map=str(file))
    if isinstance(spec.walls, str):
        return spec, validate(Walls, read_yaml(find_beside(document, ("walls",), spec.walls)))
    return spec, spec.walls


def find_beside(document: Document, at: Location, name: str) -> Path:
    """Return the file that a key of a document names, from the document's own folder.

    Raises:
        PipelineError: There is no such file.
    """
    path = Path(document.name).parent / name
    if not _is_file(path):
        raise PipelineError(
            f"{document.locate(at)}: there is no file {path}; give the path of one, from the folder of this file."
        )
    return path


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a name that no file can have, or a folder that is closed to us
        return False
