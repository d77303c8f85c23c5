"""Whatever is said of a result holds against sampling: over random chains with shared zeros."""

import pytest

from conclusions import refuted as followed
from force_mechanisms import given
from force_samples import pushing, tree_of
from grown import Grown, swept
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.formula.to_text import text
from mechc.report.text.derivation import render
from mechc.source import Source
from mechc.work import MOST_WORK
from open_chains import Chain
from statements import missing, refuted

POLE = """
param alpha = 85 deg in 80 deg .. 100 deg
param L = 80 mm
slider A along x
slider C along -y
link AC
AC = L @ -90 deg + alpha
force P at A along x
force F at C along y
find k = P/F
"""

TREBLED = """
param al = {value} deg in {low} deg .. {high} deg
slider A along 2*al
slider C along x
{more}
link AC
AC = 100 mm @ -al
force P at A along 2*al
force F at {load}
find k = P/F
"""


def results(text):
    compilation = Compilation(Source("chain.mech", text))
    found = compilation.results
    assert MOST_WORK - compilation.allowance.left < MOST_WORK / 5
    return compilation.pose.mechanism, found


def hold(seeds, equal=False):
    """Compile chains and try what is said; return how many had a result."""
    compiled, codes = 0, set[str]()
    for seed in seeds:
        text = Chain(seed, equal).text
        try:
            (mechanism, found), tree = results(text), tree_of(text)
        except MechcError as error:
            codes |= {d.code for d in error.diagnostics}
            continue
        for result in found:
            assert list(refuted(mechanism, result, seed)) == [], seed
            assert list(missing(mechanism, result, seed)) == [], seed
            assert list(followed(tree, mechanism, result, seed)) == [], seed
        compiled += 1
    assert "E817" not in codes
    return compiled


def test_nothing_that_is_said_is_refuted_and_no_zero_is_left_out():
    assert hold(range(12)) > 8


def test_a_sum_of_which_it_is_not_known_what_it_shares_is_stated_all_the_same():
    """With l4 = l5 the sum vanishes at a root of the sine across the line; elsewhere it counts."""
    mechanism, (k,) = results(Chain(80074, equal=True).text)
    assert len([v for v in k.zeros if v.except_where]) == 1
    assert list(refuted(mechanism, k, 80074)) == list(missing(mechanism, k, 80074)) == []


def test_a_sine_that_a_sum_has_for_itself_vanishes_too():
    """The sum cos 3t + … sin 2t/sin(t - 5 deg) shares the pole, and vanishes with cos t."""
    mechanism, (k,) = results(Chain(530287).text)
    assert "cos(t/2 + pi/4)" in {text(v.factor) for v in k.zeros}
    assert list(missing(mechanism, k, 530287)) == []


def test_what_a_sum_shares_with_a_sine_across_the_line_counts_by_its_order():
    """cos(3t/2) and (1 - 2 cos t)² share a root at 60 deg, where k is infinite all the same."""
    mechanism, (k,) = results(Chain(4400156, equal=True).text)
    stated = [text(v.factor) for v in k.poles]
    assert "sin(t/4 - pi/12)" in stated
    assert len(stated) == len({*stated})
    assert list(refuted(mechanism, k, 4400156)) == list(missing(mechanism, k, 4400156)) == []


def test_two_roots_of_a_double_angle_have_two_causes():
    """k is cos(45 deg + t) cos(45 deg - t): a point stands still at -45 deg, not at 45 deg."""
    mechanism, (k,) = results(Chain(80100075).text)
    assert {text(v.factor) for v in k.zeros} == {"cos(t + pi/4)", "sin(t + pi/4)"}
    assert list(followed(tree_of(Chain(80100075).text), mechanism, k, 80100075)) == []


@pytest.mark.parametrize("seed", [910196, 910228])
def test_a_pole_that_a_sum_hides_for_the_lengths_given_is_stated_with_the_sum(seed):
    mechanism, (k,) = results(Chain(seed, equal=True).text)
    assert any(v.except_where for v in k.poles)
    assert list(refuted(mechanism, k, seed)) == list(missing(mechanism, k, seed)) == []


def test_lengths_that_are_equal_by_chance_make_no_false_zeros():
    assert hold(range(1000, 1010), equal=True) > 7


@pytest.mark.slow
def test_nothing_that_is_said_of_hundreds_of_chains_is_refuted():
    assert hold(range(2000, 2040)) > 30


