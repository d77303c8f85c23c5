"""The part of a force that teeth or a belt lose: a number of its own among the coefficients."""

from mechc.compilation import Compilation
from mechc.formula.evaluate import evaluate
from mechc.source import Source
from small_mechanisms import gear_train


def coefficients(text: str) -> dict[str, float]:
    named = Compilation(Source("train.mech", text)).described.literals
    return {p.name: evaluate(p.value, {}) for p in named if p.name.startswith("f") and p.value}


def test_the_same_loss_of_several_pairs_is_of_none_of_them():
    """It was f_O1 at O2, too."""
    both = coefficients(gear_train("friction gear O1 0.03", "friction gear O2 0.03"))
    assert both == {"f": 0.03}
    each = coefficients(gear_train("friction gear O1 0.03", "friction gear O2 0.04"))
    assert each == {"f_O1": 0.03, "f_O2": 0.04}


def test_a_loss_is_no_coefficient_of_friction():
    losses = ("friction gear O1 0.03", "friction gear O2 0.05", "friction slider K 0.03")
    press = ("slider K along y", "link DK", "DK = 90 mm @ 60 deg", *losses)
    found = coefficients(gear_train(*press).replace("force Q at D", "force Q at K"))
    assert found == {"f_O1": 0.03, "f_O2": 0.05, "f_K": 0.03}
