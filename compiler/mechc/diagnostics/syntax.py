"""The words of errors in the text itself, in either notation (E1xx).

Those of YAML's shape are in :mod:`.syntax_yaml`, those of size in :mod:`.syntax_limits`.
"""

import re
from collections.abc import Iterable

from ..source import Span
from ..units import UNITS
from .diagnostic import Message, Related, coded, near_miss


def listed(words: Iterable[str], last: str = "or") -> str:
    """Join words as in speech.

    >>> listed(["a name", "'('", "a number"])
    "a name, '(' or a number"
    """
    *front, final = words
    return f"{', '.join(front)} {last} {final}" if front else final


WITH_FRICTION = (
    "an efficiency comes with friction: beside `find k = P/F` the line "
    "`friction pins 0.1 diameter 10 mm` gives eta_k"
)


@coded("E101")
def unexpected_text(span: Span, found: str, expected: list[str], hint: str = "") -> Message:
    """A statement has the wrong word or sign at this place.

    Each statement has one order of words, and the message lists what may stand at
    the marked place.

        slider K 90 deg          # wrong: 'along' is missing
        slider K along 90 deg    # right
    """
    hint = hint or f"write what is expected, or leave {found} out"
    return Message(span, f"found {found}, expected {listed(expected)}", hint)


@coded("E102")
def unknown_statement(span: Span, word: str, known: Iterable[str], hint: str = "") -> Message:
    """A line begins with a word that no statement begins with.

    Every line of a description is one statement: it begins with the statement's word
    (``param``, ``pivot``, ``link`` …) or is a vector between two points (``AB = …``).

        pivott O      # wrong
        pivot  O      # right
        a = 40 mm     # wrong: a parameter is declared
        param a = 40 mm
    """
    known = list(known)
    message = f"no statement begins with '{word}'"
    return Message(
        span, message, hint or near_miss(word, known) or f"statements: {', '.join(known)}"
    )


@coded("E103")
def unknown_unit(
    span: Span, unit: str, known: Iterable[str], hint: str = "", where: str = " behind a number"
) -> Message:
    """The word behind a number, or behind the ``in`` of a result, is no unit.

    A unit follows its number directly or after a space; a compound unit has no spaces
    inside. A product with a parameter is written with ``*``.

        param l = 40 milimeter   # wrong
        param l = 40 mm          # right
        param l = 8 in in 7 in .. 9 in   # right: inches, from seven to nine
        let s = 2 l              # wrong: l is a parameter
        let s = 2*l              # right
    """
    product = f"a product is written with '*', as in 2*{unit}" if _is_name(unit) else ""
    product = _OTHER_UNITS.get(unit, product)
    spaces = "a compound unit has no spaces, as in 2 m/s^2"
    usual = product or spaces if where else "name a unit such as mm, kN, MPa or cm^3"
    if not where and unit.lower() in ("l", "liter", "litre", "liters", "litres"):
        hint = "a litre is a dm^3"
    return Message(span, f"'{unit}'{where} is not a unit", hint or near_miss(unit, known) or usual)


def _is_name(word: str) -> bool:
    """Return whether a word is rather a name than a unit: ``sigma_T``, not ``kg_m``.

    >>> [_is_name(word) for word in ("l", "sigma_T", "m/s", "mm^", "kg_m")]
    [True, True, False, False, False]
    """
    parts = word.split("_")
    return word.replace("_", "").isalnum() and (len(parts) == 1 or parts[0] not in UNITS)


_OTHER_UNITS = {
    **dict.fromkeys(("hp", "PS", "HP"), "a horsepower is 745.7 W, a metric one 735.5 W"),
    **dict.fromkeys(("h", "hr", "hour", "hours"), "an hour is 3600 s"),
    **dict.fromkeys(("nm",), "a nanometre is 1e-3 um; a torque is in N*m"),
    "min": "a range stands behind 'in': in LOW .. HIGH; minutes are min behind a number",
}
"""Units that mechc does not know, and what there is in their place."""


@coded("E104")
def unknown_function(span: Span, name: str, known: Iterable[str]) -> Message:
    """A name before a bracket is no function of the language.

    The functions are sin cos tan cot sec csc asin acos atan atan2 sqrt hypot abs min max
    exp log; tg, ctg, cosec, arcsin, arccos, arctan, arctg and ln are read as their twins.
    A product with a bracket needs its sign.

        let k = sinn(alpha)      # wrong
        let k = sin(alpha)       # right
        let s = a(1 + e)         # wrong
        let s = a*(1 + e)        # right
        let q = m(2*r)           # wrong: m is a table
        let q = m at 2*r         # right
    """
    known = list(known)
    hint = (
        _WRITTEN_OTHERWISE.get(name.lower(), "")
        or near_miss(name, known)
        or near_miss(name.lower(), known)
        or f"for a product write {name}*(…), for a table {name} at …"
    )
    return Message(span, f"'{name}' is not a function", hint)


