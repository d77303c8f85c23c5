"""Where results are least and greatest along a stroke: beside jams, and where formulas are 0/0."""

import math

import pytest

import mechc
from mechc.study.stroke.extrema import with_values


def of(stroke, name):
    return [one for one in stroke.extrema if one.result == name]


def test_parts_on_which_a_result_has_values_end_where_it_has_none():
    grid = [0.0, 1.0, 2.0, 3.0, 4.0]
    assert [*with_values(grid, lambda _: 1.0)] == [grid]
    assert not [*with_values(grid, lambda _: math.nan)]
    (part,) = with_values(grid, lambda x: 1.0 if x > 1.5 else math.nan)
    assert part == pytest.approx([1.5, 1.505, 2, 3, 3.99, 4], abs=1e-9)
    (island,) = with_values(grid, lambda x: 1.0 if abs(x - 1) < 0.25 else math.nan)
    assert island == pytest.approx([0.75, 0.7525, 1, 1.2475, 1.25], abs=1e-9)


JAMMED = """
param r = 50 mm
param phi = 0.5488 rad
pivot O at (0 mm, 0 mm)
link OA
OA = r @ phi
slot T in OA
pivot G at (27.922 mm, -72.803 mm)
slider T along 1.35167 rad through G
telescope AT
torque M on OA
actuator F between A and T
find k = M / F
drive phi from 0.2988 rad to 0.7988 rad
friction pins 0.004 diameter 6 mm
friction contact T 0.0048
"""


def test_a_result_that_turns_in_the_cell_next_to_a_jam_has_an_extremum():
    """It jams up to 0.31366 rad, and k_hold is greatest 0.0006 beyond: a cell is 0.0007."""
    mechanism = mechc.loads(JAMMED)
    places = [0.3138 + 1e-5 * i for i in range(100)]
    found = mechanism.evaluate(phi=places)["k_hold"]
    greatest = max(range(100), key=lambda i: found[i])
    assert 0 < greatest < 99
    tops = [e for e in of(mechanism.stroke(3), "k_hold") if e.drive > 0.3137]
    assert [(e.kind, e.drive, e.value) for e in tops] == [
        (
            "maximum",
            pytest.approx(places[greatest], abs=1e-5),
            pytest.approx(found[greatest], rel=1e-6),
        )
    ]
