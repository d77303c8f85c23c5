"""The layout of a YAML description: one table from which reader, printer and schema are made.

Adding a construct to YAML is adding an entry here, and nowhere else.
"""

from .. import ast
from ..vocabulary import LANGUAGES
from .layout_keys import (
    AT_POINT,
    BETWEEN,
    FRICTION,
    NAMED,
    ON_LINK,
    PARAM_KEYS,
    SHARING,
    TIE,
    TIMES,
    WHEELS,
)
from .sections import (
    Entry,
    Key,
    Kind,
    Section,
    Shape,
    bare,
    key,
    listed,
    named,
    one,
    optional,
    plain,
)

SECTIONS: tuple[Section, ...] = (
    one("mechc", "version of the language", ast.Version, plain(Kind.VERSION, "number")),
    one(
        "mechanism",
        "name of the mechanism; generated functions are called after it",
        ast.Heading,
        plain(Kind.HEADING, "name"),
        optional("title", Kind.TEXT),
    ),
    one(
        "sheet",
        "name of a calculation sheet",
        ast.SheetHeading,
        plain(Kind.HEADING, "name"),
        optional("title", Kind.TEXT),
    ),
    one("source", "where it comes from", ast.SourceNote, plain(Kind.TEXT, "text")),
    named(
        "params",
        "parameters: a value with its unit, a range, a dimension",
        Entry(ast.Param, NAMED, plain(Kind.MEASURE, "value", "tolerance"), PARAM_KEYS),
    ),
    bare(
        "drive",
        "the driving coordinate and its stroke",
        Entry(
            ast.Drive,
            NAMED,
            plain(Kind.RANGE, "low", "high"),
            (optional("range", Kind.RANGE, "low", "high"), optional("speed", Kind.EXPRESSION)),
        ),
    ),
    bare(
        "pivots",
        "pins fixed to the ground",
        Entry(ast.Pivot, AT_POINT, plain(Kind.CARTESIAN, "at")),
    ),
    named(
        "sliders",
        "points guided by the ground along a direction",
        Entry(
            ast.Slider,
            AT_POINT,
            plain(Kind.DIRECTION, "along"),
            (key("along", Kind.DIRECTION), optional("through", Kind.PLACE)),
        ),
    ),
    bare(
        "links",
        "rigid bodies by their points",
        Entry(ast.Link, key("points", Kind.POINTS), plain(Kind.TEXT, "label")),
    ),
    named(
        "slides",
        "bodies that only translate",
        Entry(ast.Slide, key("points", Kind.BODY), plain(Kind.DIRECTION, "along")),
    ),
    named(
        "slots",
        "pins that slide along a line of a link",
        Entry(
            ast.Slot,
            AT_POINT,
            plain(Kind.ROD, "line"),
            (
                key("in", Kind.POINTS, "line"),
                optional("about", Kind.POINT, needs=("radius",)),
                optional("radius", Kind.EXPRESSION, needs=("about",)),
                optional("guiding", Kind.POINTS, "guided"),
            ),
        ),
    ),
    bare(
        "telescopes",
        "two-part links of variable length",
        Entry(ast.Telescope, key("points", Kind.ROD)),
    ),
    listed(
        "gears",
        "pairs of meshing gears: pivot and radius of each",
        Entry(ast.Gear, keys=(optional("inner", Kind.FLAG),), others=WHEELS),
    ),
    listed(
        "racks",
        "a slider's rack on a pivot's gear",
        Entry(
            ast.Rack,
            keys=(key("radius", Kind.EXPRESSION),),
            others=(Key("", Kind.POINT, ("point", "pivot")),),
        ),
    ),
    named(
        "contacts",
        "points that touch a line of another link",
        Entry(
            ast.Contact,
            AT_POINT,
            keys=(key("with", Kind.POINTS, "line"), key("normal", Kind.DIRECTION)),
        ),
    ),
    listed(
        "belts",
        "belts or chains: pivot and radius of each wheel",
        Entry(ast.Belt, keys=(optional("crossed", Kind.FLAG),), others=WHEELS),
    ),
    named(
        "screws",
        "sliders moved by a turning link",
        Entry(
            ast.Screw,
            AT_POINT,
            keys=(key("pitch", Kind.EXPRESSION), key("link", Kind.POINTS)),
        ),
    ),
    listed(
        "ropes",
        "ropes: from a point over pulleys to another one",
        Entry(ast.Rope, short=plain(Kind.ROUTE, "start", "falls")),
    ),
    named(
        "points",
        "where points are drawn, at the default pose",
        Entry(ast.Drawn, AT_POINT, plain(Kind.CARTESIAN, "at")),
    ),
    named(
        "geometry",
        "vectors between two points, angles at the middle one of three",
        Entry(ast.Vector, key("points", Kind.ROD), plain(Kind.VECTOR, "value")),
        Entry(ast.Turn, key("points", Kind.CORNER), plain(Kind.EXPRESSION, "angle")),
    ),
    named(
        "assembly",
        "which closure is meant at the default pose",
        Entry(
            ast.Assembly,
            key("points", Kind.BODY),
            plain(Kind.WORD, "mode", words=("cw", "ccw", "forward", "back")),
        ),
    ),
    Section(
        "mirror",
        "the description is one half",
        Shape.ONE,
        (Entry(ast.Mirror, keys=(key("across", Kind.DIRECTION), SHARING)),),
    ),
    Section(
        "copies",
        "identical branches around an axis",
        Shape.ONE,
        (Entry(ast.Copies, keys=(key("n", Kind.EXPRESSION, "number"), SHARING)),),
    ),
    named(
        "forces",
        "forces on points",
        Entry(
            ast.Force,
            NAMED,
            keys=(
                key("at", Kind.POINT, "point"),
                ON_LINK,
                key("along", Kind.DIRECTION),
                TIE,
                TIMES,
            ),
        ),
    ),
    named(
        "torques",
        "couples on links, positive counter-clockwise",
        Entry(ast.Torque, NAMED, keys=(key("link", Kind.POINTS), TIE, TIMES)),
    ),
    named(
        "actuators",
        "pairs of forces that push two points apart",
        Entry(ast.Actuator, NAMED, keys=(BETWEEN, TIMES)),
    ),
    listed(
        "springs",
        "springs between two points",
        Entry(
            ast.Spring,
            keys=(BETWEEN, key("rate", Kind.EXPRESSION), key("free", Kind.EXPRESSION), TIMES),
        ),
    ),
    named(
        "weights",
        "weights of masses",
        Entry(
            ast.Weight,
            NAMED,
            keys=(
                key("mass", Kind.EXPRESSION),
                key("at", Kind.POINT, "point"),
                ON_LINK,
                TIMES,
            ),
        ),
    ),
    named(
        "loads",
        "loads spread over a stretch of a link",
        Entry(
            ast.Distributed,
            NAMED,
            keys=(
                optional("intensity", Kind.EXPRESSION),
                optional("to", Kind.EXPRESSION, "end", needs=("intensity",)),
                key("over", Kind.ROD, "line"),
                key("along", Kind.DIRECTION),
                TIMES,
            ),
        ),
    ),
    one("gravity", "direction of gravity", ast.Gravity, plain(Kind.DIRECTION, "along")),
    named("friction", "friction at pins, guides, rollers, contacts and transmissions", *FRICTION),
    one(
        "motion",
        "which way it moves",
        ast.Motion,
        plain(Kind.WORD, "sense", words=("tightening", "releasing")),
    ),
    one(
        "efficiency",
        "overrides friction by one number",
        ast.Efficiency,
        plain(Kind.EXPRESSION, "value"),
    ),
    named(
        "tables",
        "tables of a value for an argument, in proportion between two rows",
        Entry(
            ast.Table,
            NAMED,
            plain(Kind.ROWS, "rows"),
            (key("rows", Kind.ROWS), optional("source", Kind.TEXT)),
        ),
    ),
    named(
        "lists",
        "sizes that there are, from the smallest",
        Entry(
            ast.Sizes,
            NAMED,
            plain(Kind.SIZES, "sizes"),
            (key("sizes", Kind.SIZES), optional("source", Kind.TEXT)),
        ),
    ),
    named(
        "use",
        "other sheets and mechanisms, by the prefix that their names get here",
        Entry(
            ast.Use,
            key("prefix", Kind.NAME),
            plain(Kind.USED, "used"),
            (
                key("name", Kind.USED, "used"),
                optional("with", Kind.GIVEN, "given"),
                optional("at", Kind.CARTESIAN),
                optional("turned", Kind.EXPRESSION),
                optional("joining", Kind.JOINTS),
                optional("without", Kind.NAMES),
            ),
        ),
    ),
    named(
        "let",
        "user-defined formulas",
        Entry(
            ast.Let,
            NAMED,
            plain(Kind.LET_VALUE, "value"),
            (
                key("value", Kind.LET_VALUE),
                optional("unit", Kind.UNIT),
                optional("label", Kind.TEXT),
            ),
        ),
    ),
    Section(
        "find",
        "what to derive",
        Shape.EITHER,
        (Entry(ast.Find, NAMED, plain(Kind.RESULT, "target", "name", "on")),),
    ),
    listed(
        "require",
        "conditions of use",
        Entry(ast.Require, short=plain(Kind.CONDITION, "operands", "operators")),
    ),
    listed(
        "expect",
        "what a book or a colleague says",
        Entry(ast.Expect, short=plain(Kind.EXPECTATION, "subject", "value", "at", "tolerance")),
    ),
    listed(
        "report",
        "what a report of it holds",
        Entry(ast.Reported, short=plain(Kind.REPORTED, "name", "over")),
    ),
    listed(
        "translate",
        "what titles, labels and remarks are in other languages",
        Entry(
            ast.Translate,
            keys=(
                key("text", Kind.TEXT),
                *(optional(language, Kind.TEXT) for language in LANGUAGES),
            ),
        ),
    ),
)

BY_NAME = {section.name: section for section in SECTIONS}
BESIDE = {
    beside.name: [s.name for s in SECTIONS if beside in s.beside]
    for section in SECTIONS
    for beside in section.beside
}
"""The keys that stand beside a section, and the sections of which one must be there."""
ORDER = {entry.node: n for n, section in enumerate(SECTIONS) for entry in section.entries}
"""The place of each node's section: YAML has an order of sections, not of statements."""