_WRITTEN_OTHERWISE = {
    "cbrt": "a cube root is written x^(1/3)",
    "root": "a root is written sqrt(x), or x^(1/3)",
    "pow": "a power is written x^3",
    "power": "a power is written x^3",
    "sqr": "a square is written x^2",
    "log10": "the logarithm to base 10 is log(x)/log(10)",
    "lg": "the logarithm to base 10 is log(x)/log(10)",
    "rad": "an angle carries its unit, as in 12 deg",
    "radians": "an angle carries its unit, as in 12 deg",
    "deg": "an angle carries its unit, as in 12 deg",
    "degrees": "an angle carries its unit, as in 12 deg",
    "if": "a choice is written: a when x < 1 mm else b",
    "ceil": "the next of the sizes of a list is written: next d in sizes",
    **dict.fromkeys(
        ("round", "floor", "int", "trunc"),
        "nothing rounds; the next of the sizes of a list is written: next d in sizes",
    ),
    "roundup": "the next of the sizes of a list is written: next d in sizes",
}
"""Functions of other languages, and what there is here in their place."""


@coded("E105")
def wrong_argument_count(span: Span, name: str, found: int, expected: str) -> Message:
    """A function has too few or too many arguments.

    let r = atan2(y)         # wrong
    let r = atan2(y, x)      # right: first y, then x
    """
    hint = "atan2 takes y, then x: atan2(y, x)" if name == "atan2" else _COUNT_ARGUMENTS
    return Message(span, f"{name} takes {expected}, found {found}", hint)


_COUNT_ARGUMENTS = "arguments stand in brackets, with commas between them"


@coded("E106")
def reserved_word(span: Span, word: str) -> Message:
    """A word of the language was taken as a name.

    The words that statements are made of, the functions and ``pi`` are reserved, so
    that a line reads one way only.

        param at = 40 mm         # wrong
        param a_t = 40 mm        # right
    """
    hint = f"choose another name, say {word}_1"
    return Message(span, f"'{word}' is a word of the language and cannot be a name", hint)


@coded("E107")
def unclosed_bracket(span: Span, bracket: str) -> Message:
    """A bracket is opened and never closed, or closed and never opened.

    let k = 2*(a + b         # wrong
    let k = 2*(a + b)        # right
    """
    match bracket:
        case ")":
            return Message(span, "this ')' closes nothing", "remove it, or open a '(' before it")
        case _:
            return Message(span, "this '(' is never closed", "add a ')'")


@coded("E108")
def unfinished_statement(span: Span, expected: list[str], hint: str = "") -> Message:
    """A statement ends before it is complete.

    force P at A             # wrong: in which direction?
    force P at A along x     # right
    """
    hint = hint or "go on with what is expected"
    return Message(span, f"the statement ends here, expected {listed(expected)}", hint)


@coded("E109")
def missing_equals(span: Span, found: str, hint: str = "") -> Message:
    """An ``=`` is missing between a name and its value.

    param a 40 mm            # wrong
    param a = 40 mm          # right
    """
    message = f"found {found}, expected '=' and a value"
    return Message(span, message, hint or "write NAME = VALUE")


@coded("E110")
def not_a_point(span: Span, text: str, expected: str, hint: str = "") -> Message:
    """A point's name was expected.

    A point is a capital letter with optional digits or primes: A, B2, O1, K'. A link is
    named by its points written together: OBA.

        pivot o                  # wrong
        pivot O                  # right
    """
    rule = "a point is a capital letter with optional digits or primes: A, B2, K'"
    return Message(span, f"found '{text}', expected {expected}", hint or rule)


@coded("E111")
def wrong_point_count(span: Span, text: str, found: int, expected: str) -> Message:
    """A link, a line or an angle is named by another number of points.

    telescope ABC            # wrong: it has two ends
    telescope AB             # right
    angle AB = 30 deg        # wrong: an angle is at the middle one of three
    angle ABC = 30 deg       # right
    """
    points = "1 point" if found == 1 else f"{found} points"
    hint = "name fewer points, or more"
    if found == 2 and "the corner" in expected:
        hint = f"the direction of a vector stands behind '@': {text} = @ 30 deg"
    if found > 2 and "two points" in expected:
        hint = "name two of them"
    if found == 1:
        hint = "a link is named by its points, written together: OA"
    if expected == "a point":
        hint = f"a joint is named by the one point at which it is: {_one_of(text)}"
    return Message(span, f"'{text}' names {points}, expected {expected}", hint)


