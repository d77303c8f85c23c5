r"""What differs between languages in a formula, and names as LaTeX.

English books write tan and cot and a decimal point, Ukrainian and Russian ones tg and
ctg and a decimal comma.
"""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from ...base.frozen import frozen
from ...base.later import pattern
from ...formula.names import (
    GREEK,
    JointForceName,
    MadeRatio,
    PointName,
    corner_of,
    split_force,
    split_made_ratio,
    split_name,
    split_points,
    split_ratio,
    words_in,
)
from ...model.mechanism import Reaction
from ..languages.registry import locale
from ..made_names import MadeNames
from .text import escape

_COMMON = {
    "sin": r"\sin",
    "cos": r"\cos",
    "sec": r"\sec",
    "csc": r"\csc",
    "asin": r"\arcsin",
    "acos": r"\arccos",
    "atan2": r"\operatorname{atan2}",
    "min": r"\min",
    "max": r"\max",
    "sign": r"\operatorname{sgn}",
    "log": r"\ln",
    "next": r"\operatorname{next}",
    "interpolate": r"\operatorname{table}",
    "row": r"\operatorname{row}",
    "met": r"\operatorname{row}",
}


_RELATIONS = {"<=": r"\leq ", ">=": r"\geq ", "!=": r"\neq "}


def relation_sign(sign: str) -> str:
    """Return the sign between two sides; one that has no name in LaTeX as it is."""
    return _RELATIONS.get(sign, sign)


@frozen
class LatexNotation:
    """How functions, decimals and names are written, and which names are angles or couples."""

    functions: Mapping[str, str]
    decimal: str
    made: MadeNames
    """The names made up in the document that is written by this notation."""

    units: Mapping[str, str]
    """The letters of units in the language."""

    otherwise: str
    """What is at the last case of a choice."""

    language: str = "en"
    texts: Mapping[str, str] = MappingProxyType({})
    """Texts of the description, names and words in them, as they are in the ``language``."""

    angles: frozenset[str] = frozenset()
    couples: frozenset[str] = frozenset()
    guided: frozenset[str] = frozenset()
    spellings: Mapping[str, str] = MappingProxyType({})
    """The names that cannot be written by rule (see :func:`spellings`)."""

    subscripts: Mapping[str, str] = MappingProxyType({})
    """The subscripts that mechc gives, as they are in the language."""

    own: frozenset[str] = frozenset()
    """The user's own names: their subscripts stay as they are."""

    pictured: frozenset[str] = frozenset()
    """Points and quantities that texts may name."""

    prefixes: tuple[str, ...] = ()
    """The prefixes of names that are written as an index."""

    plain: frozenset[str] = frozenset()
    """Names in which a prefix is written as it is."""

    def prefix(self, symbol: str) -> str:
        """Return the prefix under which something else brings a name in, '' where none does."""
        if symbol in self.plain:
            return ""
        found = (p for p in self.prefixes if symbol.startswith(f"{p}_"))
        return max(found, key=len, default="")

    def words(self, symbol: str) -> Mapping[str, str]:
        """Return the words in a name that differ in the language, as LaTeX."""
        given = {word: escape(self.texts[word]) for word in words_in(symbol) if word in self.texts}
        return given if symbol in self.own else {**self.subscripts, **given}

    @property
    def between(self) -> str:
        """What stands between coordinates, ``(15; 60)`` where decimals have commas."""
        return "," if self.decimal == "." else r";\ "


def notation(language: str) -> LatexNotation:
    """Return the notation of a language's books, for one document."""
    known = locale(language)
    functions, made = {**_COMMON, **known.functions}, MadeNames()
    otherwise = known.calculation["otherwise"]
    return LatexNotation(
        functions,
        known.decimal,
        made,
        known.units,
        otherwise,
        language,
        subscripts=known.subscripts,
    )


def translated(text: str, style: LatexNotation) -> str:
    r"""Return a text of the description in the language of the document, as LaTeX.

    Points, vectors and loads of the mechanism stand in it as they do in formulas.

    >>> style = LatexNotation({}, ".", MadeNames(), {}, "", pictured=frozenset({"O1", "A"}))
    >>> translated("A lever O1A about O1", style)
    'A lever $O_{1}A$ about $O_{1}$'
    >>> translated("Norton, fig. 2a: V = r·ω/(2b sin φ)", style).split(": ")[1]
    '$V$ = $r$\\ensuremath{\\cdot}\\ensuremath{\\omega}/(2$b$ sin \\ensuremath{\\varphi})'
    """
    named = _NAMED.sub(
        lambda found: _as_drawn(found[0], style), escape(style.texts.get(text, text))
    )
    return (
        _FACTOR.sub(lambda found: f"${found[1] or found[2] or found[3]}$", named)
        if _FORMULA.search(named)
        else named
    )


