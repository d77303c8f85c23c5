"""Forces, torques and weights, and the formulas that tie one load to another."""

from collections.abc import Sequence
from fractions import Fraction

from ...diagnostics.model import loads as messages
from ...diagnostics.model import names, sizes
from ...diagnostics.model import spread_loads as spread_messages
from ...formula.evaluate import evaluate
from ...formula.tree import (
    Call,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    degrees,
    negative,
    number,
    product,
    total,
)
from ...formula.walk import symbols
from ...source import Span
from ...syntax import ast
from ...units import ACCELERATION, FORCE, MASS, NUMBER, STIFFNESS, TORQUE, Dimension
from ..constants import leaves, number_of, rational
from ..entries import Ray, drawn_places, ray_through, vector_between
from ..formulas.directions import check_sign, read_direction, value_of
from ..formulas.expressions import Reader
from ..formulas.measured import fits
from ..formulas.parameters import constant
from ..mechanism import (
    GRAVITY,
    Absolute,
    Arrow,
    Direction,
    Force,
    ForcePair,
    Load,
    Mechanism,
    Offset,
    Spread,
    Torque,
)
from ..names.scope import DESCRIPTION, TIE, NameScope
from ..statements import every, only
from ..values import ordered
from .force_pairs import carrying, read_force_pair
from .resultants import free_point

LEAST_G, MOST_G = 0.1, 100.0
"""Accelerations of free fall, in m/s^2, between which all are that somebody works with."""

G_IN_DIGITS = ("9.8", "9.80", "9.81", "9.807", "9.8066", "9.80665")
"""How the acceleration of free fall is written as a plain number."""


def read_loads(file: ast.File, built: Mechanism, scope: NameScope) -> list[Load]:
    """Return every load in the order of the file; lengths are those of what was ``built``."""
    gravity = _gravity(file, scope)
    is_mirrored = only(file, ast.Mirror) is not None
    _remark_on_weight_in_mass(file, scope)
    loads: list[Load] = []
    for statement in file.statements:
        match statement:
            case ast.Force():
                load: Load | None = _force(statement, scope)
            case ast.Torque():
                load = _torque(statement, scope)
            case ast.Weight():
                load = _weight(statement, gravity, scope)
            case ast.Distributed():
                load = _distributed(statement, free_point(loads, scope), built, scope)
            case ast.Actuator() | ast.Spring():
                times = _times(statement.times, scope)
                load = read_force_pair(statement, is_mirrored, times, scope)
            case _:
                continue
        if load:
            loads.append(load)
    _check_ties(loads, scope)
    _check_given_once(loads, file, scope)
    return loads


def _force(statement: ast.Force, scope: NameScope) -> Force | None:
    points = scope.points.acting(statement.point)
    link = carrying(statement.link, statement.point, scope)
    along = read_direction(statement.along, scope)
    times = _times(statement.times, scope)
    tie = _tie(statement.tie, FORCE, statement.name, scope) if statement.tie else None
    if not points or link is None or not along or (statement.tie and not tie):
        return None
    name = statement.name.text
    return Force(name, points[0], along, statement.span, tie, times, link=link)


def _torque(statement: ast.Torque, scope: NameScope) -> Torque | None:
    link = scope.points.link(statement.link)
    times = _times(statement.times, scope)
    tie = _tie(statement.tie, TORQUE, statement.name, scope) if statement.tie else None
    if not link or (statement.tie and not tie):
        return None
    return Torque(statement.name.text, link.name, statement.span, tie, times)


def _weight(statement: ast.Weight, along: Direction | None, scope: NameScope) -> Force | None:
    points = scope.points.acting(statement.point)
    link = carrying(statement.link, statement.point, scope)
    mass = Reader(scope, DESCRIPTION).wanted(statement.mass, MASS, "a mass")
    check_sign(mass, statement.mass.span, "a mass", scope)
    times = _times(statement.times, scope)
    g = _acceleration(scope)
    if not points or link is None or not mass or not along or not g:
        return None
    name, tie = statement.name.text, product([(mass, 1), (g, 1)])
    return Force(name, points[0], along, statement.span, tie, times, weight=True, link=link)


