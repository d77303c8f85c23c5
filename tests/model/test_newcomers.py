"""Mechanisms as newcomers describe them, from collections and textbooks, by drawn coordinates.

Slips of those who wrote them are corrected; the loads balance in every motion that a reading of
the same lines by coordinates allows (:mod:`reference_drawn`).
"""

import math
import re

import pytest

import mechc
from paths import TESTS
from reference_drawn import Drawn, released

TEXTS = {
    re.match(r"mechanism (\w+)", text)[1]: text
    for text in re.split(r"\n\n", (TESTS / "corpus" / "newcomers.txt").read_text().strip())
}
SOME = ("double_wishbone", "five_bar_robot", "wolfrom", "work_platform", "step_ladder")


def loads_of(text, drawn):
    """Return the value of every load: what is known, given ones at will, and what is found."""
    values = {name: 2 + math.sqrt(i) for i, (name, _) in enumerate(drawn.loads())}
    values |= drawn.known()
    if ratio := re.search(r"find k = (\w+)/(\w+)", text):
        return values | {ratio[1]: mechc.loads(text).evaluate()["k"] * values[ratio[2]]}
    asked = re.search("find (.*)", text)[1].split(", ")
    given = {name: value for name, value in values.items() if not name.startswith((*asked, "S_"))}
    return values | mechc.loads(text).evaluate(**given)


def agree(text):
    drawn = Drawn(released(text))
    work, greatest = drawn.work(loads_of(text, drawn))
    assert len(work)
    assert max(map(abs, work)) <= 1e-9 * greatest


@pytest.mark.parametrize("name", SOME)
def test_its_loads_balance(name):
    agree(TEXTS[name])


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(TEXTS.keys() - set(SOME)))
def test_the_loads_of_each_balance(name):
    agree(TEXTS[name])