_NAMED = pattern(r"(?<![\w\\{'])(?:[A-Z][0-9]*'*)+(?![\w'}])")
"""What may be a point, a vector or a load in a text."""

_FORMULA = pattern(r" = |\\cdot|\b(?:sin|cos|tan|cot|tg|ctg) \\")
"""What only a text with a formula has."""

_UNIT = r"(?<!\d [mN]/)(?<!\d N\\ensuremath\{\\cdot\})(?<!\d \$N\$\\ensuremath\{\\cdot\})"
_SIGN = rf"(?:(?<=[=+] )|(?<=[/(])|(?<=\\cdot\}})|(?<=\{{-\}} )){_UNIT}"
_FUNCTION = r"(?= (?:sin|cos|tan|cot|tg|ctg)\b)"
_BEHIND = (
    rf"(?:{_FUNCTION}|(?<!\d .)(?= [=+]| \\ensuremath\{{-|/|\\ensuremath\{{(?:\\cdot|\{{\}}_)))"
)
_LETTER = r"(?<![A-Za-z\\_'])([A-Za-z])(?![\w}'])"
_FACTOR = pattern(rf"{_SIGN}{_LETTER}|{_LETTER}{_BEHIND}|(?<=\(\d)([A-Za-z])(?=\))")
"""A letter in a formula of a text: next to a sign of it, or before a function; no unit."""

_WORDS = {"en": frozenset({"A", "I"})}
"""Letters that are words of a language, too."""


def _as_drawn(word: str, style: LatexNotation) -> str:
    """Return a word of a text, as mathematics where it is made of names of the picture."""
    parts = ["".join(part) for part in split_points(word)]
    known = word not in _WORDS.get(style.language, ()) and style.pictured.issuperset(parts)
    return f"${points(word)}$" if known else word


def name(symbol: str, style: LatexNotation) -> str:
    r"""Return a quantity's name as LaTeX.

    >>> [name(s, notation("uk")) for s in ("alpha_1", "l_A", "phi", "eff", "omega_O1B")]
    ['\\alpha_1', 'l_A', '\\varphi', '\\mathrm{eff}', '\\omega_{O_{1}B}']
    """
    return style.spellings.get(symbol) or _by_rule(symbol, style)


def of_result(symbol: str, style: LatexNotation) -> str:
    r"""Return a result's name, one that was asked for without a name as the ratio that it is.

    >>> of_result("M_over_F", notation("en")), of_result("k", notation("en"))
    ('M/F', 'k')
    """
    return "/".join(name(part, style) for part in split_ratio(symbol))


def of_force(symbol: str, force: Reaction, style: LatexNotation) -> str:
    r"""Return a force on a link with the link above, a direction as an angle.

    >>> of_force("R_B_on_BC_x", Reaction("B", "BC", "x"), notation("en"))
    '{R_{B,x}^{BC}}'
    >>> of_force("R_O_direction", Reaction("O", "", "direction"), notation("en"))
    '\\varphi_{R_O}'
    """
    if force.part == "direction":
        size = Reaction(force.point, force.link, "size")
        return rf"\varphi_{{{of_force(symbol.replace('_direction', ''), size, style)}}}"
    base, on, rest = symbol.partition(f"_on_{force.link}")
    whole = name(base + rest, style)
    return f"{{{whole}^{{{points(force.link)}}}}}" if force.link and on else whole


def of_first_order(symbol: str, style: LatexNotation) -> str:
    """Return a result of first order in friction, its 1 not below the f.

    >>> of_first_order("k_f1", notation("en"))
    'k_{f1}'
    """
    return name(symbol, style).replace("f_{1}}", "f1}")


def _by_rule(symbol: str, style: LatexNotation) -> str:
    if prefix := style.prefix(symbol):
        return _of_part(symbol.removeprefix(f"{prefix}_"), prefix, style)
    if symbol.startswith("len_"):
        return points(symbol.removeprefix("len_"))
    if symbol not in style.own and (corner := corner_of(symbol)):
        return rf"\angle {points(corner)}"
    if symbol not in style.own and (ratio := split_made_ratio(symbol)):
        return _of_ratio(ratio, style)
    return _whole(symbol, style)


def _of_ratio(ratio: MadeRatio, style: LatexNotation) -> str:
    r"""Return the name of a ratio that has none: of its loads, with the index of its friction.

    >>> [name(f"{ratio}", notation("en")) for ratio in ("M_over_F_f1", "eta_M_over_F")]
    ['(M/F)_{f_{1}}', '\\eta_{M/F}']
    """
    whole = f"{name(ratio.above, style)}/{name(ratio.below, style)}"
    if ratio.is_efficiency:
        return rf"\eta_{{{whole}}}"
    index = f"k_{ratio.ending}" if ratio.ending else "k"
    return f"({whole})" + _whole(index, style).removeprefix("k")


