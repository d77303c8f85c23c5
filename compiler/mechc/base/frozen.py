"""Frozen classes: what ``dataclass(frozen=True, slots=True)`` means, without generated code.

:mod:`dataclasses` writes and compiles the methods of every class anew, a third of a
millisecond each; for the hundred small types of this package that is longer than a
compilation takes. Here the methods are written once and go by the names of the fields.
"""

from collections.abc import Callable, Iterable, Mapping
from copyreg import pickle
from operator import attrgetter
from types import MappingProxyType
from typing import Any, NoReturn, TypeVar, cast, dataclass_transform

from .named import NamedTuple

T = TypeVar("T")

REQUIRED: Any = object()
"""The default of a field that has none."""


def read_only(content: dict[Any, Any]) -> MappingProxyType[Any, Any]:
    """Return a mapping that cannot be changed."""
    return MappingProxyType(content)


# Defaults that are mappings cannot be changed either, and Python alone would not copy them.
pickle(MappingProxyType, lambda mapping: (read_only, (dict(mapping),)))


class FrozenField(NamedTuple):
    """One field of a frozen class."""

    name: str
    default: Any = REQUIRED
    compare: bool = True
    kw_only: bool = False
    on_demand: bool = False


def field(
    *,
    default: Any = REQUIRED,
    compare: bool = True,
    kw_only: bool = False,
    on_demand: bool = False,
) -> Any:
    """Say of a field that it does not count in comparisons, or is given by name only.

    The value of one ``on_demand`` may be given by :func:`on_demand`.
    """
    return FrozenField("", default, compare, kw_only, on_demand)


class _OnDemand:
    """What makes a value; it does so once, for all objects that have it."""

    def __init__(self, make: Callable[[], object]) -> None:
        self._make: Callable[[], object] | None = make
        self._made: object = None

    def made(self) -> object:
        """Return the value."""
        if self._make is not None:
            self._made, self._make = self._make(), None
        return self._made


def on_demand(make: Callable[[], T]) -> T:
    """Return a stand-in for a field's value until it is read: only then it is made.

    >>> @frozen
    ... class Book:
    ...     index: str = field(default="", on_demand=True)
    >>> book = replace(Book(on_demand(lambda: print("read") or "A to Z")))
    >>> book.index, book.index
    read
    ('A to Z', 'A to Z')
    """
    return cast("T", _OnDemand(make))


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(cls: type[T]) -> type[T]:
    """Return the class with ``__init__`` and the rest for its annotated fields.

    Objects are equal when they are of one class and equal field by field.

    >>> @frozen
    ... class Rod:
    ...     points: str
    ...     label: str = field(default="", compare=False)
    >>> Rod("AB", "coupler"), Rod("AB") == Rod("AB", "coupler"), Rod.__match_args__
    (Rod(points='AB', label='coupler'), True, ('points', 'label'))
    >>> Rod("AB").points = "BC"
    Traceback (most recent call last):
    AttributeError: a Rod cannot be changed: points
    """
    own = [_declared(name, vars(cls).get(name, REQUIRED)) for name in cls.__annotations__]
    every = [*fields(cls), *own]
    every.sort(key=lambda f: f.kw_only)
    return _with_slots(cls, own, every)


class Hashed:
    """A base of values that are hashed again and again: each keeps its hash."""

    __slots__ = ("hash_kept",)
    hash_kept: int


def fields(of: object) -> tuple[FrozenField, ...]:
    """Return the fields of a frozen class or object in the order of its arguments.

    What is neither has none.
    """
    return getattr(of, "__fields__", ())


def contents(value: object, of: object) -> dict[str, Any]:
    """Return by name what the fields that a class or object has hold in a frozen object.

    What is made on demand is not made for that.
    """
    kind = type(value)
    return {
        f.name: getattr(kind, f.name).held(value) if f.on_demand else getattr(value, f.name)
        for f in fields(of)
    }


def replace(value: T, /, **changes: Any) -> T:
    """Return a frozen object with some of its fields changed."""
    return type(value)(**contents(value, value) | changes)


# ------------------------------------------------------------------- making the class


def _declared(name: str, default: Any) -> FrozenField:
    if isinstance(default, FrozenField):
        return default._replace(name=name)
    return FrozenField(name, default)


def _with_slots(cls: type[T], own: Iterable[FrozenField], every: Iterable[FrozenField]) -> type[T]:
    """Return the class made once more: slots can only be given to a new one."""
    names = tuple(f.name for f in own)
    compared = [f.name for f in every if f.compare]
    left_out = {"__dict__", "__weakref__", *names}
    methods = _METHODS | ({"__hash__": _kept_hash} if issubclass(cls, Hashed) else {})
    methods["__init__"] = _first_init
    body = methods | {name: part for name, part in vars(cls).items() if name not in left_out}
    body["__slots__"] = names
    body["__fields__"] = tuple(every)
    body["__match_args__"] = tuple(f.name for f in every if not f.kw_only)
    body["_compared"] = attrgetter(*compared) if compared else type
    made: type[T] = type(cls)(cls.__name__, cls.__bases__, body)  # type: ignore[misc]
    made.__qualname__ = cls.__qualname__
    for name in (f.name for f in own if f.on_demand):
        setattr(made, name, _SlotReader(getattr(made, name)))
    return made


