"""What is said of a result, on formulas and functions written by hand."""

import math
from collections.abc import Callable
from fractions import Fraction
from types import SimpleNamespace

import pytest

import mechc
from mechc.algebra.angle import Angle
from mechc.algebra.intervals import NumberInterval
from mechc.algebra.product import ONE, Product
from mechc.algebra.sums import add
from mechc.algebra.trigonometry import cosine, sine
from mechc.base.frozen import replace
from mechc.compilation import compile_source
from mechc.diagnostics import Report
from mechc.formula.evaluate import evaluate
from mechc.formula.numeric.rounding import PrintedNumber
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, number, power, product, quotient, total
from mechc.model.mechanism import Drive, Efficiency, Find, LoadRatio, Require, WithFriction
from mechc.model.result import Definition, Result
from mechc.model.values import complete, default_pose
from mechc.power.from_plan import balance
from mechc.source import Source
from mechc.study import variables
from mechc.study.analysis import Acted, Break, DeadCentre, Vanishing
from mechc.study.expectations import random_poses
from mechc.study.forms import holding
from mechc.study.ratios import sizes
from mechc.study.sampling import _jumps, _loose, _next_to_ends, sampled_values
from mechc.study.states import AgainstFriction, RatioAlong, StateFound, divisors_of_terms
from mechc.study.stroke.columns import FilledColumn, named_apart
from mechc.study.stroke.extrema import _is_shown, extrema, turns_between
from mechc.study.stroke.rows import from_both_sides
from mechc.study.stroke.run import ENOUGH, GRADED, graded, looked_at
from mechc.study.stroke.stretches import with_reached
from mechc.study.stroke.stroke import Extremum, StrokeColumn, StrokeInterval
from mechc.study.stroke.transmission import TransmissionAngle, named, transmissions
from mechc.study.trends import trend
from mechc.study.zeros import _each_place_once, _joined, breaks, limits
from mechc.units import LENGTH, NUMBER
from small_poses import HERE, VALUES, lever, plan, slider_crank, two_bars

PHI, PSI = VALUES["phi"], VALUES["psi"]
x, a = Product.symbol("x"), Product.symbol("a")

# ------------------------------------------------------------------------------ trends


def box(low, high):
    return {"x": NumberInterval(low, high), "a": NumberInterval(1.0, 1.0)}


@pytest.mark.parametrize(
    ("slope", "expected"),
    [(ONE, "rises"), (-ONE, "falls"), (Product(0), "constant"), (add([x, -a]), "turns")],
)
def test_a_result_moves_as_its_derivative_says(slope, expected):
    assert trend(x, slope, "x", box(0.5, 2.0)) == expected


def test_a_result_rises_on_either_side_of_a_pole_and_not_across():
    """1/(a − x) has the slope 1/(a − x)² and jumps at x = a."""
    below = add([a, -x])
    assert trend(below**-1, below**-2, "x", box(0.5, 2.0)) == "rises between poles"
    assert trend(below**-1, below**-2, "x", box(0.1, 0.9)) == "rises"


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (0, 60, "falls"),
        (0, 180, "falls"),
        (-180, 0, "rises"),
        (0, 181, "unknown"),
        (-1, 60, "turns"),
    ],
)
def test_a_cosine_moves_one_way_over_a_range_at_whose_end_its_derivative_is_zero(
    low, high, expected
):
    angle = Angle.of("x")
    variables = box(math.radians(low), math.radians(high))
    assert trend(cosine(angle), -sine(angle), "x", variables) == expected


def test_a_derivative_that_is_zero_for_one_value_of_another_parameter_says_nothing():
    """x sin a does not move with x where a is zero; cos(a + x) does, but at one end."""
    variables = {"x": NumberInterval(0.0, 1.0), "a": NumberInterval(0.0, 1.0)}
    both = Angle.of("a") + Angle.of("x")
    still = sine(Angle.of("a"))
    assert trend(x * still, still, "x", variables) == "unknown"
    assert trend(cosine(both), -sine(both), "x", variables) == "falls"
    given = {"x": NumberInterval(0.0, 0.0), "a": NumberInterval(0.0, 1.0)}
    assert trend(cosine(both), -sine(both), "x", given) == "unknown"


