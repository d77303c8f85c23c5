"""The builders of statements whose fields are in another order than their words.

Their span, comments and remark come from the reader of the line.
"""

from typing import Any, Literal, cast

from ...diagnostics import syntax
from .. import ast
from ..fault import Fault
from .lalr import NOWHERE, Token, span_of

RangeExpressions = tuple[ast.Expr, ast.Expr]
TableRow = tuple[ast.Expr, ast.Expr]
Rim = tuple[ast.Expr, ast.Name | None]
"""A wheel: its radius, and the link that it is fixed to, or the ground."""


def unquoted(token: Token | None) -> str:
    r"""Return the text between the quotes; ``\n`` is a line end, ``\"`` a quote.

    >>> unquoted(Token("STRING", r'"a \"b\" c"'))
    'a "b" c'
    """
    parts = str(token or '""')[1:-1].split("\\\\")
    return "\\".join(part.replace("\\n", "\n").replace("\\", "") for part in parts)


def version(number: Token) -> ast.Version:
    """Return ``mechc 1``, the only version so far."""
    if number != "1":
        raise Fault(syntax.unknown_version(span_of(number), str(number)))
    return ast.Version(NOWHERE, str(number))


def sheet_heading(name: ast.Name, title: Token | None) -> ast.SheetHeading:
    """Return ``sheet NAME "Title"``."""
    return ast.SheetHeading(NOWHERE, name, unquoted(title))


def table(name: ast.Name, source: Token | None, *rows: TableRow) -> ast.Table:
    """Return ``table m49 "Table 4.9" = 1: 0.388, 0.9: 0.400``."""
    return ast.Table(NOWHERE, name, rows, unquoted(source))


def sizes(name: ast.Name, source: Token | None, *listed: ast.Expr) -> ast.Sizes:
    """Return ``list bores "ISO 15552" = 32 mm, 40 mm``."""
    return ast.Sizes(NOWHERE, name, listed, unquoted(source))


def let(name: ast.Name, value: ast.LetValue, unit: ast.Name | None, label: Token | None) -> ast.Let:
    """Return ``let p = 4*P/(pi*d^2) in MPa as "label"``."""
    return ast.Let(NOWHERE, name, value, unit, unquoted(label))


def translate(text: Token, *others: Token | None) -> ast.Translate:
    """Return ``translate "arm" uk "плече"``."""
    return ast.Translate(NOWHERE, unquoted(text), *map(unquoted, others))


def use(
    used: ast.Name,
    prefix: ast.Name,
    given: tuple[tuple[ast.Name, ast.Expr], ...] | None,
    at: ast.Cartesian | None,
    turned: ast.Expr | None,
    joining: tuple[tuple[ast.Name, ast.Name], ...] | None,
    without: tuple[ast.Name, ...] | None,
) -> ast.Use:
    """Return ``use clamp as T (P = 2*F) at (x, y) turned θ joining T.C = B without F``."""
    return ast.Use(NOWHERE, used, prefix, given or (), at, turned, joining or (), without or ())


def used(token: Token) -> ast.Name:
    """Return the name of a used description: one of the library, or a path in quotes."""
    text = unquoted(token) if token.type == "STRING" else str(token)
    return ast.Name(text, span_of(token))


def joint(there: ast.Name, equal: Token, here: ast.Name) -> tuple[ast.Name, ast.Name]:
    """Return ``T.C = B``."""
    return there, here


def given(*parts: Any) -> tuple[Any, ...]:
    """Return the values given to parameters, without the brackets around them."""
    return parts[1:-1]


def heading(name: ast.Name, title: Token | None) -> ast.Heading:
    """Return ``mechanism NAME "Title"``."""
    return ast.Heading(NOWHERE, name, unquoted(title))


