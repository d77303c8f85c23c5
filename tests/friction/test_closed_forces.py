"""Forces at joints with friction in closed form, against the forces that code iterates."""

import math
from math import cos, radians, sin, tan

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.formula.to_text import text
from mechc.formula.tree import ZERO
from mechc.report.text.derivation import render
from mechc.source import Source
from paths import LIBRARY

ROD = """
mechanism rod "A rod between two guides"
param beta = 12 deg in 2 deg .. 40 deg
param l = 200 mm
slider A along y
slider B along x
link AB
AB = l @ 180 deg - beta
force P at A along -y
force F at B along -x
friction pins 0.1 diameter 20 mm
friction slider B 0.1
find P
find N_AB
find N_B
find R_B on AB
"""

CRANK = """
mechanism crank "A crank that is driven by a force"
param beta = 12 deg in 2 deg .. 40 deg
pivot O
slider B along x
link AB
link OAC
OA = 50 mm @ 80 deg
AB = 200 mm @ -beta
OC = 150 mm @ 170 deg
force P at C along -y
force F at B along -x
friction pins 0.1 diameter 20 mm
find P
find N_AB
find R_O
find R_A on OAC
"""

DELTA = math.asin(2 * 0.001 / 0.2)
F = 1000.0


def printed(description: str) -> dict[str, str]:
    results = compile_source(Source("printed.mech", description)).derivation.results
    return {result.name: text(result.formula) for result in results}


def test_a_rod_passes_on_a_component_of_its_force():
    found = printed(ROD)
    assert found["N_AB_f"] == ("F*cos(delta_AB)/(cos(beta + delta_AB) - f*sin(beta + delta_AB))")
    assert found["N_B_f"] == "F/(cot(beta + delta_AB) - f)"
    assert found["R_B_on_AB_f"] == "F/(cos(beta + delta_AB) - f*sin(beta + delta_AB))"


@pytest.mark.parametrize(
    ("description", "last"),
    [
        (ROD, {"N_AB_f": "rod part", "N_B_f": "across", "R_B_on_AB_x_f": "rod part"}),
        (CRANK, {"N_AB_f": "rod part", "R_O_x_f": "balance", "R_A_on_OAC_y_f": "rod part"}),
    ],
)
def test_a_force_takes_the_steps_up_to_what_it_is_made_of(description, last):
    """The line of the rod and the balance of B give S_AB; what the driving load needs is left."""
    solved = compile_source(Source("steps.mech", description)).solution.solved
    steps = {s.result.name: [p.kind for p in s.steps] for s in solved if s.result.name in last}
    assert steps == {name: ["internal", "slider", kind] for name, kind in last.items()}


@pytest.mark.parametrize("beta", [5.0, 12.0, 31.0])
def test_it_is_what_is_iterated(beta):
    found = mechc.loads(ROD).evaluate(F=F, beta=radians(beta))
    turned = radians(beta) + DELTA
    whole = F / (cos(turned) - 0.1 * sin(turned))
    assert found["N_AB_f"] == pytest.approx(whole * cos(DELTA))
    assert found["N_B_f"] == pytest.approx(whole * sin(turned))
    assert found["R_B_on_AB_x_f"] == pytest.approx(-whole * cos(turned))


def test_a_pivot_balances_the_load_with_friction():
    """The driving load is that of its result with friction, not the one without it."""
    found = printed(CRANK)
    assert found["N_AB_f"] == "-F*cos(delta_AB)/cos(beta - delta_AB)"
    assert found["R_O_y_f"] == "P_f - F*tan(beta - delta_AB)"
    assert found["R_A_on_OAC_y_f"] == "F*tan(beta - delta_AB)"
    values = mechc.loads(CRANK).evaluate(F=F)
    across = F * tan(radians(12) - DELTA)
    assert values["R_O_y_f"] == pytest.approx(values["P_f"] - across)
    assert values["R_A_on_OAC_y_f"] == pytest.approx(across)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "is the component along the rod of $S_{AB}$, the whole force that it passes on"),
        ("uk", "складова вздовж стрижня повної сили $S_{AB}$, яку він передає"),
        ("ru", "составляющая вдоль стержня полной силы $S_{AB}$, которую он передаёт"),
    ],
)
def test_a_report_says_what_each_force_of_a_rod_is(language, said):
    shown = mechc.loads(CRANK).emit("latex", language=language)
    assert said in shown
    assert r"N_{AB,f}=-S_{AB}\cos\delta_{AB}" in shown.replace(r"\text{т}", "f").replace(
        r"\text{тер}", "f"
    )
    assert "Newton" not in shown


