"""What a closure gives in one term goes into k, and a slot closes without a drive."""

import mechc
from mechc.formula.to_text import text

SLOTTED_LEVER = """
param g = 40 mm
param b = 120 mm
param phi = 30 deg in 10 deg .. 60 deg
pivot O at (0 mm, 0 mm)
slider A along y through (g, 0 mm)
link OB
slot A in OB
OB = b @ phi
force P at A along y
force F at B along -perp OB
find k = P/F
"""

SWINGING_ROD = """
param g = 40 mm
param b = 120 mm
param phi = 30 deg in 10 deg .. 60 deg
pivot O at (0 mm, 0 mm)
pivot Q at (g, 0 mm)
link QA
link OB
slot A in OB
OB = b @ phi
QA = @ 90 deg
torque M on QA
force F at B along -perp OB
find k = M/F
"""


def test_a_side_of_one_term_cancels() -> None:
    result = mechc.loads(SLOTTED_LEVER).results["k"]
    assert text(result.formula) == "b*cos(phi)^2/g"
    assert not result.where


def test_where_such_a_side_is_infinite_nothing_is_said() -> None:
    result = mechc.loads(SLOTTED_LEVER).results["k"]
    assert [text(b.factor) for b in result.breaks] == ["cos(phi)"]
    assert not result.zeros


def test_a_slot_closes_without_a_drive() -> None:
    """The pin lies where the slot crosses a rod whose length is open."""
    result = mechc.loads(SWINGING_ROD).results["k"]
    assert text(result.formula) == "b*sin(phi)^2"


def test_the_place_in_a_slot_is_the_side_of_the_triangle() -> None:
    """The pin of a slotted lever stands at QB, not at a sum of the crank and the ground."""
    result = mechc.load("whitworth").results["k"]
    assert text(result.formula) == (
        "e*r*sin(phi_QB - beta_DE)*cos(phi - phi_QB)/(len_QB*cos(beta_DE))"
    )
