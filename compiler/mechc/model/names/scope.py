"""The world of names: parameters, loads, results and lets, and what formulas may use."""

from collections.abc import Iterable, Iterator
from itertools import permutations
from typing import Literal

from ...base.named import NamedTuple
from ...diagnostics import Report
from ...diagnostics.model import names as messages
from ...formula.evaluate import evaluate
from ...formula.names import ParsedName, another, split_name
from ...formula.tree import ZERO, Constant, Formula, Number
from ...formula.walk import symbols
from ...source import Span
from ...syntax import ast
from ...syntax.vocabulary import points_of
from ...units import DIMENSIONS, PARTS, Dimension
from . import not_brought
from .forms import FORMS, form_of, form_of_pose
from .points import PointTable

NameKind = Literal["parameter", "let", "load", "result", "table", "list"]


class ScopeEntry(NamedTuple):
    """What a name stands for. ``dimension`` is None where an error hid it.

    A ``let`` may depend on loads or results, ``on_loads``, on results, ``on_results``, or on
    directions and lengths that the pose has, ``on_pose``, so that the pose cannot follow from it.
    A quantity made of numbers without unit only ``is_unitless``; where it is one such number,
    that is ``number``.
    """

    kind: NameKind
    span: Span
    dimension: Dimension | None = None
    on_loads: bool = False
    on_pose: bool = False
    on_results: bool = False
    is_unitless: bool = False
    number: "UnitlessNumber | None" = None


class UnitlessNumber(NamedTuple):
    """A number without unit that a parameter was given, and where it stands."""

    digits: str
    span: Span


class NamedNumber(NamedTuple):
    """A number under a name that it was given, and where it stands."""

    symbol: Constant
    dimension: Dimension
    span: Span


class Usage(NamedTuple):
    """Which kinds of names a formula may mention, and how to say so.

    A let in it may depend on loads and results only ``with_loads``, on results only
    ``with_results``. Of a formula ``in_description`` a let becomes a dependent parameter, since
    the description itself is made of it. ``with_pose`` it may mention ``phi_AB`` and ``len_AB``.
    """

    kinds: frozenset[NameKind]
    wanted: str
    with_loads: bool = False
    in_description: bool = True
    with_pose: bool = True
    with_results: bool = True


DESCRIPTION = Usage(
    frozenset({"parameter", "let"}), "parameters and what follows from them", with_pose=False
)
TIE = Usage(frozenset({"parameter", "let", "load"}), "parameters and one load")
CONDITION = DESCRIPTION._replace(in_description=False, with_pose=True)
EXPECTED = TIE._replace(
    wanted="parameters and loads", with_loads=True, in_description=False, with_results=False
)
FORMULA = Usage(frozenset({"parameter", "let", "load", "result"}), "a quantity", True, False)


AXES = {
    **dict.fromkeys(("down", "downwards", "downward", "bottom"), "-y"),
    **dict.fromkeys(("up", "upwards", "upward", "vertical", "vertically"), "y"),
    **dict.fromkeys(("left", "leftwards"), "-x"),
    **dict.fromkeys(("right", "rightwards", "horizontal", "horizontally"), "x"),
}
"""What people call the directions of the axes."""


