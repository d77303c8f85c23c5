"""A size below zero is doubted in the sheet whose line gives it, once, and not where it is used."""

from pathlib import Path
from types import SimpleNamespace
from typing import Literal, cast

import pytest

from mechc.calculation.calculation import Check
from mechc.calculation.doubtful_signs import _doubt, _force, _has_sign
from mechc.compilation import Compilation, complete
from mechc.files import read
from mechc.formula.tree import Call, Formula, Symbol, number, product, total
from mechc.formula.walk import symbols
from mechc.model.mechanism import Let, Mechanism, Require
from mechc.units import FORCE, LENGTH
from small_poses import HERE

TUBE = """sheet tube
param D = {outer} mm
param t = 12 mm
let d = D - 2*t in mm
let A = pi*d^2/4 in mm^2
"""


def warned(path: Path) -> list[str]:
    return [d.code for d in complete(Compilation(read(path))).report.sorted()]


def tube(folder: Path, outer: int) -> Path:
    path = folder / "tube.mech"
    path.write_text(TUBE.format(outer=outer), "utf-8")
    return path


@pytest.mark.parametrize(("outer", "codes"), [(20, ["W290"]), (30, [])])
def test_a_size_below_zero_is_doubted_once(tmp_path: Path, outer: int, codes: list[str]) -> None:
    assert warned(tube(tmp_path, outer)) == codes


def test_one_of_a_used_sheet_is_doubted_there(tmp_path: Path) -> None:
    tube(tmp_path, 20)
    user = tmp_path / "user.mech"
    user.write_text('sheet user\nuse "tube.mech" as T\nlet w = T_A + T_A in mm^2\n', "utf-8")
    assert warned(user) == []


@pytest.mark.parametrize(("asked", "force"), [("u", "m_F"), ("m_F", "m_F"), ("w", ""), ("x", "")])
def test_the_force_that_a_bound_rests_on_is_found_through_formulas(asked: str, force: str) -> None:
    """u = v, v = m_F, which is a force of a used mechanism; w = x + x, which is none."""
    values = {"u": Symbol("v"), "v": Symbol("m_F"), "w": total([Symbol("x"), Symbol("x")])}
    lets = [SimpleNamespace(name=name, value=value) for name, value in values.items()]
    taken = [
        SimpleNamespace(name="m_F", dimension=FORCE),
        SimpleNamespace(name="x", dimension=LENGTH),
    ]
    mechanism = cast(Mechanism, SimpleNamespace(lets=lets, taken=taken))
    assert _force(Symbol(asked), mechanism) == force


@pytest.mark.parametrize(
    ("value", "given", "has_sign"),
    [
        (product([(Symbol("L"), 1), (Call("cos", (Symbol("phi"),)), 1)]), {"L": 1.0}, True),
        (Call("sqrt", (Symbol("L"),)), {"L": 1.0}, False),
        (total([Symbol("L"), number(-2)]), {"L": 1.0}, False),
        (total([Symbol("L"), number(-2)]), {"L": -1.0}, True),
        (total([Symbol("x_1"), number(-2)]), {"x_1": 1.0}, True),
    ],
)
def test_projections_coordinates_and_what_is_made_of_signed_lengths_have_signs(
    value: Formula, given: dict[str, float], has_sign: bool
) -> None:
    let = Let("w", value, LENGTH, HERE)
    made_of = {"w", *symbols(value)}
    assert _has_sign(let, made_of, {"w": let}, given) is has_sign


@pytest.mark.parametrize(("operator", "side"), [("<", "N"), ("<=", "N"), (">", "S"), (">=", "S")])
def test_the_smaller_side_of_a_bound_is_doubted(
    operator: Literal["<", "<=", ">", ">="], side: str
) -> None:
    condition = Require(Symbol("N"), operator, Symbol("S"), HERE)
    found = _doubt(Check(condition, -5.0, 7.0), -5.0, "m_F")
    assert found.message.startswith(f"{side} is -5, ")
