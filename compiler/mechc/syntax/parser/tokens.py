"""Text to tokens: units joined to their numbers, strange characters and long numbers refused.

A token's ``start_pos`` and ``end_pos`` are offsets into the user's text. For a scalar of
YAML they differ from those in the scalar's value, so the caller passes the ``places``.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import takewhile
from typing import TYPE_CHECKING

from ...diagnostics import Diagnostic, syntax, syntax_limits
from ...source import Span
from ...units import UNITS
from .. import limits
from ..fault import Fault
from ..vocabulary import (
    CHOICE,
    DIAMETER,
    FIT,
    FIT_OF_A_HOLE,
    IN_A_UNIT,
    OF_A_PIN,
    POINT,
    RANGE,
    WRAP,
    split_quantity,
)
from . import unit_words
from .grammar import lexed
from .lalr import Token, span_of

if TYPE_CHECKING:
    from . import strange as characters
else:
    from ...base.later import Later

    characters = Later("mechc.syntax.parser.strange")

NextAfter = Callable[[int], int]

LONGEST_UNIT = max(map(len, UNITS))

BEGINS_OPERAND = frozenset({"NAME", "NUMBER", "LEFT", "PLUS", "MINUS"})

BLANKS = frozenset(" \t\u00a0\u2007\u2009\u202f")
"""What may stand between a number and its unit: word processors put spaces that do not break."""


def tokens(text: str, places: NextAfter | None = None) -> list[Token]:
    """Return the tokens of a text, with comments and line ends, units joined to numbers."""
    found = list(with_units(text, [plus_minus(token) for token in lexed(text)]))
    return [moved(token, places) for token in found] if places else found


def plus_minus(token: Token) -> Token:
    """Return the sign ± as ``+-``, which it is another spelling of."""
    return Token("PLUSMINUS", "+-", *span_of(token)) if token == "±" else token


def moved(token: Token, places: NextAfter) -> Token:
    """Return a token with its place in the user's text."""
    start, end = span_of(token)
    return Token(token.type, str(token), places(start), places(max(start, end - 1)) + 1)


def with_units(text: str, found: list[Token]) -> Iterator[Token]:
    """Join each number with the unit behind it."""
    end, begins_formula = 0, False
    for position, token in enumerate(found):
        if position == 0 or found[position - 1].type == "NEWLINE":
            begins_formula = token in ("let", "next")
        start, stop = span_of(token)
        if start < end:
            continue
        bare = token.type == "NUMBER" and not token.endswith('"')
        unit = unit_behind(text, stop) if bare else None
        if unit is None or (unit == "in" and is_word(found[position + 1 :], begins_formula)):
            yield token
        else:
            end = span_of(unit)[1]
            yield Token("NUMBER", f"{token} {unit}", start, end)


def unit_behind(text: str, at: int) -> Token | None:
    """Return the longest unit that begins here or after blanks.

    None ends in the middle of a word: in ``5 N*mass`` the unit is N.
    """
    while text[at : at + 1] in BLANKS:
        at += 1
    for end in range(min(at + LONGEST_UNIT, len(text)), at, -1):
        unit = text[at:end]
        if unit in UNITS and (unit.endswith("°") or not _goes_on(text, end)):
            return Token("UNIT", unit, at, end)
    return None


def _goes_on(text: str, at: int) -> bool:
    """Return whether a letter, a digit or a prime stands at a place."""
    return at < len(text) and (text[at].isalnum() or text[at] in "_'")


def is_word(found: Sequence[Token], formula: bool) -> bool:
    """Return whether the word ``in``, the first of these, is no inch.

    It begins a range or, in a user-defined formula, stands before a unit or a list:
    ``F/d^2 in MPa``.
    """
    before = formula and len(found) > 1 and found[1].type in ("NAME", "NUMBER")
    return before or begins_range(found)


def begins_range(found: Sequence[Token]) -> bool:
    """Return whether the word ``in``, the first of these, begins a range and is no inch.

    In ``8 in - 2 in in 1 in .. 9 in`` that is the last one before the dots that an end follows.
    """
    line = list(takewhile(lambda t: t.type != "NEWLINE" and t != "..", found))
    if len(line) == len(found) or found[len(line)] != "..":
        return False
    ranges = (i for i, t in enumerate(line[1:]) if t.type in BEGINS_OPERAND and line[i] == "in")
    return max(ranges, default=-1) == 0


def check(line: Iterable[Token]) -> None:
    """Refuse what the grammar cannot speak of: strange characters, sizes, glued units."""
    before: Token | None = None
    line = list(line)
    for position, token in enumerate(line):
        if token.type == "STRANGE":
            raise Fault(strange(line, position))
        if token.type == "NUMBER":
            check_number(token)
        if before is not None and before.type == "NUMBER":
            check_unit(before, token, line[0])
        before = token
    check_nesting(line)
    check_cases(line)


