"""What one YAML value means, by its kind: the fields of the node that it fills."""

from collections.abc import Callable, Mapping
from typing import Any

from ...diagnostics import syntax, syntax_yaml
from ...source import Source, Span
from .. import ast
from ..fault import Fault
from ..parser import expressions, usual_slips
from ..parser.grammar import keywords
from ..vocabulary import NAME
from . import slips
from .nodes import Listing, Scalar, YamlNode
from .nodes import Mapping as Table
from .scalars import described, one_of, parsed, scalar_of
from .sections import EntryKey, ValueKind

Fields = tuple[Any, ...]

RANGE_OF = "a range has two dots and no brackets: 2 deg .. 40 deg"


def values(key: EntryKey, node: YamlNode, source: Source) -> dict[str, Any]:
    """Return the fields that a value fills. Raises :class:`Fault` if it does not fit."""
    if key.kind is ValueKind.WORD:
        return dict(zip(key.fields, (one_of(key.words, node),), strict=True))
    found = READERS[key.kind](node, source)
    return dict(zip(key.fields, found, strict=True))


def expression(node: YamlNode, source: Source) -> Fields:
    """Read an expression."""
    return (parsed("expression", "an expression", node, source),)


def direction(node: YamlNode, source: Source) -> Fields:
    """Read a direction."""
    return (parsed("direction", "a direction", node, source),)


def vector(node: YamlNode, source: Source) -> Fields:
    """Read ``l @ alpha``, ``{length: l, angle: alpha}`` or ``[x, y]``."""
    match node:
        case Listing():
            return cartesian(node, source)
        case Table(entries=entries):
            return (polar(node, {k.text: (k, v) for k, v in entries}, source),)
        case _:
            expected = "a length, length @ direction, {length: …, angle: …} or [x, y]"
            return (parsed("vector", expected, node, source),)


def polar(node: Table, entries: Mapping[str, tuple[Scalar, YamlNode]], source: Source) -> ast.Polar:
    """Read ``{length: l, angle: alpha}``, either alone."""
    for name, (key, _) in entries.items():
        if name not in ("length", "angle"):
            allowed = ["length", "angle"]
            hint = slips.COMPONENTS if name in ("x", "y") else slips.of_key(name, allowed)
            raise Fault(syntax_yaml.unknown_key(key.span, name, "a vector", allowed, hint))
    if not entries:
        raise Fault(syntax_yaml.missing_key(node.span, ["length", "angle"], "the vector"))
    length = expression(entries["length"][1], source)[0] if "length" in entries else None
    angle = direction(entries["angle"][1], source)[0] if "angle" in entries else None
    return ast.Polar(length, angle, node.span)


def cartesian(node: YamlNode, source: Source) -> Fields:
    """Read ``[x, y]``."""
    match node:
        case Listing(items=(x, y)):
            ends = expression(x, source)[0], expression(y, source)[0]
            return (ast.Cartesian(*ends, node.span),)
        case Scalar(empty=False, text=text) if text.startswith("("):
            value = parsed("vector", "[x, y]", node, source)
            if isinstance(value, ast.Cartesian):
                return (value,)
    expected, hint = "coordinates [x, y]", usual_slips.COORDINATES
    raise Fault(syntax_yaml.wrong_shape(node.span, described(node), expected, hint))


def place(node: YamlNode, source: Source) -> Fields:
    """Read a point or ``[x, y]``."""
    if isinstance(node, Scalar) and not node.text.startswith("("):
        return (point_name("point", node),)
    return cartesian(node, source)


def point_name(kind: str, node: YamlNode) -> ast.Name:
    """Read a name made of points."""
    scalar = scalar_of(node, expressions.COUNTED[kind][2])
    return expressions.point_name(kind, scalar.text, scalar.span)


def name(node: YamlNode, source: Source) -> Fields:
    """Read a name that the user gives."""
    scalar = scalar_of(node, "a name")
    return (name_of(scalar.text, scalar.span),)


def heading(node: YamlNode, source: Source) -> Fields:
    """Read the name of a description, which may be a word of the language."""
    scalar = scalar_of(node, "a name")
    return (_spelled(scalar.text, scalar.span),)


def name_of(text: str, span: Span) -> ast.Name:
    """Return a name that the user gives and lines refer to: no word of the language."""
    if text in keywords():
        raise Fault(syntax.reserved_word(span, text))
    return _spelled(text, span)


def _spelled(text: str, span: Span) -> ast.Name:
    """Return a name; it is a letter with letters, digits, underscores."""
    if not NAME.fullmatch(text):
        expected = "a name of Latin letters, digits and underscores"
        raise Fault(syntax.not_a_name(span, text, expected))
    return expressions.new_name(text, span)