def test_a_joint_that_passes_nothing_on_has_no_size():
    """The ground and the band at O balance: on the drum nothing is left but the couple."""
    brake = LIBRARY.joinpath("band_brake.mech").read_text("utf-8")
    found = mechc.loads(f"{brake}\nfind R_O on OG\n").results
    assert found["R_O_on_OG_f"].formula == ZERO
    assert found["R_O_on_OG_f"].default == 0


TURNED = """
param phi = 60 deg
pivot O
slider B along x through O
link OA
link AB
OA = 60 mm @ phi
AB = 240 mm
assembly B forward
torque M on OA
force F at B along x
friction pins 0.1 diameter 40 mm
friction slider B 0.12
find M/F
find R_O
"""


def test_at_the_pivot_of_a_crank_under_a_couple_acts_the_force_of_its_rod():
    """A couple has no part in the size of a force: no root of two squares is printed."""
    whole = "F/(cos(beta_AB + delta_AB) - f_B*sin(beta_AB + delta_AB))"
    assert printed(TURNED)["R_O_f"] == whole
    found = mechc.loads(TURNED).evaluate(F=F)
    assert found["R_O_f"] == pytest.approx(math.hypot(found["R_O_x_f"], found["R_O_y_f"]))


@pytest.mark.parametrize("size", [50, 5000])
def test_a_load_on_the_pin_of_a_pivot_is_carried_by_the_ground_alone(size):
    """The link presses the pin as without it, so that M is the same; the ground holds both."""
    added = f"force Q at O along y\nlet Q = {size} N\n"
    shown, found = printed(TURNED + added), mechc.loads(TURNED + added).evaluate(F=F)
    whole = "F/(1 - f_B*tan(beta_AB + delta_AB))"
    assert shown["R_O_x_f"] == f"-{whole}"
    assert "Q" in shown["R_O_y_f"]
    without = mechc.loads(TURNED).evaluate(F=F)
    assert found["R_O_y_f"] == pytest.approx(without["R_O_y_f"] - size)
    assert found["M_over_F_f"] == pytest.approx(without["M_over_F_f"])


BESIDE_A_RATIO = """
pivot O at (0 m, -2 m)
pivot C at (0 m, -1 m)
A at (1 m, -1 m)
B at (1 m, 3 m)
D at (3 m, -2 m)
link OA
link AB
link CBD
torque M on OA
force F at D along x
friction pins 0.1 diameter 500 mm
find k = M/F
find N_AB
find R_O
"""


def test_a_force_beside_a_ratio_is_not_that_per_unit_of_load():
    """S_AB is that of F = 1 where k_f is found; the force itself is S_AB_f wherever it stands."""
    compilation = compile_source(Source("beside.mech", BESIDE_A_RATIO))
    note = " ".join(render(compilation.derivation, compilation.mechanism, unicode=False).split())
    assert "N_AB_f = S_AB_f * cos(delta_AB)" in note
    assert "N_AB_f = S_AB * cos(delta_AB)" not in note
    assert "R_O_x_f = -S_AB *" not in note


def test_a_coefficient_on_the_way_to_a_force_is_given_in_no_newtons():
    compilation = compile_source(Source("beside.mech", BESIDE_A_RATIO))
    note = render(compilation.derivation, compilation.mechanism, unicode=False)
    assert not [line for line in note.splitlines() if "a_AB = " in line and line.endswith(" N")]
