"""What JSON says of a derivation: steps, terms, and paragraphs with their equations."""

from typing import get_args

from ...formula.to_text import text
from ...report.kinds import PositionKind, SentenceKind, StepRule
from ...report.steps import (
    Derivation,
    DerivationStep,
    Equation,
    Explanation,
    Paragraph,
    PositionStep,
    PowerTerm,
)
from .formula import DEFINITION, FORMULA
from .kinds import TEXT, JsonKind, list_of, map_of, member, one_of, record


def _equation(equation: Equation) -> str:
    return f"{text(equation.left)} = {text(equation.right)}"


STEP: JsonKind[DerivationStep] = record(
    "step",
    "One step of the derivation.",
    member("rule", "The rule of mechanics.", one_of(*StepRule), lambda s: s.rule),
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

POSITION: JsonKind[PositionStep] = record(
    "position_step",
    "What one loop gives of the position.",
    member("kind", "How the loop is solved.", one_of(*get_args(PositionKind)), lambda s: s.kind),
    member("points", "Of the loop.", list_of(TEXT), lambda s: s.points),
    member("definitions", "In order.", list_of(DEFINITION), lambda s: s.definitions),
    member("like", "The triangle that one is congruent to.", list_of(TEXT), lambda s: s.like),
)

TERM: JsonKind[PowerTerm] = record(
    "term",
    "The power of one load: times · load · speed.",
    member("load", "Its name.", TEXT, lambda t: t.load),
    member("point", "Where it acts.", TEXT, lambda t: t.point),
    member("times", "How often it acts.", FORMULA, lambda t: t.times),
    member("speed", "Signed along the load.", FORMULA, lambda t: t.speed),
)

PARAGRAPH: JsonKind[Paragraph] = record(
    "passage",
    "A sentence with the equations that it leads to.",
    member("says", "What the sentence says.", one_of(*SentenceKind), lambda p: p.sentence),
    member("names", "What it says it of.", map_of(list_of(TEXT)), lambda p: p.names),
    member("formulas", "Directions, speeds …", map_of(FORMULA), lambda p: p.formulas),
    member(
        "equations",
        "What follows.",
        list_of(TEXT),
        lambda p: tuple(map(_equation, p.equations)),
    ),
)

ACCOUNT: JsonKind[Explanation] = record(
    "account",
    "How results were found that need more than the power equation.",
    member("results", "Their names.", list_of(TEXT), lambda a: a.results),
    member("passages", "In order.", list_of(PARAGRAPH), lambda a: a.paragraphs),
    member("where", "What the equations rest on.", list_of(DEFINITION), lambda a: a.where),
)

DERIVATION: JsonKind[Derivation] = record(
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
