"""One mistake a file: its name begins with its code, its last lines tell the messages.

``#! CODE LINE:COLUMN message | hint``, as the reader of either notation reports them.
"""

from contextlib import suppress
from pathlib import Path

import pytest

from mechc.diagnostics import CATALOGUE, MechcError, Report
from mechc.source import Source
from mechc.syntax import limits
from mechc.syntax.notation import read

BAD = Path(__file__).parent / "corpus" / "bad"
FILES = sorted(path for path in BAD.iterdir() if path.name.startswith(("E1", "E81")))


def messages(source: Source) -> list[str]:
    """Return what reading a text reports, a line each."""
    report = Report(source)
    with suppress(MechcError):
        read(source, report)
    lines = []
    for found in report.sorted():
        assert found.span is not None
        place = source.position(found.span.start)
        hint = f" | {found.hint}" if found.hint else ""
        lines.append(f"#! {found.code} {place.line}:{place.column} {found.message}{hint}")
    return lines


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_the_message(path):
    text = path.read_text(encoding="utf-8")
    expected = [line for line in text.splitlines() if line.startswith("#!")]
    assert messages(Source(path.name, text)) == expected
    assert any(line.split()[1] == path.name[:4] for line in expected)


def test_a_text_too_long():
    (message,) = messages(Source("a.mech", "#" * (limits.CHARACTERS + 1)))
    assert message == "#! E811 1:1 the text has 250001 characters, expected at most 250000"


def test_every_code_of_syntax_is_reached():
    codes = {code for code in CATALOGUE if code.startswith(("E1", "E81"))}
    assert codes == {path.name[:4] for path in FILES} | {"E811"}
