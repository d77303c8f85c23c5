"""A mechanism that stands by the places of its pins and is driven, used by a sheet."""

import math
from pathlib import Path

import numpy as np
import pytest

import mechc
from mechc.diagnostics import MechcError

TIPPER = """
mechanism tipper
pivot O at (0 mm, 0 mm)
pivot C at (300 mm, -200 mm)
link OAG
telescope CA
A at (700 mm, 50 mm)
G at (600 mm, 150 mm)
drive OA from {low} to {high}
actuator P between C and A
weight W mass 1500 kg at G
find P, R_O
"""

FOUR_BAR = """
mechanism bars
param phi: angle
pivot O at (0 mm, 0 mm)
pivot C at (200 mm, 0 mm)
link OA
link AB
link CB
OA = @ phi
A at (30 mm, 52 mm)
B at (180 mm, 120 mm)
drive phi from 40 deg to 80 deg
torque M on OA
torque Q on CB
find k = Q/M
"""


def written(folder: Path, used: str, given: str = "") -> Path:
    (folder / "used.mech").write_text(used)
    path = folder / "sheet.mech"
    path.write_text(f'sheet s\nuse "used.mech" as T{given}\nlet n = 1/T_{_result(used)}\n')
    return path


def _result(used: str) -> str:
    return "P" if "find P" in used else "k"


@pytest.mark.parametrize(("low", "high"), [("4 deg", "40 deg"), ("40 deg", "4 deg")])
def test_what_drives_is_a_parameter_at_its_drawn_value(tmp_path: Path, low: str, high: str) -> None:
    """It may run over the stroke, and has the values of the mechanism alone."""
    path = written(tmp_path, TIPPER.format(low=low, high=high))
    path.write_text(path.read_text() + "let turn = T_R_O_direction\nlet rest = T_R_O - T_R_O_x\n")
    sheet, alone = mechc.load(path), mechc.load(tmp_path / "used.mech")
    drawn = math.atan2(50, 700)
    assert sheet.defaults == {"T_phi_OA": pytest.approx(drawn, rel=1e-14)}
    assert sheet.evaluate()["T_P"] == pytest.approx(alone.evaluate()["P"], rel=1e-13)
    stroke = np.linspace(math.radians(4), math.radians(40), 9)
    along, of_alone = sheet.evaluate(T_phi_OA=stroke), alone.evaluate(phi_OA=stroke)
    for name in ("P", "R_O", "R_O_x", "R_O_direction"):
        np.testing.assert_allclose(along[f"T_{name}"], of_alone[name], rtol=1e-13)
    (known,) = sheet._compilation.mechanism.parameters
    assert known.range is not None


def test_it_may_be_given(tmp_path: Path) -> None:
    used = TIPPER.format(low="4 deg", high="40 deg")
    sheet = mechc.load(written(tmp_path, used, " (phi_OA = 30 deg)"))
    alone = mechc.load(tmp_path / "used.mech")
    assert sheet.evaluate()["T_P"] == pytest.approx(alone.evaluate(phi_OA="30 deg")["P"])
    with pytest.raises(MechcError) as refused:
        mechc.load(written(tmp_path, used, " (phi_OA = 50 deg)"))
    assert [d.code for d in refused.value.diagnostics] == ["E560"]


def test_a_parameter_that_the_drawing_gives(tmp_path: Path) -> None:
    """It is declared, without a value."""
    sheet = mechc.load(written(tmp_path, FOUR_BAR))
    alone = mechc.load(tmp_path / "used.mech")
    assert sheet.evaluate()["T_k"] == pytest.approx(alone.evaluate()["k"], rel=1e-13)


def test_a_failed_requirement_on_a_drawn_mechanism_writes_nothing(tmp_path: Path) -> None:
    """Its values are known, so that the condition is checked: it was passed over once."""
    path = written(tmp_path, TIPPER.format(low="4 deg", high="40 deg"))
    path.write_text(path.read_text() + "require T_P < 26 kN\n")
    with pytest.raises(MechcError) as refused:
        mechc.load(path)
    assert [d.code for d in refused.value.diagnostics] == ["E550"]


def test_a_weight_is_given_by_a_let(tmp_path: Path) -> None:
    """It has the value of its mass; without the line a hint says so."""
    used = TIPPER.format(low="4 deg", high="40 deg")
    path = written(tmp_path, used)
    path.write_text(path.read_text() + "let w = T_W\n")
    with pytest.raises(MechcError) as refused:
        mechc.load(path)
    (found,) = refused.value.diagnostics
    assert found.hint == "with a line `let q = W` used.mech gives it as 'T_q'"
    path = written(tmp_path, f"{used}let q = W in kN\n")
    path.write_text(path.read_text() + "let w = T_q\n")
    assert mechc.load(path).evaluate()["w"] == pytest.approx(1500 * 9.80665)
    assert mechc.load(tmp_path / "used.mech").evaluate()["q"] == pytest.approx(1500 * 9.80665)
