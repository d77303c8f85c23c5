"""Which parts of a name are words."""

import pytest

from mechc.formula.names import is_word


@pytest.mark.parametrize("part", ["far", "dP", "in"])
def test_several_letters_are_a_word(part):
    assert is_word(part)


@pytest.mark.parametrize("part", ["k", "alpha", "mu", "OB", "x1", "12", ""])
def test_a_letter_a_point_and_a_number_are_none(part):
    assert not is_word(part)
