"""The last step of a derivation: ratios of speeds put into the power equation give k."""

import math

import pytest

import mechc
from good_mechanisms import CLOSED, compiled, loaded
from mechc.algebra.equality import equal
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import Symbol
from mechc.formula.walk import substitute, symbols
from mechc.model.values import completed, defaults
from mechc.report.kinds import StepRule

OPEN = ["karpenko_fig1_parallel_levers", "karpenko_fig9_packet_clamp", "tied_chain", "claw_closed"]


def test_speeds_found_one_after_another_make_a_product():
    (last,) = compiled("karpenko_fig9_packet_clamp").derivation.last_steps
    assert text(last.chain.ratio) == "V_K/V_A"
    assert [text(link) for link in last.chain.links] == ["V_K/V_B", "V_B/V_A"]
    assert text(last.chain.product) == "a*sin(alpha + beta)/(b*cos(beta))"
    assert text(last.ratio.left) == "P/F"
    assert text(last.ratio.right) == "V_K/(2*V_A*cos(alpha))"


def test_speeds_that_lead_from_the_load_below_to_the_one_above_make_a_product_too():
    """Steps go from the driven end; M/F asks for V_C/ω, so that each ratio is turned over."""
    (last,) = compiled("four_bar").derivation.last_steps
    assert text(last.chain.ratio) == "V_C/omega_O1A"
    assert [text(link) for link in last.chain.links] == ["V_C/V_B", "V_B/V_A", "V_A/omega_O1A"]
    assert text(last.chain.product) == "a*d*sin(phi - psi)/(c*sin(theta - psi))"
    assert text(last.ratio.right) == "V_C/omega_O1A"


def test_a_product_is_not_stated_once_more_upside_down():
    steps = compiled("table_4_4_lever").derivation.last_steps
    assert [text(step.ratio.left) for step in steps] == ["M/P", "P/M"]
    assert [step.chain is not None for step in steps] == [True, False]


def test_the_angular_velocity_under_a_couple_is_a_step():
    derivation = compiled("four_bar").derivation
    last = derivation.steps[-1]
    assert last.rule is StepRule.ARM
    assert [text(e.right) for e in (*last.relations, *last.results)] == [
        "len_O1A*omega_O1A",
        "V_A/a",
    ]
    (balance,) = derivation.balances
    assert text(balance.left) == "F*V_C - M*omega_O1A"


@pytest.mark.parametrize("name", [n for n in (*CLOSED, *OPEN) if n != "triad_closed"])
def test_with_the_speeds_put_in_it_is_k(name):
    derivation = compiled(name).derivation
    if not derivation.last_steps:
        pytest.skip("more than two loads do work")
    speeds = {}
    for step in derivation.steps:
        for left, right in step.results:
            if isinstance(left, Symbol):
                speeds[left.name] = right
    (k,) = (r for r in derivation.results if r.name == "k")
    (last,) = derivation.last_steps
    ratio = last.ratio.right
    named = {found.name: found.formula for found in derivation.ratios}
    assert equal(put_in(ratio, speeds), put_in(k.formula, named))


def put_in(formula, known):
    while names := symbols(formula) & known.keys():
        formula = substitute(formula, {name: known[name] for name in names})
    return formula


def test_a_ratio_with_a_sign_of_its_own_is_not_contradicted():
    """A speed asked for is signed along its guide; in the steps it is as the point moves."""
    text = """
        mechanism m
        pivot O at (0 mm, 0 mm)
        link OA
        link AB
        slider B along x
        A at (30 mm, 40 mm)
        B at (150 mm, 0 mm)
        torque M on OA
        force F at B along x
        find k = M/F
        find v = V_B/omega_OA
    """
    derivation = mechc.loads(text).derivation
    (last,) = derivation.last_steps
    (v,) = (r for r in derivation.results if r.name == "v")
    assert last.chain is None or equal(last.chain.product, v.formula)


def test_the_power_of_a_cylinder_is_by_the_speed_of_the_end_that_the_lever_rule_names():
    derivation = compiled("excavator_arm").derivation
    balances = [text(e.left) for e in derivation.balances]
    assert balances == ["P*sin(mu_B)*V_B - F*sin(mu_B - phi_CB)*V_E"]
    (last,) = derivation.last_steps
    assert text(last.ratio.right) == "V_E*sin(mu_B - phi_CB)/(V_B*sin(mu_B))"


def test_loads_that_are_tied_are_put_into_the_ratio_with_their_factor():
    """The common half stands outside, a sum of minuses has one minus in front."""
    shown = {
        name: text(compiled(name).derivation.last_steps[0].ratio.right)
        for name in ("claw_closed", "scissor_table")
    }
    assert shown["claw_closed"] == "-(V_C_R + f*V_C_T)/V_B"
    assert shown["scissor_table"] == "(cos(gamma_M/2)*V_D - V_C_W)/(2*V_AE)"


def test_a_quotient_of_two_negative_sums_has_no_minus():
    """Both jaws move against what presses on them."""
    text = loaded("d45_09_racks_pinion").emit("latex")
    assert r"\frac{N}{P}&=\frac{V_A}{V_A+V_B}" in text.replace(r"\frac{N}{P}=", r"\frac{N}{P}&=")


def test_by_equilibrium_a_long_ratio_ends_in_forces_not_in_ratios_of_speeds():
    """Jansen's leg: k rests on i_ZBC, i_ZD and i_DEF, which sums of forces know nothing of."""
    compilation = compiled("jansen_leg")
    by_sums = compilation.by_equilibrium
    (k,), (explanation,) = by_sums.results, by_sums.explanations
    assert not any(d.name.startswith("i_") for d in k.where)
    assert [d.name for d in k.where][-3:] == ["n_CE", "n_AB", "n_AD"]
    assert [text(side) for e in explanation.paragraphs[-1].equations for side in e] == [
        *("n_CE", "N_CE/W", "n_AB", "N_AB/W", "n_AD", "N_AD/W")
    ]
    assert {n for n in symbols(k.formula) if n[0] in "in"} == {"n_AB", "n_AD"}
    (by_speeds,) = compilation.reported.results
    for phi in (40, 140, 230, 310):
        known = {**defaults(compilation.mechanism), "phi": math.radians(phi)}
        values = [evaluate(one.formula, completed(known, one.where)) for one in (k, by_speeds)]
        assert values[0] == pytest.approx(values[1], rel=1e-9)


def test_by_equilibrium_a_short_ratio_stays_as_it_is():
    compilation = compiled("karpenko_fig9_packet_clamp")
    by_sums = compilation.by_equilibrium.results[0].formula
    assert text(by_sums) == text(compilation.reported.results[0].formula)