class _SlotReader:
    """Reads a slot whose value may be one that is made on demand."""

    def __init__(self, slot: Any) -> None:
        self.held, self._put = slot.__get__, slot.__set__

    def __set__(self, owner: object, value: object) -> None:
        """Put a value into the slot."""
        self._put(owner, value)

    def __get__(self, owner: object, kind: type) -> Any:
        """Return the value in the slot, made if it has not been."""
        if owner is None:
            return self
        value = self.held(owner)
        if isinstance(value, _OnDemand):
            value = value.made()
            self._put(owner, value)
        return value


def _first_init(self: object, /, *given: Any, **named: Any) -> None:
    """Make the constructor of a class together with its first object.

    Most compilations make no object of every other class that they import.
    """
    cls = next(c for c in type(self).__mro__ if vars(c).get("__init__") is _first_init)
    cls.__init__ = made = _init(cls, list(fields(cls)))  # type: ignore[misc]
    made(self, *given, **named)


def _init(cls: type, every: list[FrozenField]) -> Callable[..., None]:
    """Return ``__init__``, which goes past the refusal by way of the slots themselves.

    Formulas and angles have one field or two, and there are hundreds of thousands of them: of
    such few none is looped over.
    """
    puts = [getattr(cls, f.name).__set__ for f in every]
    positional = [f for f in every if not f.kw_only]
    exact = len(every) if len(positional) == len(every) else -1
    first: Any = puts[0] if puts else None
    final: Any = puts[-1] if puts else None
    names, defaults = [f.name for f in positional], {f.name: f.default for f in every}
    needed = frozenset(name for name, default in defaults.items() if default is REQUIRED)

    def bound(given: tuple[Any, ...], named: Mapping[str, Any]) -> tuple[Any, ...]:
        values: dict[str, Any] = {**dict(zip(names, given, strict=False)), **named}
        fit = len(names) >= len(given) and len(values) == len(given) + len(named)
        if not (fit and needed <= values.keys() <= defaults.keys()):
            raise TypeError(_misfit(cls.__name__, names, defaults, given, named))
        return tuple((defaults | values).values())

    def of_one(self: object, /, *given: Any, **named: Any) -> None:
        (value,) = bound(given, named) if named or len(given) != 1 else given
        first(self, value)

    def of_two(self: object, /, *given: Any, **named: Any) -> None:
        one, other = bound(given, named) if named or len(given) != 2 else given
        first(self, one)
        final(self, other)

    def of_any(self: object, /, *given: Any, **named: Any) -> None:
        if named or len(given) != exact:
            given = bound(given, named)
        for put, value in zip(puts, given, strict=True):
            put(self, value)

    return {1: of_one, 2: of_two}.get(exact, of_any)


def _misfit(
    name: str,
    names: list[str],
    defaults: Mapping[str, Any],
    given: tuple[Any, ...],
    named: Mapping[str, Any],
) -> str:
    """Return the error of a constructor that got these values."""
    if len(given) > len(names):
        return f"{name} takes {len(names)} values, {len(given)} were given"
    if twice := named.keys() & {*names[: len(given)]}:
        return f"{name} got two values for {', '.join(sorted(twice))}"
    if unknown := named.keys() - defaults.keys():
        return f"{name} has no {', '.join(sorted(unknown))}"
    left = [f for f in defaults if f not in named and f not in names[: len(given)]]
    return f"{name} needs {', '.join(f for f in left if defaults[f] is REQUIRED)}"


# ------------------------------------------------------------------------ its methods


def _eq(self: Any, other: Any) -> Any:
    if other.__class__ is not self.__class__:
        return NotImplemented
    return self._compared(self) == self._compared(other)


def _hash(self: Any) -> int:
    return hash(self._compared(self))


def _kept_hash(self: Any) -> int:
    try:
        kept: int = self.hash_kept
    except AttributeError:
        kept = hash(self._compared(self))
        object.__setattr__(self, "hash_kept", kept)
    return kept


def _repr(self: Any) -> str:
    shown = ", ".join(f"{f.name}={getattr(self, f.name)!r}" for f in fields(self))
    return f"{type(self).__qualname__}({shown})"


def _refuse(self: Any, name: str, *value: Any) -> NoReturn:
    raise AttributeError(f"a {type(self).__name__} cannot be changed: {name}")


def _getstate(self: Any) -> tuple[Any, ...]:
    return tuple(getattr(self, f.name) for f in fields(self))


def _setstate(self: Any, state: tuple[Any, ...]) -> None:
    for one, value in zip(fields(self), state, strict=True):
        object.__setattr__(self, one.name, value)


_METHODS: dict[str, Any] = {
    "__eq__": _eq,
    "__hash__": _hash,
    "__repr__": _repr,
    "__setattr__": _refuse,
    "__delattr__": _refuse,
    "__getstate__": _getstate,
    "__setstate__": _setstate,
    "__replace__": replace,
}
