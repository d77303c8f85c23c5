r"""Displayed equations that never run off the page.

A right-hand side that no line holds is broken between the terms of its sum; a sum
inside a fraction gets a name (``Z_1``) and is defined below; a product of very many
factors is continued on the next line.

Within one document a name stands for one sum and a sum has one name: what was named in an
earlier display keeps that name and is not defined again.
"""

from collections.abc import Iterable, Iterator, Sequence

from ...base.named import NamedTuple
from ...formula.layout import is_angle
from ...formula.tree import Formula, Product, Sum, negative
from ...formula.walk import children, rebuild, symbols
from .notation import LatexNotation
from .printer import Box, Boxes, box, plain, row, signed

LINE_WIDTH = 38.0
"""Room in a line, in em: A4 with margins of 25 mm at 11 pt, less some air; reports have more."""

TWO_EQUATIONS_WIDTH = 40.0
"""Room for two equations in a line; widths are estimated rather too large than too small."""

LINES_ON_A_PAGE = 4
"""An equation of no more lines than this stands on one page."""

_INDENT = 2.0
"""The indentation of a line that continues an equation, in em: a quad on either side."""

_GAP = 1.0
"""What two equations in one line keep apart at least, in em."""


class DisplayLine(NamedTuple):
    """One equation to display: its left side as it stands, its right side as a formula.

    ``unit`` stands behind a right side that is a number. What it is equal to on the way, a
    ``chain``, has a line of its own where the right side does not fit behind it.
    """

    left: Box
    right: Formula
    angle: bool = False
    unit: str = ""
    chain: Box | None = None


class _Display:
    """The names that one display uses, of which those made up in it are defined below it."""

    def __init__(self, style: LatexNotation, shown: Iterable[Formula]) -> None:
        self._names = style.made
        self.box = Boxes(style).whole
        self._names.take(name for formula in shown for name in symbols(formula))
        self.made: list[tuple[Formula, Formula]] = []

    def name(self, formula: Formula) -> Formula:
        """Return the name of a sum, that of its opposite with a minus, a new one for others."""
        known = self._names.known(formula) or self._names.opposite(formula)
        if known is None:
            known = self._names.of_sum(formula)
            self.made.append((formula, known))
        return known


def display(
    lines: tuple[DisplayLine, ...], style: LatexNotation, where: str, boxed: bool = False
) -> str:
    """Return the equations as displays; ``where`` is the word before names made up here."""
    names = _Display(style, [line.right for line in lines])
    rows = [_row(line, style, names) for line in lines]
    return _with_names(_environment(rows, boxed), names, style, where)


def _row(line: DisplayLine, style: LatexNotation, names: _Display) -> tuple[Box, list[Box]]:
    """Return the sides of an equation, the right one as the lines that it takes."""
    if line.chain is None:
        return line.left, _fitted(line, style, names)
    whole = row((line.left, plain("="), line.chain))
    if whole.width + names.box(line.right, line.angle).width + _INDENT <= LINE_WIDTH:
        return whole, _fitted(line._replace(left=whole), style, names)
    first, *others = _fitted(line._replace(left=plain("")), style, names)
    return line.left, [line.chain, row((plain("="), first)), *others]


def vanishing(formula: Formula, style: LatexNotation, where: str) -> str:
    """Return ``formula = 0`` as a display, broken between the terms of its sum."""
    names = _Display(style, [formula])
    *parts, last = _fitted(DisplayLine(plain(""), formula), style, names)
    return _with_names(_multline([*parts, row((last, plain("=0")))]), names, style, where)


def balance(left: Formula, right: Formula, style: LatexNotation, where: str) -> str:
    """Return an equation of two wide sides as a display, the right one on lines of its own."""
    names = _Display(style, [left, right])
    parts = _fitted(DisplayLine(plain(""), left), style, names)
    first, *others = _fitted(DisplayLine(plain("="), right), style, names)
    whole = _multline([*parts, row((plain("="), first)), *others])
    return _with_names(whole, names, style, where)


def _multline(parts: list[Box]) -> str:
    text = f"{_break(len(parts))}\n".join(part.tex for part in parts)
    return f"\\begin{{multline*}}\n{text}\n\\end{{multline*}}"


def _break(lines: int) -> str:
    """Return the end of a line of one equation, which a page parts where it is long alone."""
    return r"\\*" if lines <= LINES_ON_A_PAGE else r"\\"


def _with_names(whole: str, names: _Display, style: LatexNotation, where: str) -> str:
    """Return a display followed by the definitions of the names made up in it."""
    defined: list[tuple[Box, list[Box]]] = []
    for formula, symbol in names.made:  # which grows while long sums are broken in turn
        left = box(symbol, style)
        defined.append((left, _fitted(DisplayLine(left, formula), style, names)))
    return f"{whole}\n{where}\n{_environment(defined)}" if defined else whole


def _environment(rows: list[tuple[Box, list[Box]]], boxed: bool = False) -> str:
    """Return rows of equations aligned at the equals sign."""
    if len(rows) == 1 and len(rows[0][1]) == 1:
        left, (right,) = rows[0]
        equation = f"{left.tex}={right.tex}"
        return "\\[\n" + (rf"\boxed{{{equation}}}" if boxed else equation) + "\n\\]"
    lines = [(_aligned(left, parts), _room(left, parts)) for left, parts in rows]
    return aligned(lines)


def _room(left: Box, parts: list[Box]) -> float:
    """Return how much of a line an equation takes; one of several lines takes all of it."""
    return left.width + parts[0].width + 1.2 if len(parts) == 1 else TWO_EQUATIONS_WIDTH


