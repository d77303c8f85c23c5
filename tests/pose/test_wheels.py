"""Gears at given places: their centres are as far apart as their radii say."""

import pytest

from mechc.compilation import Compilation
from mechc.source import Source

PAIR = """
pivot O at (0 mm, 0 mm)
pivot Q at ({apart} mm, 0 mm)
link OA
link QB
OA = 100 mm @ 30 deg
QB = 150 mm @ 60 deg
gear O 20 mm, Q 80 mm{inner}
torque M on OA
force F at B along x
find k = M/F
"""


@pytest.mark.parametrize(
    ("apart", "inner", "hint"),
    [
        (100, "", None),
        (60, " inner", None),
        (60, "", "add `inner`"),
        (100, " inner", "leave `inner` out"),
        (50, "", "are they diameters"),
        (30, " inner", "are they diameters"),
        (65, "", "fix the radii"),
        (65, " inner", "fix the radii"),
    ],
)
def test_gears_fit_by_the_sum_of_their_radii_or_inside_by_the_difference(apart, inner, hint):
    compilation = Compilation(Source("m.mech", PAIR.format(apart=apart, inner=inner)))
    assert compilation.pose
    found = [d.hint for d in compilation.report.sorted() if d.code == "W302"]
    assert len(found) == (hint is not None)
    assert all(said.startswith(hint) for said in found), found
