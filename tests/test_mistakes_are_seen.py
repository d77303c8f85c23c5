"""One mistake put into a description of the library is never accepted in silence."""

import re
from collections.abc import Iterator
from random import Random

import pytest

from mechc.diagnostics import MechcError
from mechc.driver import Compilation
from mechc.files import library
from mechc.source import Source

MISTAKEN = {"mm": "kg", "deg": "mm", "kg": "mm", "m": "deg", "N": "deg", "kN": "mm"}
QUANTITY = re.compile(r"(?<![\w.])(?!0 )(\d[\d.]*)\s+(mm|deg|kN|kg|N|m)(?![\w^/*])")
LINES = ("param", "OA", "AB", "OB", "BK", "slider", "force")


def mistakes(text: str) -> Iterator[tuple[str, str]]:
    """Yield descriptions with one mistake each, and what was done."""
    lines = text.splitlines()
    for number, line in enumerate(lines):
        code = line.split("#")[0].rstrip()
        for wrong in of_line(code):
            yield "\n".join([*lines[:number], wrong, *lines[number + 1 :], ""]), wrong


def of_line(code: str) -> Iterator[str]:
    if not code:
        return
    word = code.split()[0]
    yield code.replace(word, f"{word}x", 1)
    yield f"{code}\n{code}"
    if not word.startswith(LINES):
        return
    for found in QUANTITY.finditer(code):
        start, end = found.span(2)
        yield f"{code[:start].rstrip()}{code[end:]}"
        yield f"{code[:start]}{MISTAKEN[found[2]]}{code[end:]}"


def is_seen(text: str) -> bool:
    compilation = Compilation(Source("a.mech", text))
    try:
        return bool(compilation.balance and compilation.report.diagnostics)
    except MechcError:
        return True


def drawn(seed: int, number: int) -> list[tuple[str, str, str]]:
    dice = Random(seed)
    texts = {name: path.read_text("utf-8") for name, path in library().items()}
    every = [(name, text, wrong) for name in texts for text, wrong in mistakes(texts[name])]
    return dice.sample(every, number)


def silent(cases: list[tuple[str, str, str]]) -> list[tuple[str, str]]:
    return [(name, wrong) for name, text, wrong in cases if not is_seen(text)]


HARMLESS = re.compile(r'(?s)param \w+ = [\d.]+ \w+ as "cylinder bore"|drive .*|param d .*')
"""A bore stands in a formula of the user's own only; a second drive is another matter."""


def test_some_mistakes_are_seen():
    assert not [found for found in silent(drawn(1, 60)) if not HARMLESS.fullmatch(found[1])]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2, 6))
def test_many_mistakes_are_seen(seed):
    assert not [found for found in silent(drawn(seed, 250)) if not HARMLESS.fullmatch(found[1])]
