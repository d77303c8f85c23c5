"""Frozen classes behave as frozen data classes with slots do."""

import copy
import pickle
import re

import pytest

from mechc.base.frozen import contents, field, fields, frozen, on_demand, replace
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


@frozen
class Book:
    name: str
    index: str = field(default="", on_demand=True)


@frozen
class Volume(Book):
    number: int = 1


def book_and_readings() -> tuple[Volume, list[str]]:
    readings: list[str] = []

    def read() -> str:
        readings.append("read")
        return "A to Z"

    return Volume("B", on_demand(read), 2), readings


def test_a_value_on_demand_is_made_once_for_all_copies():
    book, readings = book_and_readings()
    copies = [replace(book, number=3), Book(**contents(book, Book)), replace(book, name="C")]
    assert not readings
    assert [b.index for b in (*copies, book, book)] == ["A to Z"] * 5
    assert readings == ["read"]


def test_a_value_on_demand_counts_as_any_other():
    book, readings = book_and_readings()
    assert book == Volume("B", "A to Z", 2) != Volume("B", "A", 2)
    assert repr(book) == "Volume(name='B', index='A to Z', number=2)"
    assert hash(book_and_readings()[0]) == hash(book)
    assert pickle.loads(pickle.dumps(book_and_readings()[0])) == book
    assert copy.deepcopy(book_and_readings()[0]) == book
    with pytest.raises(AttributeError, match="a Volume cannot be changed: index"):
        book.index = "A"  # type: ignore[misc]
    assert readings == ["read"]


def test_a_value_on_demand_that_fails_is_tried_again():
    tries = iter([0, 2])
    book = Book("B", on_demand(lambda: "A" * (2 // next(tries))))
    with pytest.raises(ZeroDivisionError):
        assert book.index
    assert book.index == "A"
