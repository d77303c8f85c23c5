"""A printed page read with its units alone: nothing of the compiler but its LaTeX is looked at.

Every quantity has an exponent for each base unit and, where the page does not say what it is
measured in, for itself as an unknown. Each relation is an equation for these exponents and one
for the values: both must hold.
"""

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property, reduce
from itertools import pairwise

from latex_reader import read
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Call, Formula, Number, Pi, Power, Product, Sum, Symbol
from mechc.formula.walk import substitute, symbols
from page import NAME

Powers = Mapping[str, Fraction]
"""Exponents of base units (kg, m, s) and of what is unknown."""

ONE: Powers = {}
BASE = ("kilogram", "metre", "second")


def times(a: Powers, b: Powers, exponent: Fraction = Fraction(1)) -> Powers:
    """Return a·b^exponent."""
    found = {n: a.get(n, Fraction(0)) + exponent * b.get(n, Fraction(0)) for n in {*a, *b}}
    return {n: e for n, e in found.items() if e}


def _of(kg: int, m: int, s: int) -> Powers:
    return {n: Fraction(e) for n, e in zip(BASE, (kg, m, s), strict=True) if e}


LENGTH, FORCE, COUPLE, PRESSURE = _of(0, 1, 0), _of(1, 1, -2), _of(1, 2, -2), _of(1, -1, -2)
SPEED, RATE = _of(0, 1, -1), _of(0, 0, -1)
WORDS: dict[str, tuple[float, Powers]] = {
    **dict.fromkeys(("mm", "мм"), (1e-3, LENGTH)),
    **dict.fromkeys(("m", "м"), (1.0, LENGTH)),
    "in": (0.0254, LENGTH),
    **dict.fromkeys(("N", "Н"), (1.0, FORCE)),
    **dict.fromkeys(("kN", "кН"), (1e3, FORCE)),
    "lbf": (4.4482216152605, FORCE),
    **dict.fromkeys(("MPa", "МПа"), (1e6, PRESSURE)),
    **dict.fromkeys(("GPa", "ГПа"), (1e9, PRESSURE)),
    **dict.fromkeys(("s", "с"), (1.0, _of(0, 0, 1))),
    **dict.fromkeys(("kg", "кг"), (1.0, _of(1, 0, 0))),
    **dict.fromkeys(("rad", "рад"), (1.0, ONE)),
}
"""Units as they are printed."""

SHAPES = (
    (re.compile(r"V_"), SPEED),
    (re.compile(r"\\omega_"), RATE),
    (re.compile(r"\\mu$|\\mu_"), ONE),
)
"""What names that no table of a page explains are measured in by custom."""

UNIT = re.compile(rf"\\text\{{({'|'.join(WORDS)})\}}")
LITERAL = re.compile(r"(?<![\d._])(?<![_^]\{)(?<!atan)\d+(?:\.\d+)?")
READ = re.compile(f"{NAME.pattern}|({LITERAL.pattern})")
"""A name, digits in it included, or a number."""
FIGURES = 6
"""Numbers are rounded to so many figures."""

DEGREES, HALF_OF_LAST_DECIMAL = r"^\circ", 0.5e-6
"""Degrees have six decimals at most, however small they are."""

NOTHING = 1e-12
"""What rounding leaves of a zero, in SI."""

ZERO_AT_AN_END = 1e-8
"""What it leaves where a loop ends and angles have half the digits of others: 0 is stated."""


class Contradiction(Exception):
    """A relation whose sides, or whose terms, are not measured in the same units."""


