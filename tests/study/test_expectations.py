"""What a book says: proved, refuted by a pose with both numbers, or agreed to without proof."""

from fractions import Fraction

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.diagnostics import Report
from mechc.formula.tree import Call, Formula, Symbol, degrees, number, power, product, total
from mechc.model.mechanism import Expect, Interval, Mechanism, Parameter, Require
from mechc.model.result import Definition, Result
from mechc.model.values import complete, default_pose
from mechc.source import Source, Span
from mechc.study.expectations import Finding, compare, likely_a_formula, random_poses
from mechc.units import ANGLE, LENGTH, NUMBER

HERE = Span(0, 0)
A, B, ALPHA, PHI = map(Symbol, ("a", "b", "alpha", "phi"))


def ratio(above: Formula, below: Formula) -> Formula:
    return product([(above, 1), (below, -1)])


def tan(angle: Formula) -> Formula:
    return Call("tan", (angle,))


PARAMETERS = (
    Parameter("a", LENGTH, HERE, value=number(Fraction(1, 10)), unit="mm"),
    Parameter("b", LENGTH, HERE),
    Parameter(
        "alpha",
        ANGLE,
        HERE,
        value=degrees(30),
        range=Interval(degrees(5), degrees(80)),
        unit="deg",
    ),
)


def judged(
    expected: Formula,
    found: Formula,
    *,
    at: dict[str, Formula] | None = None,
    tolerance: Fraction = Fraction(0),
    where: tuple[Definition, ...] = (),
    parameters: tuple[Parameter, ...] = PARAMETERS,
) -> tuple[Finding, list[str]]:
    expect = Expect("k", expected, at or {}, tolerance, HERE)
    mechanism = Mechanism("m", "", "", HERE, parameters=parameters, expects=(expect,))
    report = Report(Source("m.mech", ""))
    (finding,) = compare(mechanism, (Result("k", None, NUMBER, found, where=where),), report)
    return finding, [f"{d.code}: {d.message}" for d in report.diagnostics]


def test_another_form_is_proved() -> None:
    sine, cosine = Call("sin", (ALPHA,)), Call("cos", (ALPHA,))
    finding, said = judged(ratio(sine, cosine), tan(ALPHA))
    assert (finding.outcome, said) == ("proved", [])


def test_wrong_formula_is_refuted_at_the_default_pose() -> None:
    finding, said = judged(Call("cot", (ALPHA,)), tan(ALPHA))
    assert finding.outcome == "refuted"
    assert said == ["E581: k is 0.57735 where 1.73205 is expected, at alpha = 30 deg"]


def test_formula_right_only_at_the_default_pose_is_refuted_elsewhere() -> None:
    twice = product([(number(2), 1), (Call("sin", (ALPHA,)), 1), (tan(ALPHA), 1)])
    finding, _ = judged(twice, tan(ALPHA))
    assert finding.outcome == "refuted"
    assert finding.at["alpha"] != pytest.approx(default_pose(_mechanism())["alpha"])


def test_slip_in_the_tenth_digit_is_found() -> None:
    slip = product([(number(Fraction(1_000_000_01, 1_000_000_00)), 1), (tan(ALPHA), 1)])
    finding, said = judged(slip, tan(ALPHA))
    assert finding.outcome == "refuted"
    found, expected = said[0].split(" is expected")[0].split(" where ")
    assert found.split()[-1] != expected


def test_length_without_a_value_may_stand_in_both() -> None:
    assert judged(ratio(A, B), ratio(A, B))[0].outcome == "proved"
    assert judged(ratio(B, A), ratio(A, B))[0].outcome == "refuted"


def test_intermediates_are_seen_through() -> None:
    where = (Definition("phi", total([ALPHA, ALPHA])),)
    twice = total([ALPHA, ALPHA])
    assert judged(Call("sin", (twice,)), Call("sin", (PHI,)), where=where)[0].outcome == "proved"


def test_root_agrees_without_proof() -> None:
    sine = Call("sin", (ALPHA,))
    root = Call("sqrt", (power(sine, number(2)),))
    finding, said = judged(root, sine)
    assert finding.outcome == "agrees"
    assert said == ["W581: the formula for k agrees at all 13 poses tried, but is not proved equal"]


