"""Tables and lists of a description: rows in SI, from the smallest on, and not too many."""

import pytest

from mechc.diagnostics import MechcError, Report
from mechc.formula.evaluate import evaluate
from mechc.model.from_syntax import resolve
from mechc.model.mechanism import Mechanism
from mechc.source import Source
from mechc.syntax.notation import read


def sheet(lines: str) -> Mechanism:
    report = Report(Source("s.mech", f"sheet s\n{lines}\n"))
    return resolve(read(report.source, report), report)


def sizes(count: int) -> str:
    return "list bores = " + ", ".join(f"{i + 1} mm" for i in range(count))


def test_sizes_are_in_si() -> None:
    made = sheet(f"{sizes(3)}\nparam d = 1.5 mm\nlet bore = next d in bores")
    (let,) = made.lets
    assert evaluate(let.value, {"d": 0.0015}) == pytest.approx(0.002)


@pytest.mark.parametrize(("count", "codes"), [(200, []), (201, ["E216"])])
def test_a_list_has_two_hundred_sizes_at_most(count: int, codes: list[str]) -> None:
    lines = f"{sizes(count)}\nparam d = 1.5 mm\nlet bore = next d in bores"
    try:
        sheet(lines)
        found = []
    except MechcError as error:
        found = [d.code for d in error.diagnostics]
    assert found == codes


@pytest.mark.parametrize(
    ("table", "value"),
    [("0: 1 mm, 1 m/s: 2 mm", 0.0015), ("0 m/s: 0, 1 m/s: 2 mm", 0.001), ("0: 0, 1 m/s: 2", 1.0)],
)
def test_a_bare_zero_in_a_table_measures_what_the_others_do(table: str, value: float) -> None:
    made = sheet(f"table m = {table}\nparam v = 0.5 m/s\nlet q = m at v")
    (let,) = made.lets
    assert evaluate(let.value, {"v": 0.5}) == pytest.approx(value)


@pytest.mark.parametrize(
    ("rows", "codes"),
    [
        ("1 mm: 2 N, 2 m: 3 N", ["W289"]),
        ("1 mm: 2 N, 2 mm: 3 kN", ["W289"]),
        ("500 mm: 2 N, 2 m: 3 N", []),
        ("1 mm: 2 N, 300 mm: 3 N", []),
    ],
)
def test_a_table_of_two_rows_in_two_units(rows: str, codes: list[str]) -> None:
    text = f"sheet s\ntable m = {rows}\nparam x = 1 mm\nlet q = m at x\n"
    report = Report(Source("s.mech", text))
    assert resolve(read(report.source, report), report)
    assert [d.code for d in report.diagnostics if d.code == "W289"] == codes
