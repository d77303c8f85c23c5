"""Drawings in rows, and lines by their fewest places, on sheets built by hand."""

import pytest

from mechc.drawing.arrange import WIDE, below_each_other, in_rows, joined, parted
from mechc.drawing.drawing import Arc, Drawing, Label, TextRun
from mechc.drawing.pens import SYMBOL
from mechc.drawing.plots.panels import kept
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


def ring(height: float, *names: float) -> Drawing:
    """A body around a height, names above or below it, and the margin of a sheet around all."""
    labels = tuple(Label(Plane(0, y), (TextRun("O"),), SYMBOL, 3.9, 4.0, 4.0) for y in names)
    low, high = min((height - 4, *names)) - 5, max((height + 4, *names)) + 5
    return Drawing(
        "", "", (Arc(Plane(0, height), 4.0, SYMBOL),), labels, Plane(-4, low), Plane(4, high)
    )


def sizes(parts: tuple[Drawing, ...]) -> list[tuple[int, int, float]]:
    """How many shapes and labels are in each part, and how high it is."""
    return [(len(p.shapes), len(p.labels), p.high.y - p.low.y) for p in parts]


def test_a_drawing_that_is_too_high_is_cut_where_rows_meet():
    """Four rows of 18 mm: two and two, or each by itself."""
    whole = below_each_other([ring(0)] * 4)
    assert parted(whole, 72.0) == (whole,)
    assert sizes(parted(whole, 54.0)) == [(2, 0, 36.0), (2, 0, 36.0)]
    assert sizes(parted(whole, 40.0)) == [(2, 0, 36.0), (2, 0, 36.0)]
    assert sizes(parted(whole, 20.0)) == [(1, 0, 18.0)] * 4
    assert [shape.centre.y for part in parted(whole, 40.0) for shape in part.shapes] == [
        *(-9, -27, -45, -63)
    ]


def test_names_stay_with_what_they_are_of_however_far_they_stand_from_it():
    """Names 20 mm above and below their body, though nothing stands between: rows of 50 mm."""
    whole = below_each_other([ring(0, 20, -20)] * 3)
    assert sizes(parted(whole, 60.0)) == [(1, 2, 50.0)] * 3
    assert sizes(parted(whole, 10.0)) == [(1, 2, 50.0)] * 3


def test_bodies_next_to_each_other_are_one_row_whatever_rows_they_have():
    high = joined([sheet(0, 5), below_each_other([ring(0)] * 3)])
    assert high.between == (-28, -46)
    assert in_rows([high, ring(0)]).between == ()


def test_a_heading_goes_with_the_row_below_it():
    """Two headings of 10 mm, each over two rows of 18 mm."""
    heading = sheet(0, 5)
    whole = below_each_other([joined([heading, below_each_other([ring(0)] * 2)])] * 2)
    assert [part.high.y for part in parted(whole, 56.0)] == [0, -46]
    assert [part.high.y for part in parted(whole, 40.0)] == [0, -28, -46, -74]


def test_parts_are_as_high_as_each_other_as_far_as_rows_allow():
    """Four rows of 40 on parts of 130: two and two, not three and one."""
    rows = [sheet(0, 100, 0, 40) for _ in range(4)]
    parts = parted(below_each_other(rows), 130)
    assert [part.high.y - part.low.y for part in parts] == [80, 80]
    uneven = below_each_other([sheet(0, 100, 0, high) for high in (100, 30, 30)])
    assert [part.high.y - part.low.y for part in parted(uneven, 130)] == [100, 60]