def test_a_result_falls_from_a_pole_at_the_end_of_a_range():
    """The tangent has its poles at both ends, cot 2x falls on either side of the one within."""
    angle, twice = Angle.of("x"), Angle.of("x") * 2
    tangent, upright = sine(angle) * cosine(angle) ** -1, cosine(angle) ** -2
    cot, slope = cosine(twice) * sine(twice) ** -1, -Product(2) * sine(twice) ** -2
    assert trend(tangent, upright, "x", box(-math.pi / 2, math.pi / 2)) == "rises"
    assert trend(cot, slope, "x", box(0.0, 0.7)) == "falls"
    assert trend(cot, slope, "x", box(0.0, 2.0)) == "falls between poles"


# ------------------------------------------------------------------------------ ranges


def test_a_boundary_is_narrowed_down_to_where_it_lies():
    assert variables.last(lambda v: v < math.pi, 3.0, 4.0) == pytest.approx(math.pi, rel=1e-12)


def test_spans_are_the_parts_on_which_something_holds():
    places = [0.0, 1.0, 2.0, 3.0, 4.0]
    found = list(variables.spans(places, lambda v: v < 0.5 or v > 2.5))
    assert found == [(0.0, pytest.approx(0.5)), (pytest.approx(2.5), 4.0)]
    near = list(variables.spans([0.5, 1.5, 2.0], lambda v: v < 1.4 or v > 1.6))
    assert near == [(0.5, pytest.approx(1.4)), (pytest.approx(1.6), 2.0)]


def result(formula, *where):
    return Result("k", None, NUMBER, formula, tuple(where))


def test_results_are_followed_along_the_angles_and_the_drive_they_rest_on():
    pose = lever(drive=Drive("a", None, None, HERE))
    of = [result(Symbol("u"), Definition("u", total([Symbol("a"), Symbol("b"), Symbol("phi")])))]
    assert list(variables.varying(pose.mechanism, of)) == ["a", "phi"]
    assert list(variables.moved(pose.mechanism, of)) == ["a", "phi"]
    assert variables.turns("phi", pose.mechanism)
    assert not variables.turns("a", pose.mechanism)
    assert variables.unit_of("a", pose.mechanism) == "m"
    assert variables.unit_of("phi", pose.mechanism) == ""


def test_one_load_without_a_size_may_have_any_and_two_none():
    mechanism = lever().mechanism
    assert sizes(mechanism, result(Symbol("F"))) == {"F": 1.0}
    assert sizes(mechanism, result(total([Symbol("F"), Symbol("P")]))) is None
    assert sizes(mechanism, result(Symbol("F"), Definition("F", number(3)))) == {}


def test_random_poses_are_the_same_each_time():
    mechanism = lever().mechanism
    assert default_pose(mechanism) == pytest.approx(VALUES)
    assert list(random_poses(mechanism, 2)) == list(random_poses(mechanism, 2))
    assert len(list(random_poses(mechanism, 3))) == 3
    assert complete(mechanism, {"a": 1.0}) == {"a": 1.0}


# ------------------------------------------------------------------- zeros and poles


def solved(pose, above, below):
    """Return the ratio of two loads, solved, and the balance that it is of."""
    find = Find("k", LoadRatio(above, below), HERE)
    asked = replace(pose, mechanism=replace(pose.mechanism, finds=(find,)))
    found = balance(plan(asked), Report(Source("", "")))
    return found.solved[0], found


def test_a_toggle_needs_no_force_where_it_is_straight():
    """k = P/F = 2·tan α is zero at α = 0, where K stands still, and infinite at 90°."""
    item, found = solved(two_bars(), "P", "F")
    (zero,), (pole,) = limits(item, found, VALUES)
    assert zero.cause == DeadCentre(still=Acted("K"), moving=Acted("B"))
    assert pole.cause == "perpendicular load"


