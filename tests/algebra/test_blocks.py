"""Equations matched with unknowns, and blocks of them: by hand, and by all ways between them."""

import random
from itertools import product

import pytest

from mechc.algebra.solution_order import blocks, match


def test_a_chain_is_solved_from_its_end():
    columns = [frozenset({0, 1}), frozenset({1, 2}), frozenset({2})]
    matched = match(columns)
    assert matched == {0: 0, 1: 1, 2: 2}
    assert blocks(columns, matched) == [[2], [1], [0]]


def test_what_hangs_together_is_one_block():
    """x + y and x - y by themselves, then z by both, then u and v, which need each other and z."""
    columns = [{2, 0, 1}, {0, 1}, {0, 1}, {3, 4}, {3, 4, 2}]
    columns = [frozenset(c) for c in columns]
    assert blocks(columns, match(columns)) == [[0, 1], [2], [3, 4]]


def test_a_ring_is_one_block():
    columns = [frozenset({i, (i + 1) % 5}) for i in range(5)]
    assert blocks(columns, match(columns)) == [[0, 1, 2, 3, 4]]


def test_two_rings_that_one_way_leads_between():
    """0 and 1 need each other; 2, 3 and 4 do, and 3 needs 0."""
    columns = [frozenset(c) for c in ({0, 1}, {1, 0}, {2, 3}, {3, 4, 0}, {4, 2})]
    matched = {i: i for i in range(5)}
    assert blocks(columns, matched) == [[0, 1], [2, 3, 4]]


@pytest.mark.parametrize("seed", range(40))
def test_blocks_are_unknowns_that_lead_to_each_other(seed):
    """Each comes after all that it needs."""
    dice = random.Random(seed)
    size = dice.randrange(1, 9)
    columns = [frozenset({i, *dice.choices(range(size), k=2)}) for i in range(size)]
    matched = match(columns)
    found = blocks(columns, matched)
    assert sorted(u for block in found for u in block) == list(range(size))
    leads = {u: set(columns[matched[u]]) for u in range(size)}
    for k, i, j in product(range(size), repeat=3):
        if k in leads[i] and j in leads[k]:
            leads[i].add(j)
    place = {u: at for at, block in enumerate(found) for u in block}
    for i, j in product(range(size), repeat=2):
        assert (place[i] == place[j]) == (i == j or (j in leads[i] and i in leads[j]))
        assert place[j] <= place[i] or j not in leads[i]
