"""A used mechanism that becomes a part of this one, joined to it at points.

Its points, links, joints, loads and parameters come in under names of their own
(:mod:`.part_names`) and in the frame that the line gives (:mod:`.framed`); from there on it is
one mechanism. What stays behind: what it finds and expects, formulas and conditions that rest
on that, forces at the joined points, which stand for the neighbour, and what ``without`` names.
One drive moves the whole: that of the file, or else of the first part that has one. The
parameter of a drive that stays behind has no value any more; a loop gives it one, and its
range is a condition of use (:func:`_kept_range`).
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from ...base.frozen import replace
from ...diagnostics import Report
from ...diagnostics import joining as messages
from ...diagnostics.model import quantities
from ...formula.evaluate import evaluate
from ...source import Span
from ...syntax import ast, moved
from ...units import ANGLE, DIMENSIONS, UNITS, Dimension
from ..forces.force_pairs import spring_name
from ..linkage.fast_pins import is_held
from ..mechanism import Interval, Parameter
from ..names.forms import COORDINATES, form_of, form_of_pose
from ..statements import declared
from .at_joints import AtJoints
from .brought import given_to, labelled, labels, parameter, translated, with_origin
from .composed import Used
from .framed import PartFrame, between, literal, negative, number, plus, same
from .joint_points import Joining, UsedPart, WholeMechanism, is_a_part, joints, move_alike
from .part_names import declared_points, numbered, of_a_part, renamed, symbols_in

BEHIND = (ast.Version, ast.Heading, ast.SourceNote, ast.Find, ast.Expect, ast.Motion, ast.Gravity)
"""What a part leaves behind: these are said of the whole."""

FOUND = frozenset({"V", "omega", "R", "N"})
"""The quantities that are found of a mechanism, by their prefixes."""


def part_of(
    use: ast.Use, used: Used, whole: WholeMechanism, met: frozenset[str], report: Report
) -> UsedPart | None:
    """Return a used mechanism as a part of the whole; None where something is wrong, reported.

    ``met`` are its points at which it is joined, here or by parts below.
    """
    own = tuple(moved.moved(s, used.start) for s in used.file.statements)
    there, here = declared_points(own), declared_points(whole.statements)
    joined = joints(Joining(use, used, own, whole, {}, met), there, here, report)
    if joined is None:
        return None
    joining = Joining(use, used, own, whole, joined, met)
    if not is_a_part(joining, report) or not move_alike(joining, report):
        return None
    points = numbered(there, joined, use.prefix.text, here)
    part = UsedPart(points, used, use.prefix.span)
    return part._replace(statements=tuple(_statements(joining, points, report)))


# ----------------------------------------------------------------------- left behind


def _left_behind(joining: Joining, report: Report) -> frozenset[str]:
    """Return the names of quantities that stay behind; report what cannot."""
    use = joining.use
    loads = {_load_name(s): s for s in joining.own if isinstance(s, ast.Load)}
    known = [*loads, *joining.used.parameters]
    for name in use.without:
        if name.text not in known:
            report.add(messages.not_there(name.span, name.text, joining.used.mechanism.name, known))
    forces = (s for s in joining.own if isinstance(s, ast.Force))
    behind = {s.name.text for s in forces if s.point.text in joining.met}
    behind |= {name.text for name in use.without} & loads.keys()
    for load, statement in loads.items():
        rests = {s.name for s in symbols_in(statement)} & behind
        if load not in behind and rests:
            place, tied = use.used.span, statement.span
            report.add(messages.rests_on_what_stays(place, load, min(rests), tied))
    places = set(_coordinates(joining.own))
    return frozenset(
        behind | places | _resting_on(behind | {*_results(joining.own), *places}, joining.own)
    )


def _results(own: Iterable[ast.Statement]) -> Iterator[str]:
    """Yield the names of results: those that are named, and loads that are asked for."""
    for statement in own:
        match statement:
            case ast.Find(name=ast.Name(text=name)) | ast.Find(target=ast.Symbol(name=name)):
                yield name


def _coordinates(own: Sequence[ast.Statement]) -> Iterator[str]:
    """Yield the coordinates that formulas ask for: a part has its place in the whole."""
    names = {name.text for statement in own for name in declared(statement)}
    for symbol in (symbol for statement in own for symbol in symbols_in(statement)):
        form = form_of_pose(symbol.name)
        if form and form.prefix in COORDINATES and symbol.name not in names:
            yield symbol.name


def _load_name(statement: ast.Load) -> str:
    return spring_name(statement) if isinstance(statement, ast.Spring) else statement.name.text


def _resting_on(behind: set[str], own: Sequence[ast.Statement]) -> set[str]:
    """Return the user-defined formulas that rest on what stays behind, one by way of another."""
    found: set[str] = set()
    lets = [s for s in own if isinstance(s, ast.Let)]
    while more := {s.name.text for s in lets if _rests(s, behind | found)} - found:
        found |= more
    return found


def _rests(statement: ast.Statement, behind: set[str] | frozenset[str]) -> bool:
    """Return whether a statement names what stays behind, or what is found of a mechanism."""
    forms = ((s.name, form_of(s.name)) for s in symbols_in(statement))
    return any(name in behind or (form and form.prefix in FOUND) for name, form in forms)


# ---------------------------------------------------------------------------- the frame


def _frame(joining: Joining, report: Report) -> PartFrame:
    """Return the frame of a part: as it is said, or so that drawn places of a joint coincide."""
    there, here = _places(joining.own), _places(joining.whole.statements)
    use = joining.use
    drawn = [(p, q) for p, q in joining.joined.items() if p in there and q in here]
    turned = _turn(use, report)
    frame = PartFrame(use.at, turned)
    if use.at is None and drawn:
        first, outside = drawn[0]
        frame = between(here[outside], there[first], turned)
    for inside, outside in drawn:
        if not same(frame.place(there[inside]), here[outside]):
            spans = there[inside].span, here[outside].span
            report.add(messages.other_place(use.prefix.span, inside, outside, *spans))
            break
    return frame


def _turn(use: ast.Use, report: Report) -> ast.Expr | None:
    """Return by what a part is turned; None where that is a number of another dimension."""
    found = literal(use.turned) if use.turned else None
    unit = UNITS.get(found[1]) if found else None
    if use.turned is None or unit is None or unit.dimension == ANGLE:
        return use.turned
    what = "what a part is turned by"
    report.add(quantities.wrong_dimension(use.turned.span, unit.dimension, ANGLE, what))
    return None


def _places(statements: Iterable[ast.Statement]) -> dict[str, ast.Cartesian]:
    """Return where points are said to be."""
    placed = (s for s in statements if isinstance(s, ast.Pivot | ast.Drawn))
    return {s.point.text: s.at for s in placed if s.at}


# -------------------------------------------------------------------------- coming in


def _statements(
    joining: Joining, points: Mapping[str, str], report: Report
) -> Iterator[ast.Statement]:
    """Yield the statements of a part in the whole."""
    use, used, prefix = joining.use, joining.used, joining.use.prefix.text
    given = given_to(use, used, report)
    frame, behind = _frame(joining, report), _left_behind(joining, report)
    quantities = {n.text: f"{prefix}_{n.text}" for s in joining.own for n in declared(s)}
    names = of_a_part(points, quantities, frame.seen)
    springs = [s for s in joining.own if isinstance(s, ast.Spring)]
    quantities |= {spring_name(s): spring_name(renamed(s, names)) for s in springs}
    called = {f"{prefix}.{own}": name for own, name in points.items()}
    at_joints = AtJoints(joining.whole.statements, joining.joined, called)
    for statement in _coming(joining, behind, at_joints, points):
        described = with_origin(labelled(statement), used.mechanism.name)
        there = frame.statement(renamed(described, names))
        if isinstance(statement, ast.Param) and isinstance(there, ast.Param):
            yield from _parameter(statement.name.text, there, joining, given)
        else:
            yield from at_joints.left(statement, there, report)
    for name in filter(used.loads.__contains__, given):
        yield ast.Let(use.span, ast.Name(quantities[name], use.span), given[name])


def _parameter(
    name: str, there: ast.Param, joining: Joining, given: Mapping[str, ast.Expr]
) -> Iterator[ast.Statement]:
    """Yield the statements of a part's parameter in the whole.

    One that a loop gives has no value and keeps to its range, one that is given a number has that.
    """
    known, value = joining.used.parameters[name], given.get(name)
    word = next((w for w, kind in DIMENSIONS.items() if kind == known.dimension), None)
    measures = ast.Name(word, there.span) if word else None
    if value and word and _is_literal(value, known.dimension):
        yield replace(there, value=value, tolerance=None, dimension=measures)
    elif name not in joining.freed:
        yield parameter(there, known, value, joining.use)
    else:
        yield replace(there, value=None, low=None, high=None, tolerance=None, dimension=measures)
        yield from _kept_range(there, known)


def _is_literal(value: ast.Expr, dimension: Dimension) -> bool:
    """Return whether a value is a number of a dimension; one of another is given amiss."""
    found = literal(value)
    unit = UNITS.get(found[1]) if found else None
    return found is not None and (unit is None or unit.dimension == dimension)


def _coming(
    joining: Joining, behind: frozenset[str], at_joints: AtJoints, points: Iterable[str]
) -> Iterator[ast.Statement]:
    """Yield the statements of a used mechanism that come in, by the names that they have there."""
    texts = labels(joining.own)
    for statement in joining.own:
        match statement:
            case ast.Translate(text=text):
                if text in texts:
                    yield from translated(statement, joining.used, joining.own)
            case ast.PinFriction(point=None):
                yield from _each_pin(statement, joining, at_joints, points)
            case _ if not _stays(statement, joining, behind):
                yield statement


def _stays(statement: ast.Statement, joining: Joining, behind: frozenset[str]) -> bool:
    """Return whether a statement stays behind."""
    match statement:
        case ast.Drive():
            return joining.whole.is_driven
        case ast.Let(name=name):
            return name.text in behind
        case ast.Require():
            return _rests(statement, behind)
        case _ if isinstance(statement, ast.Load):
            return _load_name(statement) in behind
        case _:
            return isinstance(statement, BEHIND)


def _each_pin(
    statement: ast.PinFriction, joining: Joining, at_joints: AtJoints, points: Iterable[str]
) -> Iterator[ast.PinFriction]:
    """Yield the friction of each pin of a part, of which one line says that all have it."""
    mechanism, joined = joining.used.mechanism, joining.joined
    bodies = [b.points for b in mechanism.rigid_links]
    bodies += [b.points for b in mechanism.telescopes]
    frictions = (s for s in joining.own if isinstance(s, ast.PinFriction))
    named = {s.point.text for s in frictions if s.point}
    for point in points:
        at = sum(point in body for body in bodies)
        is_pin = at > 1 or (at == 1 and (point in joined or is_held(point, mechanism)))
        if is_pin and point not in named and not at_joints.has_friction(point):
            yield replace(statement, point=ast.Name(point, statement.span))


# -------------------------------------------------------------------------------------- ranges kept


def _kept_range(statement: ast.Param, parameter: Parameter) -> Iterator[ast.Require]:
    """Yield the condition that a value found by a loop keeps to the range of a parameter."""
    if not parameter.range or not statement.low or not statement.high:
        return
    low, high = statement.low, statement.high
    name, place = (
        ast.Symbol(statement.name.text, statement.name.span),
        Span(low.span.start, high.span.end),
    )
    condition = ast.Require(place, (low, name, high), ("<=", "<="), remark=statement.label)
    if parameter.dimension != ANGLE or _in_half_turns(parameter.range):
        yield condition
    elif not _is_a_turn(parameter.range):
        middle, reach = _half(plus(high, low)), _half(plus(high, negative(low)))
        sides = _cosine(plus(name, negative(middle))), _cosine(reach)
        yield replace(condition, operands=sides, operators=(">=",))


def _in_half_turns(within: Interval) -> bool:
    return all(abs(evaluate(end, {})) < math.pi for end in within)


def _is_a_turn(within: Interval) -> bool:
    return evaluate(within.high, {}) - evaluate(within.low, {}) >= 2 * math.pi


def _half(value: ast.Expr) -> ast.Expr:
    """Return half a value: a number where it is one."""
    if known := literal(value):
        return number(known[0] / 2, known[1], value.span)
    return ast.Product(((1, value), (-1, number(Fraction(2), "", value.span))), value.span)


def _cosine(angle: ast.Expr) -> ast.Expr:
    return ast.Call("cos", (angle,), angle.span)
