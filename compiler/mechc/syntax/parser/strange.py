"""What people mean by a character that the language does not have: a hint for each."""

import unicodedata
from collections.abc import Mapping, Sequence

from ..vocabulary import split_quantity
from .lalr import Token, span_of

QUOTES = "a text stands in plain double quotes"

LOOKALIKES: Mapping[str, str] = {
    **dict.fromkeys("−–—", "the minus sign is '-'"),
    **dict.fromkeys("·×⋅∙", "a product is written with '*'"),
    **dict.fromkeys("“„«»", QUOTES),
    **dict.fromkeys("º˚", "degrees are written deg or °"),
    **dict.fromkeys("⌀Øø∅", "leave it out: a diameter is a length like any other"),
    **dict.fromkeys("⁰¹⁴⁵⁶⁷⁸⁹⁻", "a power is written with '^', as in m^4 or 1/s"),
    "÷": "a quotient is written with '/'",
    "²": "a square is written '^2'",
    "³": "a cube is written '^3'",
    "√": "a root is written sqrt(…)",
    "≤": "write '<='",
    "≥": "write '>='",
    "≠": "write '!='",
    "≈": "a figure is expected within its digits, or +- 0.01: expect k = 0.353 +- 0.01",
    "…": "a range is written with two dots",
    "~": "leave it out; a range is written with two dots",
    "°": "degrees belong to a number, as in 30°; a parameter has its own unit",
    "∈": "a range stands behind 'in', as in 10 deg in 2 deg .. 40 deg",
    "∠": "a direction is an angle behind '@', as in OB = l @ 30 deg",
    "%": "a comment begins with '#'; a hundredth is written 0.01",
    "‰": "a thousandth is written 0.001",
    "_": "digits stand together, as in 1200",
    ".": "a range is written with two dots",
    "'": "a text stands in double quotes; feet are ft, minutes of arc are 1/60 deg",
    "’": "a prime is written with '",
    "′": "a prime is written with '",
    "|": "the size of a value is abs(x)",
    "&": "conditions are joined by 'and'",
    "[": "lists are for YAML; here repeat the statement",
    "{": "mappings are for YAML",
    ";": "statements end with their line",
    "π": "write pi",
}

BEHIND_NUMBER: Mapping[str, str] = {
    **dict.fromkeys("′’", "feet are ft, minutes of arc are 1/60 deg"),
    **dict.fromkeys("″”", 'inches are in or "; seconds of arc are 1/3600 deg'),
    "[": "a unit stands behind its number without brackets: 200 mm",
}
"""What a character means behind a number."""

GREEK = (
    *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "lambda", "mu", "nu"),
    *("xi", "rho", "sigma", "tau", "phi", "varphi", "chi", "psi", "omega"),
)

CYRILLIC_UNITS: Mapping[str, str] = {
    **{"мм": "mm", "см": "cm", "дм": "dm", "м": "m", "км": "km", "мкм": "um"},
    **{"град": "deg", "рад": "rad", "об": "rev"},
    **{"Н": "N", "даН": "daN", "кН": "kN", "МН": "MN", "кгс": "kgf"},
    **{"Н·м": "N*m", "Н*м": "N*m", "Нм": "N*m", "Н·мм": "N*mm", "Н*мм": "N*mm", "кН·м": "kN*m"},
    **{"кН*м": "kN*m", "Н/мм": "N/mm", "Н/м": "N/m", "Н/мм^2": "N/mm^2", "Н/мм²": "N/mm^2"},
    **{"г": "g", "кг": "kg", "т": "t", "Па": "Pa", "кПа": "kPa", "МПа": "MPa", "ГПа": "GPa"},
    **{"бар": "bar", "с": "s", "сек": "s", "мс": "ms", "мин": "min", "хв": "min", "Гц": "Hz"},
    **{"об/мин": "rpm", "об/хв": "rpm", "м/с": "m/s", "мм/с": "mm/s", "м/с^2": "m/s^2"},
    **{"м/с²": "m/s^2", "рад/с": "rad/s", "Вт": "W", "кВт": "kW", "Дж": "J"},
    **{"мм^2": "mm^2", "мм²": "mm^2", "см²": "cm^2", "см^2": "cm^2", "м²": "m^2"},
}
"""Units as they are written in Ukrainian and Russian."""

TEXTS: Mapping[str, str] = {
    "SOURCE": 'a text stands in double quotes: source "Book, fig. 9"',
    "TRANSLATE": 'texts stand in double quotes: translate "handle" uk "рукоятка"',
}
"""What is said in a statement that has texts only, which stand without quotes."""


