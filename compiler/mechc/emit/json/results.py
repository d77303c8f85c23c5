"""What JSON says of a result: its formula, and all that follows from it."""

from collections.abc import Mapping
from typing import get_args

from ...model.mechanism import (
    Axial,
    Efficiency,
    LoadForm,
    LoadRatio,
    Normal,
    Reaction,
    Require,
    ResultTarget,
    SpeedRatio,
    WithFriction,
)
from ...model.result import Result
from ...study.analysis import Analysis, Break, ClaimScope, DeadCentre, Trend, Vanishing
from ...study.locking_intervals import (
    Bound,
    EfficiencyRange,
    Locking,
    LockingInterval,
    LockingIntervals,
)
from ...units import si_unit
from ..describe import dimension_name
from .formula import DEFINITION, FORMULA
from .kinds import FLOAT, TEXT, TRUTH, JsonKind, list_of, map_of, member, one_of, optional, record
from .lets import MOST_INTERMEDIATES

TRENDS, SCOPES = get_args(Trend), get_args(ClaimScope)
CAUSES = ("dead centre", "perpendicular load", "other")
KINDS: Mapping[type[ResultTarget] | type[None], str] = {
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


CONDITION: JsonKind[Require] = record(
    "condition",
    "What must hold: left operator right.",
    member("left", "One side.", FORMULA, lambda c: c.left),
    member("operator", "How they compare.", TEXT, lambda c: c.operator),
    member("right", "The other side.", FORMULA, lambda c: c.right),
)


def _cause(limit: Vanishing) -> str:
    return "dead centre" if isinstance(limit.cause, DeadCentre) else limit.cause


def _still(limit: Vanishing) -> str | None:
    return limit.cause.still.name if isinstance(limit.cause, DeadCentre) else None


def _moving(limit: Vanishing) -> str | None:
    return limit.cause.moving.name if isinstance(limit.cause, DeadCentre) else None


VANISHING: JsonKind[Vanishing] = record(
    "vanishing",
    "A condition under which a result is zero, or infinite.",
    member("factor", "It is where this is 0.", FORMULA, lambda v: v.factor),
    member("symbol", "Solved for this.", optional(TEXT), lambda v: v.at and v.at[0]),
    member("value", "Its value there.", optional(FORMULA), lambda v: v.at and v.at[1]),
    member("values", "All within its range.", list_of(FORMULA), lambda v: v.within),
    member("period", "More follow by this.", optional(FORMULA), lambda v: v.period),
    member("kind", "What happens there.", one_of(*CAUSES), _cause),
    member("still", "What stands still at a dead centre.", optional(TEXT), _still),
    member("moving", "What moves there.", optional(TEXT), _moving),
    member("but", "Unless one of these is 0, too.", list_of(FORMULA), lambda v: v.except_where),
    member("outside", "Proved: not within the ranges given.", TRUTH, lambda v: v.outside),
)

BREAK: JsonKind[Break] = record(
    "break",
    "A condition under which something that loops find is infinite.",
    member("factor", "It is where this is 0.", FORMULA, lambda b: b.factor),
    member("name", "What is infinite.", TEXT, lambda b: b.name),
)

STATES = ("free", "locked", "jammed")
_NUMBERS = list_of(FLOAT)

BOUND: JsonKind[Bound] = record(
    "bound",
    "An end of a stretch.",
    member("place", "SI and radians.", FLOAT, lambda b: b.x),
    member("formula", "The same, where one is known.", optional(FORMULA), lambda b: b.exact),
    member("dead_centre", "The ratio changes its sign.", TRUTH, lambda b: b.is_dead_centre),
)

STRETCH: JsonKind[LockingInterval] = record(
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

REACH: JsonKind[LockingIntervals] = record(
    "reach",
    "Where nothing moves as one parameter varies, the others at their values.",
    member("parameter", "Its name.", TEXT, lambda r: r.parameter),
    member("range", "As given.", optional(_NUMBERS), lambda r: r.range),
    member("stretches", "In order.", list_of(STRETCH), lambda r: r.stretches),
)

LOCKING: JsonKind[Locking] = record(
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

EFFICIENCY_RANGE: JsonKind[EfficiencyRange] = record(
    "course",
    "What an efficiency runs through over a range, found by sampling.",
    member("parameter", "Its name.", TEXT, lambda c: c.parameter),
    member("range", "SI and radians.", _NUMBERS, lambda c: c.range),
    member("least", "0 where nothing moves.", FLOAT, lambda c: c.least),
    member("greatest", "The highest.", FLOAT, lambda c: c.greatest),
    member("usual", "Where it is 0.9 … 0.95.", list_of(_NUMBERS), lambda c: c.usual),
)

_POWERS = map_of(JsonKind({"type": "integer"}, int))
_PAIRS = list_of(list_of(TEXT))

ELSEWHERE: JsonKind[Result] = record(
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
        "guards", "What must hold, or there is no value.", list_of(CONDITION), lambda r: r.guards
    ),
)

RESULT: JsonKind[Analysis] = record(
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
        f"{MOST_INTERMEDIATES} leaves out "
        "those that other results are, or define in their own where.",
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
    member(
        "driven",
        "Of a load with friction, and its efficiency: whether the others drive the motion at the "
        "default pose, or would without friction; null where that is not known, and at a dead "
        "centre.",
        optional(TRUTH),
        lambda r: r.driven,
    ),
    member(
        "courses", "Of an efficiency.", list_of(EFFICIENCY_RANGE), lambda r: r.efficiency_ranges
    ),
    member(
        "value", "At the default pose, SI; null at a pole or a jump.", FLOAT, lambda r: r.default
    ),
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
