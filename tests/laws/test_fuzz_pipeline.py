"""Spoiled descriptions through the whole compiler: an error, or every target's output.

What may not come out: an exception of another kind, a number that is none, an error that
speaks of mechc itself, or a wait.
"""

import math
import time

import pytest

from mechc.compilation import Compilation, complete, emit, warnings
from mechc.diagnostics import MechcError
from mechc.diagnostics.render import render
from mechc.diagnostics.statics import BUGS
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.source import Source
from mutations import mutant, texts

SECONDS = 20
"""Far beyond what any description takes, on a slow machine: what runs so long may never end."""

TARGETS = [registry.load(name) for name in registry.BUILT_IN]


def attempt(name: str, text: str) -> bool:
    """Take a text as far as it goes; return whether it compiled."""
    source = Source(name, text)
    compilation = Compilation(source)
    try:
        complete(compilation)
    except MechcError as error:
        refused, found = True, error.diagnostics
    else:
        refused, found = False, tuple(warnings(compilation))
    assert all(render(d, source) and d.hint for d in found)
    assert not [(d.code, d.message) for d in found if d.code in BUGS]
    if refused:
        return False
    defaults = [r.default for r in compilation.results if r.default is not None]
    assert all(map(math.isfinite, defaults))
    for target in TARGETS:
        for language in ("en", "uk"):
            assert emit(compilation, target, Options(stem="x", language=language))
    return True


def fuzz(seeds: range) -> None:
    given = texts()
    compiled = 0
    for seed in seeds:
        name, text = mutant(seed, given)
        begun = time.process_time()
        try:
            compiled += attempt(name, text)
        except Exception as error:
            error.add_note(f"seed {seed}: {name} spoiled\n{text}")
            raise
        assert time.process_time() - begun < SECONDS, f"seed {seed}: {name} spoiled\n{text}"
    assert len(seeds) / 20 < compiled < len(seeds) / 2


@pytest.mark.parametrize("part", range(2))
def test_spoiled_descriptions(part):
    fuzz(range(part, 40, 2))


@pytest.mark.slow
def test_hundreds_of_spoiled_descriptions():
    fuzz(range(40, 160))
