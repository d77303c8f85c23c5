"""The document of a whole result: every record of it, member by member.

The document and its JSON Schema are both made from what stands here.
"""

from collections.abc import Mapping
from typing import NamedTuple, get_args

from ...formula.to_text import text
from ...formula.tree import Formula
from ...formula.walk import evaluate
from ...model.locking import Bound, EfficiencyRange, Locking, LockingIntervals, Stretch
from ...model.mechanism import (
    Axial,
    Efficiency,
    LoadForm,
    LoadRatio,
    Normal,
    Parameter,
    Reaction,
    Require,
    SpeedRatio,
    Target,
    WithFriction,
)
from ...model.result import Result
from ...model.sheets import is_sheet
from ...pose.pose import LoopKind
from ...report.derivation.steps import (
    Derivation,
    Equation,
    Explanation,
    Paragraph,
    PositionStep,
    PowerTerm,
    Rule,
    SentenceKind,
    Step,
)
from ...statics.verdict import Trial, Verdict
from ...study.analysis import Analysis, Break, Scope, Trend, Vanishing
from ...units import si_unit
from ..describe import dimension_name
from ..target import Compiled
from .figure import FIGURE
from .formula import DEFINITION, FORMULA
from .free_bodies import DIAGRAM
from .functions import FUNCTION
from .kinds import FLOAT, TEXT, TRUTH, Kind, list_of, map_of, member, one_of, optional, record
from .lets import LONG, defined_once
from .points import MOVED, moved

VERSION = 1
"""Raised whenever a member changes its meaning or goes."""

TRENDS, SCOPES = get_args(Trend), get_args(Scope)
VANISHINGS = ("output still", "drive locked", "perpendicular load", "other")
KINDS: Mapping[type[Target] | type[None], str] = {
    LoadRatio: "load ratio",
    LoadForm: "load",
    SpeedRatio: "speed ratio",
    Reaction: "reaction",
    Axial: "axial force",
    Normal: "normal force",
    WithFriction: "with friction",
    Efficiency: "efficiency",
    type(None): "formula",
}


def _number(formula: Formula | None) -> float | None:
    return None if formula is None else evaluate(formula, {})


def _value(parameter: Parameter) -> float | None:
    return None if parameter.dependent else _number(parameter.value)


def _equation(equation: Equation) -> str:
    return f"{text(equation.left)} = {text(equation.right)}"


def _dependence(parameter: Parameter) -> Formula | None:
    return parameter.value if parameter.dependent else None


