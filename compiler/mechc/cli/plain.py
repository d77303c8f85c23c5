"""A command line that is right, read without click.

Whatever is not plain is left to click: a slip, for which it has the words, and help.
"""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from .usage import Argument, BadParameter, Command, Option, WholeNumber, Word

EXPANDED = set("*?[~$%")
"""What a word is expanded for on Windows, where the shell does not do it."""


class _NotPlainError(Exception):
    """The command line is not plain."""


def read(command: Command, words: Sequence[str]) -> dict[str, Any] | None:
    """Return the values of a command's arguments and options by name; None if it is not plain.

    >>> from .usage import argument, command, option
    >>> @command("try")
    ... @argument("file")
    ... @option("-n", "--points", kind=WholeNumber(2, 100), default=19)
    ... @option("--csv", is_flag=True)
    ... def example(file, points, csv): ...
    >>> read(example, ["--csv", "clamp.mech", "-n", "5"])
    {'file': 'clamp.mech', 'points': 5, 'csv': True}
    >>> read(example, ["clamp.mech", "-n", "1"])
    """
    if os.name == "nt" and any(EXPANDED & set(word) for word in words):
        return None
    try:
        rest, given = _sorted(command, words)
        return dict([*_arguments(command, rest), *_options(command, given)])
    except (_NotPlainError, BadParameter):
        return None


def _sorted(command: Command, words: Iterable[str]) -> tuple[list[str], dict[str, list[Any]]]:
    """Return the words without a flag, and what was given for each option."""
    options = {flag: option for option in _of(command) for flag in (*option.flags, option.against)}
    rest: list[str] = []
    given: dict[str, list[Any]] = {}
    left = iter(words)
    for word in left:
        if word == "-" or not word.startswith("-"):
            rest.append(word)
            continue
        flag, sign, value = word.partition("=") if word.startswith("--") else (word, "", "")
        option = options.get(flag)
        if option is None or (sign and not option.takes_value):
            raise _NotPlainError
        values = given.setdefault(option.name, [])
        if not option.takes_value:
            values.append(option.value or flag != option.against)
        else:
            values.append(value if sign else _next(left))
    return rest, given


def _of(command: Command) -> Iterator[Option]:
    return (one for one in command.parameters if isinstance(one, Option))


def _next(left: Iterator[str]) -> str:
    for word in left:
        return word
    raise _NotPlainError


def _arguments(command: Command, rest: list[str]) -> Iterator[tuple[str, Any]]:
    """Yield the values of the arguments by name; what is too many or too few is not plain."""
    for one in command.parameters:
        if isinstance(one, Argument):
            taken = len(rest) if one.several else 1
            words, rest = rest[:taken], rest[taken:]
            if one.required and not words:
                raise _NotPlainError
            values = [_of_kind(one.kind, word) for word in words]
            yield one.name, tuple(values) if one.several else next(iter(values), None)
    if rest:
        raise _NotPlainError


def _options(command: Command, given: Mapping[str, list[Any]]) -> Iterator[tuple[str, Any]]:
    """Yield the values of the options by name; of several flags for the same the last counts."""
    seen: dict[str, Any] = {}
    for option in _of(command):
        values = given.get(option.name)
        if option.takes_value:
            values = values and [_of_kind(option.kind, value) for value in values]
        if option.multiple:
            seen[option.name] = _checked(option, tuple(values or ()))
        elif values:
            seen[option.name] = _checked(option, values[-1])
        elif seen.get(option.name) is None:
            seen[option.name] = _checked(option, _default(option))
    yield from seen.items()


def _default(option: Option) -> Any:
    if option.value is not None:
        return option.value if option.default else None
    return False if option.is_flag and option.default is None else option.default


def _checked(option: Option, value: Any) -> Any:
    return option.check(value) if option.check else value


def _of_kind(kind: Word | WholeNumber | type[Path] | None, text: str) -> Any:
    """Return a word as what it is to be."""
    match kind:
        case Word(choices):
            if text not in choices:
                raise _NotPlainError
            return text
        case WholeNumber(low, high):
            if not text.isdecimal() or not low <= int(text) <= high:
                raise _NotPlainError
            return int(text)
        case None:
            return text
        case path:
            return path(text)