def _distributed(
    statement: ast.Distributed, point: str, built: Mechanism, scope: NameScope
) -> Force | None:
    """Return the resultant of a load that is spread over a stretch of a link."""
    link, ends = scope.points.link(statement.line), scope.points.acting(statement.line)
    along = read_direction(statement.along, scope)
    times = _times(statement.times, scope)
    name, at = statement.name.text, statement.line.span
    intensities = _intensities(statement, scope)
    if link is None or not ends or not along or intensities is None:
        return None
    if intensities and _cancels(intensities, scope):
        scope.report.add(spread_messages.spread_without_resultant(at, name))
        return None
    length = _length(ends[0], ends[1], built)
    if length is None:
        ray = ray_through((ends[0], ends[1]), built.geometry)
        start = ray.start if ray else ""
        scope.report.add(spread_messages.stretch_without_length(at, ends[0], ends[1], start))
        return None
    spread = Spread(link.name, ends[0], ends[1], length, _centroid(intensities), intensities)
    return Force(name, point, along, statement.span, spread.resultant, times, spread=spread)


def _intensities(statement: ast.Distributed, scope: NameScope) -> tuple[Formula, ...] | None:
    """Return the intensities at the ends of a stretch; None where one is wrong, reported."""
    reader = Reader(scope, DESCRIPTION)
    written = [e for e in (statement.intensity, statement.end) if e is not None]
    read = [reader.wanted(e, STIFFNESS, "an intensity") for e in written]
    _check_senses(statement, read, scope)
    found = tuple(
        scope.named("q", statement.name.text, formula, STIFFNESS, e.span)
        for e, formula in zip(written, read, strict=True)
        if formula is not None
    )
    return found if len(found) == len(written) else None


def _check_senses(
    statement: ast.Distributed, intensities: Sequence[Formula | None], scope: NameScope
) -> None:
    """Report a spread load that acts against its direction all along; one end alone may."""
    known = [value_of(each, scope) if each else None for each in intensities]
    if not known or any(value is None or value > 0 for value in known):
        return
    written = (e for e in (statement.intensity, statement.end) if e is not None)
    for formula, each in zip(intensities, written, strict=True):
        check_sign(formula, each.span, f"the intensity of {statement.name.text}", scope)


def _length(tail: str, head: str, built: Mechanism) -> Formula | None:
    """Return the distance of two points, as far as they are drawn or one entry gives it."""
    if length := _drawn_length(tail, head, built):
        return length
    match vector_between((tail, head), built.geometry):
        case Arrow(length=length):
            return length
        case Offset(x=x, y=y):
            return Call("hypot", (x, y))
        case None:
            return _collinear_length(tail, head, built)


def _collinear_length(tail: str, head: str, built: Mechanism) -> Formula | None:
    """Return the distance of two points on a line through a third one, where numbers give it."""
    match ray_through((tail, head), built.geometry):
        case Ray(near=Number(near), far=Number(far)) if near != far:
            return Number(abs(far - near))
        case _:
            return None


def _cancels(intensities: tuple[Formula, ...], scope: NameScope) -> bool:
    """Return whether a spread load adds up to nothing, as far as its ends have values."""
    mean = total(intensities)
    return symbols(mean) <= scope.values.keys() and evaluate(mean, scope.values) == 0


def _drawn_length(tail: str, head: str, built: Mechanism) -> Formula | None:
    """Return the distance of two points that are drawn, a number where it can be."""
    places = drawn_places(built)
    if not places.keys() >= {tail, head}:
        return None
    ends = zip(places[tail], places[head], strict=True)
    way = tuple(total([b, negative(a)]) for a, b in ends)
    if any(map(symbols, way)):
        return Call("hypot", way)
    return number_of(Call("hypot", tuple(map(number_of, way))))


def _centroid(intensities: tuple[Formula, ...]) -> Formula:
    """Return 1/2, or (q₁ + 2q₂)/(3(q₁ + q₂)): how far along the resultant acts."""
    if len(intensities) < 2:
        return number(Fraction(1, 2))
    first, second = intensities
    weighted = total([first, product([(number(2), 1), (second, 1)])])
    return product([(weighted, 1), (number(3), -1), (total([first, second]), -1)])


def _acceleration(scope: NameScope) -> Formula | None:
    """Return g: the parameter of that name if there is one."""
    declared = scope.declared("g")
    if declared is None:
        return GRAVITY
    what = "'g', the acceleration of free fall where there are weights"
    g = Reader(scope, DESCRIPTION).wanted(ast.Symbol("g", declared), ACCELERATION, what)
    check_sign(g, declared, "the acceleration of free fall", scope)
    value = value_of(g, scope) if g else None
    if value is not None and value > 0 and not LEAST_G < value < MOST_G:
        scope.report.add(sizes.strange_gravity(declared, value))
    return g


def _gravity(file: ast.File, scope: NameScope) -> Direction | None:
    statement = only(file, ast.Gravity)
    if statement is None:
        weights = every(file, ast.Weight)
        return Absolute(degrees(-90), weights[0].span if weights else Span(0, 0))
    if not every(file, ast.Weight):
        scope.report.add(messages.idle_gravity(statement.span))
    return read_direction(statement.along, scope)


