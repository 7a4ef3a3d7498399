"""Action classes for controllers that command one number, or a fixed number of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, ClassVar

from pydantic import ValidationError, create_model

from tutorstudent.core.words.actions import Action, component, read_vocabulary
from tutorstudent.core.words.errors import ContractError, quote
from tutorstudent.core.words.forms import Form, OwnForm, PlainForm
from tutorstudent.core.words.named_form import NamedForm

Read = Callable[[Any], Any]
Write = Callable[[Any, Any], Any]


class Command(Action):
    """An action of one kind that stands for the owner's own command."""

    form: ClassVar[Form]
    """How the owner's command is read and written; by default it is a number, or a sequence of numbers."""

    @classmethod
    def __pydantic_init_subclass__(cls, **kwargs: Any) -> None:
        super().__pydantic_init_subclass__(**kwargs)
        if isinstance(getattr(cls, "form", None), PlainForm | None):
            cls.form = PlainForm(len(cls.vocabulary.components))

    @classmethod
    def read(cls, command: Any) -> Command:
        """Return the action that an owner's command stands for.

        Raises:
            ContractError: if it is not of the class's form, or out of bounds.
        """
        names = cls.vocabulary.components
        numbers = cls.form.read(command)
        try:
            return cls.model_validate(dict(zip(names, numbers, strict=True)))
        except ValidationError as error:
            problem = error.errors(include_url=False)[0]
            where = f"'{problem['loc'][-1]}': " if len(names) > 1 else ""
            raise ContractError(
                f"the controller's command is {quote(command)}: {where}{problem['msg'][0].lower()}{problem['msg'][1:]}."
                " State wider bounds, as in action=ts.scalar(-2, 2), or keep the controller within these."
            ) from None

    def write(self, like: Any) -> Any:
        """Return a new command in the type and shape of `like`, a command that `read` took."""
        return self.form.write([self.__dict__[name] for name in self.vocabulary.components], like)


def scalar(
    low: float | None = None,
    high: float | None = None,
    *,
    neutral: float = 0.0,
    scale: float | None = None,
    unit: str = "",
    name: str | None = None,
    read: Read | None = None,
    write: Write | None = None,
) -> type[Command]:
    """Return an action class of one number, amplified outward: away from neutral, and not at all at neutral.

    Args:
        low: Smallest value, or none.
        high: Largest value, or none.
        neutral: The value at which the command does nothing.
        scale: One whole unit of amplification; by default the larger bound's distance from zero.
        unit: Physical unit, for people.
        name: Where the command is an object or a mapping: the attribute or key that is the number.
        read: For any other command: returns its number.
        write: ``write(command, number)`` returns a new command with the number; the command is the last one that was
            read, None before there was any.

    >>> scalar(-1, 1)(value=0.25)
    Scalar(kind='command', value=0.25)
    """
    names = None if name is None else [name]
    form = _make_form("scalar()", 1, names, read, write)
    return _make_command(
        "Scalar", {name or "value": component(low, high, neutral=neutral, scale=scale, unit=unit)}, form
    )


def vector(
    low: Sequence[float] | float,
    high: Sequence[float] | float,
    size: int | None = None,
    *,
    neutral: float = 0.0,
    unit: str = "",
    names: Sequence[str] | None = None,
    read: Read | None = None,
    write: Write | None = None,
) -> type[Command]:
    """Return an action class of several numbers that are amplified together, so that their direction is kept.

    Args:
        low: Smallest value of all numbers, or of each.
        high: Largest value of all numbers, or of each.
        size: How many numbers; may be left out where there are names.
        neutral: The value at which a number does nothing.
        unit: Physical unit, for people.
        names: Where the command is an object or a mapping: the attributes or keys that are the numbers, with dots for
            what lies deeper: ``["linear.x", "angular.z"]``. A copy of the command with these changed comes back.
        read: For any other command: returns its numbers.
        write: ``write(command, numbers)`` returns a new command with the list of numbers; see `scalar`.

    >>> vector(-1, 1, 2).read([0.3, -0.4])
    Vector(kind='command', x0=0.3, x1=-0.4)
    """
    size = len(names or ()) if size is None else size
    form = _make_form("vector()", size, names, read, write)
    lows, highs = ([bound] * size if isinstance(bound, int | float) else list(bound) for bound in (low, high))
    if len(lows) != size or len(highs) != size:
        raise ContractError(f"vector(): found {len(lows)} low and {len(highs)} high bounds; expected {size} of each.")
    called = names or [f"x{i}" for i in range(size)]
    bounds = zip(lows, highs, strict=True)
    fields = [component(least, most, neutral=neutral, unit=unit) for least, most in bounds]
    return _make_command("Vector", dict(zip(called, fields, strict=True)), form)


def _make_form(what: str, size: int, names: Sequence[str] | None, read: Read | None, write: Write | None) -> Form:
    if size < 1:
        raise ContractError(f"{what}: found the size {size}; say how many numbers there are, 1 or more, or names=.")
    if names is not None:
        _check_names(what, size, names)
        if read is not None or write is not None:
            raise ContractError(
                f"{what}: found names and read= or write=; either names say where the numbers are, "
                "or the two functions do."
            )
        return NamedForm(names)
    if read is None and write is None:
        return PlainForm(size)
    if not callable(read) or not callable(write):
        raise ContractError(f"{what}: found read={read!r} and write={write!r}; give two functions, or neither.")
    return OwnForm(size, read, write)


def _check_names(what: str, size: int, names: Sequence[str]) -> None:
    if isinstance(names, str) or not all(isinstance(name, str) for name in names):
        raise ContractError(f"{what}: found names={names!r}; expected a list of strings.")
    if len(names) != size or len(set(names)) != size:
        raise ContractError(f"{what}: found the names {', '.join(names)}; expected {size} different ones.")
    for name in names:
        if not all(name.split(".")) or name.startswith("_") or hasattr(Command, name) or name == "kind":
            raise ContractError(
                f"{what}: a number cannot be called '{name}' here; give read= and write= instead of names."
            )


def _make_command(title: str, fields: dict[str, Any], form: Form) -> type[Command]:
    typed: dict[str, Any] = {name: (float, field) for name, field in fields.items()}
    made: type[Command] = create_model(title, __base__=Command, __module__=__name__, **typed)
    made.form = form
    made.amplification = {"command": {tuple(fields): "outward"}}
    made.vocabulary = read_vocabulary(made)
    return made