def dotted(before: Token | None, behind: Token | None) -> str:
    """Return a hint at what a single dot was meant as, by what is on either side; '' if unclear."""
    if behind is None or behind.type != "NAME":
        return ""
    if behind.lower() in ("inf", "nan"):
        return "a value is a number, and finite"
    if before is None or before.type not in ("NUMBER", "NAME"):
        return ""
    if before.type == "NAME" and behind in ("mech", "yaml", "yml"):
        return f'a file is named in quotes: "{before}.{behind}"'
    if before.type == "NAME":
        return f"a name has no dot: write {before}_{behind}"
    unit = split_quantity(before)[1]
    return f"units are multiplied with '*', as in {unit}*{behind}" if unit else ""


def strange(line: Sequence[Token], position: int) -> Diagnostic:
    """Return the error about a character outside the language."""
    token = line[position]
    span, character = span_of(token), str(token)
    if character.startswith('"'):
        return syntax.unclosed_text(span)
    before = line[position - 1] if position else None
    behind = line[position + 1] if position + 1 < len(line) else None
    hint = dotted(before, behind) if character == "." else ""
    hint = hint or characters.meaning(line, position)
    return syntax.unexpected_character(Span(span.start, span.start + 1), character, hint)


def check_number(token: Token) -> None:
    """Refuse numbers that are too long or too large to keep exactly."""
    digits, _ = split_quantity(token)
    mantissa, _, exponent = digits.lower().partition("e")
    if sum(c.isdigit() for c in mantissa) > limits.MOST_DIGITS:
        raise Fault(syntax_limits.number_too_long(span_of(token), limits.MOST_DIGITS))
    power = exponent.lstrip("+-0")
    if len(power) > 3 or int(power or 0) > limits.DECIMAL_EXPONENT:
        limit = limits.DECIMAL_EXPONENT
        raise Fault(syntax_limits.exponent_too_large(span_of(token), exponent[:8], limit))


OF_POINTS = frozenset({"pivot", "slider", "link", "telescope", "slide"})
"""Words of the statements that begin with points."""


def check_unit(number: Token, behind: Token, first: Token) -> None:
    """Refuse a word behind a number that is no unit, and ``5 mm^7`` (is the unit cubed?)."""
    unit = split_quantity(number)[1]
    if behind.type == "NAME":
        plain = [name for name in UNITS if name.isalpha()]
        meant = unit_words.unit_meant(behind)
        if unit not in ("", "in") and not meant and behind not in UNITS:
            return  # the number has its unit, so that this is no other
        hint = unit_words.hint_of(behind) or (RANGE if unit == "in" else "")
        hint = CHOICE if behind in ("if", "otherwise", "unless") else hint
        hint = DIAMETER if first == "friction" and behind in OF_A_PIN else hint
        hint = WRAP if first == "friction" and behind == "wrap" else hint
        hint = FIT if FIT_OF_A_HOLE.fullmatch(behind) else hint
        if behind in ("O", "o") and span_of(number).end == span_of(behind).start:
            hint = f"if the figure 0 is meant, and not the letter: {number}0"
        if first in OF_POINTS and POINT.fullmatch(behind):
            hint = f"the number of a point stands behind its letter: {behind}{number}"
        if unit and behind in UNITS:
            hint = f"a compound unit has no spaces, as in {unit}*{behind}"
            hint = IN_A_UNIT if unit == "in" else hint
        raise Fault(syntax.unknown_unit(span_of(behind), str(behind), plain, hint))
    if unit and behind.type == "CIRCUMFLEX" and span_of(number).end == span_of(behind).start:
        span = Span(span_of(number).end - len(unit), span_of(behind).end)
        power = f"a power of a quantity is written ({number})^…"
        raise Fault(syntax.unknown_unit(span, f"{unit}^", (), power))


def check_cases(line: Iterable[Token]) -> None:
    """Refuse choices of more cases than anybody reads, each in the ``else`` of the one before."""
    cases = [token for token in line if token.type == "WHEN"]
    if len(cases) > limits.NESTING:
        raise Fault(syntax_limits.nested_too_deep(span_of(cases[-1]), limits.NESTING))


def check_nesting(line: Iterable[Token]) -> None:
    """Refuse brackets, powers of powers and repeated signs that nest too deep."""
    depths, operand = [0], False
    for token in line:
        depths, operand = nested(depths, operand, token)
        if len(depths) + sum(depths) > limits.NESTING + 1:
            raise Fault(syntax_limits.nested_too_deep(span_of(token), limits.NESTING))


def nested(depths: list[int], operand: bool, token: Token) -> tuple[list[int], bool]:
    """Follow one token: ``depths`` has, for each open bracket, the powers and signs in it.

    ``operand`` states whether an operand has just ended, so that a minus is a difference.
    """
    match token.type:
        case "LEFT":
            return [*depths, 0], False
        case "RIGHT":
            return depths[:-1] or [0], True
        case "CIRCUMFLEX":
            return [*depths[:-1], depths[-1] + 1], False
        case "MINUS" if not operand:
            return [*depths[:-1], depths[-1] + 1], False
        case "NAME" | "NUMBER":
            return depths, True
        case _:
            return [*depths[:-1], 0], False