@dataclass
class Units:
    """What is known of unknown units by the relations that were read; ``scope`` is put before."""

    solved: dict[str, Powers] = field(default_factory=dict)

    def reduced(self, powers: Powers) -> Powers:
        found: Powers = ONE
        for name, exponent in powers.items():
            known = self.solved.get(name)
            part = {name: Fraction(1)} if known is None else self.reduced(known)
            found = times(found, part, exponent)
        return found

    def agree(self, a: Powers, b: Powers) -> None:
        """Learn from a relation what its sides are measured in."""
        gap = self.reduced(times(a, b, Fraction(-1)))
        unknown = next((n for n in sorted(gap) if n not in BASE), None)
        if unknown is None:
            if gap:
                raise Contradiction(f"{shown(self.reduced(a))} and {shown(self.reduced(b))}")
            return
        exponent = -1 / gap[unknown]
        self.solved[unknown] = times(ONE, {n: e for n, e in gap.items() if n != unknown}, exponent)


def shown(powers: Powers) -> str:
    return "·".join(f"{n}^{e}" for n, e in sorted(powers.items())) or "1"


@dataclass
class Table:
    """Names of a page: what they are measured in and, where the page says so, their values."""

    units: Units
    dimensions: dict[str, Powers] = field(default_factory=dict)
    values: dict[str, float] = field(default_factory=dict)

    def measure(self, formula: Formula) -> Powers | None:
        """Return the dimension of a formula; None of a zero, which may be anything."""
        match formula:
            case Number(value=value):
                return None if value == 0 else ONE
            case Pi():
                return ONE
            case Symbol(name=name):
                return self._of_name(name)
            case Sum(terms=terms):
                return self.alike(terms)
            case Product(factors=factors):
                inner = [self.measure(factor) for factor in factors]
                return None if None in inner else reduce(times, (m or ONE for m in inner), ONE)
            case Power(base=base, exponent=Number(value=value)):
                powers = self.measure(base)
                return None if powers is None else times(ONE, powers, value)
            case Power(base=base, exponent=exponent):
                return self._plain((base, exponent))
            case Call(function="min" | "max" | "abs" | "branches", arguments=arguments):
                return self.alike(arguments)
            case Call(function="atan2", arguments=arguments):
                self.alike(arguments)
                return ONE
            case Call(function="sense", arguments=(signed, _)):
                self.measure(signed)
                return ONE
            case Call(arguments=arguments):
                return self._plain(arguments)
        raise AssertionError(formula)

    def _of_name(self, name: str) -> Powers:
        if (unit := UNIT.fullmatch(name)) is not None:
            return WORDS[unit[1]][1]
        for shape, powers in SHAPES:
            if shape.match(name):
                self.dimensions.setdefault(name, powers)
        return self.dimensions.setdefault(name, {name: Fraction(1)})

    def alike(self, parts: Iterable[Formula]) -> Powers | None:
        found = [m for m in map(self.measure, parts) if m is not None]
        for other in found[1:]:
            self.units.agree(found[0], other)
        return found[0] if found else None

    def _plain(self, parts: Iterable[Formula]) -> Powers:
        for powers in map(self.measure, parts):
            self.units.agree(powers or ONE, ONE)
        return ONE


DISPLAY = re.compile(
    r"(?<!\\)\\\[(.*?)(?<!\\)\\\]|\\begin\{(align\*|multline\*)\}(.*?)\\end\{\2\}"
    r"|\$([^$=]+=[^$=]+)\$\\par",
    re.DOTALL,
)
PART = re.compile(r"\\(?:sub)?section\*?\{|\\noindent\\textbf\{")
ACTS = re.compile(
    r"(The force|Сила|The couple|Пара сил|Момент|Пара) \$(.*?)\$ "
    r"(?:acts|прикладен|приложен|діє|действует)"
)
FORCES = {"The force", "Сила"}
PER_UNIT = re.compile(
    r"(?:given per unit of|віднесено до|отнесены к) \$(.*?)\$"
    r"(?:, (?:so that|тож|поэтому) \$(.*?)\$ (?:is|— це|— это) \$(.*?)\$)?"
)
ROW = re.compile(r"^[^&\n]+ &.*\\\\\*?$", re.MULTILINE)
VALUES, RANGES = {"Value", "Значення", "Значение"}, {"Range", "Межі", "Пределы"}
SLOPE = re.compile(r"\\partial |\\mathrm\{d\} ")
CASES = re.compile(r"\\begin\{cases\}(.*?)\\end\{cases\}", re.DOTALL)
BRANCHES = r"\branches"
LENGTH_NAME = re.compile(r"(?:[A-Z]'*(?:_\{[^{}]*\}|_\w)?){2,}")
WORD = re.compile(r"\\mathrm\{\w+\}(?:_\{.*\})?|\\?[A-Za-z]|\\[a-z]+")


