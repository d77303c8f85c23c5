"""Formulas no longer than a person's: counted in operations, against the same by hand."""

import pytest

import mechc
from good_mechanisms import ALL
from mechc.algebra.equality import equal
from mechc.formula.operations import count_operations
from mechc.formula.to_text import text

LONGEST = {
    "crank_shaper": 11,
    "crimping_tool": 15,
    "double_butterfly": 54,  # its angles of 100°, 80° and 70°
    "hoeken": 11,
    "jansen_leg": 35,
    "peaucellier_closed": 11,
    "scissor_table": 19,
    "stephenson_closed": 19,
    "ternary_chain": 41,
    "triad_closed": 29,
    "vice_grip": 15,
    "watt_closed": 16,
    "whitworth": 11,
}
"""Operations of k together with those of the ratios of speeds that it rests on."""


@pytest.mark.parametrize("name", LONGEST)
def test_no_formula_grows(name: str) -> None:
    compiled = mechc.load(str(ALL[name]))._compilation
    k = next(r for r in compiled.results if r.name == "k")
    ratios = {b.name for b in compiled.balance.reading.bindings}
    shown = [k.formula, *(d.formula for d in k.where if d.name in ratios)]
    assert sum(map(count_operations, shown)) <= LONGEST[name]


def test_a_long_chain_is_read_by_ratios_of_speeds() -> None:
    """Jansen's leg as by hand: one sine over one sine, then two projections over one."""
    k = mechc.load("jansen_leg").results["k"]
    where = {d.name: text(d.formula) for d in k.where}
    assert text(k.formula) == "len_DF*cos(phi_DF)*i_DEF - len_ZD*cos(mu_D + phi_AD)*i_ZD"
    assert where["i_ZBC"] == "m*sin(phi - phi_AB)/(len_ZB*sin(mu_B))"
    assert where["i_ZD"] == "m*sin(phi - phi_AD)/(len_ZD*sin(mu_D))"
    assert where["i_DEF"] == (
        "(len_ZC*sin(phi_CE - phi_ZC)*i_ZBC + len_ZD*sin(phi_CE - mu_D - phi_AD)*i_ZD)"
        "/(len_DE*sin(mu_E))"
    )


def test_a_ratio_of_speeds_takes_no_name_that_is_taken() -> None:
    source = ALL["jansen_leg"].read_text()
    leg = mechc.loads(source.replace("param m ", "param i_ZD = 3 mm\nparam m "))
    where = {d.name for d in leg.results["k"].where}
    assert "i_ZD_2" in where
    assert "i_ZD" not in where


def test_a_straight_line_mechanism_reads_as_by_hand() -> None:
    """Hoeken: V_P of the crank's end and of the coupler's turning, not three cosines."""
    hoeken = mechc.load("hoeken").results["k"]
    assert text(hoeken.formula) == "a*(sin(phi) + 2*sin(phi - mu_B - phi_AB)*sin(phi_AB)/sin(mu_B))"


@pytest.mark.parametrize("name", ["hoeken", "ternary_chain"])
def test_a_shorter_form_is_the_same(name: str) -> None:
    solved = mechc.load(str(ALL[name]))
    (item,) = solved._compilation.balance.solved
    assert item.value is not None
    assert text(item.value.formula()) != text(item.result.formula)
    assert equal(item.value.formula(), item.result.formula)


BEAM = """
pivot A
slider C along x
slider D along x
link AB
link BCD
AB = 3 m @ 0 deg
BC = 1 m @ 0 deg
BD = 4 m @ 0 deg
load Q intensity 2 kN/m on AB along -y
force P at B along -y
torque M on BCD
let P = 3 kN
let M = 2 kN*m
find R_C, R_D
"""

SPRING = """
param l = 200 mm
param theta = 40 deg in 10 deg .. 80 deg
pivot O
slider A along y
slider B along x through O
link AB
OB = l*cos(theta) @ 0 deg
BA = l @ 180 deg - theta
spring 1.5 kN/m between O and A free 60 mm
force P at B along -x
force W at A along -y
find P
"""


def formulas(lines: str) -> dict[str, str]:
    return {name: text(r.formula) for name, r in mechc.loads(f"mechanism m{lines}").results.items()}


def test_what_loads_share_is_outside() -> None:
    """By hand: P = (W − S)·cot θ, R_C = (BD·(P + Q/2) + M)/(BD − BC)."""
    assert formulas(SPRING)["P"] == "cot(theta)*(W - S_OA)"
    assert formulas(BEAM)["R_C_y"] == "(len_BD*(Q/2 + P) + M)/(len_BD - len_BC)"


def test_what_is_divided_by_is_positive() -> None:
    """A force against its axis has a minus before it, not BC − BD below the line."""
    assert formulas(BEAM)["R_D_y"] == "-(len_BC*(Q/2 + P) + M)/(len_BD - len_BC)"