def _one_of(points: str) -> str:
    """Return the points of a text that names several, one of which is meant.

    >>> _one_of("OC"), _one_of("JJ"), _one_of("A2B'C")
    ('O or C', 'J', "A2, B' or C")
    """
    *others, last = dict.fromkeys(re.findall(r"[A-Z][0-9]*'*", points))
    return f"{', '.join(others)} or {last}" if others else last


@coded("E112")
def unexpected_character(span: Span, character: str, hint: str) -> Message:
    """A character that the language does not have.

    Names are written in Latin letters, digits and underscores; operators are
    ``+ - * / ^``. Of other signs only those of units are read, behind a number: ``12°``,
    ``5 µm``, ``8"``.

        param α = 12°            # wrong
        param alpha = 12°        # right
    """
    shown = f"'{character}'" if character.isprintable() else f"U+{ord(character):04X}"
    return Message(span, f"unexpected character {shown}", hint or "leave it out")


@coded("E113")
def unclosed_text(span: Span) -> Message:
    """A text in quotes does not end on its line.

    source "Karpenko 2023    # wrong
    source "Karpenko 2023"   # right
    """
    return Message(span, "this text is not closed", 'end it with "')


@coded("E114")
def stated_twice(span: Span, what: str, first: Span) -> Message:
    """Something that can be said only once is said twice.

    One description has one ``mechanism`` or ``sheet`` line, one ``source``, one ``mirror``,
    ``copies``, ``gravity``, ``motion`` and ``efficiency``.
    """
    related = (Related(first, "first stated here"),)
    return Message(span, f"'{what}' is stated twice", "remove one of the two", related)


@coded("E115")
def unknown_version(span: Span, number: str) -> Message:
    """The first line names a version of the language that this compiler does not know.

    mechc 7                  # wrong, today
    mechc 1                  # right
    """
    return Message(span, f"found language version {number}, expected 1", "write 'mechc 1'")


@coded("E116")
def version_not_first(span: Span) -> Message:
    """The language version must be known before anything else is read.

    ``mechc 1`` is the first statement of a file, or it is left out.
    """
    return Message(span, "'mechc' is not the first statement", "move it to the top")


@coded("E117")
def empty_parameter(span: Span, name: str) -> Message:
    """A parameter has neither a value nor a dimension nor a range.

    param a                  # wrong: a length? an angle?
    param a = 40 mm          # right
    param a: length          # right: a length without a value
    """
    hint = f"write 'param {name} = 40 mm' or 'param {name}: length'"
    return Message(span, f"parameter '{name}' has no value and no dimension", hint)


@coded("E118")
def not_a_name(span: Span, text: str, expected: str) -> Message:
    """A name was expected: a letter, then letters, digits, underscores or primes.

    params: {2a: 40 mm}      # wrong
    params: {a2: 40 mm}      # right
    """
    meant = re.sub(r"\W+", "_", text, flags=re.ASCII).strip("_")
    foreign = "write it in Latin letters, as in clamp_2"
    begin = "begin with a letter, as in a2" if text.isascii() else foreign
    hint = f"write {meant}" if meant[:1].isalpha() else begin
    if "/" in text:
        hint = f"the name stands before the formula, as in k: {text}"
    if pair := re.fullmatch(r"(\w+) ?= ?([^=]+)", text):
        hint = f"in YAML a colon stands for '=': {pair[1]}: {pair[2]}"
    if ".." in text:
        hint = f"a colon stands behind the name: {{{text.replace(' ', ': ', 1)}}}"
    return Message(span, f"found '{text}', expected {expected}", hint)


@coded("E129")
def unprintable_character(span: Span, character: str) -> Message:
    r"""A text has a control character, or half of a character.

    No editor shows it, LaTeX and C cannot take it, and a file of it could not be read
    again. It comes from a damaged file or from an escape of YAML.

        title: "a\u0007b"        # wrong: a bell
        title: "a\ud800b"        # wrong: half of a character
        title: "ab"              # right
    """
    message = f"found the character U+{ord(character):04X}, which no text has"
    return Message(span, message, "remove it; in doubt type the line anew")


@coded("E130")
def tolerance_of_nothing(span: Span, name: str) -> Message:
    """A parameter without a value has a tolerance.

    A tolerance says how far the value may be off, so there is a value.

        param a: length +- 0.1 mm        # wrong
        param a = 40 mm +- 0.1 mm        # right
    """
    return Message(span, f"'{name}' has a tolerance but no value", f"write {name} = … +- …")


@coded("E141")
def other_notation(span: Span, found: str, name: str) -> Message:
    """A description is in the other notation than the suffix of its file says.

    Files that end in .mech hold lines (``param a = 40 mm``), files that end in .yaml, .yml
    or .json hold YAML (``params: {a: 40 mm}``).
    """
    return Message(span, f"this is {found}, which the file's name does not say", f"call it {name}")
