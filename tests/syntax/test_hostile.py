"""Text that means harm, or nothing: an error or a tree, in bounded time."""

import time
from contextlib import suppress

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from mechc.diagnostics import MechcError, Report
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.to_dsl import to_dsl
from mechc.syntax.to_yaml import to_yaml
from sources import in_thirds
from strategies import files

HOSTILE = {
    "code.mech": 'let k = __import__("os").system("true")',
    "dunder.mech": "let k = ().__class__",
    "tower.mech": "let k = 9^9^9^9",
    "long_tower.mech": "let k = " + "9^" * 20_000 + "9",
    "brackets.mech": "let k = " + "(" * 20_000 + "a" + ")" * 20_000,
    "open.mech": "let k = " + "(" * 20_000,
    "close.mech": "let k = a" + ")" * 20_000,
    "signs.mech": "let k = " + "-" * 20_000 + "a",
    "calls.mech": "let k = " + "sin(" * 20_000,
    "sum.mech": "let k = " + "a + " * 20_000 + "a",
    "product.mech": "let k = " + "a*" * 40_000 + "a",
    "digits.mech": "let k = " + "1" * 100_000,
    "exponent.mech": "let k = 1e" + "9" * 100_000,
    "name.mech": "param " + "a" * 100_000 + " = 1",
    "points.mech": "link " + "A" * 100_000,
    "line.mech": "#" + "x" * 10_000_000,
    "lines.mech": "?\n" * 100_000,
    "spaces.mech": "let k = " + " " * 200_000 + "1",
    "numbers.mech": "let k = " + "1 " * 100_000,
    "quotes.mech": '"' * 100_000,
    "open_lines.mech": "let k = (\n" + "+\n" * 50_000,
    "finds.mech": "find " + "P, " * 30_000 + "P",
    "no_end.mech": "find " + "k = " * 30_000,
    "python.yaml": "params: !!python/object/apply:os.system [true]",
    "tag.yaml": "params: {a: !!float 40}",
    "bomb.yaml": "a: &a [x]\nb: &b [*a, *a]\nc: [*b, *b]",
    "lists.yaml": "[" * 100_000,
    "maps.yaml": "{a: " * 50_000,
    "block.yaml": "".join(" " * n + "a:\n" for n in range(600)),
    "keys.yaml": "".join(f"a{n}: 1\n" for n in range(15_000)),
    "same.yaml": "a: 1\n" * 30_000,
    "items.yaml": "links: [" + "AB, " * 50_000 + "]",
    "errors.yaml": "let: {" + ", ".join(f"a{n}: '?'" for n in range(5_000)) + "}",
    "line.yaml": "title: " + "x" * 10_000_000,
    "scalar.yaml": "let: {k: '" + "(" * 100_000 + "'}",
    "folded.yaml": "let:\n  k: >\n" + "    a +\n" * 20_000 + "    a\n",
    "escapes.yaml": 'let: {k: "' + "\\u0061+" * 20_000 + 'a"}',
    "escape.yaml": 'title: "\\UFFFFFFFF"',
    "version.yaml": "%YAML " + "9" * 5_000 + ".1\n---\na: 1",
    "tabs.yaml": "a:\n\t- b",
    "nul.yaml": "a: \x00",
    "key.yaml": "? [a, b]\n: c",
    "empty_key.yaml": ": c",
    "documents.yaml": "links: [AB]\n---\nlinks: [CD]",
    "bare.yaml": "just a text",
    "list.yaml": "- a\n- b",
}


def attempt(name, text):
    """Read a text; return how many errors there were. Anything but a tree or errors raises."""
    source = Source(name, text)
    report = Report(source)
    with suppress(MechcError):
        read(source, report)
    for diagnostic in report.diagnostics:
        assert diagnostic.span is not None
        assert 0 <= diagnostic.span.start <= diagnostic.span.end <= len(text)
        assert len(diagnostic.message) < 1000
    return len(report.diagnostics)


GOOD = {"tower.mech", "sum.mech", "product.mech", "name.mech", "points.mech", "finds.mech"}
GOOD |= {"folded.yaml", "spaces.mech", "line.mech", "escapes.yaml", "items.yaml"}
TOO_LARGE = {"line.mech", "items.yaml"}


SECONDS = 30
"""Of the processor: one or two are enough, and time that grows as the square takes minutes."""


@pytest.mark.parametrize("name", in_thirds(HOSTILE))
def test_hostile_text_is_read_or_refused_before_long(name):
    begun = time.process_time()
    errors = attempt(name, HOSTILE[name])
    assert time.process_time() - begun < SECONDS
    assert errors == 0 if name in GOOD - TOO_LARGE else errors > 0


quiet = settings(
    max_examples=150,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.generate],
)

VOCABULARY = """param let find slider K along 90 deg AB = @ ( ) , .. + - * / ^ < mm sin 'x # :
[ ] { } links: geometry: &a *a !t | > ? forces: P: {at: A} friction pins 1e5 perp \""""
WORDS = st.sampled_from([*VOCABULARY.split(), "\n", "- "])


@quiet
@given(st.text(max_size=80), st.sampled_from(["a.mech", "a.yaml", "-"]))
def test_any_text(text, name):
    attempt(name, text)


@quiet
@given(
    st.lists(WORDS, max_size=25).map(" ".join),
    st.sampled_from(["a.mech", "a.yaml"]),
)
def test_any_words(text, name):
    attempt(name, text)


@settings(quiet, max_examples=25)
@given(files(), st.data())
def test_mutations_of_good_files(tree, data):
    printer, name = data.draw(st.sampled_from([(to_dsl, "a.mech"), (to_yaml, "a.yaml")]))
    text = printer(tree)
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(text)))
        gone = data.draw(st.integers(0, 3))
        put = data.draw(
            st.sampled_from(["", "(", ")", "'", '"', "\n", ":", "[", "}", "#", "@", "é"])
        )
        text = text[:at] + put + text[at + gone :]
    attempt(name, text)