def test_a_crank_drives_a_slider_and_stands_still_at_its_dead_centres():
    item, found = solved(slider_crank(), "M", "F")
    (zero,), infinite = limits(item, found, VALUES)
    assert zero.cause == DeadCentre(still=Acted("B"), moving=Acted("OA"))
    causes = [p.cause for p in infinite]
    assert causes == [DeadCentre(still=Acted("OA"), moving=Acted("B"))]


STEPPED = """
mechanism stepped
param r1 = 20 mm
param r2 = 30 mm
param r4 = 27 mm
pivot O
link OS
link OA
link AQ
link OT
OA = r1 + r2 @ 30 deg
OS = @ 0 deg
AQ = @ 0 deg
OT = @ 0 deg
gear O r1 on OS, A r2
gear O r1 + 2*r2 on ground, A r2 inner
gear O r1 + r2 + r4 on OT, A r4 inner
torque M on OS
torque L on OT
find k = M/L
"""


def test_equal_radii_are_no_dead_centre():
    """Where both wheels of the planet are as large, L can do nothing, wherever the arm is."""
    (result,) = compile_source(Source("stepped.mech", STEPPED)).results
    (zero,) = result.zeros
    assert (text(zero.factor), zero.cause) == ("r2 - r4", "other")


HOIST = """
mechanism hoist
param a = 300 mm
pivot O
slider K along y
slider A along y
slider B along -y
link OC
OC = a @ {angle}
rack A on O 80 mm
rack B on O 60 mm
rope A, K along -y, B along y
force P at C along y
force Q at K along -y
find k = P/Q
"""


def test_equal_drums_are_no_dead_centre_where_they_are_numbers():
    """The falls gain and lose the same in every pose; the crank's end moves across P at 90°."""
    (plain,) = compile_source(Source("hoist.mech", HOIST.format(angle="0 deg"))).results
    (zero,) = plain.zeros
    assert (text(zero.factor), zero.cause) == ("r_O - r_O_2", "other")
    turned = HOIST.format(angle="phi").replace("pivot", "param phi = 20 deg\npivot", 1)
    (turning,) = compile_source(Source("hoist.mech", turned)).results
    (pole,) = turning.poles
    assert (text(pole.factor), pole.cause) == ("cos(phi)", "perpendicular load")


@pytest.mark.parametrize(("lengths", "is_zero"), [((0.3, 0.2), True), ((0.3, 0.3), False)])
def test_where_lengths_are_equal_a_zero_may_be_none(lengths, is_zero):
    """sin α/(a - b·cos α) vanishes at α = 0, and grows without end there where a = b."""
    item, found = solved(lever(), "P", "F")
    a, b = map(Product.symbol, "ab")
    value = sine(Angle.of("alpha")) / add([a, -b * cosine(Angle.of("alpha"))])
    item = replace(item, value=value, result=replace(item.result, formula=value.formula()))
    near = {**VALUES, **dict(zip("ab", lengths, strict=True)), "alpha": 0.4}
    assert (("alpha", number(0)) in [zero.at for zero in limits(item, found, near)[0]]) is is_zero


def test_a_zero_at_one_end_of_a_diameter_is_stated_where_a_loop_makes_it_none_at_the_other():
    """The chord from A = (cos α, sin α) to (0, 1) lies along the crank at -90°, not at 90°."""
    item, found = solved(lever(), "P", "F")
    alpha, chord = Angle.of("alpha"), Angle.of("chord")
    up, ahead = (-sine(alpha)).formula(), (-cosine(alpha)).formula()
    along = Call("atan2", (total([number(1), up]), ahead))
    value = cosine(alpha) / sine(alpha - chord)
    formed = replace(item.result, formula=value.formula(), where=(Definition("chord", along),))
    near = {**VALUES, "alpha": 0.4, "chord": 1.9}
    (zero,), _ = limits(replace(item, value=value, result=formed), found, near)
    assert zero.at is not None
    assert evaluate(zero.at[1], {}) == pytest.approx(math.pi / 2)
    assert evaluate(zero.factor, {"alpha": -math.pi / 2}) != pytest.approx(0)


