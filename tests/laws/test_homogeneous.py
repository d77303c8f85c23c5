"""Formulas balance in units, also where a length is equal to a number by chance."""

from collections.abc import Iterable

import pytest

from homogeneous import on_grid, uneven
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.source import Source
from paths import LIBRARY

LOADED_AXLE = """
pivot O at (0 m, 0 m)
pivot K at (2 m, 2 m)
link OB
B at (2 m, 0 m)
slider H along y
H at (3 m, 0 m)
rope B, K, H along -y
force W at B along -y
force F at H along -y
find k = F/W, R_K
"""

FILES = sorted(p for p in LIBRARY.rglob("*") if p.suffix in {".mech", ".yaml"})


def compiled(text: str) -> Compilation:
    compilation = Compilation(Source("m.mech", text))
    _ = compilation.results
    return compilation


def hold(texts: Iterable[str]) -> int:
    """Return how many of the descriptions have results, all of which scale."""
    number = 0
    for text in texts:
        try:
            compilation = compiled(text)
        except MechcError:
            continue
        assert list(uneven(compilation)) == [], text
        number += 1
    return number


def test_an_axle_bears_twice_the_rope_and_no_arm_of_two_metres():
    assert hold([LOADED_AXLE]) == 1


def test_formulas_of_mechanisms_on_a_grid_balance():
    assert hold(map(on_grid, range(12))) > 4


@pytest.mark.slow
def test_formulas_of_many_mechanisms_on_a_grid_balance():
    assert hold(map(on_grid, range(1000, 1100))) > 50


@pytest.mark.slow
def test_formulas_of_the_library_balance():
    texts = (path.read_text(encoding="utf-8") for path in FILES if path.suffix == ".mech")
    assert hold(texts) > 60
