"""Values that a drawing gives, held against the ranges of a description."""

import pytest

from mechc.diagnostics import MechcError, Report
from mechc.formula.tree import number
from mechc.model.drawn.geometry import _in_range
from mechc.model.mechanism import Drive, Interval, Parameter
from mechc.source import Source, Span
from mechc.units import ANGLE

HERE = Span(0, 1)
OUTSIDE = Parameter("phi", ANGLE, HERE, number(2), Interval(number(0), number(1)))
OF_A_LINK = Drive("phi", None, None, HERE, ends=("O", "A"))


@pytest.mark.parametrize("of", [None, "phi", "x"])
def test_a_value_of_the_drawing_lies_in_its_range(of):
    drives = [Drive(of, None, None, HERE)] if of else []
    report = Report(Source("m.mech", "m"))
    with pytest.raises(MechcError) as error:
        _in_range([OUTSIDE], (), drives, report)
    assert [found.code for found in error.value.diagnostics] == ["E326"]


def test_a_stroke_of_a_link_is_no_such_range():
    (left,) = _in_range([OUTSIDE], (), [OF_A_LINK], Report(Source("m.mech", "m")))
    assert left.range is None


def test_what_is_given_is_no_value_of_the_drawing():
    assert _in_range([OUTSIDE], {"phi"}, (), Report(Source("m.mech", "m"))) == (OUTSIDE,)