def _whole(symbol: str, style: LatexNotation, *last: str) -> str:
    r"""Return a name in the language, the last indices as they are.

    >>> texts = {"F_C": "F_ц", "far": "дал", "row": "ряд"}
    >>> style = LatexNotation({}, ",", MadeNames(), {}, "", texts=texts)
    >>> [_whole(symbol, style) for symbol in ("F_C", "P_far", "row")]
    ['F_{\\text{\\mechccyr{ц}}}', 'P_{\\text{\\mechccyr{дал}}}', '\\text{\\mechccyr{ряд}}']
    """
    called = style.texts.get(symbol, symbol)
    if called == symbol:
        return _indexed(symbol, style.words(symbol), *last)
    letter, *indices = called.split("_")
    words = {i: escape(i) for i in (letter, *indices) if not i.isascii()}
    return _indexed(called, words, *last)


def _of_part(symbol: str, prefix: str, style: LatexNotation) -> str:
    r"""Return a name that something else brings in: as it is there, with the prefix as an index.

    >>> style = notation("en")
    >>> [_of_part(symbol, "L", style) for symbol in ("d_min", "N_KA_f", "R_O_direction")]
    ['d_{\\mathrm{min},L}', 'N_{KA,f,L}', '\\varphi_{R_{O,L}}']
    >>> _of_part("R_A_on_AOB_x", "pivot_pin", style)
    '{R_{A,x,\\text{pivot pin}}^{AOB}}'
    """
    called = style.texts.get(prefix, prefix)
    is_text = "_" in prefix or called != prefix
    part = _text(escape(called.replace("_", " "))) if is_text else _index(prefix)
    if symbol.startswith("len_"):
        return f"{{{points(symbol.removeprefix('len_'))}}}_{{{part}}}"
    own, link, is_direction = split_force(symbol) or JointForceName(symbol, "", False)
    whole = _whole(own, style, part).replace("f_{1},", "f1,")
    if link:
        whole = f"{{{whole}^{{{points(link)}}}}}"
    return rf"\varphi_{{{whole}}}" if is_direction else whole


def _indexed(symbol: str, words: Mapping[str, str], *last: str) -> str:
    """Return a letter with its indices, the last ones as they are; some are ``words``."""
    head, primes, indices = split_name(symbol)
    letter = (_text(words[head]) if head in words else _letter(head)) + primes
    named = (_text(words[i]) if words.get(i, i) != i else _index(i) for i in indices)
    index = ",".join((*named, *last))
    if not index:
        return letter
    return f"{letter}_{index}" if len(index) == 1 else f"{letter}_{{{index}}}"


def _text(word: str) -> str:
    return rf"\text{{{word}}}"


def _letter(head: str) -> str:
    """Return the head of a name: a Greek letter, a letter as it is, else an upright word."""
    match head:
        case "phi":
            return r"\varphi"  # the shape that pictures have
        case "epsilon":
            return r"\varepsilon"
        case "omicron":
            return "o"
        case _ if head in GREEK:
            return f"\\{head}"
        case _ if len(head) == 1:
            return head
        case _:
            return _word("mathrm", head)


def _word(alphabet: str, word: str) -> str:
    letters = word.replace("_", r"\_")
    return rf"\{alphabet}{{{letters}}}"


def _index(index: str) -> str:
    if split_points(index):
        return points(index)
    stem, primes, numbers = split_name(index)
    if index.isdigit():
        return index
    return _letter(stem) + primes + "".join(f"_{{{n}}}" for n in numbers)


def points(names: str) -> str:
    """Return a point, vector or link as LaTeX mathematics.

    >>> points("O1B'")
    "O_{1}B'"
    >>> points("A_0")
    'A_{0}'
    """
    own, _, index = names.partition("_")
    found = split_points(own)
    if index and found:
        found = (*found[:-1], found[-1]._replace(number=f"{found[-1].number}{index}"))
    return "".join(map(_point, found)) or rf"\mathrm{{{names}}}"


def _point(point: PointName) -> str:
    number = f"_{{{point.number}}}" if point.number else ""
    return point.letter + number + point.primes


def spellings(names: Iterable[str], style: LatexNotation) -> dict[str, str]:
    r"""Return spellings letter by letter for names that the rules would write alike.

    >>> sorted(spellings(["alpha1", "alpha_1", "b"], notation("en")).values())
    ['\\mathit{alpha1}', '\\mathit{alpha\\_1}']
    """
    ruled: dict[str, list[str]] = {}
    for symbol in dict.fromkeys(names):
        ruled.setdefault(_by_rule(symbol, style), []).append(symbol)
    alike = [symbol for group in ruled.values() if len(group) > 1 for symbol in group]
    return {symbol: _word("mathit", symbol) for symbol in alike}