class Relation:
    """Formulas that a page says to be equal, as they are printed."""

    def __init__(self, text: str) -> None:
        self.is_boxed = r"\boxed{" in text
        self.is_slope = bool(SLOPE.search(text))
        text = SLOPE.sub("", text.replace("&", " ").replace(r"\quad{}", " "))
        if self.is_boxed:
            text = text.strip().removeprefix(r"\boxed{").removesuffix("}")
        self.parts = [part.strip() for part in text.split("=")]

    def __repr__(self) -> str:
        return " = ".join(self.parts)


def relations(tex: str) -> Iterator[Relation]:
    """Yield the equations that are displayed, line by line, or stand behind their text."""
    for single, kind, several, alone in DISPLAY.findall(tex):
        text = re.sub(r"\\\\\*?(\[2pt\])?\s*&(\\quad\{\}|(?==))", " ", single or several or alone)
        text = re.sub(r"\\\\\*?\n", " ", text) if kind == "multline*" else text
        text = CASES.sub(lambda found: _branches(found[1]), text)
        for line in re.split(r"\\\\\*?(?:\[2pt\])?\n|&\n|\\qquad ", text):
            yield from map(Relation, re.split(r"\\[gl]eq |[<>]", line))


def _branches(rows: str) -> str:
    """Return the dimensions that a formula may have, whatever the conditions."""
    values = (row.partition("&")[0].strip(" ,") for row in rows.split(r"\\\\"))
    return BRANCHES + "".join(f"{{{value}}}" for value in values)


