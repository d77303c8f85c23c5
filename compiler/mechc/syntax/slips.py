"""What people mean by a token that does not fit: one hint for each of the usual slips."""

from collections.abc import Sequence

from ..diagnostics import near_miss
from .grammar import keywords, spelling
from .lalr import Token
from .spans import span_of
from .vocabulary import FUNCTIONS, NAME, RANGE, TWINS, split_quantity

ENDS = frozenset({"NAME", "NUMBER", "RIGHT"})
"""An operand ends with one of these."""

OPERATORS = frozenset({"PLUS", "MINUS", "PLUSMINUS", "TIMES_SIGN", "OVER", "CIRCUMFLEX"})

DOUBLED = {"*": "a power is written with '^'", "=": "equality is written '='"}

STATED = {
    ("TORQUE", "at"): "a couple acts on a link: torque M on OA",
    ("FORCE", "on"): "a force acts at a point: force F at A along x",
    ("SLIDER", "at"): "a guide has a direction, slider K along 90 deg, and its point a place in a "
    "line of its own: K at (0 mm, 80 mm)",
    ("PIVOT", "("): "the place of a pivot stands behind 'at': pivot O at (0 mm, 0 mm)",
    ("SPRING", "between"): "the rate comes first: spring 5 N/mm between A and B",
    ("WEIGHT", "="): "a weight has a mass: weight W mass 2 kg at G",
    ("WEIGHT", "at"): "a weight has a mass: weight W mass 2 kg at G",
}
"""What is said otherwise in a statement, by its word and what does not fit in it."""

WRITTEN = {
    "DRIVE": "a stroke is written: drive phi from 10 deg to 80 deg",
    "ASSEMBLY": "ccw is counter-clockwise, cw clockwise; along a guide it is forward or back",
}
"""How a statement is written, whatever does not fit in it."""


def hint_for(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint for the slips that are made most, '' where it is none of them."""
    token, before = line[position], line[position - 1] if position else None
    return (
        _of_list(token, line[0])
        or STATED.get((line[0].type, str(token)), "")
        or _of_name(line, position)
        or _of_neighbours(token, before, allowed)
        or _of_sign(token, before, allowed)
        or _of_vector(line, position, allowed)
        or WRITTEN.get(line[0].type, "")
    )


def unfinished(line: Sequence[Token], allowed: set[str]) -> str:
    """Return a hint where a statement ends too early."""
    last = line[-1] if line else None
    if last is not None and last.type in OPERATORS:
        return f"the '{last}' has no right side"
    if last == "@":
        return "a direction stands behind '@', as in OA = a @ 30 deg"
    return RANGE if ".." in {spelling().get(name) for name in allowed} else ""


def _of_vector(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint where a vector, a place or a named result is written otherwise."""
    token, before = str(line[position]), str(line[position - 1]) if position else ""
    if "AT_SIGN" in allowed and token in (",", "<", "at"):
        return "a direction stands behind '@', as in OA = a @ 30 deg"
    if before == "at" and allowed == {"LEFT"}:
        return "a place stands in brackets: (0 mm, 0 mm)"
    if line[0].type == "FIND" and token == "=":
        return "the name stands first, as in find k = P/F"
    return ""


def _of_list(token: Token, first: Token) -> str:
    """Return a hint where points or things are listed that are written otherwise."""
    if first.type in ("LINK", "TELESCOPE") and token.type in ("MINUS", "NAME"):
        return f"the points of a {first} are written together, as in {first} OB"
    if first.type == "LOAD" and token.type == "AT":
        return "a load at a point is a force: force F at A along x"
    if first.type == "TELESCOPE" and token.type == "STRING":
        return "a telescope has no title: say it in a comment, behind '#'"
    listed = token == "," and first.type in ("PIVOT", "SLIDER", "LINK", "SLIDE", "TELESCOPE")
    return f"each {first} has a line of its own" if listed else ""


def _of_name(line: Sequence[Token], position: int) -> str:
    """Return a hint where a name that is given is cut by a hyphen."""
    if position != 2 or line[0].type not in ("PARAM", "LET", "FORCE", "TORQUE", "MECHANISM"):
        return ""
    before, token, behind = line[1], line[2], line[3] if len(line) > 3 else None
    glued = span_of(before).end == span_of(token).start
    if token.type == "MINUS" and glued and behind is not None and NAME.fullmatch(str(behind)):
        return f"a name has no '-': write {before}_{behind}"
    return ""


def _of_neighbours(token: Token, before: Token | None, allowed: set[str]) -> str:
    """Return a hint where two operands, or a function and its argument, stand side by side."""
    text, previous = str(token), str(before or "")
    if token.type == "NUMBER" and before is not None and before.type == "NUMBER":
        if split_quantity(before)[1] == "in":
            return RANGE
        return "digits stand together, as in 1200 mm"
    if text == previous and text in DOUBLED:
        return DOUBLED[text]
    if text == previous == "/":
        return "a comment begins with '#'"
    if previous in FUNCTIONS or previous in TWINS:
        return f"a function needs brackets: {previous}({text})"
    if previous.lower() in ("inf", "infinity", "nan"):
        return "a value is a number, and finite"
    words = [word for name in allowed if (word := spelling().get(name, "")).isalpha()]
    if token.type == "NAME" and (hint := near_miss(text, words)):
        return hint
    if token.type in ("NAME", "LEFT") and before is not None and before.type in ENDS:
        return "a product is written with '*'" if "TIMES_SIGN" in allowed else ""
    return ""


def _of_sign(token: Token, before: Token | None, allowed: set[str]) -> str:
    """Return a hint where a sign or a word of the language means something else here."""
    text, previous = str(token), str(before or "")
    if text == "," and previous.isdecimal() and "RIGHT" not in allowed:
        return "decimals are written with a point"
    if text == "+-":
        return "a tolerance belongs to a param or an expect; a difference is written a - b"
    if previous + text == "+/":
        return "a tolerance is written '+-' or '±'"
    if before is not None and before.type in OPERATORS:
        return f"the '{before}' has no right side"
    if text in ("to", "from") and {"..", "in"} & {spelling().get(name) for name in allowed}:
        return RANGE
    if text == ":" and "TIMES_SIGN" in allowed:
        return "a quotient is written with '/'"
    if text in keywords() and "NAME" in allowed:
        return f"'{text}' is a word of the language and cannot be a name"
    return ""