class NameScope:
    """The names of one description, filled while it is read.

    ``lets`` holds the names of all lets, which are entered behind what is asked for, and
    ``feeding`` those that the description itself (geometry, parameters, loads) uses; ``values``
    the numbers of the parameters that have one, in SI, and ``sizes`` those of all parameters, 1
    for an open one, which reveal multiples that are out of reach; ``ranges`` has the ends of
    those that run over one, ``settings`` the places where the command line gives a value.
    ``constants`` are the numbers that have got a name, by what they are and their value, with
    their places, ``shared`` those that belong to no point alone, ``brought`` what is used, by its
    prefix. Of a calculation ``sheet`` a condition keeps the names of lets.
    """

    def __init__(self, report: Report, points: PointTable, sheet: bool = False) -> None:
        self.report = report
        self.sheet = sheet
        self.points = points
        self.entries: dict[str, ScopeEntry] = {}
        self.used: set[str] = set()
        self.feeding: set[str] = set()
        self.lets: set[str] = set()
        self.values: dict[str, float] = {}
        self.settings: dict[str, Span] = {}
        self.sizes: dict[str, float] = {}
        self.ranges: dict[str, tuple[float, float]] = {}
        self.lower_ends: dict[str, Span] = {}
        self.constants: dict[tuple[str, Formula], NamedNumber] = {}
        self.shared = frozenset[Formula]()
        self.shared_sizes = frozenset[tuple[str, Formula]]()
        self.brought: dict[str, ast.Brought] = {}
        self._on_paper: dict[ParsedName, str] = {}
        self._misfits: set[tuple[str, Dimension]] = set()
        self._unknowns: set[tuple[str, str]] = set()

    def declare(self, name: ast.Name, kind: NameKind, dimension: Dimension | None = None) -> bool:
        """Enter a name; False where it is taken or reserved, which is reported."""
        if form := form_of(name.text):
            meaning = f"{FORMS[form.prefix]} {''.join(form.points)}"
            self.report.add(messages.reserved_form(name.span, name.text, meaning))
            return False
        return self.enter(name.text, ScopeEntry(kind, name.span, dimension))

    def enter(self, name: str, entry: ScopeEntry) -> bool:
        """Enter a name made up by the compiler or vetted before; False where it is taken."""
        first = self.entries.get(name)
        if first and first.span == entry.span:
            self.report.add(messages.list_of_values(entry.span, name, entry.kind))
            return False
        if first:
            self.report.add(
                messages.name_taken(entry.span, name, entry.kind, first.span, first.kind)
            )
            return False
        self.entries[name] = entry
        alike = self._on_paper.setdefault(split_name(name), name)
        if alike != name:
            self.report.add(messages.look_alike(entry.span, name, alike, self.entries[alike].span))
        return True

    def define(
        self,
        name: str,
        dimension: Dimension,
        on_loads: bool = False,
        on_pose: bool = False,
        on_results: bool = False,
    ) -> None:
        """State what a declared name measures, once its formula is read."""
        self.entries[name] = self.entries[name]._replace(
            dimension=dimension, on_loads=on_loads, on_pose=on_pose, on_results=on_results
        )

    def without_unit(self, name: str, number: UnitlessNumber | None = None) -> None:
        """State that a declared name is a number without unit, which is no angle."""
        self.entries[name] = self.entries[name]._replace(is_unitless=True, number=number)

    def declared(self, name: str) -> Span | None:
        """Return where a name is declared."""
        entry = self.entries.get(name)
        return entry.span if entry else None

    def cause(self, formula: Formula, span: Span) -> Span:
        """Return the place of a wrong value: the setting of a name in it, else its own."""
        return next((self.settings[n] for n in symbols(formula) if n in self.settings), span)

    def named(
        self, kind: str, of: str, formula: Formula, dimension: Dimension, span: Span, what: str = ""
    ) -> Formula:
        """Return a number under a name such as ``c_AB``, one for each value; else the formula.

        That of several parts which are the same, ``what``, is ``c``: as c_AB it would be read as
        that of one of them.
        """
        if not isinstance(formula, Number) or formula == ZERO:
            return formula
        key = f"{kind} {what}", formula
        if key not in self.constants:
            name = f"{kind}_{of}" if of and (what, formula) not in self.shared_sizes else kind
            taken = {*self.entries, *(known.symbol.name for known in self.constants.values())}
            while name in taken:
                name = another(name)
            self.constants[key] = NamedNumber(Constant(name, formula), dimension, span)
        return self.constants[key].symbol

    def first_misfit(self, name: str, wanted: Dimension) -> bool:
        """Whether it is the first time that a name measures something else than is wanted."""
        first = (name, wanted) not in self._misfits
        self._misfits.add((name, wanted))
        return first

    def doubt(self, formula: Formula) -> None:
        """State that what the names of a formula measure is reported to be wrong."""
        for name in symbols(formula) & self.entries.keys():
            self.entries[name] = self.entries[name]._replace(dimension=None)

    def unitless_number(self, formula: Formula) -> UnitlessNumber | None:
        """Return the number without unit that a formula is made of, where it is one."""
        found = {self.entries[name].number for name in symbols(formula) if name in self.entries}
        return found.pop() if len(found) == 1 else None

    def _unknown(self, symbol: ast.Symbol, usage: Usage) -> None:
        use = not_brought.of_a_use(symbol.name, self.brought)
        near = f"{use.prefix}_" if use else ""
        offered = [name for name in self._offered(usage) if name.startswith(near)]
        hint = next(filter(None, self._hints(symbol, usage, use)), "")
        self.unknown(symbol.span, symbol.name, offered, hint, use)

    def _hints(self, symbol: ast.Symbol, usage: Usage, use: ast.Brought | None) -> Iterator[str]:
        """Yield what an unknown name may have been meant as, the surest first, or ''."""
        name, small, raised = symbol.name, symbol.name.lower(), _with_capitals(symbol.name)
        text, at = self.report.source.part(symbol.span)
        before = text.text[: at.start]
        if not_brought.without_friction(name) in self._results():
            yield messages.with_friction(name)
        if name in DIMENSIONS:
            yield messages.dimension_as_value(name)
        if name == "z" and before.endswith("along "):
            yield messages.PLANAR
        if small in AXES:
            yield messages.axis_in_words(name, AXES[small])
        if name in self.points.places:
            yield messages.point_as_quantity(name)
        if name == "radius":
            yield messages.NEGATIVE_RADIUS
        yield messages.for_a_turn(before, name)
        if len(name) > 1 and name in PARTS:
            yield messages.unit_alone(name)
        if small in ("inf", "infinity", "nan"):
            yield "a value is a number, and finite"
        if len(points_of(name)) > 1:
            yield messages.vector_as_quantity(name, usage.with_pose)
        yield messages.rest_of_unit(before, name)
        yield messages.power_of_unit(name)
        yield messages.thread_by_name(before, name)
        if raised != name and form_of_pose(raised):
            yield messages.points_in_small(name, raised)
        elif (form := form_of_pose(name)) and not self.points.places.keys() >= set(form.points):
            yield messages.of_no_point(name, self.points.places)
        if use:
            yield not_brought.reason(name, use, self.entries)

    def _results(self) -> set[str]:
        return {name for name, entry in self.entries.items() if entry.kind == "result"}

    def unknown(
        self,
        span: Span,
        name: str,
        offered: list[str],
        hint: str = "",
        use: ast.Brought | None = None,
    ) -> None:
        """Report a name that nothing declares, where it is first met."""
        if (name, hint) not in self._unknowns:
            self._unknowns.add((name, hint))
            place = use.span if use else None
            self.report.add(messages.unknown_name(span, name, offered, hint, place))

    def look_up(self, symbol: ast.Symbol, usage: Usage) -> ScopeEntry | None:
        """Return the entry of a name in a formula; None where that is an error."""
        entry = self.entries.get(symbol.name)
        if entry is None:
            self._unknown(symbol, usage)
            return None
        self.used.add(symbol.name)
        if kind := _misplaced(entry, usage):
            is_found = entry.kind in ("load", "result") or entry.on_results
            hint = messages.FORCES_CHECKED if usage is CONDITION and is_found else ""
            hint = hint or messages.asked_for_a_value(entry.kind, symbol.name)
            self.report.add(
                messages.name_out_of_place(symbol.span, symbol.name, kind, usage.wanted, hint)
            )
            return None
        if entry.kind == "let" and usage.in_description:
            self.feeding.add(symbol.name)
        return entry if entry.dimension is not None else None

    def _offered(self, usage: Usage) -> list[str]:
        """Return the names that may stand in a formula, as far as they are few enough to list."""
        if len(self.entries) > messages.MOST_COMPARED_NAMES:
            return []
        pairs = [permutations(k.points, 2) for k in self.points.links.values()]
        vectors = [f"{form}_{a}{b}" for pair in pairs for a, b in pair for form in ("phi", "len")]
        posed = vectors if usage.with_pose and len(vectors) <= messages.MOST_COMPARED_NAMES else []
        return [*self.names(usage.kinds), *posed]

    def size(self, formula: Formula) -> float:
        """Return the value of a formula of the description, what is open being 1."""
        return evaluate(formula, dict.fromkeys(symbols(formula), 1.0) | self.sizes)

    def names(self, kinds: Iterable[NameKind]) -> list[str]:
        """Return the names of some kinds, in order of declaration."""
        return [name for name, entry in self.entries.items() if entry.kind in kinds]


def _misplaced(entry: ScopeEntry, usage: Usage) -> str:
    """Return in words what stands in a formula and may not, '' where it may."""
    has_loads = entry.on_loads and not usage.with_loads
    has_results = entry.on_results and not usage.with_results
    if entry.kind not in usage.kinds or has_loads or has_results:
        return "a formula of loads or results" if entry.on_loads else f"a {entry.kind}"
    if entry.on_pose and usage.in_description:
        return "a formula of directions and lengths that follow from the description"
    return ""


def _with_capitals(name: str) -> str:
    """Return a name with the points behind its underscore as they are written.

    >>> _with_capitals("x_b"), _with_capitals("phi_ab2"), _with_capitals("phi")
    ('x_B', 'phi_AB2', 'phi')
    """
    head, joint, points = name.partition("_")
    return f"{head}{joint}{points.upper()}"