def dimension(node: YamlNode, source: Source) -> Fields:
    """Read the name of a dimension."""
    scalar = scalar_of(node, "a dimension such as length or angle")
    if not NAME.fullmatch(scalar.text):
        expected = "a dimension such as length or angle"
        raise Fault(syntax.not_a_name(scalar.span, scalar.text, expected))
    return (ast.Name(scalar.text, scalar.span),)


def pair(node: YamlNode, source: Source) -> Fields:
    """Read ``[A, B]``; each may name the link that carries it there: ``[A on OA, B]``."""
    match node:
        case Listing(items=(first, second)):
            return (*end(first, source), *end(second, source))
    raise Fault(syntax_yaml.wrong_shape(node.span, described(node), "two points [A, B]"))


def end(node: YamlNode, source: Source) -> Fields:
    """Read ``A``, or ``A on OA``."""
    if isinstance(node, Scalar) and " on " in node.text:
        point, link = parsed("end", "a point, or a point and its link", node, source)
        return point, link
    return point_name("point", node), None


def rim(node: YamlNode, source: Source) -> Fields:
    """Read ``r``, or ``r on OA``."""
    radius, link = parsed("rim", "a radius, or a radius and the wheel's link", node, source)
    return radius, link


def shared(node: YamlNode, source: Source) -> Fields:
    """Read ``[K, L]``; a single point needs no brackets."""
    items = node.items if isinstance(node, Listing) else (node,)
    return (tuple(point_name("point", item) for item in items),)


def pin(node: YamlNode, source: Source) -> Fields:
    """Read a point, or ``pins`` for all of them."""
    if isinstance(node, Scalar) and node.text == "pins":
        return (None,)
    if isinstance(node, Scalar) and node.text == "pin":
        hint = "all pins are 'pins', and one is its point, as O"
        raise Fault(syntax.not_a_point(node.span, node.text, "a point", hint))
    return (point_name("point", node),)


def range_of(node: YamlNode, source: Source) -> Fields:
    """Read ``low .. high``."""
    if isinstance(node, Listing):
        expected = "a range LOW .. HIGH"
        raise Fault(syntax_yaml.wrong_shape(node.span, described(node), expected, RANGE_OF))
    low, high = parsed("range", "a range LOW .. HIGH", node, source)
    return low, high


def result(node: YamlNode, source: Source) -> Fields:
    """Read ``k = P/F`` or ``R_B on AB``."""
    if isinstance(node, Table):
        hint = "in a list the name stands before '=': - k = P/F"
        raise Fault(syntax_yaml.wrong_shape(node.span, described(node), "what to find", hint))
    if isinstance(node, Scalar) and node.empty:
        hint = "what has no name of its own stands in a list: [k = P/F, R_O]"
        raise Fault(syntax_yaml.wrong_shape(node.span, described(node), "what to find", hint))
    found = parsed("result", "what to find", node, source)
    return found.target, found.name, found.on


def condition(node: YamlNode, source: Source) -> Fields:
    """Read ``a < b < c``."""
    operands, operators = parsed("condition", "a condition such as a < b", node, source)
    return operands, operators


def route(node: YamlNode, source: Source) -> Fields:
    """Read ``A, K along -y, B along y``."""
    start, falls = parsed("route", "the points of a rope such as A, K, B", node, source)
    return start, falls


def expectation(node: YamlNode, source: Source) -> Fields:
    """Read ``k = 7.1 at alpha = 35 deg``."""
    found = parsed("expectation", "an expectation such as k = 7.1", node, source)
    return found.subject, found.value, found.at, found.tolerance


def reported(node: YamlNode, source: Source) -> Fields:
    """Read ``scheme`` or ``plot k over alpha``."""
    found = parsed("reported", "what a report holds, such as scheme", node, source)
    return found.name, found.over


def measure(node: YamlNode, source: Source) -> Fields:
    """Read ``40 mm +- 0.1 mm``."""
    value, tolerance = parsed("measure", "an expression", node, source)
    return value, tolerance


def let_value(node: YamlNode, source: Source) -> Fields:
    """Read an expression, or a choice, a size of a list, a value of a table."""
    return (parsed("let_value", "an expression", node, source),)


def unit(node: YamlNode, source: Source) -> Fields:
    """Read a unit."""
    return (parsed("unit", "a unit such as MPa", node, source),)


def sizes(node: YamlNode, source: Source) -> Fields:
    """Read ``[32 mm, 40 mm]``."""
    if not isinstance(node, Listing) or not node.items:
        raise Fault(syntax_yaml.wrong_shape(node.span, described(node), "sizes [32 mm, 40 mm]"))
    return (tuple(expression(item, source)[0] for item in node.items),)


