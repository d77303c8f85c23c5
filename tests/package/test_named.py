"""Named tuples are what those of :mod:`typing` are."""

import copy
import inspect
import pickle
import sys
import typing

import pytest

from mechc.base import named


class Rod(named.NamedTuple):
    """A link of two points."""

    points: str
    length: float = 1.0
    label: str | None = None

    @property
    def ends(self) -> list[str]:
        """The points apart."""
        return list(self.points)


class Typing(typing.NamedTuple):
    """The same by the standard library."""

    points: str
    length: float = 1.0
    label: str | None = None


class Empty(named.NamedTuple):
    """No field at all."""


def test_all_is_as_in_typing():
    one, other = Rod("AB", label="x"), Typing("AB", label="x")
    assert one == other == ("AB", 1.0, "x")
    assert hash(one) == hash(other)
    assert repr(one) == repr(other).replace("Typing", "Rod")
    for name in ("_fields", "_field_defaults", "__match_args__", "__annotations__"):
        assert getattr(Rod, name) == getattr(Typing, name)
    assert inspect.signature(Rod).parameters.keys() == inspect.signature(Typing).parameters.keys()
    assert one._asdict() == other._asdict()
    assert one._replace(length=2) == other._replace(length=2)
    assert Rod._make("abc") == Typing._make("abc")
    assert (one.points, one.length, one.label, one.ends) == ("AB", 1.0, "x", ["A", "B"])
    assert Rod.__doc__ == "A link of two points."
    assert Rod.__qualname__ == "Rod"
    assert not hasattr(one, "__dict__")
    assert Empty() == ()


def test_a_copy_is_of_the_same_class():
    rod = Rod("AB")
    for again in (copy.deepcopy(rod), copy.copy(rod), pickle.loads(pickle.dumps(rod))):
        assert (again, type(again)) == (rod, Rod)
    if sys.version_info >= (3, 13):
        assert copy.replace(rod, length=2) == ("AB", 2, None)


@pytest.mark.parametrize("kind", [Rod, Typing])
def test_wrong_arguments_are_refused(kind):
    for wrong in (
        lambda: kind(),
        lambda: kind("A", 1, "x", 2),
        lambda: kind("A", points="B"),
        lambda: kind("A", colour=1),
        lambda: kind._make("AB"),
    ):
        with pytest.raises(TypeError):
            wrong()
    with pytest.raises((TypeError, ValueError)):
        kind("A")._replace(colour=1)
    with pytest.raises(AttributeError):
        kind("A").points = "B"


def test_a_class_that_cannot_be_is_refused():
    body = {"__module__": __name__, "__qualname__": "Wrong"}
    annotations = {"a": int, "b": int}
    making = type(named.NamedTuple.__mro_entries__((named.NamedTuple,))[0])
    with pytest.raises(TypeError, match="without a default"):
        making("Wrong", (), body | {"__annotations__": annotations, "a": 1})
    with pytest.raises(TypeError, match="no other bases"):
        named.NamedTuple.__mro_entries__((named.NamedTuple, Rod))


def test_more_fields_than_the_usual():
    names = [f"field_{i}" for i in range(60)]
    many = type(named.NamedTuple.__mro_entries__((named.NamedTuple,))[0])(
        "Many", (), {"__annotations__": dict.fromkeys(names, int), "__module__": __name__}
    )
    made = many(*range(60))
    assert [getattr(made, name) for name in names] == list(range(60))
    assert made._replace(field_50=0)[49:52] == (49, 0, 51)
