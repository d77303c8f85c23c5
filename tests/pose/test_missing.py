"""Missing vectors: one that would follow from others that are missing is not reported as well."""

import pytest

from mechc.formula.tree import ZERO
from mechc.model.mechanism import Drawn, Link, Mechanism, Parameter, Pivot, Slot
from mechc.pose.closure_check import given_by_hand
from mechc.pose.missing_directions import _without_input
from mechc.pose.pose import OpenUnknowns
from mechc.pose.vectors import Missing
from mechc.source import Span
from mechc.units import LENGTH


class Given:
    """Vectors that are given between some points: a path from A to B is one from B to A."""

    def __init__(self, *pairs: str) -> None:
        self._pairs = {frozenset(pair) for pair in pairs}

    def path(self, tail: str, head: str) -> tuple[()] | None:
        """Return a vector where one is given."""
        return () if frozenset((tail, head)) in self._pairs else None


def first_of(asked: str, *given: str) -> list[str]:
    """Return which vectors are reported, asked for in this order."""
    missing = Missing(Given(*given))  # type: ignore[arg-type]
    return [pair for pair in asked.split() if missing.add(*pair)]


def test_a_vector_is_missing_once_in_either_sense() -> None:
    assert first_of("AB AB BA CD") == ["AB", "CD"]


def test_what_missing_vectors_would_lead_to_is_not_missing_itself() -> None:
    assert first_of("AB BC AC CA") == ["AB", "BC"]


def test_vectors_that_are_given_lead_on_from_missing_ones() -> None:
    assert first_of("AB AC", "BC") == ["AB"]
    assert first_of("AB CD AD", "BC") == ["AB", "CD"]
    assert first_of("AB CD", "AC", "BD") == ["AB"]


def test_any_are_missing_once_one_was_reported() -> None:
    missing = Missing(Given())  # type: ignore[arg-type]
    assert not missing.are_any
    assert missing.add("A", "B")
    assert missing.are_any


HERE = Span(0, 0)


@pytest.mark.parametrize(
    ("guided", "hint"), [("BD", "`angle OBD = 90 deg`"), ("", "`BD = … @ psi`")]
)
def test_a_link_that_a_block_guides_misses_its_angle_to_the_slot(guided, hint):
    links = (Link("OC", ("O", "C"), HERE), Link("BD", ("B", "D"), HERE))
    slot = Slot("B", "OC", "O", "C", HERE, guided)
    mechanism = Mechanism("m", "", "", HERE, links=links, joints=(slot,))
    sought, left = {"phi_BD": ("B", "D", HERE)}, OpenUnknowns(frozenset({"phi_BD"}), 1)
    (found,) = _without_input(mechanism, {"phi_BD": links[1]}, sought, left)
    assert hint in found.hint


def test_what_lies_in_the_place_of_a_drawn_point_or_a_pivot_is_not_given_by_hand():
    """Places are from 10 to 20 and from 40 to 50."""
    spans = {"a": (2, 4), "b": (12, 14), "c": (10, 20), "d": (18, 22), "e": (41, 50), "f": (60, 61)}
    parameters = tuple(Parameter(name, LENGTH, Span(*at)) for name, at in spans.items())
    drawn = (Drawn("A", ZERO, ZERO, 0.0, "", Span(10, 20)),)
    joints = (Pivot("O", Span(40, 50)),)
    mechanism = Mechanism("m", "", "", HERE, parameters, drawn=drawn, joints=joints)
    assert given_by_hand(mechanism) == {"a", "d", "f"}
