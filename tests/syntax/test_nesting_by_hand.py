"""How deep brackets, powers and signs nest, token by token."""

import pytest

from mechc.syntax.fault import Fault
from mechc.syntax.limits import NESTING
from mechc.syntax.parser.lalr import Token
from mechc.syntax.parser.tokens import check_nesting, nested

TYPES = {"(": "LEFT", ")": "RIGHT", "^": "CIRCUMFLEX", "-": "MINUS", "*": "STAR", "a": "NAME"}


def tokens(text: str) -> list[Token]:
    return [Token(TYPES[sign], sign) for sign in text]


@pytest.mark.parametrize(
    ("text", "depths"),
    [
        ("", [0]),
        ("(", [0, 0]),
        ("(a)", [0]),
        ("-", [1]),
        ("--", [2]),
        ("a-", [0]),
        ("a-a-", [0]),
        ("(a)-", [0]),
        ("a-(-", [0, 1]),
        ("a^-", [2]),
        ("a^a^", [2]),
        ("a^a*", [0]),
        (")", [0]),
    ],
)
def test_a_minus_behind_an_operand_is_a_difference_and_none_that_nests(text, depths):
    found, operand = [0], False
    for token in tokens(text):
        found, operand = nested(found, operand, token)
    assert found == depths


@pytest.mark.parametrize("text", ["({}", "-{}", "a^{}"], ids=["brackets", "signs", "powers"])
def test_no_more_is_nested_than_can_be_read(text):
    sign = text.replace("{}", "")
    check_nesting(tokens(sign * NESTING + "a"))
    with pytest.raises(Fault):
        check_nesting(tokens(sign * (NESTING + 1) + "a"))


def test_a_long_sum_of_differences_does_not_nest():
    check_nesting(tokens("a-" * (4 * NESTING) + "a"))
