"""A pipeline: one YAML file that says which parts make an engine, and in which world it runs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import ExitStack, closing, contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import Field, ValidationError

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.function_tutor import as_tutor
from tutorstudent.core.deciding.guard import OnIncident
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.files.assembly import Assembler
from tutorstudent.core.files.defaults import DEFAULTS, add_change, choose_selector, make_defaults
from tutorstudent.core.files.extending import EXTENDS, read_extended
from tutorstudent.core.files.plainvalues import make_plain
from tutorstudent.core.files.registry import Registry, find_registry
from tutorstudent.core.files.settings import format_setting, set_value
from tutorstudent.core.files.yamlfile import Document, Location
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.interfaces import SLOTS, Tutor
from tutorstudent.core.roles.option_problems import find_option_problems
from tutorstudent.core.roles.part import Options
from tutorstudent.core.roles.world import World
from tutorstudent.core.running.observers import Observer
from tutorstudent.core.running.runner import check_world
from tutorstudent.core.running.transplanting import LearnedFile, transplant
from tutorstudent.core.words.errors import PipelineError, list_names, quote, suggest

PLAIN = ("seed", "decisions", "on_incident", "learned")
KEYS = [EXTENDS, *PLAIN, *SLOTS, "world", "conditions", "limits", "observers", "on_tutor_failure"]


class Header(Options):
    """The plain values of a pipeline."""

    seed: int = Field(0, ge=0, description="the one seed from which every random stream is derived")
    decisions: int = Field(10_000, ge=1, le=1_000_000_000, description="how many decisions a run takes")
    on_incident: OnIncident = Field("continue", description="what to do when a part breaks its contract")
    learned: LearnedFile | None = Field(None, description="learned.npz of a run, what the student begins with")


class Built(NamedTuple):
    """Everything that a pipeline names, built and bound."""

    engine: Engine[Any, Any, Any]
    world: World[Any, Any]
    observers: list[Observer]


class Pipeline:
    """The parts of an engine as plain values, each with its place in the file."""

    def __init__(self, document: Document, registry: Registry | None = None) -> None:
        if not isinstance(document.data, dict):
            found = quote(document.data)
            raise PipelineError(
                f"{document.name}: found {found}; a pipeline is a mapping with the keys {', '.join(KEYS)}."
            )
        self.document = document
        self.registry = registry or find_registry()
        self._assembler = Assembler(document, self.registry)
        if "selector" not in document.data:  # what does not fit the default one is the student
            self._assembler.place_slot("selector", ("student",))
        self._assembler.check_keys(document.data, KEYS, ())
        if EXTENDS in document.data:
            raise self._assembler.make_error((EXTENDS,), "'extends' works only in a file; write it there.")
        header = {key: document.data[key] for key in PLAIN if key in document.data}
        self.header = self._assembler.make_model(Header, header, (), "pipeline")

    @classmethod
    def read(cls, path: Path | str, registry: Registry | None = None) -> Pipeline:
        """Return the pipeline of a YAML file, and of what that file extends."""
        return cls(read_extended(Path(path)), registry)

    def replaced(self, values: Mapping[str, Any]) -> Pipeline:
        """Return this pipeline with other values for some dotted keys, as in ``{"world.scene": "cave-box"}``.

        Raises:
            PipelineError: if a key leads through something other than a mapping, or there is no such key.
        """
        document, data = self.document, dict(self.document.data)
        for dotted, value in values.items():
            set_value(data, dotted, value, document.name)
            document = document.replace(tuple(dotted.split(".")), data, format_setting(dotted, value))
        return Pipeline(document, self.registry)

    @contextmanager
    def built(self) -> Iterator[Built]:
        """Build engine, world and observers, and close them all at the end, even if closing one of them fails.

        Raises:
            TutorStudentError: if something cannot be built; the message says where and what to do.
        """
        with ExitStack() as stack:
            engine = stack.enter_context(closing(self.engine()))
            action = engine.tutor.action
            world = stack.enter_context(closing(self.world(action)))
            observers = [stack.enter_context(closing(observer)) for observer in self.observers(action)]
            with self._assembler.locate_errors(("world",)):
                check_world(engine, world)
            yield Built(engine, world, observers)

    def engine(self, **given: Any) -> Engine[Any, Any, Any]:
        """Build the engine. A part given for a slot replaces the file's; None stands for the file's own.

        Raises:
            TutorStudentError: if it cannot be built; the message says where and what to do.
        """
        _check_given(given)
        parts = self._make_slots(given)
        if (conditions := given.get("conditions")) is None:
            conditions = self._assembler.make_parts("condition", self._get_value("conditions"), ("conditions",))
            for i, part in enumerate(conditions):
                self._assembler.place_slot(f"conditions.{part.label}", ("conditions", i))
        limits = self._make_limits(parts["tutor"])
        with self._assembler.locate_errors(()):
            engine: Engine[Any, Any, Any] = Engine(
                **parts,
                conditions=conditions,
                limits=limits,
                seed=self.header.seed,
                on_incident=self.header.on_incident,
                on_tutor_failure=self._make_failure_action(parts["tutor"]),
            )
        if self.header.learned is not None:
            with self._assembler.locate_errors(("learned",)):
                transplant(self.header.learned, engine.student)
        return engine

    def world(self, action: type[Any]) -> World[Any, Any]:
        """Build the world that the file names, bound for the actions of the engine."""
        if "world" not in self.document.data:
            raise PipelineError(
                f"{self.document.name}: there is no 'world'; add one, as in 'world: {{use: pioneer, scene: cave-box}}'."
            )
        world: World[Any, Any] = self._assembler.make_part("world", self.document.data["world"], ("world",))
        with self._assembler.locate_errors(("world",)):
            world.bind(Binding(self.header.seed, "world", action))
        return world

    def observers(self, action: type[Any]) -> list[Observer]:
        """Build the observers that the file names."""
        found: list[Observer] = self._assembler.make_parts("observer", self._get_value("observers"), ("observers",))
        for i, observer in enumerate(found):
            with self._assembler.locate_errors(("observers", i)):
                observer.bind(Binding(self.header.seed, f"observers.{i}", action))
        return found

    def _make_slots(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """Return the part of every slot; what the file leaves out depends on the tutor's actions."""
        found, parts = self.document.data, {slot: part for slot, part in given.items() if part is not None}
        tutor = parts["tutor"] if "tutor" in parts else self._make_part("tutor", found.get("tutor"))
        parts["tutor"], left_out = tutor, make_defaults(tutor)
        for slot in SLOTS:
            if slot in parts:
                continue
            value = found.get(slot, left_out.get(slot))
            if slot == "amplifier":
                value = add_change(value, tutor, self.registry)
            elif slot == "selector" and slot not in found:
                value = choose_selector(parts["student"], tutor)
            parts[slot] = self._make_part(slot, value)
        return {slot: parts[slot] for slot in SLOTS}

    def _make_part(self, slot: str, value: Any) -> Any:
        if slot not in self.document.data and value is None:
            raise PipelineError(f"{self.document.name}: there is no '{slot}'; name one, as in '{slot}: {{use: ...}}'.")
        return self._assembler.make_part(slot, value, (slot,))

    def _get_value(self, key: str) -> Any:
        return self.document.data.get(key, DEFAULTS.get(key))

    def _make_limits(self, tutor: Tutor[Any, Any]) -> Limits:
        values = self._get_value("limits")
        if not isinstance(values, dict):
            raise self._assembler.make_error(
                ("limits",), f"found {quote(values)}; write a mapping, as in limits: {{cap: 0.8}}."
            )
        return self._assembler.make_model(Limits, make_defaults(tutor)["limits"] | values, ("limits",), "limits")

    def _make_failure_action(self, tutor: Tutor[Any, Any]) -> Any:
        values = self._get_value("on_tutor_failure")
        if values == "raise":
            return None
        at: Location = ("on_tutor_failure",)
        calm = next((kind for kind, group in tutor.action.vocabulary.groups.items() if not group), "...")
        remedy = f"Write 'raise' or an action, as in on_tutor_failure: {{kind: {calm}}}."
        if not isinstance(values, dict):
            near = suggest(values, ["raise"]) if isinstance(values, str) else ""
            raise self._assembler.make_error(at, f"found {quote(values)}{near}. {remedy}")
        try:
            return tutor.action(**values)
        except ValidationError as error:
            location, problem = find_option_problems(tutor.action, error)[0]
            raise self._assembler.make_error(
                (*at, *location), f"not a {tutor.action.__name__}: {problem} {remedy}"
            ) from None


