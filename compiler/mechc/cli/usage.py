"""What a command line may hold, as data: commands with their arguments and options.

:mod:`.plain` reads a command line that is right by it. :mod:`.by_click` hands it to click, which
has the words for one that is wrong, for help and for completion, and takes longer to be imported
than a description to be compiled.
"""

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, Literal, TypeVar

from ..base.frozen import field, frozen
from ..base.named import NamedTuple
from ..files import library

F = TypeVar("F", bound=Callable[..., Any])


class Proposal(NamedTuple):
    """What the Tab key offers: a word, or the shell's own files that begin so."""

    value: str
    help: str = ""
    kind: Literal["plain", "file"] = "plain"


Complete = Callable[[str], Iterable[Proposal]]
"""Returns what may stand where something has been begun."""


@frozen
class Word:
    """One of a few words; the nearest one is proposed for a word that is none of them."""

    choices: tuple[str, ...]


@frozen
class WholeNumber:
    """A whole number from ``low`` to ``high``."""

    low: int
    high: int


@frozen
class Argument:
    """What stands without a flag: one word, or all there are."""

    name: str
    several: bool = field(default=False, kw_only=True)
    required: bool = field(default=True, kw_only=True)
    kind: Word | None = field(default=None, kw_only=True)
    metavar: str | None = field(default=None, kw_only=True)
    complete: Complete | None = field(default=None, kw_only=True)


@frozen
class Option:
    """What a flag sets: a value behind it, or itself.

    ``of_session`` states that it says how messages look, and is no argument of the command.
    """

    name: str
    flags: tuple[str, ...]
    kind: Word | WholeNumber | type[Path] | None = field(default=None, kw_only=True)
    default: Any = field(default=None, kw_only=True)
    is_flag: bool = field(default=False, kw_only=True)
    against: str = field(default="", kw_only=True)
    """The flag that takes this one back."""
    value: str | None = field(default=None, kw_only=True)
    """What a flag stands for that is one of several for the same."""
    multiple: bool = field(default=False, kw_only=True)
    check: Callable[[Any], Any] | None = field(default=None, kw_only=True)
    """Returns what the command gets for the value; raises :class:`BadParameter`."""
    metavar: str | None = field(default=None, kw_only=True)
    help: str = field(default="", kw_only=True)
    show_default: bool = field(default=False, kw_only=True)
    complete: Complete | None = field(default=None, kw_only=True)
    of_session: bool = field(default=False, kw_only=True)

    @property
    def takes_value(self) -> bool:
        """Return whether a value stands behind the flag."""
        return not self.is_flag and self.value is None


@frozen
class Command:
    """A command; ``repeatable`` if its answer hangs on its arguments and what it reads alone."""

    name: str
    run: Callable[..., int | None]
    parameters: tuple[Argument | Option, ...]
    repeatable: bool = False


class UsageError(Exception):
    """A command line that makes no sense, found by the command itself."""


class BadParameter(UsageError):
    """A value that cannot be; ``where`` names it if that is not the option being checked."""

    def __init__(self, message: str, where: str = "") -> None:
        super().__init__(message)
        self.where = where


class Exit(Exception):
    """The end of a command, with a status."""

    def __init__(self, status: int) -> None:
        super().__init__(status)
        self.status = status


def command(name: str, *, repeatable: bool = False) -> Callable[[Callable[..., Any]], Command]:
    """Make a command of a function, above its arguments and options; its docstring is the help."""

    def made(function: Callable[..., Any]) -> Command:
        parameters = tuple(vars(function).pop("parameters", ()))
        return Command(name, function, parameters, repeatable)

    return made


def argument(name: str, **what: Any) -> Callable[[F], F]:
    """Add an argument to a command."""
    return adding(Argument(name, **what))


def option(*names: str, **what: Any) -> Callable[[F], F]:
    """Add an option to a command: its flags, and a name where the long flag is not the name.

    >>> @command("try")
    ... @option("-n", "--dry-run", is_flag=True)
    ... @option("--lang", "language")
    ... def example(dry_run, language): ...
    >>> [(option.name, option.flags) for option in example.parameters]
    [('dry_run', ('-n', '--dry-run')), ('language', ('--lang',))]
    """
    flags = tuple(name.partition("/")[0] for name in names if name.startswith("-"))
    against = "".join(name.partition("/")[2] for name in names)
    long = next((flag for flag in flags if flag.startswith("--")), flags[0])
    given = (name for name in names if not name.startswith("-"))
    name = next(given, long.lstrip("-").replace("-", "_"))
    what["is_flag"] = what.get("is_flag", bool(against))
    return adding(Option(name, flags, **what, against=against))


def adding(parameter: Argument | Option) -> Callable[[F], F]:
    """Return a decorator that puts an argument or option before those of the lines below it."""

    def add(function: F) -> F:
        vars(function).setdefault("parameters", []).insert(0, parameter)
        return function

    return add


def beginning(begun: str, words: Iterable[str]) -> Iterator[Proposal]:
    """Yield the words that begin so."""
    return (Proposal(word) for word in words if word.startswith(begun))


def descriptions(begun: str) -> list[Proposal]:
    """Return the mechanisms of the library, and the shell's own files."""
    return [*beginning(begun, library()), *paths(begun)]


def paths(begun: str) -> list[Proposal]:
    """Return the request for the shell's own completion of files."""
    return [Proposal(begun, kind="file")]