@pytest.mark.parametrize(
    ("cause", "kept"),
    [
        ("other", ["sin(2*t)", "cos(3*t)"]),
        ("perpendicular load", ["sin(t)", "sin(2*t)", "cos(3*t)"]),
    ],
)
def test_a_zero_is_stated_once(cause, kept):
    """sin t and cos t vanish where sin 2t does; cos 3t vanishes elsewhere, too."""
    t = Angle.of("t")
    first = Vanishing(sine(t).formula(), None, cause)
    others = [sine(t * 2), cosine(t), cosine(t * 3)]
    found = [first, *(Vanishing(each.formula(), None, "other") for each in others)]
    assert [text(each.factor) for each in _each_place_once(found)] == kept


def test_zeros_a_half_turn_apart_are_one_where_their_cause_is_one():
    half, right = Angle.of("t") * Fraction(1, 2), Angle.constant(45)
    pairs = [(sine(half), "a"), (cosine(half + right), "b"), (cosine(half), "a")]
    found = [(next(iter(each.factors)), why) for each, why in pairs]
    said = [(text(trig.formula()), why) for trig, why in _joined(found)]
    assert said == [("sin(t)", "a"), ("cos(t/2 + pi/4)", "b")]


@pytest.mark.parametrize(
    ("part", "function", "is_absent"),
    [(0.25, "asin", True), (1.5, "asin", False), (0.25, "acos", False)],
)
def test_a_zero_is_absent_where_an_arc_keeps_an_angle_from_it(part, function, is_absent):
    """With β = arcsin(sin(t)/4) the cosine of β is at least 0.96, whatever t is."""
    item, found = solved(lever(), "P", "F")
    sine_of = Call("sin", (Symbol("turn"),))
    beta = Call(function, (product([(number(Fraction(part)), 1), (sine_of, 1)]),))
    value = cosine(Angle.of("beta"))
    formed = replace(item.result, formula=value.formula(), where=(Definition("beta", beta),))
    near = {**VALUES, "turn": 0.4, "beta": 0.1}
    (zero,), _ = limits(replace(item, value=value, result=formed), found, near)
    assert zero.absent is is_absent


def test_a_length_that_is_infinite_somewhere_breaks_a_result():
    """a/cos φ is; a sum of two positive lengths is never zero."""
    where = [
        Definition("len", quotient(Symbol("a"), Call("cos", (Symbol("phi"),)))),
        Definition("other", quotient(Symbol("a"), total([Symbol("a"), Symbol("b")]))),
    ]
    assert breaks(where, VALUES) == (Break("len", Call("cos", (Symbol("phi"),))),)


# ------------------------------------------------------------------------- the stroke


class Written:
    """A result along the stroke as a function written by hand."""

    def __init__(self, at):
        self._at = at

    def of(self, formula, result, place):
        return self._at(place)

    def function(self, formula, result):
        return self._at


class Plain:
    name, formula, derivatives, target = "k", None, None, None


def test_extrema_lie_between_the_places_where_a_result_turns():
    places = [i / 7 for i in range(15)]
    found = list(extrema(Plain, "x", Written(lambda v: (v - 1.03) ** 2 + 2), places))
    assert [(e.kind, e.drive, e.value) for e in found] == [
        ("minimum", pytest.approx(1.03, abs=1e-6), pytest.approx(2))
    ]
    (top,) = extrema(Plain, "x", Written(lambda v: math.sin(v)), [i / 5 for i in range(15)])
    assert (top.kind, top.drive) == ("maximum", pytest.approx(math.pi / 2, abs=1e-6))
    assert not list(extrema(Plain, "x", Written(lambda v: v), places))


