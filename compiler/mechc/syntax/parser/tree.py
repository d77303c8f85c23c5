"""What the LALR parser builds at each rule: one entry per name in the grammar.

Most statements have their fields in the order in which the words stand in the line, so
the node's class is the entry, of what passes motion on by the name of the class; the others
have a small function. Their span, comments and
remark come from the reader of the line.
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, get_args

from .. import ast
from ..vocabulary import GROUND
from . import builders, expressions
from .lalr import NOWHERE, Token, span_of

Made = Callable[..., object]
Toleranced = tuple[ast.Expr, ast.Expr | None]


def measure(value: ast.Expr, tolerance: ast.Expr | None) -> Toleranced:
    """Return ``40 mm +- 0.1 mm``, a value with or without a tolerance."""
    return value, tolerance


def expectation(
    subject: ast.Expr, value: ast.Expr, tolerance: ast.Expr | None, *at: Any
) -> ast.Expect:
    """Return ``k = 7.1 +- 0.1 at alpha = 35 deg``."""
    settings = tuple(setting for setting in at if setting is not None)
    return ast.Expect(NOWHERE, subject, value, settings, tolerance)


def part_of_report(name: ast.Name) -> ast.Reported:
    """Return ``scheme``, or ``k``."""
    return ast.Reported(name.span, name)


def plot_in_report(name: ast.Name, over: ast.Name) -> ast.Reported:
    """Return ``plot k over alpha``."""
    return ast.Reported(name.span.to(over.span), name, over)


def name(token: Token) -> ast.Name:
    """Return a name that the user gives or uses."""
    return expressions.new_name(str(token), span_of(token))


def dimension(token: Token) -> ast.Name:
    """Return the name of a dimension; some are words of the language too."""
    return ast.Name(str(token), span_of(token))


def points(kind: str, token: Token) -> ast.Name:
    """Return a name made of points."""
    return expressions.point_name(kind, str(token), span_of(token))


def carrier(token: Token) -> ast.Name:
    """Return the body that a wheel is fixed to: a link by its points, or the ground."""
    return ast.Name(GROUND, span_of(token)) if token == GROUND else points("points", token)


def tupled(*parts: Any) -> tuple[Any, ...]:
    """Return the parts of a rule as a tuple."""
    return parts


def itself(part: Any) -> Any:
    """Return the only part of a rule."""
    return part


def grouped(left: Token, inside: ast.Expr, right: Token) -> ast.Expr:
    """Return the expression in brackets; the tree itself shows where they are needed."""
    return inside


IN_ORDER: Mapping[str, type[ast.Statement]] = {
    **{kind.__name__.lower(): kind for kind in get_args(ast.Transmission)},
    "source_note": ast.SourceNote,
    "drive": ast.Drive,
    "pivot": ast.Pivot,
    "slider": ast.Slider,
    "slide": ast.Slide,
    "arc_slot": ast.Slot,
    "telescope": ast.Telescope,
    "drawn": ast.Drawn,
    "geometry": ast.Vector,
    "turn": ast.Turn,
    "gravity": ast.Gravity,
    "friction_roller": ast.RollerFriction,
    "friction_contact": ast.ContactFriction,
    "friction_gear": ast.GearFriction,
    "friction_belt": ast.BeltFriction,
    "friction_rack": ast.RackFriction,
    "friction_screw": ast.ScrewFriction,
    "efficiency": ast.Efficiency,
}

WITH_A_FUNCTION: Mapping[str, Made] = {
    "version": builders.version,
    "heading": builders.heading,
    "sheet_heading": builders.sheet_heading,
    "table": builders.table,
    "sizes": builders.sizes,
    "use": builders.use,
    "translate": builders.translate,
    "let": builders.let,
    "param": builders.param,
    "link": builders.link,
    "slot": builders.slot,
    "gear": builders.gear,
    "belt": builders.belt,
    "rope": builders.rope,
    "assembly": builders.assembly,
    "mirror": builders.mirror,
    "copies": builders.copies,
    "force": builders.force,
    "torque": builders.torque,
    "actuator": builders.actuator,
    "spring": builders.spring,
    "weight": builders.weight,
    "distributed": builders.distributed,
    "friction_pins": builders.friction_pins,
    "friction_pin": builders.friction_pin,
    "friction_guide": builders.friction_guide,
    "friction_collar": builders.friction_collar,
    "friction_ring": builders.friction_ring,
    "friction_rope": builders.friction_rope,
    "thrust": builders.thrust,
    "drum": builders.drum,
    "motion": builders.motion,
    "finds": tupled,
    "reports": tupled,
    "require": builders.require,
    "expect": itself,
}

PARTS: Mapping[str, Made] = {
    "unnamed_result": builders.unnamed_result,
    "named_result": builders.named_result,
    "part_of_report": part_of_report,
    "plot_in_report": plot_in_report,
    "condition": expressions.chain,
    "expectation": expectation,
    "measure": measure,
    "choice": expressions.choice,
    "branch": expressions.branch,
    "lookup": expressions.lookup,
    "row_lookup": expressions.row_lookup,
    "next_size": expressions.next_size,
    "row": tupled,
    "unit": expressions.unit,
    "setting": tupled,
    "used": builders.used,
    "given": builders.given,
    "joints": tupled,
    "joint": builders.joint,
    "behind": tupled,
    "range": tupled,
    "shared": tupled,
    "end": tupled,
    "rim": tupled,
    "route": builders.route,
    "fall": tupled,
    "carrier": carrier,
    "name": name,
    "dimension": dimension,
    "polar": expressions.polar,
    "bearing": expressions.bearing,
    "cartesian": expressions.cartesian,
    "heading_of": expressions.direction_of,
    "perpendicular": expressions.perpendicular,
    "sum": expressions.sum_of,
    "product": expressions.product_of,
    "negative": expressions.negative,
    "power": expressions.power,
    "number": expressions.number,
    "symbol": expressions.symbol,
    "call": expressions.call,
    "grouped": grouped,
    "between": itself,
}


def rules() -> dict[str, Made]:
    """Return the builders of nodes, by the names in the grammar."""
    made: dict[str, Made] = {
        rule: partial(node, NOWHERE) for rule, node in IN_ORDER.items() if rule != "source_note"
    }
    made["source_note"] = lambda token: ast.SourceNote(NOWHERE, builders.unquoted(token))
    made |= WITH_A_FUNCTION
    made |= PARTS
    made |= {kind: partial(points, kind) for kind in expressions.COUNTED}
    return made
