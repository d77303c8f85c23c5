"""A slip of the pen is stated where it is, and nothing is emitted that rests on it."""

import re
from random import Random

import pytest

from mechc.compilation import Compilation, complete, warnings
from mechc.diagnostics import Diagnostic, MechcError
from mechc.source import Source, Span
from slips import IN_LINES, IN_YAML, Slip, drawn, right

KINDS = [(kind, ".mech") for kind in IN_LINES] + [(kind, ".yaml") for kind in IN_YAML]


def found(source: Source) -> list[Diagnostic]:
    """Return the messages of a description."""
    compilation = Compilation(source)
    try:
        complete(compilation)
    except MechcError as error:
        return list(error.diagnostics)
    return warnings(compilation)


def new(slip: Slip) -> list[Diagnostic]:
    """Return the messages of a slip that the description without it has not."""
    said = found(slip.source)
    if any(d.code.startswith("E") for d in said):
        return said
    text = right(slip.path.suffix)[slip.path]
    before = found(Source(slip.path.name, text, folder=slip.path.parent))
    return [d for d in said if (d.code, d.message) not in {(b.code, b.message) for b in before}]


def is_at(span: Span | None, slip: Slip) -> bool:
    """Return whether a place has a line in common with a slip, or names what that declares."""
    if span is None or span.start > len(slip.text):
        return False
    first = slip.source.position(span.start).line
    last = slip.source.position(max(span.start, span.end - 1)).line
    if first <= slip.line + slip.written.count("\n") and last >= slip.line:
        return True
    declared = re.match(r"\s*param (\w+) +=|\s*(\w+):", slip.written)
    name = declared and (declared[1] or declared[2])
    return bool(name and re.search(rf"\b{name}\b", slip.source.line(first)))


def assert_stated(slip: Slip) -> None:
    said = new(slip)
    case = f"{slip.kind} in {slip.path.name}:{slip.line}: {slip.written}"
    assert said, f"accepted in silence: {case}"
    assert all(d.hint for d in said), case
    places = [p for d in said for p in (d.span, *(r.span for r in d.related))]
    assert any(is_at(place, slip) for place in places), f"{case}\nhas {said[0]}"


def test_slips_are_stated_where_they_are():
    for kind, suffix in Random(3).sample(KINDS, 12):
        for slip in drawn(kind, suffix, 1, 3):
            assert_stated(slip)


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "suffix"), KINDS, ids=lambda part: getattr(part, "name", part))
def test_all_kinds_of_slips_are_stated_where_they_are(kind, suffix):
    slips = drawn(kind, suffix, 3, 9)
    assert slips
    for slip in slips:
        assert_stated(slip)