def test_a_result_turns_once_among_places_that_lie_as_near_as_rounding():
    """Beside the place at which friction turns round it is looked at on either side of it."""
    places = sorted([*(i / 7 for i in range(15)), 1 - 1e-8, 1 + 1e-8])
    (top,) = extrema(Plain, "x", Written(lambda v: 3 - (v - 1) ** 2), places)
    assert (top.kind, top.drive) == ("maximum", pytest.approx(1.0, abs=1e-6))


def test_beside_a_jump_a_result_is_least_at_the_jump_and_not_where_it_was_looked_at():
    places = [i / 7 for i in range(15)]
    (low,) = extrema(Plain, "x", Written(lambda v: -v if v < 1.03 else 5.0 + v), places)
    assert (low.kind, low.drive) == ("minimum", pytest.approx(1.03, abs=1e-6))
    assert low.value == pytest.approx(-1.03)


def test_an_extremum_beside_a_pole_turns_before_it():
    found = Extremum("k", "minimum", 1.0, 2.0)
    assert turns_between(found, [2.0], Plain, Written(lambda v: (v - 1) ** 2 + 2))
    assert not turns_between(found, [2.0], Plain, Written(lambda v: 2.0))


class Signed:
    """What moves with signs that are given as functions."""

    def __init__(self, *signs):
        self._signs = signs

    def signs(self, x):
        return tuple(math.copysign(1, sign(x)) for sign in self._signs)


def test_friction_is_looked_at_on_either_side_of_each_change_of_a_sign():
    found = list(_jumps(Signed(lambda x: x - 0.3, lambda x: x - 0.7), 0.0, 1.0))
    assert found == pytest.approx([0.3, 0.3, 0.7, 0.7], abs=1e-5)


def test_a_change_next_to_the_end_of_a_narrow_cell_is_passed_in_one_step():
    """The clamp with parallel levers was looked at in 2,000 places, 1,900 next to its end."""
    near = 1.57 - 8e-11
    assert len(list(_jumps(Signed(lambda x: x - near), 1.57 - 4e-8, 1.57))) <= 4


def test_the_sides_of_a_place_are_continued_to_it():
    def anywhere(place):
        return True

    smooth = from_both_sides(lambda v: 3 + v, anywhere, 1.0, 1.0)
    assert smooth == PrintedNumber(pytest.approx(4.0))
    jump = from_both_sides(lambda v: math.copysign(2.0, v), anywhere, 0.0, 1.0)
    assert jump == PrintedNumber(None, undetermined=True)
    pole = from_both_sides(lambda v: 1 / abs(v) if v else math.inf, anywhere, 0.0, 1.0)
    assert pole.number == math.inf
    onesided = from_both_sides(lambda v: math.copysign(2.0, v), lambda v: v > 0, 0.0, 1.0)
    assert onesided.number == 2.0
    steep = from_both_sides(lambda v: 30 + v / 1e-9, lambda v: v > 0, 0.0, 1.0)
    assert steep.number == pytest.approx(30.0)


def test_places_lie_closer_where_a_loop_ends():
    steps = list(graded(1.0, 2.0))
    assert len(steps) == GRADED - 1
    assert steps[0] == 1 + GRADED**-2
    free, ended = StrokeInterval(0.0, 1.0, "", ""), StrokeInterval(0.0, 1.0, "loop", "")
    many = [i / (2 * ENOUGH) for i in range(1, 2 * ENOUGH)]
    assert looked_at(free, many) == [0.0, *many, 1.0]
    assert len(looked_at(ended, many)) == len(many) + 2 + GRADED - 1


