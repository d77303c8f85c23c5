"""What people mean by a token that does not fit: the hint for each of the usual slips."""

import pytest

from mechc.diagnostics import Report
from mechc.source import Source
from mechc.syntax.notation import read

HINTS = {
    'let k = "5 mm"': "a value stands without quotes: 5 mm",
    'OA = 40 "mm"': "a unit stands without quotes: 40 mm",
    'pivot O "base"': "a label stands behind '#': # base",
    "OA = 40 mm // crank": "a comment begins with '#'",
    "link OA 40 mm": "a length is a line of its own: OA = 40 mm",
    "param l_{max} = 3 mm": "an index belongs to the name: l_max",
    "find P/F = k": "the name stands first, as in find k = P/F",
}


@pytest.mark.parametrize("line", HINTS)
def test_a_slip_has_its_hint(line: str) -> None:
    report = Report(Source("m.mech", f"mechanism m\n{line}\n"))
    read(report.source, report)
    assert [found.hint for found in report.diagnostics] == [HINTS[line]]
