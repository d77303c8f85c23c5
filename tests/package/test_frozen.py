"""Frozen classes behave as frozen data classes with slots do."""

import copy
import pickle
import re

import pytest

from mechc.frozen import field, fields, frozen, replace
from paths import PACKAGE


@frozen
class Line:
    place: int = field(compare=False)
    remark: str = field(default="", kw_only=True)


@frozen
class Point(Line):
    name: str
    at: tuple[float, ...] = ()


@frozen
class Nothing:
    pass


def test_arguments_stand_in_order_the_bases_first():
    point = Point(3, "A", (1.0,), remark="left")
    assert (point.place, point.name, point.at, point.remark) == (3, "A", (1.0,), "left")
    assert point == Point(name="A", at=(1.0,), place=3, remark="left")
    assert [f.name for f in fields(point)] == ["place", "name", "at", "remark"]
    assert Point.__match_args__ == ("place", "name", "at")


def test_equality_is_of_one_class_and_of_the_compared_fields():
    assert Point(1, "A") == Point(2, "A")
    assert hash(Point(1, "A")) == hash(Point(2, "A"))
    assert Point(1, "A") != Point(1, "B")
    assert Point(1, "A") != Line(1)
    assert Line(1) == Line(2)
    assert Nothing() == Nothing() != Line(1)
    assert Point(1, "A") != (1, "A", ())


@pytest.mark.parametrize(
    ("given", "named", "message"),
    [
        ((1,), {}, "Point needs name"),
        ((1, "A", (), "x"), {}, "Point takes 3 values, 4 were given"),
        ((1, "A"), {"name": "B"}, "Point got two values for name"),
        ((1, "A"), {"label": "B"}, "Point has no label"),
    ],
)
def test_wrong_arguments_are_stated(given, named, message):
    with pytest.raises(TypeError, match=message):
        Point(*given, **named)


def test_nothing_can_be_changed():
    point = Point(1, "A")
    for change in (lambda: setattr(point, "name", "B"), lambda: setattr(point, "new", 1)):
        with pytest.raises(AttributeError, match="a Point cannot be changed"):
            change()
    with pytest.raises(AttributeError):
        del point.name
    assert not hasattr(point, "__dict__")


def test_copies():
    point = Point(1, "A", remark="left")
    assert replace(point, name="B") == Point(1, "B", remark="left")
    for same in (copy.copy(point), copy.deepcopy(point), pickle.loads(pickle.dumps(point))):
        assert repr(same) == repr(point) == "Point(place=1, name='A', at=(), remark='left')"


def test_the_package_has_one_kind_of_record():
    for path in PACKAGE.rglob("*.py"):
        assert not re.search(r"^(from|import) dataclasses", path.read_text("utf-8"), re.M), path
