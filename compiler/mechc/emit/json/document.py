"""The document of a whole result: its parameters, results, derivation, verdict and pictures.

The document and its JSON Schema are both made from what stands here.
"""

from collections.abc import Sequence
from typing import get_args

from ...base.named import NamedTuple
from ...formula.evaluate import evaluate
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...model.mechanism import Parameter
from ...model.result import Definition
from ...model.statements import is_sheet
from ...model.values import Chain
from ...pose.motion import MotionKind, MotionQuantity
from ...routine.statuses import STATUSES
from ...routine.steps import Function
from ...statics.verdict import Trial, Verdict
from ...units import si_unit
from ..describe import condition_lines, dimension_name, numbered, quantity_words
from ..target import Compiled
from .derivation import DERIVATION
from .figure import FIGURE
from .formula import DEFINITION, FORMULA
from .free_bodies import DIAGRAM
from .kinds import FLOAT, TEXT, TRUTH, JsonKind, list_of, map_of, member, one_of, optional, record
from .lets import defined_once
from .results import RESULT

VERSION = 1
"""Raised whenever a member changes its meaning or goes."""


def _number(formula: Formula | None) -> float | None:
    return None if formula is None else evaluate(formula, {})


def _value(parameter: Parameter) -> float | None:
    return None if parameter.dependent else _number(parameter.value)


def _dependence(parameter: Parameter) -> Formula | None:
    return parameter.value if parameter.dependent else None


FUNCTION: JsonKind[Function] = record(
    "function",
    "A function of the emitted code.",
    member("name", "The result's.", TEXT, lambda f: f.name),
    member("inputs", "In order.", list_of(TEXT), lambda f: tuple(i.name for i in f.inputs)),
    member(
        "conditions",
        "Where one is broken, the function gives NaN.",
        list_of(TEXT),
        lambda f: tuple(condition_lines(f)),
    ),
    member(
        "otherwise",
        "The function that is called where this one has no value.",
        optional(TEXT),
        lambda f: f.otherwise.name if f.otherwise else None,
    ),
    member(
        "status",
        f"The function that tells what its numbers and NaN mean: {'; '.join(numbered(STATUSES))}.",
        optional(TEXT),
        lambda f: f.status.name if f.status else None,
    ),
    member(
        "operations",
        "With shared parts computed once.",
        JsonKind({"type": "integer"}, int),
        lambda f: f.operations,
    ),
)

PARAMETER: JsonKind[Parameter] = record(
    "parameter",
    "A quantity of the description.",
    member("name", "As in the description.", TEXT, lambda p: p.name),
    member("dimension", "length, angle, force …", TEXT, lambda p: dimension_name(p.dimension)),
    member("unit", "SI unit of the values, or empty.", TEXT, lambda p: si_unit(p.dimension)),
    member("written_in", "The unit the author wrote, or empty.", TEXT, lambda p: p.unit),
    member("value", "Of the default pose, in SI and radians.", FLOAT, _value),
    member("tolerance", "How far it may be off, SI.", FLOAT, lambda p: _number(p.tolerance)),
    member("low", "Lower end of the range, SI.", FLOAT, lambda p: _number(p.range and p.range.low)),
    member("high", "Upper end, SI.", FLOAT, lambda p: _number(p.range and p.range.high)),
    member("formula", "Of a dependent parameter.", optional(FORMULA), _dependence),
    member("label", "For reports, or empty.", TEXT, lambda p: p.label),
    member("about", "A longer remark, or empty.", TEXT, lambda p: p.about),
)

TRIAL: JsonKind[Trial] = record(
    "trial",
    "One pose, computed by virtual power and by free bodies.",
    member("result", "Which result.", TEXT, lambda t: t.result),
    member("values", "The pose, SI.", map_of(FLOAT), lambda t: t.values),
    member("power", "By virtual power.", FLOAT, lambda t: t.power),
    member("statics", "By equilibrium of every free body.", FLOAT, lambda t: t.statics),
    member("error", "Relative difference.", FLOAT, lambda t: t.error),
    member("condition", "Of the equilibrium equations.", FLOAT, lambda t: t.condition),
    member("agrees", "Within what the condition allows.", TRUTH, lambda t: t.agrees),
)


def _said(verdict: Verdict) -> tuple[str, ...]:
    return tuple(map(str, verdict.remarks))


VERDICT: JsonKind[Verdict] = record(
    "verdict",
    "The second opinion.",
    member("agrees", "Whether every trial agrees.", TRUTH, lambda v: v.agrees),
    member("worst", "Largest relative difference.", FLOAT, lambda v: v.worst),
    member("trials", "The default pose first.", list_of(TRIAL), lambda v: v.trials),
    member("remarks", "What could not be tried.", list_of(TEXT), _said),
)


class Moved(NamedTuple):
    """The quantities of a motion with their values, and the definitions that they rest on."""

    quantities: tuple[tuple[MotionQuantity, float | None], ...]
    definitions: tuple[Definition, ...]


def moved(compiled: Compiled) -> Moved | None:
    """Return the quantities of motion, with their values at the pose of the figure."""
    if compiled.motion is None:
        return None
    quantities = compiled.motion.quantities
    chain = Chain(dict(compiled.motion.definitions))
    needed = chain.needed_by(_names(quantities))
    known = compiled.figure.values if compiled.figure else {}
    values = Chain({**dict(chain.definitions), **{q.name: q.formula for q in quantities}})
    found = values.complete(known)
    definitions = tuple(Definition(*d) for d in chain.definitions if d[0] in needed)
    return Moved(tuple((q, found.get(q.name)) for q in quantities), definitions)