def test_what_the_default_pose_is_not_on_cannot_be_reached():
    first, second = StrokeInterval(0.0, 1.0, "", "loop"), StrokeInterval(2.0, 3.0, "loop", "")
    found = with_reached([first, second], 0.5, "excluded", False)
    assert [s.reached for s in found] == [True, False]
    joined = [first._replace(after="excluded"), second._replace(before="excluded")]
    assert [s.reached for s in with_reached(joined, 0.5, "excluded", False)] == [True, True]
    round_ = [first, StrokeInterval(2.0, 2 * math.pi, "loop", "")]
    assert [s.reached for s in with_reached(round_, 0.5, "excluded", True)] == [True, True]
    assert [s.reached for s in with_reached(round_, 0.5, "excluded", False)] == [True, False]
    assert [s.reached for s in with_reached([first, second], None, "", False)] == [True, True]


def test_columns_of_one_name_differ():
    columns = [
        FilledColumn(StrokeColumn("k", LENGTH, c), abs) for c in ("result", "slope", "slope")
    ]
    assert [f.column.name for f in named_apart(columns)] == ["k", "k (slope)", "k (slope)'"]


def test_a_rod_passes_its_force_by_its_angle_to_the_normal_of_the_guide():
    """At the slider 90° less the angle between rod and guide."""
    found = dict(named(transmissions(slider_crank(drive=Drive("phi", None, None, HERE))), {}))
    assert list(found) == ["mu_B"]
    assert found["mu_B"].at(VALUES) == pytest.approx(math.pi / 2 - abs(PSI))


def test_a_crank_that_is_no_drive_has_a_transmission_angle():
    found = dict(named(transmissions(slider_crank()), {}))
    assert found["mu_A"].at(VALUES) == pytest.approx(math.pi - (PHI - PSI))
    assert (found["mu_A"].rod, found["mu_A"].onto) == ("AB", "OA")


def test_a_transmission_angle_has_no_name_of_another_angle():
    """Where the loops call an angle at the same pin mu_A, rod and link stand beside it."""
    assert "mu_A(AB-OA)" in dict(named(transmissions(slider_crank()), {"mu_A": "AC"}))
    assert "mu_A" in dict(named(transmissions(slider_crank()), {"mu_A": frozenset("OB")}))


@pytest.mark.parametrize("turn", [70, -70, 430])
def test_a_transmission_angle_between_links_is_that_of_the_triangle(turn):
    values = {"psi": math.radians(turn)}
    link = TransmissionAngle(
        "B", Angle.of("psi") + Angle.constant(40 if turn > 0 else -40), "AB", "CB"
    )
    assert math.degrees(link.at(values)) == pytest.approx(110)
    assert math.degrees(link._replace(onto="").at(values)) == pytest.approx(70)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("karpenko_fig9_packet_clamp", ()),  # no bore of the cylinder
        ("karpenko_fig7_single_lever", ()),
        ("planetary_gear", ("m", "phi")),
        ("roberval_balance", ("h", "x", "y", "phi")),
    ],
)
def test_independence_is_concluded_of_what_the_geometry_is_given_by(name, expected):
    """A pressure, or the bore that it acts on, is in no formula of k: nobody looks for it there."""
    assert mechc.load(name).results["k"].independent == expected


class ByHand(RatioAlong):
    """A ratio as a function of its parameter; with friction there is half of it everywhere."""

    is_slow = False

    def __init__(
        self, ratio: Callable[[float], float], divisor: Callable[[float], float] = abs
    ) -> None:
        self._ratio, self._divisor = ratio, divisor
        self.ideal_along = SimpleNamespace(centres={})

    def without(self, x: float) -> float:
        return self._ratio(x)

    def driven(self, x: float) -> bool | None:
        return self._ratio(x) < 0 if self._ratio(x) else None

    def factors(self, x: float) -> tuple[float, ...]:
        return ()

    def divisors(self, x: float) -> tuple[float, ...]:
        return (self._divisor(x),)

    def signs(self, x: float) -> tuple[float, ...]:
        return ()

    def at(self, x: float) -> StateFound:
        return StateFound("free", 0.5, False)


IDEAL = SimpleNamespace(sign=1, is_iterated=False, is_slow=False, real=SimpleNamespace(where=()))
SLIDING = SimpleNamespace(off_rest=lambda where, x: [], trouble=lambda x: "")
"""A sweep on which every slip has a sense."""