def meaning(line: Sequence[Token], position: int) -> str:
    """Return the hint at a strange token of a line, '' where it is best left out."""
    token = line[position]
    character = token[:1]
    before = line[position - 1] if position else None
    if line[0].type in TEXTS and before is not None and '"' not in "".join(line[:position]):
        return TEXTS[line[0].type]
    if character.isdecimal():
        return f"digits are 0 to 9: write {int(character)}"
    if character == ";" and line[position + 1 :] in ([], ["\n"]):
        return LOOKALIKES[";"]
    if character == "%" and "+-" in line[:position]:
        return "a tolerance is an amount, no share: for one per cent of 3 kN write 3 kN +- 0.03 kN"
    is_place = "at" in map(str, line[:position]) and ")" not in line[:position]
    if character in "[;" and is_place and line[0].type != "LET":
        return "a place is written (20 mm, 35 mm)"
    if character == "\\":
        return _command(line, position)
    if character == "?":
        return _question(line, position)
    if before is not None and (hint := _behind(before, token, line, position)):
        return hint
    if unit := CYRILLIC_UNITS.get(_word(line, position)):
        return f"units are written in Latin letters: {unit}"
    if character == ";" and str(line[0]) in ("table", "list"):
        return "a ',' stands between two rows, or sizes"
    hint = LOOKALIKES.get(character, "")
    return hint or _of_kind(character)


def _behind(before: Token, token: Token, line: Sequence[Token], position: int) -> str:
    """Return the hint at a character behind a number, or behind a name."""
    character, glued = token[:1], span_of(before).end == span_of(token).start
    if before.type == "NUMBER" and not split_quantity(before)[1]:
        return BEHIND_NUMBER.get(character, "")
    digit = unicodedata.digit(character, -1)
    if before.type == "NAME" and glued and "₀" <= character <= "₉":
        return f"an index belongs to the name: {before}{digit} or {before}_{digit}"
    if before.type == "NAME" and before.endswith("_") and character == "{":
        inside = str(line[position + 1]) if position + 1 < len(line) else "1"
        return f"an index belongs to the name: {before}{inside}"
    if character == "[" and (before.type == "NAME" or before in ("*", "/", "+", "-", "(")):
        return "brackets are round; a table is asked by 'at': let q = m at 2*r/d"
    return "brackets are round" * (character == "[" and before.type == "COMPARISON")


def _command(line: Sequence[Token], position: int) -> str:
    """Return the hint at a backslash: a command of LaTeX, or a line that would go on."""
    if position + 1 == len(line):
        return "a statement stands on one line, however long"
    name = str(line[position + 1])
    if name.lower() in GREEK:
        return f"Greek letters are spelled out: {name}"
    return "formulas are written in a line: a/b, sqrt(x), sin(alpha)"


def _question(line: Sequence[Token], position: int) -> str:
    """Return the hint at a question mark: a choice, or a value that is not known."""
    if ":" in map(str, line[position:]):
        return "a choice is written with 'when', as in 1.1 when v < 1 m/s else 1.3"
    is_value = position and line[0].type == "PARAM" and line[position - 1] == "="
    name = line[1] if is_value else ""
    return f"what has no value is declared by its dimension: param {name}: length" * bool(name)


def _word(line: Sequence[Token], position: int) -> str:
    """Return the text from a token on, up to a space."""
    word, end = "", span_of(line[position]).start
    for token in line[position:]:
        if span_of(token).start != end:
            break
        word, end = word + str(token), span_of(token).end
    return word.rstrip(",;")


def _of_kind(character: str) -> str:
    """Return the hint at a fraction in one sign, or a letter of another alphabet."""
    value = unicodedata.numeric(character, None) if len(character) == 1 else None
    if value is not None and not character.isalpha():
        return f"a fraction is a part of one number with a point: {character} is {value:.4g}"
    if not character.isprintable():
        return "leave it out: it is a sign that is not seen"
    return f"names are written in Latin letters; this is {script(character)}" * character.isalpha()


BESIDE_NAMES = frozenset({"GREEK", "SMALL", "CAPITAL", "LETTER", "FINAL", "LUNATE", "REVERSED"})
"""The words that stand before a Greek letter's name in the tables of characters."""


def script(character: str) -> str:
    """Return which alphabet a letter is from; look-alikes are hard to see.

    >>> script("А"), script("é")
    ('a Cyrillic letter', 'another letter')
    >>> [script(letter).rpartition(" ")[2] for letter in "αΛςϕϵ"]
    ['alpha', 'lambda', 'sigma', 'phi', 'epsilon']
    """
    if "\u0400" <= character <= "\u04ff":
        return "a Cyrillic letter"
    if "\u0370" <= character <= "\u03ff":
        words = (w for w in unicodedata.name(character, "").split() if w not in BESIDE_NAMES)
        name = next(words, "alpha").lower().replace("lamda", "lambda")
        return f"a Greek letter: write its name, {name}"
    return "another letter"
