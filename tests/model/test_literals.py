"""Lengths that a description gives by numbers: named, listed, decided by their value."""

import json
import math
import re

import pytest

import mechc
from mechc.algebra.equality import equal
from mechc.formula.evaluate import evaluate
from mechc.formula.operations import count_operations
from mechc.formula.to_text import text
from mechc.formula.tree import Symbol
from mechc.formula.walk import substitute
from mechc.model.mechanism import Pivot, Rack, Rope, Screw, WheelPair
from small_poses import ALONG, HERE

CRANK = """
param phi = 40 deg in 0 deg .. 360 deg
pivot O at (0 mm, 0 mm)
pivot Q at (100 mm, 20 mm)
link OA
link AB
link QB
OA = 30 mm @ phi
AB = 90 mm
QB = 70 mm
assembly ABQ cw
drive phi from 0 deg to 360 deg
torque M on OA
torque T on QB
find k = M/T
"""

NAMED = {"30 mm": "a", "90 mm": "b", "70 mm": "c", "100 mm": "d", "20 mm": "h"}


def with_parameters(description: str) -> str:
    """Return a description with a parameter for each of its lengths."""
    lines = [f"param {name} = {length}" for length, name in NAMED.items()]
    for length, name in NAMED.items():
        description = re.sub(rf"\b{length}", name, description)
    return "\n".join([*lines, description])


def test_a_number_reads_as_a_parameter_does() -> None:
    literal, declared = mechc.loads(CRANK), mechc.loads(with_parameters(CRANK))
    assert literal.evaluate()["k"] == pytest.approx(declared.evaluate()["k"], rel=1e-13)
    names = {"len_OA": "a", "len_AB": "b", "len_QB": "c", "x_Q": "d", "y_Q": "h"}
    short = {name: Symbol(other) for name, other in names.items()}
    mine, theirs = literal.results["k"], declared.results["k"]
    assert equal(substitute(mine.formula, short), theirs.formula)
    assert count_operations(mine.formula) == count_operations(theirs.formula)


def test_code_takes_no_number_and_has_it_as_a_constant() -> None:
    code = mechc.loads(CRANK).emit("python")
    assert "def k(phi):" in code
    assert "def pose(phi):" in code
    assert " len_AB = 0.09" in code
    assert "where len_AB = 0.09" in code
    assert '"len_AB"' not in code


def test_numbers_are_given_with_their_units() -> None:
    mechanism = mechc.loads(CRANK)
    latex = mechanism.emit("latex")
    assert r"$Q$ & $(x_Q,y_Q)$" in latex
    assert r"$x_Q$ & coordinate of $Q$ & $100\,\text{mm}$" in latex
    assert r"$AB$ & $90\,\text{mm}$" in latex


def test_formulas_scale_with_all_lengths() -> None:
    """What has no length in it but by names is the same for a mechanism ten times as large."""
    large = re.sub(r"(\d+) mm", r"\1 cm", CRANK)
    one, ten = (mechc.loads(d).results["k"] for d in (CRANK, large))
    assert text(one.formula) == text(ten.formula)
    assert one.default == pytest.approx(ten.default, rel=1e-12)


PARALLELOGRAM = """
param phi = 40 deg in 10 deg .. 80 deg
pivot O at (0 mm, 0 mm)
pivot Q at (200 mm, 0 mm)
link OA
link AB
link QB
OA = 60 mm @ phi
AB = 200 mm
QB = 60 mm
assembly ABQ cw
drive phi from 10 deg to 80 deg
torque M on OA
torque T on QB
find k = M/T
"""


def test_equal_numbers_are_equal_under_two_names() -> None:
    assert mechc.loads(PARALLELOGRAM).k == -1


BENT = """
param alpha = 20 deg
param beta = 25 deg
pivot O
slider K along y
link OBC
link BK
OB = 200 mm @ 90 deg - alpha
BC = 200 mm @ 90 deg
BK = 200 mm @ 90 deg + beta
force P at C along -x
force F at K along -y
find k = P/F
"""


