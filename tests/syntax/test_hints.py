"""Statements in hints, in the notation of the text: hand-built hints, and all of the corpus."""

import re

import pytest

import mechc
from mechc.diagnostics import MechcError, Report
from mechc.source import Source
from mechc.syntax.from_yaml import parse
from mechc.syntax.hints import in_yaml
from paths import CORPUS


@pytest.mark.parametrize(
    ("line", "written"),
    [
        ("AB = … @ alpha", "geometry: {AB: … @ alpha}"),
        ("slider B along x through O", "sliders: {B: {along: x, through: O}}"),
        ("friction pins 0.10 diameter 10 mm", "friction: {pins: {f: 0.10, diameter: 10 mm}}"),
        ("motion releasing", "motion: releasing"),
        ("require v <= 2 m/s", "require: [v <= 2 m/s]"),
        ("expect k = [1, 2]", "expect k = [1, 2]"),
        ("sharing K", "sharing K"),
        ("", ""),
    ],
)
def test_a_statement_is_put_on_one_line_of_yaml(line, written):
    assert in_yaml(f"write `{line}`.") == f"write `{written}`."


def test_a_twin_in_a_hint_does_not_begin_a_quotation():
    hint = "write the point described first: `link AA'`, not A'"
    assert in_yaml(hint) == "write the point described first: `links: [AA']`, not A'"


def test_a_hint_is_in_the_notation_of_the_text():
    described = "params: {a: 100 mm}\npivots: {O: [0 mm, 0 mm]}\nlinks: [OA]\ngeometry: {OA: a @ b}"
    with pytest.raises(MechcError) as caught:
        mechc.loads(f"{described}\ntorques: {{M: {{link: OA}}}}\nfind: [M]\n", "a.yaml")
    (found,) = (d for d in caught.value.diagnostics if d.code == "E201")
    assert "'params: {b: …}'" in found.hint


def test_what_is_written_in_hints_is_yaml():
    """Each statement in the hints of the corpus, which are those of lines, reads back as YAML."""
    texts = (path.read_text("utf-8") for path in CORPUS.glob("bad/*.mech"))
    hints = {h for text in texts for h in re.findall(r"^#! .* \| (.*)$", text, re.MULTILINE)}
    changed = [(hint, in_yaml(hint)) for hint in sorted(hints)]
    quoted = re.compile(r"[`']([a-z]+: [^`']*)[`']")
    statements = {s for hint, found in changed if hint != found for s in quoted.findall(found)}
    assert len(statements) > 50
    for statement in sorted(statements):
        source = Source("hint.yaml", statement.replace("…", "left_open"))
        report = Report(source)
        parse(source, report)
        assert not report.diagnostics, statement
