"""What forces and friction may be: coefficients within sense, loads on a mirror line."""

import pytest

from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.source import Source
from small_mechanisms import lever


def codes(text: str) -> list[str]:
    """Return the codes of what the model says of a description."""
    compilation = Compilation(Source("forces.mech", text))
    try:
        assert compilation.mechanism
    except MechcError as error:
        return [d.code for d in error.diagnostics]
    return [d.code for d in compilation.report.sorted()]


@pytest.mark.parametrize(
    ("coefficient", "found"), [("0", []), ("0.1", []), ("-0.1", ["E274"]), ("1.5", ["W251"])]
)
def test_a_coefficient_of_friction_is_not_negative(coefficient, found):
    assert codes(lever(f"friction pins {coefficient} diameter 10 mm")) == found


JAWS = """
slider K along 120 deg
pivot O
link KA
link OA
KA = 80 mm @ 150 deg
OA = 60 mm @ 35 deg
mirror across 120 deg sharing K
force F at K along {along} deg
torque M on OA
find k = M/F
"""


@pytest.mark.parametrize(("along", "found"), [(120, []), (300, []), (100, ["E263"])])
def test_a_force_on_a_shared_point_is_along_the_mirror_line_and_a_couple_may_be_anywhere(
    along, found
):
    assert codes(JAWS.format(along=along)) == found


PLUNGER = """
pivot E
slider C along x
link EB
link BC
EB = 80 mm @ 10 deg
BC = 80 mm @ -10 deg
force Q at B along -y
force W at C along -x
find k = Q/W
friction slider C 0.1 guide 40 mm overhang {overhang}
"""


@pytest.mark.parametrize(
    ("overhang", "found"),
    [("13 mm", ["W270"]), ("14 mm", []), ("13 mm linear", []), ("13 mm edges", [])],
)
def test_the_usual_law_of_an_overhang_counts_less_than_a_guide_below_a_third(overhang, found):
    """3l/s is below 1 for l < s/3 = 13.33 mm."""
    assert codes(PLUNGER.format(overhang=overhang)) == found


ACROSS = """
pivot O
pivot Q
slider K along y
link OD
link QE
rack K on O 25 mm
OD = 50 mm @ 20 deg
QE = 50 mm @ 0 deg
gear {wheels}
mirror across y sharing K
force P at K along y
force F at D along -x
find k = P/F
"""


@pytest.mark.parametrize(
    ("wheels", "hint"),
    [("O 10 mm, O' 10 mm", "leave the pair out"), ("Q' 10 mm, O 10 mm", "describe both halves")],
)
def test_twins_need_no_wheels_and_others_across_the_mirror_need_both_halves(wheels, hint):
    with pytest.raises(MechcError) as error:
        assert Compilation(Source("a.mech", ACROSS.format(wheels=wheels))).mechanism
    (found,) = error.value.diagnostics
    assert (found.code, found.hint.startswith(hint)) == ("E298", True)
