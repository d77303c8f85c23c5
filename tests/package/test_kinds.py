"""Kinds that are words: members of a class, and strings."""

import copy
import pickle

import pytest

from mechc.base.string_enum import Word


class Side(Word):
    """A side of a line."""

    LEFT = "left"
    """Where one looks along it."""
    RIGHT = "right"
    _BOTH = "left and right"


def test_a_member_is_a_word_and_knows_its_name() -> None:
    assert isinstance(Side.LEFT, Side)
    assert Side.LEFT == "left"
    assert {"left": 1}[Side.LEFT] == 1
    assert (Side.LEFT.name, Side.LEFT.value, type(Side.LEFT.value)) == ("LEFT", "left", str)
    assert (repr(Side.LEFT), str(Side.LEFT)) == ("<Side.LEFT: 'left'>", "left")
    assert Side._BOTH == "left and right"
    assert not isinstance(Side._BOTH, Side)


def test_members_are_found_by_their_words_and_come_in_order() -> None:
    assert Side("right") is Side.RIGHT
    assert list(Side) == [Side.LEFT, Side.RIGHT]
    with pytest.raises(ValueError, match="'up' is no Side"):
        Side("up")


def test_a_copy_is_the_same_member() -> None:
    for copied in (copy.copy, copy.deepcopy, lambda side: pickle.loads(pickle.dumps(side))):
        assert copied(Side.LEFT) is Side.LEFT
