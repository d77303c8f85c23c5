"""What people mean by a token that does not fit: one hint for each of the usual slips."""

from collections.abc import Sequence

from ...diagnostics import near_miss
from ...units import UNITS
from ..examples import WRITTEN
from ..vocabulary import (
    CHOICE,
    DIAMETER,
    FUNCTIONS,
    LANGUAGES,
    NAME,
    RANGE,
    TWINS,
    points_of,
    split_quantity,
)
from .grammar import keywords, spelling
from .lalr import Token, span_of
from .lines import OPERAND_ENDS
from .statement_examples import example, whole_example, words_behind
from .usual_slips import (
    ASKED,
    CHOICES,
    COORDINATES,
    DIRECTIONS,
    FRICTION_OF,
    LINKED,
    SCALARS,
    STATED,
)

OPERATORS = frozenset({"PLUS", "MINUS", "PLUSMINUS", "TIMES_SIGN", "OVER", "CIRCUMFLEX"})

DOUBLED = {"*": "a power is written with '^'", "=": "equality is written '='"}


THOUSAND = 3
"""Digits behind a comma that stands for thousands, or for decimals."""

PARTED = "a ',' stands between two values"

ONE_EACH = frozenset({"PIVOT", "SLIDER", "LINK", "SLIDE", "TELESCOPE", "PARAM", "LET"})
"""A statement with one of these words is about one thing, and has no comma outside brackets."""

PICKED = ("nearest", "closest", "previous", "last", "first")
"""What people call a size of a list."""

LATER_TITLES = frozenset({"MECHANISM", "SHEET"})

OF_TEXTS = frozenset({"SOURCE", "TRANSLATE"})
"""Words of the statements that have texts only."""

FORMULAS = frozenset({"PARAM", "LET", "REQUIRE"})
"""Words of the statements that give or compare what formulas come to."""


def in_scalar(token: Token, allowed: set[str]) -> str:
    """Return a hint at what only lines have, in a value of YAML."""
    if token == "," and "AT_SIGN" in allowed:
        return f"{COORDINATES}; a direction stands behind '@'"
    return SCALARS.get(token, "")


