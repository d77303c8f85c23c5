"""Free bodies in JSON: under each set of loads, every body with all that acts on it."""

import math
from typing import get_args

from ...statics.diagrams import diagram
from ...statics.diagrams.diagram import Acting, Diagram, FreeBody
from .figure import PLANE
from .kinds import FLOAT, TEXT, TRUTH, JsonKind, list_of, map_of, member, one_of, optional, record


def _magnitude(acting: Acting) -> float | None:
    return math.hypot(*acting.force) if acting.force else None


ACTING: JsonKind[Acting] = record(
    "acting",
    "A force on a body and a couple beside it.",
    member("kind", "What it comes from.", one_of(*get_args(diagram.ActionKind)), lambda a: a.kind),
    member(
        "by",
        "A load, body or pin, ground, branches (other copies); empty of losses in wheels.",
        TEXT,
        lambda a: a.by,
    ),
    member("point", "Where, or empty for a couple alone.", TEXT, lambda a: a.point),
    member("force", "In N, along x and y; null if not known.", optional(PLANE), lambda a: a.force),
    member("magnitude", "Its size, N.", FLOAT, _magnitude),
    member("moment", "Of the couple, N m, counter-clockwise.", FLOAT, lambda a: a.moment),
    member(
        "offset",
        "How far right of the point the line of action passes, in m; null without a force.",
        FLOAT,
        lambda a: a.offset,
    ),
    member(
        "gap",
        "Why it is not known: equilibrium leaves it open, or how teeth and belts press does.",
        one_of("", "indeterminate", "transmission"),
        lambda a: a.gap,
    ),
    member("chosen", "It depends on what was chosen for the figure.", TRUTH, lambda a: a.chosen),
)

FREE_BODY: JsonKind[FreeBody] = record(
    "free_body",
    "A link or slide, or a pin on which more acts than two links.",
    member("name", "As in the figure.", TEXT, lambda b: b.name),
    member("kind", "What it is.", one_of("link", "slide", "slider", "pin"), lambda b: b.kind),
    member("forces", "All that acts on it.", list_of(ACTING), lambda b: b.forces),
)

DIAGRAM: JsonKind[Diagram] = record(
    "free_body_diagram",
    "All free bodies under one set of loads, at the pose of the figure; of copies one branch.",
    member("result", "Whose loads they are.", TEXT, lambda d: d.result),
    member(
        "motion",
        "The sense in which friction resists; empty without friction.",
        one_of("", "tightening", "releasing"),
        lambda d: d.motion,
    ),
    member("loads", "Those that act, N or N m.", map_of(FLOAT), lambda d: d.loads),
    member(
        "per",
        "The load whose size nothing gives: forces are per unit of it. Else empty.",
        TEXT,
        lambda d: d.per,
    ),
    member("left_out", "Loads that do not act here.", list_of(TEXT), lambda d: d.left_out),
    member("trouble", "Why there are no bodies, or empty.", TEXT, lambda d: d.trouble),
    member("bodies", "Links, slides, then pins.", list_of(FREE_BODY), lambda d: d.bodies),
)