def rows(node: YamlNode, source: Source) -> Fields:
    """Read ``[[1, 0.388], [0.9, 0.400]]``."""
    if not isinstance(node, Listing) or not node.items:
        raise Fault(syntax_yaml.wrong_shape(node.span, described(node), "rows [[1, 0.388], …]"))
    return (tuple(row(item, source) for item in node.items),)


def row(node: YamlNode, source: Source) -> tuple[ast.Expr, ast.Expr]:
    """Read ``[1, 0.388]``."""
    match node:
        case Listing(items=(argument, value)):
            return expression(argument, source)[0], expression(value, source)[0]
    raise Fault(syntax_yaml.wrong_shape(node.span, described(node), "an argument and its value"))


def used(node: YamlNode, source: Source) -> Fields:
    """Read a name of the library, or a path."""
    scalar = scalar_of(node, "a name of the library, or a path in this folder")
    return (ast.Name(scalar.text, scalar.span),)


def given(node: YamlNode, source: Source) -> Fields:
    """Read ``{F: 3 kN, d: d}``."""
    if not isinstance(node, Table):
        expected = "a mapping of parameters {F: …}"
        raise Fault(syntax_yaml.wrong_shape(node.span, described(node), expected))
    pairs = ((*name(key, source), *expression(value, source)) for key, value in node.entries)
    return (tuple(pairs),)


def joints(node: YamlNode, source: Source) -> Fields:
    """Read ``{T.C: B}``."""
    if not isinstance(node, Table):
        expected = "a mapping of points {T.C: B}"
        raise Fault(syntax_yaml.wrong_shape(node.span, described(node), expected))
    return (tuple((point_name("point", k), point_name("point", v)) for k, v in node.entries),)


def names(node: YamlNode, source: Source) -> Fields:
    """Read ``[F, alpha]``; a single name needs no brackets."""
    items = node.items if isinstance(node, Listing) else (node,)
    return (tuple(part for item in items for part in name(item, source)),)


def text_of(node: YamlNode, source: Source) -> Fields:
    """Read a text."""
    if isinstance(node, Scalar):
        return ("" if node.empty else node.text,)
    keys = [name.text for name, _ in node.entries] if isinstance(node, Table) else []
    hint = slips.of_text_in_keys(keys) if keys else ""
    raise Fault(syntax_yaml.wrong_shape(node.span, described(node), "a text", hint))


def flag(node: YamlNode, source: Source) -> Fields:
    """Read ``true`` or ``false``."""
    return (one_of(("true", "false"), node) == "true",)


def version(node: YamlNode, source: Source) -> Fields:
    """Read the version of the language."""
    scalar = scalar_of(node, "a version")
    if scalar.text != "1":
        raise Fault(syntax.unknown_version(scalar.span, scalar.text))
    return (scalar.text,)


def points_as(kind: str) -> Callable[[YamlNode, Source], Fields]:
    """Return the reader of names made of so many points."""
    return lambda node, source: (point_name(kind, node),)


READERS: Mapping[ValueKind, Callable[[YamlNode, Source], Fields]] = {
    ValueKind.NAME: name,
    ValueKind.HEADING: heading,
    ValueKind.POINT: points_as("point"),
    ValueKind.POINTS: points_as("points"),
    ValueKind.ROD: points_as("rod"),
    ValueKind.CORNER: points_as("corner"),
    ValueKind.BODY: points_as("body"),
    ValueKind.PIN: pin,
    ValueKind.PAIR: pair,
    ValueKind.RIM: rim,
    ValueKind.ROUTE: route,
    ValueKind.SHARED: shared,
    ValueKind.EXPRESSION: expression,
    ValueKind.DIRECTION: direction,
    ValueKind.VECTOR: vector,
    ValueKind.CARTESIAN: cartesian,
    ValueKind.PLACE: place,
    ValueKind.RANGE: range_of,
    ValueKind.RESULT: result,
    ValueKind.CONDITION: condition,
    ValueKind.EXPECTATION: expectation,
    ValueKind.REPORTED: reported,
    ValueKind.MEASURE: measure,
    ValueKind.LET_VALUE: let_value,
    ValueKind.UNIT: unit,
    ValueKind.ROWS: rows,
    ValueKind.SIZES: sizes,
    ValueKind.DIMENSION: dimension,
    ValueKind.USED: used,
    ValueKind.GIVEN: given,
    ValueKind.JOINTS: joints,
    ValueKind.NAMES: names,
    ValueKind.TEXT: text_of,
    ValueKind.FLAG: flag,
    ValueKind.VERSION: version,
}