def hint_for(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint for the slips that are made most, '' where it is none of them."""
    token, before = line[position], line[position - 1] if position else None
    return (
        _of_comment(line, position, allowed)
        or _of_label(line, position)
        or _of_text(line, position)
        or of_decimals(line, position)
        or (line[0].type in FORMULAS and of_asking(line, position, allowed))
        or _of_bracket(line, position, allowed)
        or _of_list(line, position)
        or _of_speed(line, position)
        or _of_ends(line, position, allowed)
        or _of_perpendicular(line, position)
        or _of_slide(line, position)
        or _of_friction(line, position)
        or STATED.get((line[0].type, str(token)), "")
        or _of_radius(line, position)
        or _of_name(line, position)
        or _of_vector(line, position, allowed)
        or _of_picking(line, position)
        or CHOICES.get(line[0].type, "")
        or _of_two_units(line, position)
        or _of_sense(line, position)
        or _of_neighbours(line, position, allowed)
        or (whole_example(line) if token.isalpha() and token in words_behind(line) else "")
        or _of_sign(token, before, allowed)
        or example(line, allowed)
    )


def lacks_name(line: Sequence[Token], position: int) -> bool:
    """Return whether a statement goes on where its name is missing: ``force at K along y``."""
    following = line[position + 1] if position + 1 < len(line) else ""
    return str(line[position]) in words_behind(line) and following != "="


def unfinished(line: Sequence[Token], allowed: set[str]) -> str:
    """Return a hint where a statement ends too early."""
    last = line[-1] if line else None
    if last is not None and last.type in OPERATORS:
        return f"the '{last}' has no right side"
    if last == "@":
        return "a direction stands behind '@', as in OA = a @ 30 deg"
    if ".." in {spelling().get(name) for name in allowed}:
        return RANGE
    is_text = bool(line) and line[0].type in OF_TEXTS and allowed == {"STRING"}
    return whole_example(line) if is_text or words_behind(line) else example(line, allowed)


def of_asking(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint where a table, a list or a choice is asked within a formula.

    The words ``at`` and ``when`` end the formula before them; ``next`` is taken for a name.
    """
    words = [str(token) for token in line[: position + 1]]
    if line[0].type == "REQUIRE" and words[-1] == "at" and "=" in map(str, line[position:]):
        return "a condition holds at the values given: others come by -D F=10kN behind the command"
    word = "next" if "next" in words[-4:-1] else words[-1]
    is_behind = word in ASKED and "TIMES_SIGN" in allowed
    return ASKED[word].format(WRITTEN[f"let {word}"]) if is_behind else ""


def _of_vector(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint where a vector, a place or a named result is written otherwise."""
    token, before = str(line[position]), str(line[position - 1]) if position else ""
    if "AT_SIGN" in allowed and token in (",", "<", "at", "angle", "along", "dir"):
        return "a direction stands behind '@', as in OA = a @ 30 deg"
    if token in UNITS and "(" in map(str, line[:position]) and line[0].type != "LET":
        return f"each value has its unit: (20 {token}, 35 {token})"
    if token == "=" and "at" in map(str, line[:position]) and line[position - 2] == "(":
        return "a place is two lengths: (20 mm, 35 mm)"
    if token == "," and "RIGHT" in allowed and "along" in map(str, line[:position]):
        return DIRECTIONS
    if token == "," and "RIGHT" in allowed and "at" in map(str, line[:position]):
        return "a place is two lengths, in the plane: (20 mm, 35 mm)"
    if line[0].type == "LINK" and line[position].type == "NUMBER":
        is_length = position > 1 and split_quantity(token)[1]
        return f"a length is a line of its own: {line[1]} = {token}" if is_length else LINKED
    if before == "at" and allowed == {"LEFT"}:
        return "a place stands in brackets: (0 mm, 0 mm)"
    is_named_last = line[position].type == "NAME" and "/" in map(str, line[:position])
    if line[0].type == "FIND" and (token == "=" or is_named_last):
        return "the name stands first, as in find k = P/F"
    return ""


def _of_speed(line: Sequence[Token], position: int) -> str:
    """Return a hint at the speed of a drive behind another word than ``speed``."""
    token, value = line[position], "".join(line[position + 1 : position + 2])
    unit = split_quantity(value)[1] if value[:1].isdigit() else ""
    if line[0].type != "DRIVE" or token != "at" or not (unit == "rpm" or unit.endswith("/s")):
        return ""
    return f"it is written: {' '.join(line[:position])} speed {value}"


def _of_ends(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint where the ends of a stroke, or of a spread load, are written as a range."""
    if line[position] != ".." or "to" not in {spelling().get(name) for name in allowed}:
        return ""
    return f"it is written: {' '.join([*line[:position], 'to', *line[position + 1 :][:1]])}"


def _of_perpendicular(line: Sequence[Token], position: int) -> str:
    """Return a hint at a minus between ``perp`` and its points."""
    if line[position] != "-" or line[position - 1] != "perp" or not position:
        return ""
    points = "".join(line[position + 1 : position + 2])
    return f"the '-' stands before 'perp': -perp {points or 'OA'}"


def _of_slide(line: Sequence[Token], position: int) -> str:
    """Return a hint at the friction of a slide, which has the name of its first point."""
    points = points_of("".join(line[position + 1 : position + 2]))
    if [line[0].type, str(line[position])] != ["FRICTION", "slide"] or not points:
        return ""
    rest = " ".join(line[position + 2 :])
    return f"a slide is named by its first point: friction slider {points[0]} {rest}"


def _of_friction(line: Sequence[Token], position: int) -> str:
    """Return a hint at a friction by another word, as ``guide`` for that of a slider."""
    meant = FRICTION_OF.get(str(line[position]), "")
    is_kind = line[0].type == "FRICTION" and position == 1 and meant
    return f"it is written: {WRITTEN[f'friction {meant}']}" if is_kind else ""


def _of_sense(line: Sequence[Token], position: int) -> str:
    """Return a hint where an angle is said to be clockwise, or the other way."""
    token, before = str(line[position]).lower(), line[position - 1] if position else None
    if token not in ("cw", "ccw", "clockwise", "counterclockwise", "anticlockwise"):
        return ""
    is_angle = "@" in map(str, line[:position])
    is_behind = before is not None and (before.type == "NUMBER" or is_angle)
    return "angles count counter-clockwise, clockwise ones are negative: @ -30 deg" * is_behind


def _of_two_units(line: Sequence[Token], position: int) -> str:
    """Return a hint at a quantity in two units, ``5 ft 3 in`` or ``50 deg 30 min``."""
    pair = line[max(position - 1, 0) : position + 1]
    if [token.type for token in pair] != ["NUMBER", "NUMBER"]:
        return ""
    units = [split_quantity(token)[1] for token in pair]
    if units[0] in ("deg", "°") and units[1] in ("min", "'", "s"):
        return "an angle is a decimal number of degrees: 50.5 deg"
    is_sum = all(units) and units[0] != units[1]
    return f"a quantity in two units is a sum: {pair[0]} + {pair[1]}" if is_sum else ""


def _of_comment(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint at a remark behind two strokes, or a stroke and a star, or two dashes."""
    signs = "".join(map(str, line[position : position + 2]))
    before = "".join(map(str, line[max(position - 1, 0) : position + 1]))
    is_comment = "//" in (signs, before) or signs == "/*"
    is_comment |= signs == "--" and "TIMES_SIGN" not in allowed
    return "a comment begins with '#'" if is_comment else ""


def _of_label(line: Sequence[Token], position: int) -> str:
    """Return a hint at a text behind a statement that takes none."""
    text = line[position]
    is_label = position > 1 and text.type == "STRING" and position == len(line) - 1
    if is_label and line[position - 1] == "=" and line[0].type in ("TABLE", "LIST"):
        return "rows and sizes stand in the description: table m = 1: 0.388, 0.5: 0.541"
    if is_label and line[position - 1] == "=":
        return f"a value stands without quotes: {text[1:-1]}"
    if is_label and line[position - 1].type == "NUMBER" and text[1:-1] in UNITS:
        return f"a unit stands without quotes: {line[position - 1]} {text[1:-1]}"
    return f"a label stands behind '#': # {text[1:-1]}" if is_label else ""


def _of_text(line: Sequence[Token], position: int) -> str:
    """Return a hint at a text without quotes: a title, a label, a source."""
    token, before = line[position], str(line[position - 1]) if position else ""
    if line[0].type in LATER_TITLES and token in LANGUAGES and position > 2:
        return f'a title in another language is a line: translate "{line[2][1:-1]}" {token} "…"'
    is_title = line[0].type in LATER_TITLES and position == 2
    if is_title and token.type == "NAME" and line[-1].type == "STRING":
        words = [word for word in line[1:] if word.type == "NAME"]
        return f"a name is one word: {'_'.join(words)}"
    if is_title and all(word.type == "NAME" and word.islower() for word in line[1:]):
        example = WRITTEN[str(line[0])]
        return f"a name is one word, {'_'.join(line[1:])}, and a title has quotes: {example}"
    if token.type == "NAME" and (is_title or before in ("as", "source")):
        rest = " ".join(map(str, line[position:]))
        return f'a text stands in double quotes: {before} "{rest}"'
    return ""


def _of_picking(line: Sequence[Token], position: int) -> str:
    """Return a hint at a size that is picked from a list by another word than ``next``."""
    before = str(line[position - 1]) if position else ""
    picks = line[0].type == "LET" and before in PICKED and "in" in map(str, line[position:])
    return ASKED["next"].format(WRITTEN["let next"]) if picks else ""


def of_decimals(line: Sequence[Token], position: int) -> str:
    """Return a hint at a comma that does not fit, where one stands in a number."""
    triples = zip(line, line[1:], line[2:], strict=False)
    parts = [triple[-1] for triple in triples if _is_decimal_comma(*triple)]
    if line[position] != "," or not parts:
        return ""
    whole = line[list(line).index(parts[0]) - 2]
    is_thousand = len(split_quantity(parts[0])[0]) == THOUSAND and whole != "0"
    return f"decimals are written with a point{', thousands together: 3000' * is_thousand}"


def _is_decimal_comma(whole: Token, comma: Token, part: Token) -> bool:
    """Return whether a comma without a space stands in a number: ``8,25 in``."""
    glued = span_of(whole).end == span_of(comma).start < span_of(comma).end == span_of(part).start
    return glued and comma == "," and whole.isdecimal() and part[:1].isdecimal()


def _of_bracket(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint where a formula ends, or is compared, inside a bracket that is still open."""
    token = line[position]
    ends = str(token) in keywords() or token.type == "COMPARISON"
    if ends and "RIGHT" in allowed and line[0].type in FORMULAS:
        return f"a bracket is not closed: ')' is missing before '{token}'"
    return ""


def _of_list(line: Sequence[Token], position: int) -> str:
    """Return a hint where points or things are listed that are written otherwise."""
    first, before, token = line[0], line[position - 1], line[position]
    if first.type == "LINK" and points_of(token) and not points_of(before):
        return f'what a link is called stands behind its points: link {token} "{before}"'
    if first.type == "LINK" and position == 2 and token.islower() and token.type == "NAME":
        return f'what a link is called stands in double quotes: link {before} "{token}"'
    if first.type in ("LINK", "TELESCOPE") and token.type in ("MINUS", "NAME"):
        return f"the points of a {first} are written together, as in {first} OB"
    if first.type == "REPORT" and token.type == "NAME" and before.type == "NAME":
        return f"a ',' stands between what a report holds: {before}, {token}"
    if first.type == "LOAD" and token.type == "AT":
        return "a load at a point is a force: force F at A along x"
    if first.type in ("TABLE", "LIST") and token.type != "COMMA":
        return f"it is written: {WRITTEN[str(first)]}"
    listed = token == "," and first.type in ONE_EACH
    return f"each {first} has a line of its own" if listed else ""


def _of_radius(line: Sequence[Token], position: int) -> str:
    """Return a hint where the size of a wheel is announced by a word that is not ``radius``."""
    words = [str(token) for token in line[: position + 1]]
    is_wheel = line[0].type in ("RACK", "GEAR", "BELT")
    if is_wheel and (words[-1] == "diameter" or words[-2:-1] == ["r"]):
        return f"a wheel has its radius there: {WRITTEN[words[0]]}"
    return ""


def _of_name(line: Sequence[Token], position: int) -> str:
    """Return a hint where a name that is given is cut by a hyphen."""
    if position != 2 or line[0].type not in ("PARAM", "LET", "FORCE", "TORQUE", "MECHANISM"):
        return ""
    before, token, behind = line[1], line[2], line[3] if len(line) > 3 else None
    glued = span_of(before).end == span_of(token).start
    if token.type == "MINUS" and glued and behind is not None and NAME.fullmatch(str(behind)):
        return f"a name has no '-': write {before}_{behind}"
    return ""


def _of_neighbours(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint where two operands, or a function and its argument, stand side by side."""
    token, before = line[position], line[position - 1] if position else None
    text, previous = str(token), str(before or "")
    if token.type == "NUMBER" and before is not None and before.type == "NUMBER":
        return _of_two_numbers(before, line[position + 1 : position + 2], allowed)
    if text == previous and text in DOUBLED:
        return DOUBLED[text]
    if previous == "if":
        return CHOICE
    if previous in FUNCTIONS or previous in TWINS:
        return f"a function needs brackets: {previous}({text})"
    if previous.lower() in ("inf", "infinity", "nan"):
        return "a value is a number, and finite"
    words = [word for name in allowed if (word := spelling().get(name, "")).isalpha()]
    if token.type == "NAME" and (hint := near_miss(text, words)):
        return hint
    if token.type in ("NAME", "LEFT") and before is not None and before.type in OPERAND_ENDS:
        if before.type == "NUMBER" and split_quantity(before)[1]:
            return PARTED if "COMMA" in allowed else ""
        return _of_product(line, position, allowed)
    return ""


def _of_two_numbers(first: Token, behind: Sequence[Token], allowed: set[str]) -> str:
    """Return a hint at a number before another one, by its unit and what stands behind both."""
    unit = split_quantity(first)[1]
    if unit == "in":
        return RANGE
    if unit:
        return PARTED if "COMMA" in allowed else ""
    if behind == ["/"]:
        return "a fraction is a part of one number with a point: 7 7/8 is 7.875"
    return "digits stand together, as in 1200 mm"


def _of_product(line: Sequence[Token], position: int, allowed: set[str]) -> str:
    """Return a hint where a name or a bracket stands behind an operand."""
    words = [str(token) for token in line[: position + 2]]
    if words[position] == "(" and words[position + 1 :] and words[position + 1] in UNITS:
        return f"a unit stands without brackets: {words[position - 1]} {words[position + 1]}"
    if words[position] == "(" and words[position - 2 : position - 1] == ["^"]:
        function, power = words[position - 3], words[position - 1]
        if function in FUNCTIONS or function in TWINS:
            return f"a power of a function stands behind it: {function}(…)^{power}"
    if (words[0], words[position]) == ("friction", "radius"):
        return DIAMETER
    if (words[0], words[position]) == ("let", "of"):
        return ASKED["at"].format(WRITTEN["let at"])
    is_formula = line[0].type in FORMULAS | {"EXPECT", "NAME", "NUMBER"} or words[0] in FUNCTIONS
    return "a product is written with '*'" if is_formula and "TIMES_SIGN" in allowed else ""


def _of_sign(token: Token, before: Token | None, allowed: set[str]) -> str:
    """Return a hint where a sign or a word of the language means something else here."""
    text, previous = str(token), str(before or "")
    if text == "+-":
        return "a tolerance belongs to a param or an expect; a difference is written a - b"
    if text == "=" and previous in ("<", ">"):
        return f"it is written '{previous}='"
    if previous == "=" and text in ("<", ">"):
        return f"it is written '{text}='"
    if previous + text == "+/":
        return "a tolerance is written '+-' or '±'"
    if before is not None and before.type in OPERATORS:
        return f"the '{before}' has no right side"
    if text in ("to", "from") and {"..", "in"} & {spelling().get(name) for name in allowed}:
        return RANGE
    if text == ":" and ".." in {spelling().get(name) for name in allowed}:
        return RANGE
    if text == ":" and "=" in {spelling().get(name) for name in allowed}:
        return f"what follows a name stands behind '=': {previous} = …"
    if text == ":" and "TIMES_SIGN" in allowed:
        return "a quotient is written with '/'"
    if previous == "@" and text == "along":
        return "the direction itself stands behind '@', as in OA = a @ OB"
    if text in keywords() and "NAME" in allowed:
        return f"'{text}' is a word of the language and cannot be a name"
    return ""