def with_friction(kind: type[RatioAlong], real: float | None, ideal: float) -> RatioAlong:
    """Return a ratio that is the same everywhere, ``real`` with friction."""

    class Constant(kind):
        def without(self, x: float) -> float:
            return ideal

        def is_dead_centre(self, x: float) -> bool:
            return not ideal

        def _real(self, x: float) -> float | None:
            return real

    return Constant(SimpleNamespace(sweep=SLIDING, result=None), IDEAL)


class AtRest(RatioAlong):
    """A ratio that is zero at 0.5, and 1.1 or 0.9 of it with friction, where a slip is 0."""

    def __init__(self) -> None:
        beside = SimpleNamespace(off_rest=lambda where, x: [x - 1e-9, x + 1e-9])
        super().__init__(SimpleNamespace(sweep=beside, result=None), IDEAL)

    def without(self, x: float) -> float:
        return x - 0.5

    def is_dead_centre(self, x: float) -> bool:
        return x == 0.5

    def _real(self, x: float) -> float:
        has_sense = abs(x - 0.5) > 1e-10
        return (1.1 if x > 0.5 else 0.9) * (x - 0.5) * has_sense


def test_beside_a_dead_centre_both_ratios_are_taken_where_the_slip_has_a_sense():
    """Nearer to it than that place the ratio is some 1e-15."""
    moving = AtRest()
    assert moving.at(0.5 - 1e-15).share == pytest.approx(0.9)
    assert moving.at(0.5 + 1e-15).share == pytest.approx(1.1)
    assert [moving.at(0.5 + x).driven for x in (-1e-15, 1e-15)] == [True, False]


@pytest.mark.parametrize(
    ("ideal", "real", "state", "efficiency", "margin"),
    [
        (2.0, 5.0, "free", 0.4, 0.4),  # the drive has more to do
        (-2.0, -1.0, "free", 0.5, 0.5),  # the load drives, and less is left of it
        (-2.0, 1.0, "locked", 0.0, -0.5),
        (2.0, -1.0, "jammed", 0.0, -2.0),
        (2.0, math.nan, "jammed", 0.0, -math.inf),
        (0.0, 1.0, None, math.nan, -math.inf),
        (2.0, None, None, math.nan, -math.inf),
    ],
)
def test_something_moves_where_the_ratio_keeps_its_sign(ideal, real, state, efficiency, margin):
    moving = with_friction(RatioAlong, real, ideal)
    assert moving.at(0.0).state == state
    assert moving.efficiency(0.0) == pytest.approx(efficiency, nan_ok=True)
    assert moving.margin(0.0) == margin


@pytest.mark.parametrize(
    ("effort", "state", "efficiency", "margin"),
    [
        (4.0, "free", 1.0, 0.25),
        (0.0, "free", 1.0, math.inf),
        (math.nan, "jammed", 0.0, -math.inf),
        (-1.0, None, math.nan, -math.inf),
        (None, None, math.nan, -math.inf),
    ],
)
def test_a_drive_against_friction_alone_moves_where_an_effort_balances(
    effort, state, efficiency, margin
):
    moving = with_friction(AgainstFriction, effort, 0.0)
    assert moving.at(0.0).state == state
    assert moving.driven(0.0) is False
    assert moving.efficiency(0.0) == pytest.approx(efficiency, nan_ok=True)
    assert moving.margin(0.0) == margin


@pytest.mark.parametrize("power", [2, -2])
def test_a_dead_centre_that_is_only_touched_is_looked_at(power: int) -> None:
    """A ratio that is zero or infinite at 0.31 has the same sign on both sides of it."""
    moving = ByHand(lambda x: (x - 0.31) ** power if x != 0.31 else 0.0)
    found = sampled_values(moving, 0.0, 1.0)
    assert min(abs(x - 0.31) for x in found) < 1e-6