def test_a_formula_names_the_length_that_is_meant_not_one_as_long() -> None:
    (k,) = mechc.loads(BENT)._compilation.results
    assert text(k.formula) == "len_OB*sin(alpha + beta)/(cos(beta)*(len_BC + len_OB*cos(alpha)))"


THREE_CRANKS = """
param phi = 40 deg
pivot O at (0 mm, 0 mm)
pivot Q at (200 mm, 0 mm)
pivot S at (500 mm, 0 mm)
link OA
link ABC
link QB
link SC
OA = 60 mm @ phi
AB = 200 mm @ 0 deg
AC = 500 mm @ 0 deg
QB = 60 mm @ phi
SC = 60 mm @ phi
torque M on OA
torque T on SC
find k = M/T
"""


def test_whether_a_mechanism_moves_is_decided_by_the_numbers() -> None:
    """One body on three equal cranks: the third is redundant where 200 + 300 = 500."""
    mechanism = mechc.loads(THREE_CRANKS)
    assert mechanism.k == -1
    assert "W401" in [w.code for w in mechanism.warnings]


def test_names_do_not_clash_with_those_of_the_description() -> None:
    mechanism = mechc.loads(CRANK + "let x_Q = 2*k\n")
    assert {"x_Q_2", "len_AB"} <= mechanism.where.keys()
    assert mechanism.evaluate()["x_Q"] == pytest.approx(2 * mechanism.evaluate()["k"])


SIZES = """
pivot O at (0 mm, 0 mm)
pivot S at (0 mm, 150 mm)
link OBG
B at (90 mm, 40 mm)
G at (400 mm, 180 mm)
spring 2 N/mm between S and B free 60 mm
load Q intensity 10 N/(5 mm) on OG along -y
friction pin O 0.1 diameter 0.5 in
force P at G along x
find P
"""


def test_sizes_of_springs_loads_and_pins_have_names_and_units() -> None:
    found = mechc.loads(SIZES)
    sizes = {p.name: p for p in found._compilation.mechanism.literals}
    units = {name: sizes[name].unit for name in ("c_SB", "l_SB", "q_Q", "d_O")}
    assert units == {"c_SB": "N/mm", "l_SB": "mm", "q_Q": "N/mm", "d_O": "in"}
    # The spring is 142.127 mm long; both act on the line through O and G, or at its middle.
    force = 2000 * (0.06 - math.hypot(0.09, 0.11))
    moment = force * (0.09 * -0.11 - 0.04 * 0.09) / math.hypot(0.09, 0.11)
    moment -= 2000 * math.hypot(0.4, 0.18) * 0.2
    assert found.evaluate()["P"] == pytest.approx(moment / 0.18, rel=1e-12)
    assert {"d_O", "len_SB"} <= {str(name) for name in found.where}


def test_a_name_that_the_description_has_is_left_to_it() -> None:
    text_of = SIZES.replace("find P", "param d_O = 7 mm\nfind P\nlet z = d_O")
    names = [p.name for p in mechc.loads(text_of)._compilation.mechanism.literals]
    assert "d_O_2" in names


def test_both_intensities_of_a_load_differ_on_paper() -> None:
    text_of = SIZES.replace("intensity 10 N/(5 mm)", "intensity 2 N/mm to 1 N/mm")
    varied = mechc.loads(text_of.replace("friction pin", "# friction pin"))
    sizes = {p.name: p.unit for p in varied._compilation.mechanism.literals}
    assert (sizes["q_Q"], sizes["q_Q_2"]) == ("N/mm", "N/mm")
    assert "q_Q+2q_{Q,2}" in varied.emit("latex")


LEVER = """
param a = 30 mm
param b = 50 mm
param q = 40 deg
param m = 0.3
pivot O
link OAB
OA = {length} @ 0 deg
OB = a @ 90 deg
force P at A along y
force F at B along x
find k = P/F
"""