class PrintedUnits:
    """A page: ``contradictions`` are what does not balance on it, ``unread`` what was not read.

    Names have the values that the page gives them, ``instead`` those that are not rounded.
    """

    def __init__(self, tex: str, instead: Mapping[str, float] | None = None) -> None:
        self.table, self.instead = Table(Units()), instead or {}
        self.read_relations = self.valued = 0
        self.tex = re.sub(r"\^(\d)", r"^{\1}", tex.replace("{,}", ".").replace(r";\ ", ","))
        self.unread: list[str] = []
        self.rounded: dict[str, float] = {}
        self.current: dict[str, str] = {}
        starts = [0, *(m.start() for m in PART.finditer(self.tex)), len(self.tex)]
        self.scopes = [self.tex[a:b] for a, b in pairwise(starts)]

    @cached_property
    def names(self) -> set[str]:
        """Names of more than a letter: in a first column, and left of an equals sign."""
        cells = re.findall(r"(?:^|& )\$([A-Za-z\\][^$ ]*)\$ &", self.tex, re.MULTILINE)
        lefts = [relation.parts[0] for relation in relations(self.tex)]
        named = {n for n in lefts if LENGTH_NAME.fullmatch(n) or WORD.fullmatch(n)}
        return {
            *(c for c in cells if not re.search(r"\^|\\frac|[-+=<]", c)),
            *named,
            *NAME.findall(self.tex),
            *self.instead,
        }

    def read(self, tex: str) -> Formula:
        """Return a formula whose names are those that are meant in this part of the page."""
        if tex.startswith(BRANCHES):
            inner = tex.removeprefix(BRANCHES)[1:-1].split("}{")
            return Call("branches", tuple(map(self.read, inner)))
        units = {unit[0] for unit in UNIT.finditer(tex)}
        formula = read(tex, {*self.names, *units})
        return substitute(formula, {n: Symbol(m) for n, m in self.current.items()})

    def _is_name(self, tex: str) -> bool:
        return tex in self.names or re.fullmatch(r"[A-Za-z]|\\[a-z]+", tex) is not None

    def value(self, formula: Formula, moved: Mapping[str, float] | None = None) -> float | None:
        """Return the value of a formula; None where a name in it has none."""
        known = {u: WORDS[UNIT.fullmatch(u)[1]][0] for u in symbols(formula) if UNIT.fullmatch(u)}
        known |= self.table.values | dict(moved or {})
        if isinstance(formula, Call) and formula.function == "branches":
            return None
        return evaluate(formula, known) if symbols(formula) <= known.keys() else None

    def contradictions(self) -> Iterator[str]:
        self._given()
        for number, scope in enumerate(self.scopes):
            with_units = self._opened(scope, number)
            for relation in relations(scope):
                yield from self._checked(relation, scope)
            for name in with_units:
                self.current.pop(name, None)

    def _given(self) -> None:
        columns: list[str] = []
        for row in ROW.finditer(self.tex):
            cells = [c.strip() for c in row[0].removesuffix("*").removesuffix(r"\\").split("&")]
            if "$" not in row[0]:
                columns = cells
            elif VALUES.intersection(columns) and len(cells) == len(columns):
                self._row(cells[0].strip("$"), dict(zip(columns, cells, strict=True)))
        for kind, load in ACTS.findall(self.tex):
            powers = self.table.measure(self.read(load))
            self.table.units.agree(powers or ONE, FORCE if kind in FORCES else COUPLE)

    def _row(self, name: str, said: Mapping[str, str]) -> None:
        value = next(said[c].strip("$") for c in VALUES if c in said)
        within = next((said[c].strip("$") for c in RANGES if c in said), "")
        tex = value or within.rpartition(r"\ldots\ ")[2]
        if tex:
            formula = self.read(tex)
            self.table.dimensions[name] = self.table.measure(formula) or ONE
            found = self.value(formula)
            if value and found is not None:
                self.table.values[name] = self.instead.get(name, found)

    def _opened(self, scope: str, number: int) -> list[str]:
        """Give the names of a part that counts per unit of a load meanings of their own."""
        said = PER_UNIT.search(scope)
        if said is None:
            return []
        unit, drive, ratio = said.groups()
        loads = [name for name in (unit, drive) if name]
        self.current |= {name: f"{name} of {number}" for name in loads}
        self.table.dimensions[f"{unit} of {number}"] = ONE
        self.table.values[f"{unit} of {number}"] = 1.0
        for relation in relations(scope):
            left = relation.parts[0]
            is_known = relation.is_boxed or left in (*self.table.values, *loads)
            if self._is_name(left) and not is_known and not left.startswith("k"):
                self.current[left] = f"{left} of {number}"
        if ratio:
            self.current[drive] = ratio
        return loads

    def _checked(self, relation: Relation, scope: str) -> Iterator[str]:
        try:
            sides = [self.read(part) for part in relation.parts]
        except (AssertionError, IndexError, ValueError) as error:
            self.unread.append(f"{relation}: {error}")
            return
        self.read_relations += 1
        try:
            self.table.alike(sides)
        except Contradiction as error:
            yield f"{relation}: {error}"
        if not relation.is_slope:
            yield from self._values(relation, sides)

    def _values(self, relation: Relation, sides: list[Formula]) -> Iterator[str]:
        values = [self.value(side) for side in sides]
        if isinstance(sides[0], Symbol):
            values[0] = self.instead.get(sides[0].name.partition(" of ")[0], values[0])
        known = [(i, v) for i, v in enumerate(values) if v is not None and math.isfinite(v)]
        if not known:
            return
        self.valued += len(known) > 1
        first, value = known[0]
        own = self.slack(relation.parts[first])
        for i, other in known[1:]:
            least = ZERO_AT_AN_END if other == 0 else NOTHING
            slack = own + self.slack(relation.parts[i]) + least
            if abs(other - value) > slack + 1e-9 * abs(value):
                yield f"{relation}: {value} and {other}"
        if isinstance(sides[0], Symbol):
            self.table.values[sides[0].name] = value
            self.rounded[sides[0].name] = own

    def slack(self, tex: str) -> float:
        """Return how far rounding of the numbers printed may change a formula's value.

        Names count with what rounding may have made of their own values.
        """
        formula = self.read(tex)
        here = self.value(formula) or 0.0
        total = 0.0
        for name in symbols(formula) & self.rounded.keys():
            moved = self.value(formula, {name: self.table.values[name] + self.rounded[name]})
            total += abs((moved or 0.0) - here)
        for literal in (found for found in READ.finditer(tex) if found[1]):
            size = float(literal[1])
            if size:
                half = 0.5 * 10.0 ** (math.floor(math.log10(size)) + 1 - FIGURES)
                if tex.startswith(DEGREES, literal.end(1)):
                    half = max(half, HALF_OF_LAST_DECIMAL)
                moved = f"{tex[: literal.start(1)]}{size + half:.12f}{tex[literal.end(1) :]}"
                total += abs((self.value(self.read(moved)) or 0.0) - here)
        return total


