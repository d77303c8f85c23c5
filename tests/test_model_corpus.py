"""One mistake a file, with the exact message: ``#! CODE LINE:COLUMN message | hint``."""

from pathlib import Path

import pytest

from mechc.diagnostics import CATALOGUE, MechcError, Report
from mechc.model.from_syntax import resolve
from mechc.source import Source
from mechc.syntax.notation import read

BAD = Path(__file__).parent / "corpus" / "bad"
FILES = sorted(p for p in BAD.iterdir() if p.name[1] == "2")


def messages(path: Path) -> list[str]:
    """Return what reading and resolving a file reports."""
    source = Source(path.name, path.read_text(encoding="utf-8"))
    report = Report(source)
    try:
        tree = read(source, report)
        report.stop_on_errors()
        resolve(tree, report)
    except MechcError:
        pass
    lines = []
    for found in report.sorted():
        assert found.span is not None
        place = source.position(found.span.start)
        hint = f" | {found.hint}" if found.hint else ""
        lines.append(f"#! {found.code} {place.line}:{place.column} {found.message}{hint}")
    return lines


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.name)
def test_message(path: Path) -> None:
    text = path.read_text(encoding="utf-8").splitlines()
    expected = [line for line in text if line.startswith("#!")]
    assert messages(path) == expected
    assert any(line.split()[1] == path.name[:4] for line in expected)


def test_every_code_of_the_model_is_reached() -> None:
    assert {code for code in CATALOGUE if code[1] == "2"} == {p.name[:4] for p in FILES}