def test_a_zero_hides_next_to_the_pole_of_a_term() -> None:
    """1 + 1e-4/(x − 0.3117) is nearly 1 at the ends of a cell, and nearly straight over it."""
    zero, pole = 0.3116, 0.3117
    moving = ByHand(
        lambda x: (x - zero) / (x - pole) if x != pole else math.inf, lambda x: x - pole
    )
    found = sampled_values(moving, 0.0, 1.0)
    for place in (zero, pole):
        assert min(abs(x - place) for x in found) < 1e-6


@pytest.mark.parametrize(("top", "found"), [(0.005, [0.5]), (-0.005, []), (-math.inf, [])])
def test_a_stretch_that_is_free_hides_among_values_at_which_nothing_moves(top, found):
    """The margin is a parabola whose top, at 0.5, lies between the values that are looked at."""

    class Parabola(ByHand):
        def margin(self, x: float) -> float:
            return top - (x - 0.5) ** 2

    looked = list(_loose(Parabola(math.cos), [0.0, 0.4, 1.0]))
    assert looked == pytest.approx(found, abs=0.02)


def test_beside_the_end_of_a_loop_something_may_move_between_two_jammed_values():
    """There is no pose up to 0, and it moves from 0.01 to 0.03 alone."""

    class Island(ByHand):
        def at(self, x: float) -> StateFound:
            return StateFound("free" if 0.01 < x < 0.03 else "jammed", 0.5, False)

    moving = Island(lambda x: 1.0 if x > 0 else 0.0)
    grid = [-0.5, 0.0, 1e-6, 1.0, 2.0]
    assert any(0.01 < x < 0.03 for x in _next_to_ends(moving, grid))
    assert list(_next_to_ends(moving, [1e-6, 1.0, 2.0])) == []


@pytest.mark.parametrize("top", [0.001, 0.999])
def test_a_highest_efficiency_hides_in_the_cell_at_an_end(top):
    """It rises to a kink within the first cell, or the last, whose middle is lower than its end."""

    class Kink(ByHand):
        def efficiency(self, x: float) -> float:
            return 0.8 - 0.5 * abs(x - top)

    assert min(abs(x - top) for x in sampled_values(Kink(math.cos), 0.0, 1.0)) < 1e-5


@pytest.mark.parametrize(("value", "shown"), [(3e-12, False), (0.0, False), (0.004, True)])
def test_an_efficiency_has_no_extremum_of_rounding(value, shown):
    found = Extremum("eta_k", "maximum", 0.68, value)
    of = WithFriction(LoadRatio("M", "F"), "tightening")
    assert _is_shown(found, SimpleNamespace(target=Efficiency(of.of, of.sense))) == shown
    assert _is_shown(found, SimpleNamespace(target=of))


def test_what_definitions_share_is_gone_into_once_for_divisors():
    """x_i = x_(i-1) + sin x_(i-1) + 1/a: 2^60 ways lead down to the first."""
    below = power(Symbol("a"), number(-1))
    where = {}
    for i in range(60):
        earlier = Symbol(f"x{i}")
        where[f"x{i + 1}"] = total([earlier, Call("sin", (earlier,)), below])
    found = divisors_of_terms(total([Symbol("x60"), Symbol("b")]), where)
    assert set(found) == {Symbol("a")}


@pytest.mark.parametrize(
    ("values", "is_held"),
    [({"x": 1, "y": 2}, True), ({"x": -1, "y": 2}, False), ({"x": 1, "y": 0.5}, False)],
)
def test_conditions_hold_where_each_of_them_does(values, is_held):
    """x > 0, y > x and 3 > y; one in a name without a value is not looked at."""
    x, y = Symbol("x"), Symbol("y")
    pairs = (x, number(0)), (y, x), (number(3), y), (Symbol("z"), x)
    conditions = [Require(left, ">", right, HERE) for left, right in pairs]
    assert holding(conditions, {"x", "y"})(values) == is_held
