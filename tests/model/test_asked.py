"""Directions and lengths of the pose in formulas of the user's own: ``phi_AB``, ``len_AB``."""

import math

import pytest

import mechc
from mechc.diagnostics import Report
from mechc.formula.to_text import text
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.to_yaml import to_yaml
from small_mechanisms import four_bar

BASE = four_bar("find k = M/T", pivots=("O1", "O2"))
SIDES = (0.04, 0.12, 0.08, 0.1)


def compiled(lines):
    return mechc.loads(BASE + lines, "test.mech")


def stated(lines):
    with pytest.raises(mechc.MechcError) as caught:
        compiled(lines)
    return [(d.code, d.message, d.hint) for d in caught.value.diagnostics if d.code[0] == "E"]


def by_hand(phi):
    """Return the points A and B as complex numbers, B above the diagonal AO2."""
    a, b, c, d = SIDES
    first = complex(a * math.cos(phi), a * math.sin(phi))
    diagonal = complex(d, 0) - first
    size = abs(diagonal)
    lean = math.acos((size**2 + b * b - c * c) / (2 * size * b))
    direction = math.atan2(diagonal.imag, diagonal.real) + lean
    return first, first + b * complex(math.cos(direction), math.sin(direction))


ASKED = {
    "phi_AB": lambda a, b: math.atan2((b - a).imag, (b - a).real),
    "phi_BA": lambda a, b: math.atan2((a - b).imag, (a - b).real),
    "phi_O2B": lambda a, b: math.atan2(b.imag, b.real - 0.1),
    "phi_O1A": lambda a, b: math.atan2(a.imag, a.real),
    "phi_AO2": lambda a, b: math.atan2(-a.imag, 0.1 - a.real),
    "phi_O1B": lambda a, b: math.atan2(b.imag, b.real),
    "phi_AO1": lambda a, b: math.atan2(-a.imag, -a.real),
}
LENGTHS = {
    "len_AB": lambda a, b: 0.12,
    "len_BA": lambda a, b: 0.12,
    "len_O2A": lambda a, b: abs(a - 0.1),
    "len_AO2": lambda a, b: abs(a - 0.1),
    "len_O1B": lambda a, b: abs(b),
    "len_O1O2": lambda a, b: 0.1,
}


@pytest.mark.parametrize("phi", [0.3, 1.0, 2.5, 4.0])
def test_directions_and_lengths_anywhere(phi):
    asked = {**ASKED, **LENGTHS}
    lines = "".join(f"let q{i} = {name}\n" for i, name in enumerate(asked))
    values = compiled(lines).evaluate(phi=phi)
    points = by_hand(phi)
    for i, (name, expected) in enumerate(asked.items()):
        error = values[f"q{i}"] - expected(*points)
        error = math.remainder(error, 2 * math.pi) if name.startswith("phi") else error
        assert abs(error) < 1e-13, name


def test_lets_of_lets_in_any_order():
    made = compiled("let y = x + phi_O1A\nlet x = phi_O2B - phi_AB\n")
    values = made.evaluate(phi=1.0)
    a, b = by_hand(1.0)
    x = ASKED["phi_O2B"](a, b) - ASKED["phi_AB"](a, b)
    assert values["y"] == pytest.approx(x + 1.0, abs=1e-14)


def test_the_other_notation():
    lines = "let x = phi_O2B - phi_AB\nrequire len_O1B > 1 mm\n"
    source = Source("t.mech", BASE + lines)
    text = to_yaml(read(source, Report(source)))
    assert "phi_O2B - phi_AB" in text
    assert mechc.loads(text, "t.yaml").evaluate()["x"] == compiled(lines).evaluate()["x"]


def test_differences_of_directions_are_short():
    made = compiled("let mu = phi_BA - phi_BO2\n")
    assert str(made["mu"]) == "-mu_B"


def test_a_given_direction_is_put_in():
    assert str(compiled("let x = 2*phi_O1A - 10 deg\n")["x"]) == "2*phi - pi/18"


def test_an_expectation_in_directions_is_proved():
    lines = """
expect k = -a*sin(phi_AB - phi_O1A)/(c*sin(phi_AB - phi_O2B))
let x = len_O1B
expect x = 0.1079 m at phi = 60 deg
expect k = a/c*sin(phi_AB - phi_O1A)/sin(phi_O2B - phi_AB)
"""
    x = abs(by_hand(math.radians(60))[1])
    made = compiled(lines.replace("0.1079", f"{x:.4f}"))
    outcomes = [f.outcome for f in made._compilation.findings]
    assert outcomes == ["proved", "agrees", "proved"]


def test_an_expectation_that_is_wrong_is_refuted():
    ((code, message, _),) = stated("let x = len_O1B\nexpect x = 0.3 m at phi = 60 deg\n")
    assert code == "E581", message


def test_an_expectation_that_mentions_what_the_result_does_not():
    made = compiled("let x = 2*len_O1A\nexpect x = 2*a + 0*len_O1B\n")
    assert [f.outcome for f in made._compilation.findings] in (["proved"], ["agrees"])