@pytest.mark.parametrize(
    ("length", "k"),
    [
        ("2*(a + 20 mm)", "a/(2*(a + len_OA_0))"),
        ("(a - 5 mm)/2 + 20 mm", "2*a/(a - len_OA_0 + 2*len_OA_1)"),
        ("40 mm - 20 mm*sin(q) - m*a", "a/(len_OA_0 - len_OA_1*sin(q) - a*m)"),
        ("max(a - 80 mm, 10 mm)", "a/max(a - len_OA_0, len_OA_1)"),
        ("hypot(a, 20 mm)", "a/hypot(a, len_OA_0)"),
        ("sqrt(a^2 + (20 mm)^2)", "a/sqrt(a^2 + len_OA_0^2)"),
        ("sqrt((500 mm)^2 - b^2)", "a/sqrt(len_OA_0^2 - b^2)"),
        ("sqrt(a^2 - (20 mm)^2)", "a/sqrt(a^2 - len_OA_0^2)"),
        ("20 mm*m*sin(q)", "a/(len_OA_0*m*sin(q))"),
        ("20 mm/cos(q)", "a*cos(q)/len_OA_0"),
        ("m*(a + 20 mm)", "a/(m*(a + len_OA_0))"),
        ("a*(1 + m)", "1/(1 + m)"),
        ("20 mm*(1 + a/b)", "a*b/(len_OA_0*(a + b))"),
        ("20 mm*max(a/b, 2)", "a/(len_OA_0*max(a/b, 2))"),
        ("a*(b + 20 mm)/b", "b/(b + len_OA_0)"),
        ("b/a*(20 mm + sqrt(a*b))", "a^2/(b*(len_OA_0 + sqrt(a*b)))"),
        ("2*(2*a + 20 mm)", "a/(2*(2*a + len_OA_0))"),
    ],
)
def test_a_number_that_is_a_length_within_a_formula_has_a_name(length: str, k: str) -> None:
    found = mechc.loads(LEVER.format(length=length))._compilation
    assert text(found.results[0].formula) == k
    assert [p.name for p in found.mechanism.literals] == sorted(set(re.findall(r"len_\w+", k)))
    assert all(evaluate(p.value, {}) > 0 for p in found.mechanism.literals)


R, S, P = Symbol("r"), Symbol("s"), Symbol("p")
GEARS = WheelPair("gear", "O", "OA", R, "Q", "QB", S, False, HERE)


@pytest.mark.parametrize(
    ("joint", "sizes"),
    [
        (GEARS, [("r", "O", R), ("r", "Q", S)]),
        (Rack("K", "O", "OA", R, HERE), [("r", "O", R)]),
        (Screw("K", P, "OA", HERE), [("p", "K", P)]),
        (Pivot("O", HERE), []),
        (Rope(("A", "B"), (ALONG,), HERE), []),
    ],
)
def test_the_sizes_of_a_joint_are_named_and_come_back_in_their_order(joint, sizes):
    assert [tuple(size) for size in joint.sizes] == sizes
    assert joint.with_sizes([formula for *_, formula in sizes]) == joint
    others = [Symbol(f"n{i}") for i in range(len(sizes))]
    assert [size.formula for size in joint.with_sizes(others).sizes] == others


def test_the_comment_behind_a_length_is_its_label():
    """A line of two coordinates has none: its comment is on the point."""
    lines = [
        *("pivot O at (1 mm, 2 mm)  # the axle", "link OA"),
        *("OA = 30 mm @ 60 deg  # crank radius", "slider A along 150 deg"),
        *("torque M on OA", "force F at A along x", "find k = M/F"),
    ]
    solved = mechc.loads("\n".join(lines))
    constants = json.loads(solved.emit("json"))["constants"]
    assert {c["name"]: c["label"] for c in constants}["len_OA"] == "crank radius"
    assert [c["label"] for c in constants if c["name"].startswith(("x_", "y_"))] == ["", ""]
    assert r"$30\,\text{mm}$, crank radius" in solved.emit("latex")