EXTENT = re.compile(
    r"(?:the (?:least|greatest) )?\$([^$]*)\$ is (0|\$[^$]*\$(?: \w+)?)[,;]? "
    r"at ((?:(?:, | and )?\$[^$=]*=[^$]*\$)+)( (?!and\b)\w+)?"
)
PLACE = re.compile(r"\$([^$=]*)=([^$]*)\$")
FLAT, STEEP = 1e-3, 2e-2
"""Places are told in four figures: what a result is off there, near an extremum or a zero."""

ROUNDED = (1.0, *(1 + 5e-4 * part / 4 for part in (-4, -3, -2, -1, 1, 2, 3, 4)))
"""A place in four figures, and what it may have been before it was rounded."""


def extents(tex: str) -> Iterator[tuple[str, str, tuple[str, str]]]:
    """Yield each result with the value that it is said to have, and ``(name, place)``."""
    for name, value, places, unit in EXTENT.findall(tex):
        for parameter, place in PLACE.findall(places):
            measured = rf"{place}\,\text{{{unit.strip()}}}" if unit else place
            of_value = re.sub(r"\$([^$]*)\$ ?(\w*)", r"\1\\,\\text{\2}", value)
            yield name, of_value.removesuffix(r"\,\text{}"), (parameter, measured)


ROUNDED_ZERO = 1e-12
"""What a result may be in SI that is zero, at a place with few digits and where it is usual."""


def displaced(tex: str) -> Iterator[str]:
    """Yield the extrema and zeros that are not where the page says, by its own formulas."""
    formulas = tex.partition(r"\section*{Numerical values}")[0]
    for name, said, (parameter, place) in extents(tex):
        page = PrintedUnits(formulas)
        list(page.contradictions())
        value, at = (page.value(page.read(part)) for part in (said, place))
        near = [_moved(formulas, name, parameter, at * part) for part in ROUNDED]
        usual = page.table.values.get(name)
        if usual is None or None in near:
            continue
        slack = STEEP * abs(usual) + ROUNDED_ZERO if value == 0 else FLAT * abs(value)
        if not min(near) - slack <= value <= max(near) + slack:
            yield f"{name} is {near[0]}, not {value}, at {parameter} = {place}"


def _moved(formulas: str, name: str, parameter: str, at: float) -> float | None:
    """Return the value of a result by the formulas of a page, with another value of a parameter."""
    page = PrintedUnits(formulas, {parameter: at})
    list(page.contradictions())
    return page.table.values.get(name)