def _names(quantities: Sequence[MotionQuantity]) -> frozenset[str]:
    return frozenset[str]().union(*(symbols(q.formula) for q in quantities))


QUANTITY: JsonKind[tuple[MotionQuantity, float | None]] = record(
    "motion_quantity",
    "A coordinate of a point, the direction of a link, or how it changes with the drive.",
    member("name", "In the code.", TEXT, lambda q: q[0].name),
    member("kind", "What it is.", one_of(*get_args(MotionKind)), lambda q: q[0].kind),
    member("of", "The point, or the link.", TEXT, lambda q: q[0].of),
    member("axis", "Of a point, else empty.", one_of("x", "y", ""), lambda q: q[0].axis),
    member("about", "In words.", TEXT, lambda q: quantity_words(q[0])),
    member("unit", "SI, or empty.", TEXT, lambda q: si_unit(q[0].dimension)),
    member("formula", "What it is equal to.", FORMULA, lambda q: q[0].formula),
    member("value", "At the figure's pose, SI; null where there is none.", FLOAT, lambda q: q[1]),
)

MOVED: JsonKind[Moved] = record(
    "points",
    "Where points are and how links point, along the drive.",
    member("quantities", "Each by itself.", list_of(QUANTITY), lambda m: m.quantities),
    member("definitions", "In order.", list_of(DEFINITION), lambda m: m.definitions),
)


class UsedMechanism(NamedTuple):
    """A mechanism that a sheet uses, under its prefix there."""

    prefix: str
    compiled: Compiled


USED: JsonKind[UsedMechanism] = record(
    "used_mechanism",
    "A mechanism that a calculation sheet uses, compiled at the values that the sheet gives it.",
    member("prefix", "Of its quantities in the sheet: L of L_k.", TEXT, lambda u: u.prefix),
    member("name", "The mechanism's.", TEXT, lambda u: u.compiled.mechanism.name),
    member("title", "Or empty.", TEXT, lambda u: u.compiled.mechanism.title),
    member("source", "Where it is from, or empty.", TEXT, lambda u: u.compiled.mechanism.source),
    member(
        "parameters",
        "In order, by its own names, as formulas below have them.",
        list_of(PARAMETER),
        lambda u: u.compiled.mechanism.parameters,
    ),
    member(
        "constants",
        "As of the document.",
        list_of(PARAMETER),
        lambda u: u.compiled.mechanism.literals,
    ),
    member(
        "results",
        "In order.",
        list_of(RESULT),
        lambda u: defined_once(u.compiled.derivation.results),
    ),
    member("derivation", "How they follow.", DERIVATION, lambda u: u.compiled.derivation),
    member("referee", "What statics says.", VERDICT, lambda u: u.compiled.verdict),
    member("figure", "For drawings.", optional(FIGURE), lambda u: u.compiled.figure),
    member(
        "free_bodies", "At the figure's pose.", list_of(DIAGRAM), lambda u: u.compiled.free_bodies
    ),
)


def _used(compiled: Compiled) -> tuple[UsedMechanism, ...]:
    return tuple(UsedMechanism(*pair) for pair in compiled.used_mechanisms)


DOCUMENT: JsonKind[Compiled] = record(
    "result_document",
    "What mechc found of one mechanism. Numbers are SI and radians.",
    member("schema", "What this is.", one_of("mechc-result"), lambda c: "mechc-result"),
    member("version", "Of this layout.", JsonKind({"const": VERSION}, int), lambda c: VERSION),
    member("compiler", "The version of mechc.", TEXT, lambda c: c.version),
    member("name", "The mechanism's.", TEXT, lambda c: c.mechanism.name),
    member("title", "Or empty.", TEXT, lambda c: c.mechanism.title),
    member("source", "Where it is from, or empty.", TEXT, lambda c: c.mechanism.source),
    member("parameters", "In order.", list_of(PARAMETER), lambda c: c.mechanism.parameters),
    member(
        "constants",
        "Sizes that the description gives by numbers, under the names that formulas have.",
        list_of(PARAMETER),
        lambda c: c.mechanism.literals,
    ),
    member("results", "In order.", list_of(RESULT), lambda c: defined_once(c.derivation.results)),
    member("derivation", "How they follow.", DERIVATION, lambda c: c.derivation),
    member(
        "referee",
        "What statics says; null for a calculation sheet, in which nothing moves.",
        optional(VERDICT),
        lambda c: None if is_sheet(c.mechanism) else c.verdict,
    ),
    member(
        "figure",
        "For drawings.",
        optional(FIGURE),
        lambda c: None if is_sheet(c.mechanism) else c.figure,
    ),
    member(
        "free_bodies",
        "At the figure's pose.",
        list_of(DIAGRAM),
        lambda c: () if is_sheet(c.mechanism) else c.free_bodies,
    ),
    member("functions", "Of the code.", list_of(FUNCTION), lambda c: c.routine.functions),
    member("points", "Where points are, if there is a drive.", optional(MOVED), moved),
    member(
        "used_mechanisms",
        "Those that a calculation sheet uses, in the order of its text.",
        list_of(USED),
        _used,
    ),
)
