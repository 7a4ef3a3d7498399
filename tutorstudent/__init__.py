"""Wrap a controller that already works with a learner, so that it improves while it stays in command."""

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.function_tutor import FunctionTutor
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.deciding.loop import Loop
from tutorstudent.core.files.pipeline import Pipeline, load
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.interfaces import ActionSelector, Amplifier, Evaluator, Student, Tutor
from tutorstudent.core.roles.leaves import Change, Codec, Condition, Encoder, change, condition, encoder
from tutorstudent.core.roles.part import Component, Field, Options
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.roles.world import Sketch, Step, World
from tutorstudent.core.running.observers import Begin, Entries, Observer
from tutorstudent.core.running.runner import run
from tutorstudent.core.words.actions import Action, component
from tutorstudent.core.words.commands import scalar, vector
from tutorstudent.core.words.errors import (
    BrokenPlugin,
    ContractError,
    DuplicatePlugin,
    PipelineError,
    PluginError,
    TutorStudentError,
    TutorStudentWarning,
    UnknownPlugin,
    UnreadableState,
)
from tutorstudent.core.words.measures import Measure
from tutorstudent.core.words.proposals import KindProposal, LevelProposal
from tutorstudent.core.words.records import Decision, GradedAction, Incident, Lesson, Moment, Outcome
from tutorstudent.core.words.turn import Turn
from tutorstudent.wrapping import wrap

__version__ = "0.1.0"

__all__ = [
    "Action",
    "ActionSelector",
    "Amplifier",
    "Begin",
    "Binding",
    "BrokenPlugin",
    "Change",
    "Codec",
    "Component",
    "Condition",
    "ContractError",
    "Decision",
    "DuplicatePlugin",
    "Encoder",
    "Engine",
    "Entries",
    "Evaluator",
    "Field",
    "FunctionTutor",
    "GradedAction",
    "Incident",
    "KindProposal",
    "Lesson",
    "LevelProposal",
    "Limits",
    "Loop",
    "Measure",
    "Moment",
    "Observer",
    "Options",
    "Outcome",
    "Part",
    "Pipeline",
    "PipelineError",
    "PluginError",
    "Registry",
    "Sketch",
    "Step",
    "Student",
    "Turn",
    "Tutor",
    "TutorStudentError",
    "TutorStudentWarning",
    "UnknownPlugin",
    "UnreadableState",
    "World",
    "change",
    "component",
    "condition",
    "encoder",
    "hookimpl",
    "load",
    "run",
    "scalar",
    "vector",
    "wrap",
]