def aligned(lines: Sequence[tuple[str, float]]) -> str:
    """Return equations aligned at the equals sign, two in a line where they have the room.

    Each comes with its width. Those that are two abreast stand in columns of their own.
    """
    runs: list[list[str]] = []
    is_paired = False
    waiting = list(lines)
    while waiting:
        pairs = _pairs(waiting)
        found, number = (_abreast(waiting, pairs), 2 * pairs) if pairs else ([waiting[0][0]], 1)
        if runs and not pairs and not is_paired:
            runs[-1] += found
        else:
            runs.append(found)
        is_paired, waiting = bool(pairs), waiting[number:]
    return "\n".join(map(_align, runs))


def _pairs(lines: Sequence[tuple[str, float]]) -> int:
    """Return how many pairs in a row fit in two columns from the first equation on."""
    widths = [width for _, width in lines]
    most = 0
    for number in range(1, len(lines) // 2 + 1):
        if (
            max(widths[: 2 * number : 2]) + max(widths[1 : 2 * number : 2]) + _GAP
            > TWO_EQUATIONS_WIDTH
        ):
            break
        most = number
    return most


def _abreast(lines: Sequence[tuple[str, float]], pairs: int) -> list[str]:
    there = [text for text, _ in lines[: 2 * pairs]]
    return ["&\n".join(pair) for pair in zip(there[::2], there[1::2], strict=True)]


def _align(rows: Iterable[str]) -> str:
    text = "\\\\[2pt]\n".join(rows)
    return f"\\begin{{align*}}\n{text}\n\\end{{align*}}"


def _aligned(left: Box, parts: list[Box]) -> str:
    first, *others = parts
    down = _break(len(parts))
    continued = "".join(f"{down}[2pt]\n&\\quad{{}}{part.tex}" for part in others)
    return f"{left.tex}&={first.tex}{continued}"


def _fitted(line: DisplayLine, style: LatexNotation, names: _Display) -> list[Box]:
    """Return the right side as the lines that it takes."""
    room = max(LINE_WIDTH - line.left.width - _INDENT, LINE_WIDTH / 2)
    whole = names.box(line.right, line.angle)
    if whole.width <= room:
        return [row((whole, Box(line.unit, 0.0))) if line.unit else whole]
    if not isinstance(line.right, Sum):
        return _factor_lines(_named(line.right, room, style, names), room, style)
    terms = [_term(term, room, style, names) for term in line.right.terms]
    angle = line.angle or is_angle(line.right, style.angles)
    return _pack([signed(t, style, i == 0, angle) for i, t in enumerate(terms)], room)


def broken(line: DisplayLine, style: LatexNotation) -> list[Box]:
    """Return the right side as the lines that it takes; none where a part of it fits on none."""
    room = LINE_WIDTH - line.left.width - _INDENT
    if isinstance(line.right, Sum):
        terms = enumerate(line.right.terms)
        lines = _pack([signed(t, style, i == 0, line.angle) for i, t in terms], room)
    else:
        lines = [box(line.right, style, line.angle)]
    return lines if all(part.width <= room for part in lines) else []


def _pack(pieces: list[Box], room: float) -> list[Box]:
    """Fill lines with pieces, first come first served."""
    lines: list[list[Box]] = [[]]
    for piece in pieces:
        if lines[-1] and sum(p.width for p in lines[-1]) + piece.width > room:
            lines.append([])
        lines[-1].append(piece)
    return [row(line) for line in lines]


def _named(formula: Formula, room: float, style: LatexNotation, names: _Display) -> Formula:
    """Name inner sums in reading order, wide ones first, until the formula fits."""
    while names.box(formula).width > room:
        inner = [s for s in _inner_sums(formula) if not is_angle(s, style.angles)]
        if not inner:
            break
        wide = [s for s in inner if names.box(s).width > room / 4] or inner
        formula = _replace(formula, wide[0], names.name(wide[0]))
    return formula


def _term(term: Formula, room: float, style: LatexNotation, names: _Display) -> Formula:
    """Return a term that fits a line of its own, under a name where nothing else helps."""
    shorter = _named(term, room, style, names)
    return shorter if names.box(shorter).width <= room else names.name(shorter)


def _inner_sums(formula: Formula) -> Iterator[Sum]:
    """Yield the outermost sums strictly inside a formula."""
    for part in children(formula):
        if isinstance(part, Sum):
            yield part
        else:
            yield from _inner_sums(part)


def _replace(formula: Formula, old: Formula, new: Formula) -> Formula:
    if formula == old:
        return new
    parts = children(formula)
    return rebuild(formula, tuple(_replace(p, old, new) for p in parts)) if parts else formula


def _factor_lines(formula: Formula, room: float, style: LatexNotation) -> list[Box]:
    """Continue a product of many factors on further lines."""
    if not isinstance(formula, Product) or box(formula, style).width <= room:
        return [box(formula, style)]
    chunks: list[list[Formula]] = [[]]
    for factor in formula.factors:
        if chunks[-1] and _width((*chunks[-1], factor), style) > room:
            chunks.append([])
        chunks[-1].append(factor)
    parts = [_joined(chunk) for chunk in chunks]
    for i, part in enumerate(parts[1:], 1):
        if box(part, style).tex.startswith("-"):  # no sign stands behind a sign of multiplication
            parts[0], parts[i] = negative(parts[0]), negative(part)
    boxes = [box(part, style) for part in parts]
    return [boxes[0], *(row((plain(r"\times "), b)) for b in boxes[1:])]


def _joined(factors: list[Formula]) -> Formula:
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


def _width(factors: tuple[Formula, ...], style: LatexNotation) -> float:
    return box(_joined(list(factors)), style).width