def param(
    name: ast.Name,
    dimension: ast.Name | None,
    value: ast.Expr | None,
    tolerance: ast.Expr | None,
    ends: RangeExpressions | None,
    label: Token | None,
    about: Token | None,
) -> ast.Param:
    """Return a parameter, which has a value or a dimension or at least a range."""
    if tolerance and value is None:
        raise Fault(syntax.tolerance_of_nothing(tolerance.span, name.text))
    if dimension is None and value is None and ends is None:
        raise Fault(syntax.empty_parameter(name.span, name.text))
    low, high = ends or (None, None)
    texts = unquoted(label), unquoted(about)
    return ast.Param(NOWHERE, name, value, low, high, dimension, *texts, tolerance)


def link(points: ast.Name, label: Token | None) -> ast.Link:
    """Return ``link OBA "handle"``."""
    return ast.Link(NOWHERE, points, unquoted(label))


def slot(point: ast.Name, line: ast.Name, guided: ast.Name | None) -> ast.Slot:
    """Return ``slot B in OC guiding BD``."""
    return ast.Slot(NOWHERE, point, line, guided=guided)


def gear(first: ast.Name, one: Rim, second: ast.Name, other: Rim, inner: Token | None) -> ast.Gear:
    """Return ``gear O1 r1 on O1A, O2 r2 inner``."""
    (radius, link), (second_radius, second_link) = one, other
    is_inner = inner is not None
    return ast.Gear(NOWHERE, first, radius, second, second_radius, is_inner, link, second_link)


def belt(
    first: ast.Name, one: Rim, second: ast.Name, other: Rim, crossed: Token | None
) -> ast.Belt:
    """Return ``belt O1 r1 on O1A, O2 r2 crossed``."""
    (radius, link), (second_radius, second_link) = one, other
    is_crossed = crossed is not None
    return ast.Belt(NOWHERE, first, radius, second, second_radius, is_crossed, link, second_link)


def route(start: ast.Name, *falls: ast.Fall) -> tuple[ast.Name, tuple[ast.Fall, ...]]:
    """Return where a rope begins, and its falls."""
    return start, falls


def rope(route: tuple[ast.Name, tuple[ast.Fall, ...]]) -> ast.Rope:
    """Return ``rope A, K along -y, B along y``."""
    return ast.Rope(NOWHERE, *route)


def assembly(points: ast.Name, mode: Token) -> ast.Assembly:
    """Return ``assembly ABC ccw``."""
    return ast.Assembly(NOWHERE, points, cast(Any, str(mode)))


def mirror(across: ast.Direction, sharing: tuple[ast.Name, ...] | None) -> ast.Mirror:
    """Return ``mirror across θ sharing K``."""
    return ast.Mirror(NOWHERE, across, sharing or ())


def copies(number: ast.Expr, sharing: tuple[ast.Name, ...] | None) -> ast.Copies:
    """Return ``copies n sharing A``."""
    return ast.Copies(NOWHERE, number, sharing or ())


def force(
    name: ast.Name,
    tie: ast.Expr | None,
    point: ast.Name,
    link: ast.Name | None,
    along: ast.Direction,
    times: ast.Expr | None,
) -> ast.Force:
    """Return ``force P = tie at A on AB along θ times n``."""
    return ast.Force(NOWHERE, name, point, along, tie, times, link)


def weight(
    name: ast.Name,
    mass: ast.Expr,
    point: ast.Name,
    link: ast.Name | None,
    times: ast.Expr | None,
) -> ast.Weight:
    """Return ``weight W mass m at G on OG times n``."""
    return ast.Weight(NOWHERE, name, mass, point, times, link)


def distributed(
    name: ast.Name,
    intensity: ast.Expr | None,
    end: ast.Expr | None,
    line: ast.Name,
    along: ast.Direction,
    times: ast.Expr | None,
) -> ast.Distributed:
    """Return ``load Q intensity q1 to q2 on AB along θ times n``."""
    return ast.Distributed(NOWHERE, name, line, along, intensity, end, times)


PointOfLink = tuple[ast.Name, ast.Name | None]
"""An end of a pair of forces: a point, and the link that carries it there."""


def actuator(
    name: ast.Name, first: PointOfLink, second: PointOfLink, times: ast.Expr | None
) -> ast.Actuator:
    """Return ``actuator P between A on OA and B times n``."""
    return ast.Actuator(NOWHERE, name, first[0], second[0], times, first[1], second[1])


