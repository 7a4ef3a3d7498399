"""One language: functions are verbs, a plugin is a part, no three files share a name, records use glossary words."""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

import tutorstudent as ts
from tutorstudent.core.files.registry import ROLES

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "tutorstudent"
FOLDERS = sorted({path.relative_to(PACKAGE).parent.as_posix() for path in PACKAGE.rglob("*.py")})

IRREGULAR = frozenset(
    re.findall(
        r"\w+",
        """begun bound bought broken brought built caught chosen done drawn driven fallen felt found frozen given gone
        grown heard held hidden kept known laid left lost made meant met paid said seen sent shown sold sought spent
        spoken spun stood stuck taken taught thought thrown told understood won worn written""",
    )
)
VERBS_IN_ED = {"embed", "exceed", "feed", "heed", "need", "proceed", "seed", "shed", "speed"}
CONTRACT = {
    "violated": "Condition.violated, the thesis's word",
    "executed": "Tutor.executed, Engine.executed and Loop.executed: hear what was executed",
    "refused": "Engine.refused: hear that the action was refused",
    "judged": "Component.judged: hear what became of a decision",
    "built": "Pipeline.built, public",
    "replaced": "Pipeline.replaced, public",
    "chosen": "study.Searched.chosen, public",
    "spent": "study.Run.spent and study.Study.spent, public",
    "learned_state_is_plain": "a check: parts waive it by its name",
    "learned_state_is_a_copy": "a check: parts waive it by its name",
}
"""Names that are participles and stay: each is a promise to users."""

OF_ACTIONS = re.compile(
    r"moves a component|the component's scale|components of two actions|a component is a number of an action"
    r"|an amplified component|components that are never amplified|the tutor's components|a component ranges over"
    r"|each component in the action class|components and their direction|cannot name a component"
    r"|without the names of its components|\{\{?components: \{|no such component of an action",
    re.IGNORECASE,
)
"""What is said of the components of an action, in folders that are about parts."""
OF_PARTS = ["core/roles", "core/files", "command", "checks", "templates", "plugins", "study"]

RECORDS = (ts.Moment, ts.Decision, ts.GradedAction, ts.Outcome, ts.Lesson, ts.Incident, ts.Turn)
PLAIN = {"before", "by", "limited", "message", "number"}
"""Words of fields that mean what they mean everywhere."""


def is_participle(word: str) -> bool:
    return word in IRREGULAR or (word.endswith("ed") and word not in VERBS_IN_ED)


def functions(folder: Path) -> Iterator[tuple[Path, str]]:
    """Yield every function and method that is no property; one with a capital becomes a class."""
    for path in sorted(folder.glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) or node.name[0].isupper():
                continue
            if not any("property" in ast.unparse(decorator) for decorator in node.decorator_list):
                yield path.relative_to(ROOT), node.name


def texts(path: Path) -> Iterator[str]:
    """Yield docstrings, comments and messages with single spaces; of a template, the whole."""
    source = path.read_text(encoding="utf-8")
    if path.suffix != ".py":
        yield " ".join(re.sub(r"tutorstudent_components|ts\.Component", "", source).split())
        return
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value:
            yield " ".join(node.value.split())
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            yield token.string


def participles(folder: Path) -> list[str]:
    return [
        f"{path}: {name}"
        for path, name in functions(folder)
        if is_participle(name.strip("_").split("_")[0]) and name not in CONTRACT
    ]


def glossary() -> set[str]:
    rows = re.findall(r"^\| *([\w -]+?) *\|", (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8"), re.MULTILINE)
    return {word.replace(" ", "_") for word in rows} - {"word"}


def fields(record: type[object]) -> Sequence[str]:
    """Return the fields of a named tuple, and the properties of anything else."""
    properties = [name for name, value in vars(record).items() if isinstance(value, property)]
    return getattr(record, "_fields", properties)


def is_made_of(name: str, words: set[str]) -> bool:
    return name in words or all({part, part.removesuffix("s")} & words for part in name.split("_"))


@pytest.mark.parametrize("word", ["moved", "shown", "built", "taken", "reached"])
def test_a_participle_is_seen(word: str) -> None:
    assert is_participle(word)


@pytest.mark.parametrize("word", ["move", "read", "heed", "set", "put", "feed", "split"])
def test_a_verb_is_none(word: str) -> None:
    assert not is_participle(word)


@pytest.mark.parametrize("folder", FOLDERS)
def test_functions_are_verbs(folder: str) -> None:
    assert [] == participles(PACKAGE / folder)


def test_functions_of_the_examples_are_verbs() -> None:
    folders = {path.parent for path in (ROOT / "examples").rglob("*.py") if "tests" not in path.parts}
    assert folders
    assert [] == [line for folder in sorted(folders) for line in participles(folder)]


def test_every_exception_is_still_one() -> None:
    assert set(CONTRACT) == {name for folder in FOLDERS for _, name in functions(PACKAGE / folder) if name in CONTRACT}


@pytest.mark.parametrize("folder", OF_PARTS)
def test_a_plugin_is_a_part_and_a_component_is_a_number_of_an_action(folder: str) -> None:
    paths = [path for path in sorted((PACKAGE / folder).rglob("*")) if path.suffix in (".py", ".in")]
    assert paths
    assert [] == [
        f"{path.relative_to(PACKAGE)}: {text}"
        for path in paths
        for text in texts(path)
        if re.search(r"\bcomponents?\b", OF_ACTIONS.sub("", text), re.IGNORECASE)
    ]


def test_no_three_files_share_a_name() -> None:
    stems = Counter(path.stem for path in PACKAGE.rglob("*.py") if not path.stem.startswith("__"))
    assert [] == [stem for stem, times in stems.items() if times > 2]


def test_every_role_is_a_word_of_the_glossary() -> None:
    assert [] == sorted(set(ROLES) - glossary())


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.__name__)
def test_the_fields_of_the_records_are_words_of_the_glossary(record: type[object]) -> None:
    words = glossary() | PLAIN
    assert fields(record)
    assert [] == [field for field in fields(record) if not is_made_of(field, words)]
