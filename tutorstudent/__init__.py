"""Wrap a controller that already works with a learner, so that it improves while it stays in command."""

from tutorstudent.core.actions import Action, component
from tutorstudent.core.adapters import FunctionTutor, Loop
from tutorstudent.core.commands import scalar, vector
from tutorstudent.core.component import Binding, Component, Field, Options, Part
from tutorstudent.core.engine import Engine
from tutorstudent.core.errors import (
    BrokenPlugin,
    ContractError,
    DuplicatePlugin,
    PipelineError,
    PluginError,
    TutorStudentError,
    UnknownPlugin,
)
from tutorstudent.core.hookspecs import hookimpl
from tutorstudent.core.interfaces import ActionSelector, Amplifier, Evaluator, Student, Tutor
from tutorstudent.core.leaves import Change, Codec, Condition, Encoder, change, condition, encoder
from tutorstudent.core.limits import Limits
from tutorstudent.core.observers import Begin, Entries, Observer
from tutorstudent.core.pipeline import Pipeline, load
from tutorstudent.core.proposals import KindProposal, LevelProposal
from tutorstudent.core.records import Decision, GradedAction, Incident, Lesson, Moment, Outcome, Turn
from tutorstudent.core.registry import Registry
from tutorstudent.core.runner import run
from tutorstudent.core.world import Sketch, Step, World
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
    "UnknownPlugin",
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
