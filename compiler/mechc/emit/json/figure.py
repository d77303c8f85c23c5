"""The figure in JSON: points in metres, and every part with what it is in ``part``."""

from collections.abc import Mapping
from typing import Any

from ...figure.figure import (
    Actuator,
    AngleMark,
    ArcSlot,
    Belt,
    Contact,
    DimensionLine,
    Figure,
    Force,
    Gears,
    Link,
    MirrorLine,
    Part,
    Pivot,
    Plane,
    Rack,
    Rope,
    Screw,
    Segment,
    Slide,
    Slider,
    Slot,
    SpreadLoad,
    Spring,
    Telescope,
    Torque,
)
from .kinds import (
    FLOAT,
    TEXT,
    TRUTH,
    WHOLE,
    JsonKind,
    RecordField,
    any_of,
    list_of,
    map_of,
    member,
    one_of,
    optional,
    record,
)

_NAMES = list_of(TEXT)
_PAIR: JsonKind[tuple[str, str]] = JsonKind(
    {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2}, list
)

PLANE: JsonKind[Plane] = JsonKind(
    {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}, list
)
"""A place in metres, a unit direction, or a force in newtons: x, y."""

SEGMENT: JsonKind[Segment] = record(
    "segment",
    "A stretch of a line.",
    member("start", "One end.", PLANE, lambda s: s.start),
    member("end", "The other.", PLANE, lambda s: s.end),
)

FIELDS: Mapping[str, tuple[str, JsonKind[Any]]] = {
    "name": ("As in the description; a twin's has a prime.", TEXT),
    "label": ("For drawings, or empty.", TEXT),
    "points": ("Through which it goes.", _NAMES),
    "outline": ("Points at its corners, counter-clockwise.", _NAMES),
    "rods": ("Between which points bars are drawn.", list_of(_PAIR)),
    "point": ("The point that it holds or pushes.", TEXT),
    "through": ("A fixed point of the guide, or empty.", TEXT),
    "along": ("Unit direction.", PLANE),
    "ground": ("Unit direction in which the ground is.", PLANE),
    "normal": ("Unit direction in which the body pushes the point.", PLANE),
    "guide": ("The line on which it slides.", SEGMENT),
    "groove": ("The line of the slot.", SEGMENT),
    "face": ("The line that is touched.", SEGMENT),
    "line": ("The pitch line.", SEGMENT),
    "axis": ("The axis of the thread.", SEGMENT),
    "body": ("The link or slide.", TEXT),
    "link": ("The link, or empty for a force on a pin.", TEXT),
    "tail": ("From this point.", TEXT),
    "head": ("To this point.", TEXT),
    "first": ("One point.", TEXT),
    "second": ("The other point.", TEXT),
    "first_link": ("The link at the first point; empty for the pin, or a wheel that stands.", TEXT),
    "second_link": ("The link at the second point, or empty.", TEXT),
    "guided": ("The link that is fast in the block on the point, or empty.", TEXT),
    "first_radius": ("In metres.", FLOAT),
    "second_radius": ("In metres.", FLOAT),
    "inner": ("One gear is inside the other.", TRUTH),
    "touch": ("The pitch point.", PLANE),
    "runs": ("Its straight stretches.", list_of(SEGMENT)),
    "pulleys": ("The radii at which pulleys are drawn, in metres.", list_of(FLOAT)),
    "crossed": ("The belt crosses itself.", TRUTH),
    "pivot": ("The centre of the gear.", TEXT),
    "centre": ("The centre of the circle.", TEXT),
    "tail_intensity": ("In N/m at the tail; 1 where it is open.", FLOAT),
    "head_intensity": ("In N/m at the head; 1 where it is open.", FLOAT),
    "radius": ("In metres; the gear is on the left of the direction if positive.", FLOAT),
    "pitch": ("In metres for a turn; right-handed if positive.", FLOAT),
    "weight": ("It is a weight.", TRUTH),
    "times": ("How often it acts.", FLOAT),
    "at": ("Where it is drawn.", PLANE),
    "counterclockwise": ("Which way it turns.", TRUTH),
    "text": ("The formula, in mechc's own notation.", TEXT),
    "value": ("Of the formula, in metres.", FLOAT),
    "vertex": ("The point at which it is.", TEXT),
    "start": ("Where the angle begins, in radians from +x.", FLOAT),
    "sweep": ("The angle, in radians, counter-clockwise.", FLOAT),
}
"""The meaning of the fields of parts, whatever part they are of."""

PARTS: Mapping[type[Part], tuple[str, str]] = {
    Link: ("link", "A rigid body."),
    Slide: ("slide", "A body that only translates."),
    Telescope: ("telescope", "A link of variable length."),
    Pivot: ("pivot", "A pin on the ground."),
    Slider: ("slider", "A point that the ground guides."),
    Slot: ("slot", "A pin in a groove of a body."),
    ArcSlot: ("arc_slot", "A pin in a circular groove of a body."),
    Contact: ("contact", "A point that touches a body."),
    Gears: ("gears", "Two gears."),
    Belt: ("belt", "A belt or chain."),
    Rack: ("rack", "A rack on a gear."),
    Screw: ("screw", "A screw."),
    Rope: ("rope", "A rope over pulleys."),
    Force: ("force", "A force on a point."),
    SpreadLoad: ("spread_load", "A load spread over a stretch of a link."),
    Torque: ("torque", "A couple on a link."),
    Actuator: ("actuator", "A pair of forces that pushes two points apart."),
    Spring: ("spring", "A spring."),
    DimensionLine: ("dimension", "What measures a distance."),
    AngleMark: ("angle", "What measures an angle."),
}


def _field(name: str) -> RecordField[Any]:
    about, kind = FIELDS[name]
    return member(name, about, kind, lambda part: getattr(part, name))


def _part(of: type[Part]) -> JsonKind[Any]:
    word, about = PARTS[of]
    what: RecordField[Part] = member("part", "What it is.", one_of(word), lambda _: word)
    return record(f"drawn_{word}", about, what, *map(_field, of.__match_args__))


MIRROR: JsonKind[MirrorLine] = record(
    "mirror_line",
    "A line through a place.",
    member("at", "A place on it.", PLANE, lambda m: m.at),
    member("along", "Its unit direction.", PLANE, lambda m: m.along),
)

FIGURE: JsonKind[Figure] = record(
    "figure",
    "What a drawing of the default pose shows: both mirrored halves, one branch of copies.",
    member("points", "Where every point is, in metres.", map_of(PLANE), lambda f: f.points),
    member(
        "parts",
        "What is drawn there.",
        list_of(any_of({of: _part(of) for of in PARTS})),
        lambda f: f.parts,
    ),
    member("mirror", "If there are halves.", optional(MIRROR), lambda f: f.mirror),
    member("copies", "How many branches there are.", WHOLE, lambda f: f.copies),
    member("axis", "About which the branches are.", optional(MIRROR), lambda f: f.axis),
    member("size", "The length of a usual vector, to scale symbols by.", FLOAT, lambda f: f.size),
    member("values", "Of the pose, SI and radians.", map_of(FLOAT), lambda f: f.values),
    member("chosen", "Which values nothing gives.", list_of(TEXT), lambda f: f.chosen),
)
