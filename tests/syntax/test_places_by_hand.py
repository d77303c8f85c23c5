"""Where the characters of a YAML value are in the text, quoted, folded or in a block."""

import pytest

from mechc.source import Source, Span
from mechc.syntax.yaml.nodes import Scalar
from mechc.syntax.yaml.scalars import places


@pytest.mark.parametrize(
    ("raw", "value"),
    [
        ("plain", "plain"),
        ("'it''s'", "it's"),
        (r'"a\tb"', "a\tb"),
        ("|\n  ab\n  c\n", "ab\nc\n"),
        (">\n  ab\n  c\n", "ab c\n"),
    ],
)
def test_every_visible_character_is_where_it_was_written(raw, value):
    source, start = Source("a.yaml", f"x: {raw}"), 3
    found = places(Scalar(value, Span(start, start + len(raw)), True), source)
    assert len(found) == len(value)
    letters = [(at, letter) for at, letter in zip(found, value, strict=True) if letter.isalnum()]
    assert all(source.text[at] == letter for at, letter in letters)
    assert found == sorted(found)