def test_conditions_on_directions():
    made = compiled("let mu = phi_BO2 - phi_BA\nrequire 35 deg < mu\nrequire phi_AB > 0 deg\n")
    for phi in (0.1, 1.0, 2.0, 3.0, 4.0, 5.0):
        a, b = by_hand(phi)
        mu = math.remainder(math.atan2(-b.imag, 0.1 - b.real) - ASKED["phi_BA"](a, b), 2 * math.pi)
        holds = mu > math.radians(35) and ASKED["phi_AB"](a, b) > 0
        assert math.isfinite(made.evaluate(phi=phi)["k"]) == holds
    troubles = {row.trouble for row in made.stroke(19).rows}
    assert troubles == {"", "excluded by a condition of use"}


def test_a_condition_that_the_default_pose_breaks():
    for line, found in (
        ("require phi_AB > 80 deg\n", "phi_AB = 18.376 deg, expected more than 80 deg"),
        (
            "let mu = phi_BA - phi_BO2\nrequire mu > 1 rad\n",
            "mu = -0.812756 rad, expected more than 1 rad",
        ),
    ):
        warned = [d.message for d in compiled(line).warnings if d.code in ("W221", "W601")]
        assert len(warned) == 1
        assert warned[0].endswith(f"the given values break this condition: {found}")


@pytest.mark.parametrize("target", ["python", "c", "latex", "json"])
def test_every_target_has_them(target):
    made = compiled("let x = phi_O1B + len_O1B/a\nrequire len_O1B > 1 mm\n")
    assert made.emit(target)


def test_a_load_that_is_tied_by_a_direction():
    """A brake at A that grows with the slope of the coupler."""
    lines = "torque Q = T*sin(phi_AB) on O1A\n"
    base = BASE.replace("find k = M/T\n", lines + "find k = M/T\n")
    tied = mechc.loads(base, "test.mech").evaluate(phi=1.0)["k"]
    free = compiled("").evaluate(phi=1.0)["k"]
    slope = ASKED["phi_AB"](*by_hand(1.0))
    assert tied == pytest.approx(free - math.sin(slope), rel=1e-12)


@pytest.mark.parametrize(
    ("lines", "code", "part"),
    [
        ("let x = phi_AX\n", "E202", "X"),
        ("let x = phi_O2b\n", "E201", "phi_O2B, not phi_O2b"),
        ("let x = fi_AB\n", "E201", "did you mean 'phi_AB'?"),
        ("let x = len_ABO2\n", "E201", "len_ABO2"),
        ("param e = 2*len_O1B\nlet x = e\n", "E207", "follows from the description"),
        ("let e = 2*len_O1B\npivot R at (e, 0 mm)\n", "E207", "follow from the description"),
        ("let x = phi_AB + len_AB\n", "E220", "an angle"),
        ("let x = N_AB\n", "E255", "find N_AB"),
    ],
)
def test_what_is_refused(lines, code, part):
    found = stated(lines)
    assert code in [c for c, _, _ in found], found
    assert part in "".join(f"{m} {h}" for c, m, h in found if c == code)


def test_a_length_that_nothing_gives():
    text = """
param a = 40 mm
param beta = 20 deg
param phi = 60 deg
pivot O
slider B along x
link OA
link AB
OA = a @ phi
AB = @ -beta
torque M on OA
force F at B along -x
find k = M/F
"""
    with pytest.raises(mechc.MechcError) as caught:
        mechc.loads(text + "let x = len_AB\n", "t.mech")
    assert [d.code for d in caught.value.diagnostics if d.code[0] == "E"] == ["E310"]
    assert str(mechc.loads(text + "let x = phi_BA\n", "t.mech")["x"]) == "pi - beta"


@pytest.mark.parametrize(
    ("asked", "shown"),
    [
        ("cos(phi_AB - phi_CB)", "cos(mu_B)"),
        ("1 + 3*sin(phi_CB - phi_AB)^2", "1 + 3*sin(mu_B)^2"),
        ("len_AB*cos(phi_BA - phi_OA)", "-len_AB*cos(phi - phi_AB)"),
        ("tan((phi_AB - phi_CB)/2)", "-tan(mu_B/2)"),
    ],
)
def test_directions_add_up_within_a_formula(asked, shown):
    loop = """
    param phi = 60 deg
    pivot O at (0 mm, 0 mm)
    pivot C at (100 mm, 0 mm)
    link OA
    link AB
    link CB
    OA = 40 mm @ phi
    AB = 100 mm
    CB = 80 mm
    assembly ABC cw
    drive phi from 10 deg to 80 deg
    torque M on OA
    torque T on CB
    """
    found = mechc.loads(f"{loop}let c = {asked}\n")
    assert text(found.results["c"].formula) == shown


LEVER = """\
param a = 100 mm
param b = 50 mm
pivot O
link AOB
OA = a @ 0 deg
OB = b @ 180 deg
force P at A along -90 deg
force F at B along -90 deg
find P
find F
"""


def test_a_formula_of_one_of_two_loads_that_are_found_rests_on_the_other() -> None:
    """Each find is a form in the other load; what uses one of them is a form in that load too."""
    found = mechc.loads(f"{LEVER}let q = 2*P\nlet s = q + 1 N\nlet t = 3*F")
    values = found.evaluate(P=5.0, F=10.0)
    assert {n: values[n] for n in "qst"} == pytest.approx({"q": 10.0, "s": 11.0, "t": 30.0})
    assert "def q(" in found.emit("python")
