"""Forces that a mechanism gives to a sheet: by which names, and with which reserve."""

from pathlib import Path

import pytest

import mechc
from mechc import files
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.report.note import note

BENT = """
mechanism bent
pivot O at (0 mm, 0 mm)
slider K along y
link KA
link AOJ
K at (-80 mm, -60 mm)
A at (-70 mm, 0 mm)
J at (110 mm, 12 mm)
force P at K along y
force F at J along y
friction pins 0.12 diameter 14 mm
find k = P/F, R_P = R_O, R_A on KA
"""


def sheet(folder: Path, line: str) -> Path:
    """Return the path of a sheet that uses the mechanism and has one more line."""
    (folder / "bent.mech").write_text(BENT, "utf-8")
    path = folder / "sheet.mech"
    path.write_text(f'sheet s\nuse "bent.mech" as C (F = 2 kN)\n{line}\n', "utf-8")
    return path


@pytest.mark.parametrize(
    ("asked", "hint"),
    [
        ("C_R_A", "did you mean 'C_R_A_on_KA'?"),
        ("C_R_A_f", "did you mean 'C_R_A_on_KA_f'?"),
        ("C_R_P_f_y", "did you mean 'C_R_P_y_f'?"),
        ("C_R_O", "bent.mech gives it once it has a line `find R_O`; as it is, it gives C_R_P"),
        ("C_N_KA", "bent.mech gives it once it has a line `find N_KA`"),
        ("C_len_KA", "with a line `let q = len_KA` bent.mech gives it as 'C_q'"),
        ("C_y_J", "with a line `let q = y_J` bent.mech gives it as 'C_q'"),
    ],
)
def test_a_force_by_another_name(tmp_path: Path, asked: str, hint: str) -> None:
    with pytest.raises(MechcError) as refused:
        mechc.load(sheet(tmp_path, f"let q = 2*{asked}"))
    assert [d.hint for d in refused.value.diagnostics] == [hint]


def test_a_force_has_a_reserve(tmp_path: Path) -> None:
    """It is calculated, though no formula of the sheet stands for it."""
    path = sheet(tmp_path, "require C_R_P_f < 9 kN")
    compilation = Compilation(files.read(path))
    (check,) = note(compilation.mechanism, compilation.results).checks
    assert check.reserve == pytest.approx(9e3 / mechc.load(path).evaluate()["C_R_P_f"])


def test_a_number_of_the_drawing_is_given_by_a_let(tmp_path: Path) -> None:
    """It is a constant under its name there: its row is no fault."""
    path = sheet(tmp_path, "let a = 2*C_q in mm")
    (tmp_path / "bent.mech").write_text(f"{BENT}let q = len_OJ in mm\n", "utf-8")
    compilation = Compilation(files.read(path))
    rows = {line.name: line for line in note(compilation.mechanism, compilation.results).lines}
    value = rows["C_q"].value
    assert not rows["C_q"].is_number
    assert value
    assert value.text(6) == "110.653 mm"