def closed_hold(seeds):
    for grown in map(Grown, seeds):
        if "triad" not in grown.kinds:
            mechanism, found = results(swept(grown))
            for result in found:
                assert list(refuted(mechanism, result, grown.seed)) == [], grown.seed
                assert list(missing(mechanism, result, grown.seed)) == [], grown.seed
                assert list(followed(None, mechanism, result, grown.seed)) == [], grown.seed


def test_what_is_said_of_closed_mechanisms_holds_along_the_drive():
    closed_hold(range(12))


def test_nothing_is_said_of_k_where_a_length_that_loops_find_is_infinite():
    """Where a slot is parallel to the guide of its pin k jumps, and a sine of its angle is 0."""
    closed_hold([70380])
    compilation = Compilation(Source("closed.mech", swept(Grown(70380))))
    (k,) = compilation.results
    assert [b.name for b in k.breaks] == ["len_A4T8"]
    assert k.breaks[0].factor not in {v.factor for v in (*k.zeros, *k.poles)}
    said = render(compilation.derivation, compilation.mechanism, unicode=False)
    assert "is infinite, and k may jump." in " ".join(said.split())


def test_a_slope_rests_on_what_its_result_rests_on():
    """The rate of phi_A4P5 rests on len_P5A4, which the slot along it measures the other way."""
    mechanism, (k,) = results(swept(Grown(77041312)))
    assert list(followed(None, mechanism, k)) == []
    assert k.slopes.keys() == k.derivatives.keys() == {"phi"}


@pytest.mark.parametrize("seed", [53, 80140006])
def test_slopes_go_by_the_angles_of_a_side_that_turns_round_where_it_passes_zero(seed):
    """Its direction in its body is 0 or 180 deg; no loop gives that a rate."""
    mechanism, (k,) = results(swept(Grown(seed)))
    assert list(followed(None, mechanism, k)) == []
    assert k.slopes.keys() == k.derivatives.keys() == {"phi"}


@pytest.mark.slow
def test_what_is_said_of_hundreds_of_closed_mechanisms_holds():
    closed_hold(range(1000, 1040))


def test_k_is_not_said_to_rise_across_a_pole():
    mechanism, (k,) = results(POLE)
    assert k.trends == {"alpha": "rises between poles"}
    assert list(refuted(mechanism, k)) == []
    for end in ("89 deg", "90 deg"):
        mechanism, (k,) = results(POLE.replace("100 deg", end))
        assert k.trends == {"alpha": "rises"}
        assert list(refuted(mechanism, k)) == []


def test_a_zero_that_cancels_is_no_pole():
    text = TREBLED.format(value=20, low=5, high=80, more="", load="C along -x")
    _, (k,) = results(text)
    assert k.poles == ()
    assert len(k.zeros) == 1


def test_what_vanishes_less_than_it_is_divided_by_is_infinite_only():
    more = "slider D along 60 deg - al\nlink CD\nCD = 100 mm @ 60 deg"
    text = TREBLED.format(value=85, low=70, high=110, more=more, load="D along -120 deg - al")
    mechanism, (k,) = results(text)
    assert [v.at[0] for v in k.poles] == ["al"]
    assert list(refuted(mechanism, k)) == list(missing(mechanism, k)) == []


def test_a_pole_is_stated_where_the_default_pose_is_next_to_where_it_cancels():
    """u = -60.003 deg; at -60 deg the numerator vanishes with the denominator."""
    mechanism, (k,) = results(Chain(10446).text)
    assert list(refuted(mechanism, k)) == list(missing(mechanism, k)) == []


@pytest.mark.parametrize("trend", ["rises", "falls", "constant"])
def test_the_sampler_refutes_what_is_false(trend):
    mechanism, (k,) = results(POLE)
    assert list(refuted(mechanism, replace(k, trends={"alpha": trend})))


def test_no_dead_centre_is_that_of_a_load_tied_to_another():
    """T = 0.3*F acts at D, which alone is infinitely fast where ABC and H stand still."""
    sample = pushing(given(80120056))
    mechanism, (k,) = results(sample.text)
    tree = tree_of(sample.text)
    assert {text(v.factor): v.cause == "other" for v in k.poles} == {
        "sin(t7 - t9)": False,
        "cos(t3 - t4)": True,
    }
    assert list(followed(tree, mechanism, k, 80120056)) == []