STRUT = """mechanism strut
param alpha = 60 deg
param theta = 20 deg
param mu = 0.1
slider A along 0 deg
slider C along 90 deg
link AC
AC = @ 90 deg - alpha
force Q at A along theta
force W at C along -90 deg
friction slider A mu
find k = Q/W
expect k_f = (tan(alpha) + mu)/(cos(theta) + mu*sin(theta))
expect k_f = 2.325634965 at theta = 40 deg
"""


def test_a_formula_is_that_of_the_printed_case_and_a_number_that_of_code() -> None:
    """At 40 degrees Q lifts A off: its guide holds it down, and the signs of mu turn."""
    formula, figure = compile_source(Source("strut.mech", STRUT)).findings
    assert formula.outcome == "proved"
    assert figure.outcome == "agrees"


@pytest.mark.parametrize(("digits", "outcome"), [("0.577", "agrees"), ("0.578", "refuted")])
def test_figure_within_its_last_digit(digits: str, outcome: str) -> None:
    half = Fraction(1, 2000)
    assert judged(number(Fraction(digits)), tan(ALPHA), tolerance=half)[0].outcome == outcome


def test_figure_at_a_pose_of_its_own() -> None:
    at = {"alpha": degrees(45)}
    finding, said = judged(number(1), tan(ALPHA), at=at, tolerance=Fraction(1, 2000))
    assert (finding.outcome, said) == ("agrees", [])


def test_figure_without_a_pose() -> None:
    finding, said = judged(number(1), ratio(A, B), tolerance=Fraction(1, 2))
    assert finding.outcome == "undecided"
    assert said == ["E582: k cannot be compared with a number: b has no value"]


def test_dependent_parameters_follow_what_is_set() -> None:
    twice = Parameter("b", LENGTH, HERE, value=product([(number(2), 1), (A, 1)]), dependent=True)
    parameters = (twice, *PARAMETERS[:1])
    at = {"a": number(3)}
    finding, _ = judged(number(6), B, at=at, tolerance=Fraction(1, 2000), parameters=parameters)
    assert finding.outcome == "agrees"


def _mechanism(*requires: Require) -> Mechanism:
    return Mechanism("m", "", "", HERE, parameters=PARAMETERS, requires=requires)


def test_random_poses_keep_to_ranges_and_conditions() -> None:
    steep = Require(ALPHA, ">", degrees(45), HERE)
    poses = list(random_poses(_mechanism(steep), 20))
    assert len(poses) == 20
    assert all(0.785 < pose["alpha"] < 1.397 for pose in poses)
    assert len({pose["alpha"] for pose in poses}) == 20


def test_impossible_condition_gives_no_pose() -> None:
    assert not list(random_poses(_mechanism(Require(ALPHA, ">", degrees(90), HERE)), 5))


def test_completing_ends_where_a_value_is_missing() -> None:
    twice = Parameter("c", LENGTH, HERE, value=total([B, A]), dependent=True)
    mechanism = Mechanism("m", "", "", HERE, parameters=(*PARAMETERS, twice))
    assert "c" not in complete(mechanism, {"a": 1.0})
    assert complete(mechanism, {"a": 1.0, "b": 2.0})["c"] == 3.0


def test_a_whole_number_at_a_pose_is_a_figure_not_a_formula():
    text = """
param a = 1 m
pivot O
link OA
OA = a @ 0 deg
torque M on OA
force F at A along -y
find k = M/F
expect k = 2 m at a = 2 m
"""
    solved = mechc.loads(text, "lever.mech")
    assert [f.outcome for f in solved._compilation.findings] == ["agrees"]
    assert solved.warnings == []


def test_only_a_figure_without_a_pose_may_have_been_compared_as_a_formula():
    twice = product([(number(2), 1), (A, 1)])
    slips = []
    for value, at in ((number(2), {}), (twice, {}), (number(2), {"a": number(1)})):
        expect = Expect("k", value, at, Fraction(0), HERE)
        slips.append(likely_a_formula(Finding(expect, "refuted", 3.0, 2.0, {"a": 1.0}), {"a": 0.1}))
    assert slips == ["figure", "", ""]