def _check_given(given: Mapping[str, Any]) -> None:
    allowed = [*SLOTS, "conditions"]
    for slot in given:
        if slot not in allowed:
            raise PipelineError(
                f"there is no slot '{slot}' for a part of your own{suggest(slot, allowed)}. "
                f"Slots: {list_names(allowed)}."
            )


def describe(engine: Engine[Any, Any, Any], world: World[Any, Any], pipeline: Pipeline) -> dict[str, Any]:
    """Return a pipeline with every option written out, defaults included; it can be read again.

    Raises:
        PipelineError: if an option has no form that a file can hold.
    """
    failure = engine.on_tutor_failure
    values = (
        pipeline.header.model_dump()
        | {"world": world.describe()}
        | {slot: getattr(engine, slot).describe() for slot in SLOTS}
        | {
            "conditions": [condition.describe() for condition in engine.conditions],
            "limits": engine.limits.model_dump(),
            "observers": pipeline.document.data.get("observers", []),
            "on_tutor_failure": "raise" if failure is None else failure.model_dump(),
        }
    )
    return {key: make_plain(value, pipeline.document.locate((key,))) for key, value in values.items()}


def load(path: Path | str, *, tutor: Any = None, action: Any = None, **parts: Any) -> Engine[Any, Any, Any]:
    """Return the engine of a pipeline file, for a loop of your own.

    Args:
        path: The YAML file.
        tutor: Replaces the file's tutor: a `Tutor`, or any callable of the state together with `action`.
        action: The action class of a callable tutor.
        parts: Other parts by slot, for example ``student=...``; None stands for the file's own.

    Raises:
        TutorStudentError: if it cannot be built; the message says where and what to do.
    """
    if tutor is None and action is not None:
        raise PipelineError("load(): 'action' is the action class of a callable tutor; give the tutor too.")
    given = parts if tutor is None else parts | {"tutor": as_tutor(tutor, action)}
    return Pipeline.read(path).engine(**given)
