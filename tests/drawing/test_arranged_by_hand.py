"""Drawings in rows, and lines by their fewest places, on sheets built by hand."""

import pytest

from mechc.drawing.arrange import WIDE, below_each_other, in_rows
from mechc.drawing.drawing import SYMBOL, Arc, Drawing, Label, Run
from mechc.drawing.panels import kept
from mechc.drawing.parted import parted
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


def ring(height: float) -> Arc:
    return Arc(Plane(0, height), 4.0, SYMBOL)


def test_a_drawing_that_is_too_high_is_cut_where_nothing_stands():
    """Rings at 50, 41 and 9, and two that overlap at 24 and 28: cut at 35 and at 16.5."""
    heights = [50, 41, 28, 24, 9]
    whole = Drawing("", "", tuple(map(ring, heights)), (), Plane(-4, 0), Plane(4, 54))
    parts = parted(whole, 20.0)
    assert [[s.centre.y for s in part.shapes] for part in parts] == [[50, 41], [28, 24], [9]]
    assert [part.high.y for part in parts] == [54, 34.5, 16.5]
    assert [part.low.y for part in parts] == [34.5, 16.5, 0]
    assert parted(whole, 54.0) == (whole,)


def test_a_heading_goes_with_what_is_below_it():
    """Bodies at 50 and 10, each with its name above it, and a heading between them."""
    names = [Label(Plane(0, y), (Run("O"),), SYMBOL, 3.9, 4.0, 4.0) for y in (57, 31, 17)]
    whole = Drawing("", "", (ring(50), ring(10)), tuple(names), Plane(-4, 0), Plane(4, 60))
    upper, lower = parted(whole, 45.0)
    assert [label.at.y for label in upper.labels] == [57]
    assert [label.at.y for label in lower.labels] == [31, 17]


def test_a_row_that_is_too_high_by_itself_stays_whole():
    whole = Drawing("", "", (ring(20), ring(9)), (), Plane(-4, 0), Plane(4, 24))
    assert [len(part.shapes) for part in parted(whole, 5.0)] == [1, 1]