def test_conclusions_that_are_false_are_refuted():
    """Slopes, dead centres, and the load that is across the motion of its point."""
    mechanism, (k,) = results(POLE)
    tree = tree_of(POLE)
    assert list(followed(tree, mechanism, k)) == []
    assert list(followed(tree, mechanism, replace(k, derivatives={"alpha": k.formula})))
    across = [limit._replace(cause="perpendicular load") for limit in k.poles]
    assert list(followed(tree, mechanism, replace(k, poles=tuple(across))))


def test_what_stands_still_where_a_zero_meets_a_pole_is_left_to_the_values():
    """At alpha = 90 degrees k is 0, but 0/0 at the beta where it is infinite for other alphas."""
    text = """
param a = 50 mm in 20 mm .. 150 mm
param b = 60 mm
param alpha = 90 deg
param beta = 45 deg
pivot A
link AB
AB = 2*a @ 90 deg
pivot C
link CDE
slot B in CDE about D radius b
DB = @ alpha
CD = a @ alpha + beta
CE = a @ alpha + beta
slider G along 60 deg
link EG
EG = a @ 135 deg + beta
force P at B along perp AB
force F at G along 60 deg
find k = P/F
"""
    mechanism, (k,) = results(text)
    assert k.poles
    assert list(followed(tree_of(text), mechanism, k, 157002641)) == []


def test_what_does_not_turn_and_what_is_not_infinite_is_refuted():
    mechanism, (k,) = results(POLE.replace("100 deg", "89 deg"))
    assert list(refuted(mechanism, replace(k, trends={"alpha": "turns"})))
    mechanism, (k,) = results(swept(Grown(1356)))
    (far,) = k.breaks
    assert list(followed(None, mechanism, k)) == []
    finite = far._replace(name="phi_A4D12")
    assert list(followed(None, mechanism, replace(k, breaks=(finite,))))


def test_the_sampler_finds_zeros_that_are_none_and_those_left_out():
    mechanism, (k,) = results(POLE)
    assert list(refuted(mechanism, replace(k, zeros=k.poles)))
    assert list(missing(mechanism, replace(k, poles=())))


@pytest.mark.parametrize("turn", ["1.2345678*al", "al + 0.123456789 rad", "1000*al"])
def test_angles_of_which_nothing_small_is_a_multiple_take_no_time(turn):
    text = TREBLED.format(value=20, low=5, high=80, more="", load=f"C along {turn}")
    mechanism, (k,) = results(text.replace("@ -al", f"@ {turn}"))
    assert list(refuted(mechanism, k)) == []


BY_CHANCE = """
param alpha = 73.1 deg in 0 deg .. 90 deg
param beta = 0 deg in -20 deg .. 30 deg
pivot O
slider K along x
link OB
link BK
OB = 6 mm @ alpha - beta
BK = 11 mm @ 2*alpha
force P at B on OB along x
force F at K on BK along beta
find k = P/F
"""


def test_a_pole_that_a_zero_meets_at_the_default_values_only_is_stated_with_it():
    """With beta = 0 both sin(alpha + beta) and sin(alpha - beta) are sin(alpha)."""
    mechanism, (k,) = results(BY_CHANCE)
    assert {text(f) for v in k.poles for f in v.except_where} == {"sin(alpha + beta)"}
    assert {text(f) for v in k.zeros for f in v.except_where} == {"sin(alpha - beta)"}
    assert list(refuted(mechanism, k)) == list(missing(mechanism, k)) == []


BY_CHANCE_ELSEWHERE = """
param alpha = 60 deg
param beta = 120 deg in 60 deg .. 210 deg
slider A along alpha
slider C along 120 deg - alpha
link AC
AC = 80 mm @ beta
force P at A along alpha
force F at C along alpha - 60 deg
find k = P/F
"""


def test_a_place_at_which_a_zero_meets_a_pole_for_the_values_given_is_stated_with_it():
    """Both cos(alpha - beta) and sin(alpha + beta - 30 deg) are zero where beta is 150 deg.

    Each by itself has another root along alpha, by which it was proved to make k vanish.
    """
    mechanism, (k,) = results(BY_CHANCE_ELSEWHERE)
    meeting = [v for v in (*k.zeros, *k.poles) if v.at and v.at[0] == "beta" and v.except_where]
    assert [text(v.factor) for v in meeting] == ["cos(alpha - beta)", "sin(alpha + beta - pi/6)"]
    assert list(refuted(mechanism, k)) == []
