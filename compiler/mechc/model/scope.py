"""The world of names: parameters, loads, results and lets, and what formulas may use."""

import re
from collections.abc import Iterable
from typing import Literal, NamedTuple

from ..diagnostics import Report
from ..diagnostics.model import names as words
from ..formula.tree import Formula
from ..formula.walk import evaluate, symbols
from ..source import Span
from ..syntax import ast
from ..syntax.words import points_of
from ..units import Dimension
from .points import Points

Kind = Literal["parameter", "let", "load", "result"]

FORMS = {
    "V": "the velocity of a point",
    "omega": "the angular velocity of a link",
    "R": "the force on a pin",
    "N": "the force along a rod, or of a guide",
    "phi": "the direction of a vector",
    "len": "the length of a vector",
}
"""Quantities of the mechanism itself, as ``V_D``: their prefixes and meanings."""

_FORM = re.compile(rf"({'|'.join(FORMS)})_(.+)")
_SEVERAL_POINTS = frozenset({"omega", "phi", "len"})
_ONE_POINT = frozenset({"V", "R"})


class Form(NamedTuple):
    """A reserved name taken apart: ``omega_OB`` is ``omega`` of O and B."""

    prefix: str
    points: tuple[str, ...]


def form_of(name: str) -> Form | None:
    """Take a reserved name apart; None for any other name.

    >>> form_of("omega_OB"), form_of("R_o"), form_of("phi_A")
    (Form(prefix='omega', points=('O', 'B')), None, None)
    """
    match = _FORM.fullmatch(name)
    points = points_of(match[2]) if match else ()
    if not match or not points:
        return None
    misfits = _ONE_POINT if len(points) > 1 else _SEVERAL_POINTS
    return None if match[1] in misfits else Form(match[1], points)


class Entry(NamedTuple):
    """What a name stands for. ``dimension`` is None where an error hid it.

    ``plain`` tells of a ``let`` that it depends on parameters only.
    """

    kind: Kind
    span: Span
    dimension: Dimension | None = None
    plain: bool = True


class Usage(NamedTuple):
    """Which kinds of names a formula may mention, and how to say so.

    With ``plain`` a let must depend on parameters only; with ``feeds`` it thereby becomes
    a dependent parameter, since the description itself is made of it.
    """

    kinds: frozenset[Kind]
    wanted: str
    plain: bool = True
    feeds: bool = True


DESCRIPTION = Usage(frozenset({"parameter", "let"}), "parameters and what follows from them")
TIE = Usage(frozenset({"parameter", "let", "load"}), "parameters and one load")
CONDITION = DESCRIPTION._replace(feeds=False)
EXPECTED = TIE._replace(wanted="parameters and loads", feeds=False)
FORMULA = Usage(frozenset({"parameter", "let", "load", "result"}), "a quantity", False, False)


class Scope:
    """The names of one description, filled while it is read.

    ``feeding`` holds the lets that the description itself (geometry, parameters, loads)
    uses; ``values`` the numbers of the parameters that have one, in SI, and ``sizes`` those
    of all parameters, 1 for an open one, which tell multiples that are out of reach.
    """

    def __init__(self, report: Report, points: Points) -> None:
        self.report = report
        self.points = points
        self.entries: dict[str, Entry] = {}
        self.used: set[str] = set()
        self.feeding: set[str] = set()
        self.values: dict[str, float] = {}
        self.sizes: dict[str, float] = {}

    def declare(self, name: ast.Name, kind: Kind, dimension: Dimension | None = None) -> bool:
        """Enter a name; False where it is taken or reserved, which is reported."""
        if form := form_of(name.text):
            meaning = f"{FORMS[form.prefix]} {''.join(form.points)}"
            self.report.add(words.reserved_form(name.span, name.text, meaning))
            return False
        return self.enter(name.text, Entry(kind, name.span, dimension))

    def enter(self, name: str, entry: Entry) -> bool:
        """Enter a name made up by the compiler or vetted before; False where it is taken."""
        if first := self.entries.get(name):
            self.report.add(words.name_taken(entry.span, name, entry.kind, first.span, first.kind))
            return False
        self.entries[name] = entry
        return True

    def define(self, name: str, dimension: Dimension, plain: bool = True) -> None:
        """State what a declared name measures, once its formula is read."""
        entry = self.entries[name]
        self.entries[name] = entry._replace(dimension=dimension, plain=plain)

    def look_up(self, symbol: ast.Symbol, usage: Usage) -> Entry | None:
        """Return what a name in a formula stands for; None where that is an error."""
        entry = self.entries.get(symbol.name)
        if entry is None:
            known = self.names(usage.kinds) if len(self.entries) <= words.MANY else ()
            self.report.add(words.unknown_name(symbol.span, symbol.name, known))
            return None
        self.used.add(symbol.name)
        if entry.kind not in usage.kinds or (usage.plain and not entry.plain):
            kind = f"a {entry.kind}" if entry.plain else "a formula of loads or results"
            self.report.add(words.name_out_of_place(symbol.span, symbol.name, kind, usage.wanted))
            return None
        if entry.kind == "let" and usage.feeds:
            self.feeding.add(symbol.name)
        return entry if entry.dimension is not None else None

    def size(self, formula: Formula) -> float:
        """Return the value of a formula of the description, what is open being 1."""
        return evaluate(formula, dict.fromkeys(symbols(formula), 1.0) | self.sizes)

    def names(self, kinds: Iterable[Kind]) -> list[str]:
        """Return the names of some kinds, in order of declaration."""
        return [name for name, entry in self.entries.items() if entry.kind in kinds]
