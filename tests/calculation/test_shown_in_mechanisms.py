"""User-defined formulas of a mechanism, and those of sheets that it uses, as they are written."""

from pathlib import Path

import pytest

import mechc
from mechc.cli.commands.check import report
from mechc.report.text.derivation import render

PIN = """
sheet pin "Pin"
param F = 3 kN in 0 kN .. 12 kN  # force on it
param s = 240 MPa
param d = 8 mm
table impact "own" = 0 m/s: 1.0, 1 m/s: 1.2
list sizes "ISO" = 5 mm, 8 mm, 12 mm
let K = impact at 0.8 m/s
let c = 0.3 when s <= 250 MPa else 0.25
let p = 4*F/(pi*d^2) in MPa as "pressure"
let D = next d in sizes
require p < 80 MPa
"""

LEVER = """
mechanism lever
param Q = 3 kN
use "pin.mech" as pin (F = Q/2)
let arm = 10*pin_d as "arm of the lever"
pivot O
link OAB
OA = arm @ 0 deg
OB = 240 mm @ 0 deg
force P at A along y
force F at B along -y
find k = P/F
let F = Q
let tau = 2*pin_p as "stress"
let J = pi*pin_d^4/64
let w = k*pin_d - 8 mm
"""


@pytest.fixture(scope="module")
def lever(tmp_path_factory: pytest.TempPathFactory) -> mechc.SolvedMechanism:
    folder = tmp_path_factory.mktemp("lever")
    (folder / "pin.mech").write_text(PIN)
    (folder / "lever.mech").write_text(LEVER)
    return mechc.load(folder / "lever.mech")


def test_the_derivation_has_units_tables_and_texts(lever: mechc.SolvedMechanism) -> None:
    compilation = lever._compilation
    said = [s.strip() for s in render(compilation.derivation, compilation.mechanism).splitlines()]
    for line in [
        "arm = 10 · pin_d = 80 mm  arm of the lever",
        "pin_impact = 0 m/s: 1.0, 1 m/s: 1.2  own",
        "force on it (pin):",
        "pin_K = pin_impact at 0.8 m/s",
        "pin_c = (0.3 when pin_s ≤ 250 MPa; else 0.25)",
        "pressure (pin):",
        "pin_p = 4 · pin_F / (π · pin_d²)",
        "pin_p = 4 · 1.5 kN / (π · (8 mm)²) = 29.8416 MPa",
        "pin_D = next pin_d in pin_sizes",
        "pin_D = 8 mm",
        "F = 3 kN",
        "stress:",
        "J = π · (8 mm)⁴ / 64 = 201.062 mm⁴",
        "w = 3 · 8 mm − 8 mm = 16 mm",
        "The result holds for pin_F ≥ 0 kN, pin_F ≤ 12 kN, pin_p < 80 MPa.",
    ]:
        assert line in said, line
    assert not any("units of the SI" in line for line in said)


def test_so_has_the_report(lever: mechc.SolvedMechanism) -> None:
    tex = lever.emit("latex")
    for part in [
        r"Tables and lists of sizes",
        r"250\,\text{MPa}",
        r"\left(0.8\,\text{m}/\text{s}\right)",
        r"\noindent Pressure (pin):",
        r"\mathrm{pin}_d^{4}}{64}",
        r"w=k\,\mathrm{pin}_d-8\,\text{mm}",
        r"$\mathrm{pin}_F\leq 12\,\text{kN}$",
    ]:
        assert part in tex, part
    assert "250000000" not in tex


def test_so_has_the_check(lever: mechc.SolvedMechanism) -> None:
    lines = list(report(lever._compilation, verbose=False))
    assert "  pin_p = 4*pin_F/(pi*pin_d^2)  # pressure (pin)" in lines
    assert "  w = k*pin_d - 8 mm" in lines
    assert "    = 3 kN at the default pose" in lines


@pytest.mark.parametrize(
    ("own", "unit"),
    [("param S = 35 ksi", "ksi"), ("let S = 2 bar", "bar"), ("param S = 35 mm", "MPa")],
)
def test_the_users_own_unit_wins(tmp_path: Path, own: str, unit: str) -> None:
    (tmp_path / "pin.mech").write_text(PIN)
    text = f'sheet s\nuse "pin.mech" as pin (F = 2 kN)\n{own}\nlet t = 2*pin_p\nlet n = S + S\n'
    (tmp_path / "s.mech").write_text(text)
    lets = mechc.load(tmp_path / "s.mech")._compilation.mechanism.lets
    assert next(let.unit for let in lets if let.name == "t") == unit


def test_what_is_given_keeps_the_unit_that_it_has_where_it_is_given(tmp_path: Path) -> None:
    (tmp_path / "pin.mech").write_text(PIN)
    text = 'sheet s\nparam N = 900 N\nuse "pin.mech" as pin (F = 2*N)\n'
    (tmp_path / "s.mech").write_text(text)
    lets = mechc.load(tmp_path / "s.mech")._compilation.mechanism.lets
    assert lets[0].unit == "N"


@pytest.mark.parametrize(
    ("formula", "shown"),
    [
        ("pi*d^4/64", "πd⁴/64"),
        ("d/10", "d/10"),
        ("3*d/5/2", "3d / (2 · 5)"),
        ("sqrt(d)*d^(1/2)", "√(d) · √(d) = √(20 mm) · √(20 mm)"),
        ("abs(-d)", "|−d|"),
        ("abs(z)", "|z| = |−5 mm|"),
    ],
)
def test_formulas_stay_as_they_are_written(formula: str, shown: str) -> None:
    text = f"sheet s\nparam d = 20 mm\nlet z = d - 25 mm\nlet x = {formula}\n"
    compilation = mechc.loads(text)._compilation
    assert shown in render(compilation.derivation, compilation.mechanism)


def test_units_that_are_asked_for_and_angles_in_them() -> None:
    text = (
        "sheet s\nparam c = 5 N*m/rad\nparam g = 2 rad/m\nparam x = 0.1 m\nlet t = 360 deg/6\n"
        "let M = c*t\nlet phi = g*x in deg\nlet q = 12 l/min in m^3/s\n"
    )
    compilation = mechc.loads(text)._compilation
    said = [s.strip() for s in render(compilation.derivation, compilation.mechanism).splitlines()]
    assert "M = ct = 5 N·m/rad · 60° = 5.23599 N·m" in said
    assert "φ = gx = 2 rad/m · 0.1 m = 11.4592°" in said
    assert "q = 12 l/min = 0.0002 m³/s" in said


def test_a_negative_quantity_is_a_number_alone() -> None:
    compilation = mechc.loads("sheet s\nlet P = -200 N\nlet R = -(3 kN)\n")._compilation
    said = render(compilation.derivation, compilation.mechanism)
    assert "  P = −200 N\n" in said
    assert "  R = −3 kN\n" in f"{said}\n"