def _times(expression: ast.Expr | None, scope: NameScope) -> Fraction:
    """Return the factor behind ``times``; 1 where there is none or an error was reported."""
    if expression is None:
        return Fraction(1)
    found = constant(expression, scope, "'times'")
    if not found or not fits(found, NUMBER, "'times'", scope):
        return Fraction(1)
    value = rational(found.formula)
    if value is not None and value > 0:
        return value
    shown = scope.report.source.written(expression.span)
    scope.report.add(messages.times_not_positive(expression.span, shown))
    return Fraction(1)


# ---------------------------------------------------------------------------- ties


def _tie(tie: ast.Expr, dimension: Dimension, name: ast.Name, scope: NameScope) -> Formula | None:
    """Return a formula that is proportional to exactly one other load."""
    formula = Reader(scope, TIE).wanted(tie, dimension, f"load '{name.text}'")
    if formula is None:
        return None
    loads = symbols(formula) & set(scope.names({"load"}))
    if len(loads) != 1 or degree(formula, loads) != 1:
        hint = ""
        if isinstance(tie, ast.Number) and tie.unit in scope.names({"load"}):
            hint = f"a share of {tie.unit} is a product: {tie.digits}*{tie.unit}"
        scope.report.add(messages.tie_not_linear(tie.span, name.text, hint))
        return None
    return formula


def degree(formula: Formula, loads: frozenset[str]) -> int | None:
    """Return the degree in which a formula is homogeneous in loads; None if in none.

    >>> degree(product([(Symbol("f"), 1), (Symbol("R"), 1)]), frozenset({"R"}))
    1
    """
    match formula:
        case Number() | Pi():
            return 0
        case Implicit():
            return None
        case Symbol(name):
            return int(name in loads)
        case Sum(terms):
            degrees_found = {degree(t, loads) for t in terms}
            return degrees_found.pop() if len(degrees_found) == 1 else None
        case Product(factors):
            parts = [degree(f, loads) for f in factors]
            return None if None in parts else sum(p for p in parts if p)
        case Power() | Call():
            return None if symbols(formula) & loads else 0


def _check_ties(loads: Sequence[Load], scope: NameScope) -> None:
    """Report ties that form a cycle."""
    ties = {load.name: load for load in loads if load.tie}
    needs = {name: symbols(load.tie) & ties.keys() for name, load in ties.items() if load.tie}
    for cycle in ordered({name: set(wanted) for name, wanted in needs.items()})[1]:
        places = [ties[name].span for name in cycle[:-1]]
        scope.report.add(names.circular_definition(places[0], cycle, places[1:]))


def _check_given_once(loads: Sequence[Load], file: ast.File, scope: NameScope) -> None:
    """Report loads that are tied, weights and springs that get a value by ``let`` as well.

    A weight whose mass has a value, a spread load whose intensities have, and a spring are not
    asked for either.
    """
    tied = {load.name: load for load in loads if load.tie}
    for let in every(file, ast.Let):
        name = let.name.text
        if name in tied:
            scope.report.add(messages.load_given_again(let.span, name, tied[name].span))
    for find in every(file, ast.Find):
        load = tied.get(find.target.name) if isinstance(find.target, ast.Symbol) else None
        if load and (giver := _giver(load, scope)):
            found = messages.known_load_asked_for(find.span, load.name, giver, load.span)
            scope.report.add(found)


def _giver(load: Load, scope: NameScope) -> str:
    """Return the giver of a load's value: a spring, a mass or an intensity, '' for none."""

    def has_value(formula: Formula) -> bool:
        return value_of(formula, scope) is not None

    match load:
        case ForcePair(spring=True):
            return "spring"
        case Force(weight=True, tie=tie) if tie is not None and has_value(tie):
            return "mass"
        case Force(spread=Spread(intensities=given)) if given and all(map(has_value, given)):
            return "intensity"
        case _:
            return ""


def _remark_on_weight_in_mass(file: ast.File, scope: NameScope) -> None:
    """Say of a mass that is multiplied by 9.81, itself or the parameter that it is."""
    values = {p.name.text: p.value for p in every(file, ast.Param) if p.value}
    for statement in every(file, ast.Weight):
        mass: ast.Expr | None = statement.mass
        if isinstance(mass, ast.Symbol):
            mass = values.get(mass.name)
        for leaf in leaves(mass) if isinstance(mass, ast.Product) else ():
            if isinstance(leaf, ast.Number) and not leaf.unit and leaf.digits in G_IN_DIGITS:
                scope.report.add(sizes.weight_in_mass(leaf.span, leaf.digits))
