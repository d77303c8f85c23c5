"""Results with the values that the description gives: what loads are tied to counts, too."""

import pytest

from mechc.driver import compile_source
from mechc.source import Source


def test_a_load_may_rest_on_formulas_of_the_user_s_one_behind_the_other():
    lever = """
        mechanism lever
        param a = 60 mm
        param S = 2 kN
        pivot O
        link OAB
        OA = a @ 20 deg
        OB = 90 mm @ 200 deg
        force P at A along -y
        force F at B along -y
        list sizes = 1 kN, 3 kN, 7 kN
        let T = next 2*S in sizes
        let P = T
        find F
        friction pins 0.1 diameter 10 mm
    """
    found = {
        r.name: r.default for r in compile_source(Source("lever.mech", lever)).solution.results
    }
    assert found["F"] == pytest.approx(7000 * 60 / 90)
    assert found["F_f"] > found["F"]
