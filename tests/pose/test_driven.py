"""A drawn mechanism whose drive is set to another place from outside."""

import pytest

from drawn_mechanisms import DRAWN
from mechc.compilation import Compilation, complete
from mechc.diagnostics import MechcError
from mechc.source import Source
from mechc.syntax.settings import parse

EXTENDING = """
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OB
telescope CB
B at (20 mm, 80 mm)
drive CB from 100 mm to 140 mm
actuator P between C and B
torque M on OB
find k = P/M
"""


def compiled(text: str, setting: str) -> Compilation:
    return complete(Compilation(Source("drawn.mech", text), dict([parse(setting)])))


@pytest.mark.parametrize(
    ("text", "drive", "values"),
    [(DRAWN["four_bar"], "phi_OA", (10, 80)), (EXTENDING, "len_CB", (100, 140))],
)
def test_a_drive_that_is_set_is_where_the_stroke_has_it(text, drive, values):
    unit = "deg" if drive.startswith("phi") else "mm"
    rows = complete(Compilation(Source("drawn.mech", text))).stroke(2).rows
    for value, row in zip(values, rows, strict=True):
        (k,) = compiled(text, f"{drive}={value}{unit}").results
        assert k.default == pytest.approx(row.values[0], rel=1e-12)


def test_a_drive_is_set_to_where_loops_close():
    text = DRAWN["four_bar"].replace("A at (20 mm, 34.64 mm)", "A at (20 mm, 90 mm)")
    with pytest.raises(MechcError) as caught:
        compiled(text, "phi_OA=-90deg")
    assert [d.code for d in caught.value.diagnostics] == ["E340", "W220"]


TRIAD = """
pivot O at (0 mm, 0 mm)
pivot Q at (200 mm, 0 mm)
pivot R at (100 mm, 200 mm)
link OA
link AB
link BCD
link QC
link RD
A at (20 mm, 56 mm)
B at (75 mm, 70 mm)
C at (150 mm, 80 mm)
D at (110 mm, 135 mm)
drive OA from 30 deg to 77 deg
torque M on OA
force F at C along x
find k = M/F
"""


def test_of_a_closure_that_is_followed_only_what_is_known_is_said():
    """Other closures of a group of class III may be there where the drawn one has ended."""
    with pytest.raises(MechcError) as caught:
        compiled(TRIAD, "phi_OA=-150deg")
    (fault,) = [d for d in caught.value.diagnostics if d.code == "E340"]
    assert "is closed by no pose reached from the drawing" in fault.message
