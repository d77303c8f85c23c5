"""Named tuples: what :class:`typing.NamedTuple` means, without generated code.

:mod:`collections` writes and evaluates the constructor of every class anew, and :mod:`typing`
looks at every annotation: a tenth of a millisecond for each of the small types of this package.
Here one constructor is evaluated for each number of fields; a class gets a copy of it with the
names of its own fields, which is called as fast.
"""

from collections import namedtuple
from collections.abc import Callable, Iterable
from functools import cache
from operator import itemgetter
from types import FunctionType
from typing import TYPE_CHECKING, Any, Self

if TYPE_CHECKING:
    from typing import NamedTuple
else:

    class _NamedTuple:
        """Stands among the bases of a class statement, as ``typing.NamedTuple`` does."""

        def __mro_entries__(self, bases: tuple[object, ...]) -> tuple[type]:
            if len(bases) > 1:
                raise TypeError("a NamedTuple has no other bases")
            return (_Template,)

    NamedTuple = _NamedTuple()

__all__ = ["NamedTuple"]


class Named(tuple[Any, ...]):
    """What all named tuples share; the names of the fields are in ``_fields``."""

    __slots__ = ()
    _fields: tuple[str, ...] = ()

    @classmethod
    def _make(cls, values: Iterable[Any]) -> Self:
        made = tuple.__new__(cls, values)
        if len(made) != len(cls._fields):
            raise TypeError(f"Expected {len(cls._fields)} arguments, got {len(made)}")
        return made

    def _replace(self, /, **changes: Any) -> Self:
        made = self._make(map(changes.pop, self._fields, self))
        if changes:
            raise TypeError(f"Got unexpected field names: {list(changes)!r}")
        return made

    __replace__ = _replace

    def _asdict(self) -> dict[str, Any]:
        return dict(zip(self._fields, self, strict=True))

    def __repr__(self) -> str:
        shown = (f"{n}={value!r}" for n, value in zip(self._fields, self, strict=True))
        return f"{type(self).__name__}({', '.join(shown)})"

    def __getnewargs__(self) -> tuple[Any, ...]:
        return tuple(self)


class _Making(type):
    """Makes a class of its fields, with :class:`Named` as its base."""

    def __new__(cls, name: str, bases: tuple[type, ...], body: dict[str, Any]) -> type:
        fields = tuple(_annotated(body))
        defaults = {f: body[f] for f in fields if f in body}
        if tuple(defaults) != fields[len(fields) - len(defaults) :]:
            raise TypeError(f"a field of {name} without a default follows one with a default")
        # Whole before the class is made: each special method put in later makes it anew in part.
        whole: dict[str, Any] = {"__slots__": (), **body}
        whole |= {f: _getter(i) for i, f in enumerate(fields)}
        whole |= {"_fields": fields, "__match_args__": fields, "_field_defaults": defaults}
        whole["__new__"] = _constructor(fields, tuple(defaults.values()))
        return type.__new__(type, name, (Named,), whole)


_Template = type.__new__(_Making, "_Template", (), {})


def _annotated(body: dict[str, Any]) -> Iterable[str]:
    """Return the names that the body of a class annotates: as of Python 3.14 the class has them."""
    found: dict[str, Any] | None = body.get("__annotations__")
    return type.__new__(type, "_", (), dict(body)).__annotations__ if found is None else found


_make: Callable[..., Any] = namedtuple
_Sample = _make("_Sample", [f"f{i}" for i in range(24)])


def _getter(index: int) -> Any:
    """Give the attribute that reads one field: those of the standard library are in C."""
    if index < len(_Sample._fields):
        return vars(_Sample)[_Sample._fields[index]]
    return property(itemgetter(index))


def _constructor(fields: tuple[str, ...], defaults: tuple[object, ...]) -> Any:
    general = _general(len(fields))
    code = general.__code__.replace(co_varnames=("_cls", *fields), co_name="__new__")
    return staticmethod(FunctionType(code, general.__globals__, "__new__", defaults))


@cache
def _general(count: int) -> Callable[..., object]:
    names = "".join(f"f{i}, " for i in range(count))
    made: Callable[..., object] = eval(
        f"lambda _cls, {names}: _new(_cls, ({names}))", {"_new": tuple.__new__, "__builtins__": {}}
    )
    return made
