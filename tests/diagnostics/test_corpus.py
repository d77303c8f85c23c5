"""One mistake a file: its name begins with its code, its last lines tell the messages.

``#! CODE LINE:COLUMN message | hint``, as the whole compiler reports them.
"""

import re

import pytest

from mechc.cli.commands.explain import load_all
from mechc.compilation import Compilation, complete
from mechc.diagnostics import CATALOGUE, MechcError
from mechc.source import Source
from mechc.syntax import limits
from paths import CORPUS, TESTS

FILES = sorted((CORPUS / "bad").iterdir())

ELSEWHERE = {
    **dict.fromkeys(
        ["E583", "E584", "E585", "E586", "E587", "E588", "E589", "E598", "E599"],
        "plot/test_plot.py",
    ),
    "E591": "study/test_stroke.py",
    "E592": "study/test_stroke.py",
    "W591": "study/test_stroke.py",
    "W592": "study/test_stroke.py",
    "W594": "study/test_stroke_ends.py",
    "E597": "emit/test_points.py",
    "E340": "pose/test_driven.py",
    "E540": "statics/test_counted.py",
    "E601": "statics/test_referee.py",
    "E602": "statics/test_referee.py",
    "E603": "statics/test_closure.py",
    "E555": "calculation/test_uses.py",
    "E562": "calculation/test_uses.py",
    "W518": "calculation/test_used_mechanisms.py",
    "E574": "model/test_joined.py",
    "E910": "model/test_joined.py",
    "E704": "calculation/test_sheets.py",
    "E720": "drawing/test_scheme.py",
    "E721": "drawing/test_scheme.py",
    "E722": "drawing/test_bodies.py",
    "E723": "drawing/test_plans.py",
    "E730": "equilibrium/test_equilibrium.py",
    "E731": "equilibrium/test_equilibrium.py",
    "E701": "emit/test_c.py",
    "E702": "emit/test_registry.py",
    "E703": "emit/test_hostile_names.py",
    "E705": "emit/test_c_real.py",
    "W701": "emit/test_registry.py",
    "E811": "diagnostics/test_corpus.py",
    "E817": "laws/test_work_limit.py",
    "W261": "laws/test_work_limit.py",
    "E901": "cli/test_cli.py",
    "E902": "package/test_hostile.py",
    "E903": "package/test_hostile.py",
    "E904": "package/test_hostile.py",
    "E905": "package/test_hostile.py",
    "E906": "cli/test_cli.py",
}
"""What no description of a corpus can bring about, and the test that does."""


def messages(source: Source) -> list[str]:
    """Return all that compiling a text reports, a line each."""
    compilation = Compilation(source)
    try:
        complete(compilation)
        found = compilation.report.sorted()
    except MechcError as error:
        found = list(error.diagnostics)
    lines = []
    for diagnostic in found:
        assert diagnostic.span is not None
        place = source.position(diagnostic.span.start)
        assert diagnostic.hint, diagnostic
        hint = f" | {diagnostic.hint}".replace("\n", " // ")
        at = f"{place.line}:{place.column}"
        lines.append(f"#! {diagnostic.code} {at} {diagnostic.message}{hint}")
    return lines


def expected(text: str) -> list[str]:
    return [line for line in text.splitlines() if line.startswith("#!")]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_the_messages(path):
    text = path.read_text(encoding="utf-8")
    assert messages(Source(path.name, text)) == expected(text)
    assert any(line.split()[1] == path.name[:4] for line in expected(text))


def test_a_text_too_long():
    (message,) = messages(Source("a.mech", "#" * (limits.CHARACTERS + 1)))
    said = "the text has 250001 characters, expected at most 250000"
    assert message == f"#! E811 1:1 {said} | is this the right file? A mechanism is some lines long"


def test_every_code_is_reached():
    load_all()
    assert CATALOGUE.keys() == {path.name[:4] for path in FILES} | ELSEWHERE.keys()
    for code, name in ELSEWHERE.items():
        assert re.search(code, (TESTS / name).read_text(encoding="utf-8")), code


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_no_message_is_long_or_spreads_over_lines(path):
    for line in expected(path.read_text(encoding="utf-8")):
        assert len(line) < 400
        assert "  " not in line.split(" ", 3)[3]


MADE = re.compile(r"\b(?:len|delta|x|y)_[A-Z]\w*|\bphi_[A-Z]+\w*_\w*")
"""Names of lengths, angles and coordinates that mechc makes where a description has none."""


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_no_message_prints_a_name_that_nobody_introduced(path):
    """The user wrote it, or the message states its value."""
    text = path.read_text(encoding="utf-8", errors="replace")
    lines = text.split("\n")
    written = "\n".join(line for line in lines if not line.startswith("#!"))
    for line in lines:
        said = line.split(" | ")[0]
        for name in MADE.findall(said) if line.startswith("#!") else ():
            assert name in written or f"{name} = " in said, line
