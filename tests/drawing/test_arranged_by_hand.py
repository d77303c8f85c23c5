"""Drawings in rows, and lines by their fewest places, on sheets built by hand."""

import pytest

from mechc.drawing.arrange import WIDE, below_each_other, in_rows
from mechc.drawing.drawing import Drawing
from mechc.drawing.panels import kept
from mechc.pose.places import Plane


def sheet(left: float, right: float, low: float = 0.0, high: float = 10.0) -> Drawing:
    return Drawing("", "", (), (), Plane(left, low), Plane(right, high))


@pytest.mark.parametrize(("left", "rows"), [(-0.2 * WIDE, 1), (0.2 * WIDE, 1)])
def test_a_row_is_as_wide_as_its_drawings_wherever_they_are(left, rows):
    """Two of 0.45 of the width stand in one row, a third one below them."""
    one = sheet(left, left + 0.45 * WIDE)
    for number, expected in ((2, rows), (3, rows + 1)):
        whole = in_rows([one] * number)
        assert whole.high.y - whole.low.y == pytest.approx(10.0 * expected)
        assert whole.high.x - whole.low.x == pytest.approx(0.9 * WIDE)


def test_drawings_below_each_other_touch_and_begin_at_one_line():
    whole = below_each_other([sheet(5, 25, -3, 4), sheet(-8, 2, 1, 6)])
    assert (whole.low, whole.high) == (Plane(0, -12), Plane(20, 0))


def test_a_line_is_drawn_by_the_places_that_another_would_miss():
    bent = [Plane(0, 0), Plane(1, 0.001), Plane(2, 0), Plane(2, 1), Plane(2, 2)]
    assert list(kept(bent)) == [0, 2, 4]
    assert list(kept(bent[:2])) == [0, 1]
