"""Formulas in JSON: as text in mechc's own notation, and as a nested tree."""

from typing import assert_never

from ...formula.operations import count_operations
from ...formula.to_text import text
from ...formula.tree import Call, Formula, Implicit, Number, Pi, Power, Product, Sum, Symbol
from ...model.result import Definition
from .kinds import TEXT, WHOLE, Json, JsonKind, member, record


def tree(formula: Formula) -> Json:
    """Return a formula as nested objects of one member each (two for a call).

    >>> tree(Power(Symbol("a"), Call("sin", (Pi(),))))
    {'power': [{'symbol': 'a'}, {'call': 'sin', 'arguments': [{'pi': True}]}]}
    """
    match formula:
        case Number(value):
            return {"number": str(value)}
        case Pi():
            return {"pi": True}
        case Symbol(name):
            return {"symbol": name}
        case Sum(terms):
            return {"sum": [tree(t) for t in terms]}
        case Product(factors):
            return {"product": [tree(f) for f in factors]}
        case Power(base, exponent):
            return {"power": [tree(base), tree(exponent)]}
        case Call(function, arguments):
            return {"call": function, "arguments": [tree(a) for a in arguments]}
        case Implicit():
            return _solution(formula)
        case _:
            assert_never(formula)


def _solution(formula: Implicit) -> Json:
    """Return an unknown of a system: its equations, and where the way to its solution begins."""
    system = formula.system
    return {
        "solution": system.unknowns[formula.index],
        "unknowns": list(system.unknowns),
        "start": list(system.start),
        "equations": [tree(e) for e in system.equations],
        "outer": [name for name, _ in system.anchor],
        "anchor": [value for _, value in system.anchor],
        "turning": list(system.turning),
        "arguments": [tree(a) for a in formula.arguments],
    }


def _node(**members: Json) -> Json:
    return {
        "type": "object",
        "properties": members,
        "required": list(members),
        "additionalProperties": False,
    }


_TREES: Json = {"type": "array", "items": {"$ref": "#/$defs/tree"}}
_PAIR: Json = {"type": "array", "items": {"$ref": "#/$defs/tree"}, "minItems": 2, "maxItems": 2}
_NAMES: Json = {"type": "array", "items": {"type": "string"}}
_START: Json = {"type": "array", "items": {"type": ["number", "string"]}}
_ANCHOR: Json = {"type": "array", "items": {"type": ["number", "null"]}}
_SOLUTION = _node(
    solution={"type": "string"},
    unknowns=_NAMES,
    start=_START,
    equations=_TREES,
    outer=_NAMES,
    anchor=_ANCHOR,
    turning=_NAMES,
    arguments=_TREES,
)
_SCHEMA: Json = {
    "description": "A formula's tree. A number is an exact rational such as 2 or -1/3. A solution "
    "is an unknown of equations = 0 in unknowns and outer names; it is the one that is reached "
    "from start when the outer names' values go from anchor to arguments on a straight line. An "
    "anchor of null is the argument itself, and a name in start is the value of that outer name. "
    "The argument of a turning name is an angle that is known but for whole turns: of such "
    "angles the one nearest to the anchor is meant.",
    "anyOf": [
        _node(number={"type": "string", "pattern": r"^-?\d+(/\d+)?$"}),
        _node(pi={"const": True}),
        _node(symbol={"type": "string"}),
        _node(sum=_TREES),
        _node(product=_TREES),
        _node(power=_PAIR),
        _node(call={"type": "string"}, arguments=_TREES),
        _SOLUTION,
    ],
}
TREE: JsonKind[Formula] = JsonKind({"$ref": "#/$defs/tree"}, tree, {"tree": _SCHEMA})

LATEX: JsonKind[Formula] = JsonKind({"type": "string"}, lambda formula: formula)
"""A formula that becomes text with the whole document, whose names are distinct on paper."""

FORMULA: JsonKind[Formula] = record(
    "formula",
    "A formula in SI and radians.",
    member("text", "In mechc's notation: a*sin(alpha)^2/(2*b).", TEXT, text),
    member("latex", "As reports in English print it.", LATEX, lambda f: f),
    member("tree", "The same, nested.", TREE, lambda f: f),
    member("operations", "Number of operations, as sympy's count_ops.", WHOLE, count_operations),
)

DEFINITION: JsonKind[Definition] = record(
    "definition",
    "A named intermediate.",
    member("name", "The name that formulas mention.", TEXT, lambda d: d.name),
    member("formula", "What it stands for.", FORMULA, lambda d: d.formula),
)