PARAMETER: Kind[Parameter] = record(
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

CONDITION: Kind[Require] = record(
    "condition",
    "What must hold: left operator right.",
    member("left", "One side.", FORMULA, lambda c: c.left),
    member("operator", "How they compare.", TEXT, lambda c: c.operator),
    member("right", "The other side.", FORMULA, lambda c: c.right),
)

VANISHING: Kind[Vanishing] = record(
    "vanishing",
    "A condition under which a result is zero, or infinite.",
    member("factor", "It is where this is 0.", FORMULA, lambda v: v.factor),
    member("symbol", "Solved for this.", optional(TEXT), lambda v: v.at and v.at[0]),
    member("value", "Its value there.", optional(FORMULA), lambda v: v.at and v.at[1]),
    member("kind", "What happens there.", one_of(*VANISHINGS), lambda v: v.kind),
    member("but", "Unless one of these is 0, too.", list_of(FORMULA), lambda v: v.but),
    member("outside", "Proved: not within the ranges given.", TRUTH, lambda v: v.outside),
)

BREAK: Kind[Break] = record(
    "break",
    "A condition under which something that loops find is infinite.",
    member("factor", "It is where this is 0.", FORMULA, lambda b: b.factor),
    member("name", "What is infinite.", TEXT, lambda b: b.name),
)

STATES = ("free", "locked", "jammed")
_NUMBERS = list_of(FLOAT)

BOUND: Kind[Bound] = record(
    "bound",
    "An end of a stretch.",
    member("place", "SI and radians.", FLOAT, lambda b: b.x),
    member("formula", "The same, where one is known.", optional(FORMULA), lambda b: b.exact),
    member("dead_centre", "The ratio changes its sign.", TRUTH, lambda b: b.is_dead_centre),
)

STRETCH: Kind[Stretch] = record(
    "stretch",
    "A stretch on which nothing moves.",
    member("state", "Held, or not to be moved.", one_of(*STATES), lambda s: s.state),
    member(
        "low",
        "Null at the range's end.",
        optional(BOUND),
        lambda s: s.low,
    ),
    member("high", "The same above.", optional(BOUND), lambda s: s.high),
    member("within", "Its part of the range.", optional(_NUMBERS), lambda s: s.within),
    member("sampled", "Found by sampling, not solved for.", TRUTH, lambda s: s.sampled),
)

REACH: Kind[LockingIntervals] = record(
    "reach",
    "Where nothing moves as one parameter varies, the others at their values.",
    member("parameter", "Its name.", TEXT, lambda r: r.parameter),
    member("range", "As given.", optional(_NUMBERS), lambda r: r.range),
    member("stretches", "In order.", list_of(STRETCH), lambda r: r.stretches),
)

LOCKING: Kind[Locking] = record(
    "locking",
    "Of a ratio with friction: where the load alone, or the drive, moves nothing.",
    member(
        "state",
        "At the default pose; null at a dead centre.",
        optional(one_of(*STATES)),
        lambda k: k.state,
    ),
    member("reaches", "By parameter.", list_of(REACH), lambda k: k.reaches),
)

COURSE: Kind[EfficiencyRange] = record(
    "course",
    "What an efficiency runs through over a range, found by sampling.",
    member("parameter", "Its name.", TEXT, lambda c: c.parameter),
    member("range", "SI and radians.", _NUMBERS, lambda c: c.range),
    member("least", "0 where nothing moves.", FLOAT, lambda c: c.least),
    member("greatest", "The highest.", FLOAT, lambda c: c.greatest),
    member("usual", "Where it is 0.9 … 0.95.", list_of(_NUMBERS), lambda c: c.usual),
)

_POWERS = map_of(Kind({"type": "integer"}, int))
_PAIRS = list_of(list_of(TEXT))

ELSEWHERE: Kind[Result] = record(
    "elsewhere",
    "A result with friction from coupled equations, whichever way its joints are pressed.",
    member("formula", "The whole result.", FORMULA, lambda r: r.formula),
    member(
        "where",
        "In order of definition. What a let leaves out is defined by others elsewhere.",
        list_of(DEFINITION),
        lambda r: r.where,
    ),
    member(
        "guards", "What must hold, or nothing balances.", list_of(CONDITION), lambda r: r.guards
    ),
)

RESULT: Kind[Analysis] = record(
    "result",
    "A find or a let, solved.",
    member("name", "As in the description.", TEXT, lambda r: r.name),
    member("label", "The text of a let, or empty.", TEXT, lambda r: r.label),
    member("kind", "What was asked.", one_of(*KINDS.values()), lambda r: KINDS[type(r.target)]),
    member("dimension", "number, force …", TEXT, lambda r: dimension_name(r.dimension)),
    member("unit", "SI unit, or empty.", TEXT, lambda r: si_unit(r.dimension)),
    member("formula", "The whole result.", FORMULA, lambda r: r.formula),
    member(
        "where",
        "In order of definition. A let of more than "
        f"{LONG} leaves out those that other results are, or define in their own where.",
        list_of(DEFINITION),
        lambda r: r.where,
    ),
    member(
        "coefficients",
        "Of a load: the factor of every other load.",
        optional(map_of(FORMULA)),
        lambda r: r.coefficients,
    ),
    member("zeros", "Where it is 0.", list_of(VANISHING), lambda r: r.zeros),
    member("poles", "Where it is infinite.", list_of(VANISHING), lambda r: r.poles),
    member("breaks", "Where it may jump: no zero, no pole.", list_of(BREAK), lambda r: r.breaks),
    member(
        "proportional",
        "Parameters and the powers in which the result is proportional to them.",
        _POWERS,
        lambda r: r.proportional or {},
    ),
    member("independent", "What it does not depend on.", list_of(TEXT), lambda r: r.independent),
    member("swaps", "Pairs that may be exchanged.", _PAIRS, lambda r: r.swaps),
    member(
        "trends",
        "How it moves over each parameter's range, by proof.",
        map_of(one_of(*TRENDS)),
        lambda r: r.trends or {},
    ),
    member(
        "scopes",
        "For which values that is proved.",
        map_of(one_of(*SCOPES)),
        lambda r: r.scopes,
    ),
    member("derivatives", "Partial ones.", map_of(FORMULA), lambda r: r.derivatives or {}),
    member("locking", "Where friction holds it.", optional(LOCKING), lambda r: r.locking),
    member("courses", "Of an efficiency.", list_of(COURSE), lambda r: r.courses),
    member("value", "At the default pose, SI; null at a pole.", FLOAT, lambda r: r.default),
    member(
        "holds",
        "Conditions of the formula, where it is for the signs of the default pose.",
        list_of(CONDITION),
        lambda r: r.holds,
    ),
    member(
        "guards",
        "What must hold for a solution to mean anything. Where one fails, or one of holds, the "
        "result is the one for elsewhere, and where there is none code gives NaN.",
        list_of(CONDITION),
        lambda r: r.guards,
    ),
    member("elsewhere", "What holds there.", optional(ELSEWHERE), lambda r: r.elsewhere),
)

STEP: Kind[Step] = record(
    "step",
    "One step of the derivation.",
    member("rule", "The rule of mechanics.", one_of(*Rule), lambda s: s.rule),
    member("subject", "Points and links it is applied to.", list_of(TEXT), lambda s: s.subject),
    member(
        "relations",
        "What the rule says.",
        list_of(TEXT),
        lambda s: tuple(map(_equation, s.relations)),
    ),
    member(
        "results",
        "Solved for what is new.",
        list_of(TEXT),
        lambda s: tuple(map(_equation, s.results)),
    ),
)

POSITION: Kind[PositionStep] = record(
    "position_step",
    "What one loop gives of the position.",
    member("kind", "How the loop is solved.", one_of(*get_args(LoopKind)), lambda s: s.kind),
    member("points", "Of the loop.", list_of(TEXT), lambda s: s.points),
    member("definitions", "In order.", list_of(DEFINITION), lambda s: s.definitions),
)

TERM: Kind[PowerTerm] = record(
    "term",
    "The power of one load: times · load · speed.",
    member("load", "Its name.", TEXT, lambda t: t.load),
    member("point", "Where it acts.", TEXT, lambda t: t.point),
    member("times", "How often it acts.", FORMULA, lambda t: t.times),
    member("speed", "Signed along the load.", FORMULA, lambda t: t.speed),
)

PASSAGE: Kind[Paragraph] = record(
    "passage",
    "A sentence with the equations that it leads to.",
    member("says", "What the sentence says.", one_of(*SentenceKind), lambda p: p.saying),
    member("names", "What it says it of.", map_of(list_of(TEXT)), lambda p: p.names),
    member("formulas", "Directions, speeds …", map_of(FORMULA), lambda p: p.formulas),
    member(
        "equations",
        "What follows.",
        list_of(TEXT),
        lambda p: tuple(map(_equation, p.equations)),
    ),
)

ACCOUNT: Kind[Explanation] = record(
    "account",
    "How results were found that need more than the power equation.",
    member("results", "Their names.", list_of(TEXT), lambda a: a.results),
    member("passages", "In order.", list_of(PASSAGE), lambda a: a.paragraphs),
    member("where", "What the equations rest on.", list_of(DEFINITION), lambda a: a.where),
)

DERIVATION: Kind[Derivation] = record(
    "derivation",
    "From speeds to the power balance.",
    member("position", "Loop by loop.", list_of(POSITION), lambda d: d.position),
    member("steps", "In order.", list_of(STEP), lambda d: d.steps),
    member("terms", "The powers of the loads.", list_of(TERM), lambda d: d.terms),
    member(
        "balances",
        "One power equation for each degree of freedom.",
        list_of(TEXT),
        lambda d: tuple(map(_equation, d.balances)),
    ),
    member("accounts", "Of forces and friction.", list_of(ACCOUNT), lambda d: d.explanations),
)

TRIAL: Kind[Trial] = record(
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


VERDICT: Kind[Verdict] = record(
    "verdict",
    "The second opinion.",
    member("agrees", "Whether every trial agrees.", TRUTH, lambda v: v.agrees),
    member("worst", "Largest relative difference.", FLOAT, lambda v: v.worst),
    member("trials", "The default pose first.", list_of(TRIAL), lambda v: v.trials),
    member("remarks", "What could not be tried.", list_of(TEXT), _said),
)


class UsedMechanism(NamedTuple):
    """A mechanism that a sheet uses, under its prefix there."""

    prefix: str
    compiled: Compiled


USED: Kind[UsedMechanism] = record(
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


DOCUMENT: Kind[Compiled] = record(
    "result_document",
    "What mechc found of one mechanism. Numbers are SI and radians.",
    member("schema", "What this is.", one_of("mechc-result"), lambda c: "mechc-result"),
    member("version", "Of this layout.", Kind({"const": VERSION}, int), lambda c: VERSION),
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
