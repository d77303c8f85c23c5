"""The part of a force that teeth or a belt lose: a number of its own among the coefficients."""

from mechc.compilation import Compilation
from mechc.formula.evaluate import evaluate
from mechc.source import Source

TRAIN = """
pivot O1 at (0 mm, 0 mm)
pivot O2 at (60 mm, 0 mm)
pivot O3 at (130 mm, 0 mm)
link O1C
link O2E
link O3D
O1C = 100 mm @ 0 deg
O2E = 50 mm @ 90 deg
O3D = 80 mm @ 0 deg
gear O1 20 mm, O2 40 mm
gear O2 15 mm, O3 55 mm
{losses}
force P at C along -y
force Q at D along -y
find k = P/Q
"""


def coefficients(text: str, *losses: str) -> dict[str, float]:
    source = Source("train.mech", text.format(losses="\n".join(losses)))
    named = Compilation(source).described.literals
    return {p.name: evaluate(p.value, {}) for p in named if p.name.startswith("f") and p.value}


def test_the_same_loss_of_several_pairs_is_of_none_of_them():
    """It was f_O1 at O2, too."""
    both = coefficients(TRAIN, "friction gear O1 0.03", "friction gear O2 0.03")
    assert both == {"f": 0.03}
    each = coefficients(TRAIN, "friction gear O1 0.03", "friction gear O2 0.04")
    assert each == {"f_O1": 0.03, "f_O2": 0.04}


def test_a_loss_is_no_coefficient_of_friction():
    press = TRAIN.replace("link O3D", "link O3D\nslider K along y\nlink DK\nDK = 90 mm @ 60 deg")
    press = press.replace("force Q at D", "force Q at K")
    losses = ("friction gear O1 0.03", "friction gear O2 0.05", "friction slider K 0.03")
    found = coefficients(press, *losses)
    assert found == {"f_O1": 0.03, "f_O2": 0.05, "f_K": 0.03}
