"""Formulas beside those that a person writes by velocity ratios: equal, and no longer.

The names are those of the pose that a report introduces. A ratio that a person would write down
first stands behind the formula, and counts once.
"""

import math

import pytest

from good_mechanisms import compiled
from mechc.algebra.equality import equal
from mechc.formula.evaluate import evaluate
from mechc.formula.operations import count_operations
from mechc.formula.tree import Formula, Symbol
from mechc.formula.walk import constants, substitute, symbols
from report_samples import formula

BY_HAND: dict[str, tuple[str, dict[str, str]]] = {
    "crank_rocker": ("a*sin(psi - phi)/sin(psi - theta)", {}),
    "crank_shaper": (
        "-r*len_QB*sin(beta_BD + phi_QA)*cos(phi - phi_QA)/(len_QA*cos(beta_BD))",
        {},
    ),
    "whitworth": (
        "r*e*sin(phi_QB - beta_DE)*cos(phi - phi_QB)/(len_QB*cos(beta_DE))",
        {},
    ),
    "hoeken": (
        "a*sin(phi) + 5*a*i*sin(phi_AB)",
        {"i": "2*sin(phi - phi_AB - mu_B)/(5*sin(mu_B))"},
    ),
    "peaucellier": ("r*sin(delta + gamma)/sin(delta - gamma)", {}),
    "peaucellier_closed": (
        "r*sin(2*phi_AB - mu_B - phi)/sin(mu_B)",
        {},
    ),
    "watt_six_bar": (
        "a*c*sin(gamma - chi)*sin(phi - psi)/(b*sin(psi - theta)*sin(chi - delta))",
        {},
    ),
    "watt_closed": (
        "a*e*sin(phi - phi_AB)*sin(phi_AB + mu_B - phi_CD + deg(40))/(c*sin(mu_B)*sin(mu_D))",
        {},
    ),
    "stephenson_six_bar": (
        "(a*sin(chi - phi) + p*i*sin(sigma - chi))/sin(chi - delta)",
        {"i": "a*sin(phi - theta)/(b*sin(psi - theta))"},
    ),
    "stephenson_closed": (
        "(a*sin(phi - phi_CD) + e*i*sin(phi_AB - phi_CD + deg(25)))/sin(mu_D)",
        {"i": "a*sin(phi - phi_AB - mu_B)/(b*sin(mu_B))"},
    ),
    "jansen_leg": (
        "len_DF*i_DEF*cos(phi_DF) - len_ZD*i_ZD*cos(mu_D + phi_AD)",
        {
            "i_DEF": "(len_ZC*i_ZBC*sin(phi_CE - phi_ZC) + len_ZD*i_ZD*sin(phi_CE - mu_D - phi_AD))"
            "/(len_DE*sin(mu_E))",
            "i_ZD": "m*sin(phi - phi_AD)/(len_ZD*sin(mu_D))",
            "i_ZBC": "m*sin(phi - phi_AB)/(len_ZB*sin(mu_B))",
        },
    ),
    "triad_press": (
        "r*sin(phi - psi)*(b*sin(beta - sigma)*sin(gamma) + c*sin(tau - gamma)*sin(beta))"
        "/(b*sin(beta - sigma)*sin(gamma - psi) + c*sin(psi - beta)*sin(gamma - tau))",
        {},
    ),
    "triad_closed": (
        "a*sin(phi_AB - phi)"
        "*(len_BC*sin(phi_BC - phi_RD) - len_BD*cos(phi_BC - phi_RD - deg(30)))"
        "/(len_BC*sin(phi_AB - phi_RD)*sin(phi_BC - phi_QC)"
        " - len_BD*sin(phi_AB - phi_QC)*cos(phi_BC - phi_RD - deg(30)))",
        {},
    ),
    "double_butterfly": (
        "a*(len_AF*sin(phi - phi_EG)*sin(phi_AF - phi_CF)"
        " + len_AG*sin(phi_CF - phi)*sin(phi_AF - phi_EG - deg(100)))"
        "/(len_AF*len_QE*n*sin(phi_AF - phi_CF)*sin(phi_EG - phi_QD - deg(80))"
        " + len_AG*len_PC*sin(phi_AF - phi_EG - deg(100))*sin(phi_PC - phi_CF))",
        {"n": "len_PB*sin(phi_BD - phi_PC - deg(70))/(len_QD*sin(phi_BD - phi_QD))"},
    ),
}
"""k of six-bars, straight-line and quick-return mechanisms, triads and an eight-bar, by hand."""


VALID_EVERYWHERE = {"double_butterfly": 4}
"""By how many operations k is longer, as it is not divided by what vanishes at a dead centre."""


def by_name(formula: Formula) -> Formula:
    """Return a formula in which lengths given by numbers are names alone."""
    return substitute(formula, {c.name: Symbol(c.name) for c in constants([formula])})


def ratios_of(name: str) -> dict[str, Formula]:
    return {ratio.name: by_name(ratio.formula) for ratio in compiled(name).derivation.ratios}


def k_of(name: str) -> Formula:
    return next(by_name(r.formula) for r in compiled(name).derivation.results if r.name == "k")


def size(k: Formula, ratios: dict[str, Formula]) -> int:
    return count_operations(k) + sum(map(count_operations, ratios.values()))


def at_once(k: Formula, ratios: dict[str, Formula]) -> Formula:
    """Return k with its ratios put in, those that rest on others first."""
    for _ in ratios:
        k = substitute(k, ratios)
    return k


@pytest.mark.parametrize("name", BY_HAND)
def test_k_is_as_by_hand_and_no_longer(name: str) -> None:
    written, behind = BY_HAND[name]
    by_hand = formula(written), {n: formula(f) for n, f in behind.items()}
    own = k_of(name), ratios_of(name)
    assert equal(at_once(*own), at_once(*by_hand))
    assert size(*own) <= size(*by_hand) + VALID_EVERYWHERE.get(name, 0)


def test_what_is_longer_has_a_value_where_by_hand_there_is_none() -> None:
    written, behind = BY_HAND["double_butterfly"]
    by_hand = at_once(formula(written), {n: formula(f) for n, f in behind.items()})
    own = k_of("double_butterfly")
    values = {name: 0.3 + 0.1 * i for i, name in enumerate(sorted(symbols(own)))}
    values["phi_BD"] = values["phi_QD"]  # the output stands still
    assert evaluate(own, values) == 0
    assert not math.isfinite(evaluate(by_hand, values))