def spring(
    rate: ast.Expr, first: PointOfLink, second: PointOfLink, free: ast.Expr, times: ast.Expr | None
) -> ast.Spring:
    """Return ``spring c between A on OA and B free l0 times n``."""
    return ast.Spring(NOWHERE, rate, first[0], second[0], free, times, first[1], second[1])


def torque(
    name: ast.Name, tie: ast.Expr | None, points: ast.Name, times: ast.Expr | None
) -> ast.Torque:
    """Return ``torque M = tie on OA times n``."""
    return ast.Torque(NOWHERE, name, points, tie, times)


def law(token: Token | None) -> Any:
    """Return a law of friction by its word, '' where none was given."""
    return str(token or "")


def friction_pins(
    coefficient: ast.Expr, diameter: ast.Expr, named: Token | None
) -> ast.PinFriction:
    """Return ``friction pins f diameter d``."""
    return ast.PinFriction(NOWHERE, None, coefficient, diameter, law(named))


def friction_pin(
    point: ast.Name,
    coefficient: ast.Expr,
    diameter: ast.Expr,
    named: Token | None,
    link: ast.Name | None,
) -> ast.PinFriction:
    """Return ``friction pin A f diameter d on AB``."""
    return ast.PinFriction(NOWHERE, point, coefficient, diameter, law(named), link)


def friction_guide(
    point: ast.Name,
    coefficient: ast.Expr,
    length: ast.Expr | None = None,
    overhang: ast.Expr | None = None,
    named: Token | None = None,
) -> ast.GuideFriction:
    """Return ``friction slider K mu guide s overhang l couple``."""
    return ast.GuideFriction(NOWHERE, point, coefficient, length, overhang, law(named))


Thrust = tuple[ast.Expr, ast.Expr | None, ast.Name | None]


def thrust(force: ast.Expr, faces: ast.Expr | None, link: ast.Name | None) -> Thrust:
    """Return ``thrust W faces n on OA``."""
    return force, faces, link


def friction_collar(
    point: ast.Name, coefficient: ast.Expr, mean: ast.Expr, thrust: Thrust | None
) -> ast.CollarFriction:
    """Return ``friction collar A mu mean d thrust W``."""
    sizes = mean, None, None, law(None)
    return ast.CollarFriction(NOWHERE, point, coefficient, *sizes, *(thrust or ()))


def friction_ring(
    point: ast.Name,
    coefficient: ast.Expr,
    outer: ast.Expr,
    inner: ast.Expr,
    named: Token | None,
    thrust: Thrust | None,
) -> ast.CollarFriction:
    """Return ``friction collar A mu outer D inner d wear thrust W``."""
    sizes = None, outer, inner, law(named)
    return ast.CollarFriction(NOWHERE, point, coefficient, *sizes, *(thrust or ()))


Drum = tuple[ast.Expr, ast.Name]


def drum(diameter: ast.Expr, link: ast.Name) -> Drum:
    """Return ``drum D on OC``."""
    return diameter, link


def friction_rope(
    point: ast.Name, coefficient: ast.Expr, wrap: ast.Expr, turning: Drum | None
) -> ast.RopeFriction:
    """Return ``friction rope B mu wrap theta drum D on OC``."""
    return ast.RopeFriction(NOWHERE, point, coefficient, wrap, *(turning or ()))


def motion(sense: Token) -> ast.Motion:
    """Return ``motion tightening`` or its reverse."""
    return ast.Motion(NOWHERE, cast(Literal["tightening", "releasing"], str(sense)))


def unnamed_result(target: ast.Expr, on: ast.Name | None) -> ast.Find:
    """Return ``find P`` or ``find R_B on AB``."""
    return ast.Find(target.span.to((on or target).span), target, None, on)


def named_result(name: ast.Name, target: ast.Expr, on: ast.Name | None) -> ast.Find:
    """Return ``find k = P / F``."""
    return ast.Find(name.span.to((on or target).span), target, name, on)


def require(condition: tuple[Any, Any]) -> ast.Require:
    """Return ``require a < b < c``."""
    return ast.Require(NOWHERE, *condition)
