"""Rows of a table that are taken exactly: what has no row has no value, and is said."""

from pathlib import Path

import numpy as np
import pytest

import mechc
from mechc.compilation import Compilation, complete
from mechc.diagnostics import MechcError
from mechc.source import Source
from run_targets import COMPILER, assert_close, built, by_c_in_batch, by_c_singly, by_python

SHEET = """
sheet bolt
param F = 6 kN in 1 kN .. 20 kN
list threads "ISO 262" = 6 mm, 8 mm, 10 mm, 12 mm, 16 mm
table pitches "ISO 261" = 6 mm: 1 mm, 8 mm: 1.25 mm, 10 mm: 1.5 mm, 12 mm: 1.75 mm
let d_min = 1.2*sqrt(4*F/(pi*(160 MPa)))
let d = next d_min in threads
let p = pitches at exactly d
"""


def sheet(text: str = SHEET) -> Compilation:
    return complete(Compilation(Source("bolt.mech", text)))


def test_a_row_has_its_value_and_nothing_else_has_one() -> None:
    found = mechc.loads(SHEET).evaluate(F=[1000, 6000, 11300, 20000])["p"]
    assert found == pytest.approx([1e-3, 1.5e-3, 1.75e-3, np.nan], nan_ok=True, rel=1e-15)


def test_what_is_computed_need_not_have_the_bits_of_the_row() -> None:
    found = mechc.loads(
        "sheet s\nparam r = 15.75 mm\nlet D = 2*r\n"
        "table t = 31.5 mm: 1, 63 mm: 2\nlet n = t at exactly (3*D - D)/2\n"
    )
    assert found.evaluate()["n"] == 1


def test_a_row_that_is_missing_is_an_error_with_the_nearest() -> None:
    with pytest.raises(MechcError, match="has no row at d = 16 mm, the nearest is at 12 mm"):
        sheet(SHEET.replace("6 kN in", "20 kN in"))


def test_the_units_of_what_is_looked_up_are_those_of_the_table() -> None:
    units = {let.name: let.unit for let in sheet().mechanism.lets}
    assert units == {"d_min": "mm", "d": "mm", "p": "mm"}


@pytest.mark.parametrize(
    ("asked", "table", "warned"),
    [
        ("at exactly d", "8 mm: 1, 12 mm: 2", False),
        ("at d", "8 mm: 1, 12 mm: 2", True),
        ("at d", "8 mm: 1, 10 mm: 3, 12 mm: 2", False),
        ("at d/2", "4 mm: 1, 6 mm: 2", False),
    ],
)
def test_sizes_between_rows_are_pointed_out(asked: str, table: str, warned: bool) -> None:
    text = f"sheet s\nparam m = 7 mm\nlist l = 8 mm, 10 mm, 12 mm\ntable t = {table}\n"
    found = sheet(f"{text}let d = next m in l\nlet n = t {asked}\n")
    assert ("W269" in {d.code for d in found.report.diagnostics}) == warned


@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
def test_c_agrees(tmp_path: Path) -> None:
    found = sheet()
    made = built(found, tmp_path)
    for way in (by_c_singly, by_c_in_batch):
        assert_close(way(found, made), by_python(found), 16, found.routine)


def test_exactly_is_a_name_anywhere_else() -> None:
    found = mechc.loads("sheet s\nparam exactly = 2\nlet at_most = 3*exactly\n")
    assert found.evaluate()["at_most"] == 6


def test_a_range_over_rows_is_no_range_between_them() -> None:
    text = "sheet s\nparam m = 2 in 1 .. 3\ntable t = 1: 5, 2: 6, 3: 7\nlet n = t at exactly m\n"
    assert "W283" not in {d.code for d in sheet(text).report.diagnostics}
    wide = sheet(text.replace("1 .. 3", "0 .. 3"))
    assert "W283" in {d.code for d in wide.report.diagnostics}


def test_pages_have_computed_numbers_of_a_table_to_the_digits_of_values() -> None:
    text = "sheet s\ntable t = 1: 0.362621262385658, 2: 0.5\nparam x = 1.5\nlet y = t at x\n"
    page = mechc.loads(text, "s.mech").emit("latex")
    assert "0.362621$" in page
    assert "0.362621+" in page
    assert "0.3626212" not in page
