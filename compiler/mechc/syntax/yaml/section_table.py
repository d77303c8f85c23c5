"""The table of YAML's sections: from it reader, printer and schema are made.

Adding a construct to YAML is adding an entry here, and nowhere else.
"""

from .. import ast
from ..vocabulary import LANGUAGES
from .entry_keys import (
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
    EntryKey,
    EntryShape,
    SectionEntry,
    ValueKind,
    YamlSection,
    bare,
    key,
    listed,
    named,
    one,
    optional,
    plain,
)

SECTIONS: tuple[YamlSection, ...] = (
    one("mechc", "version of the language", ast.Version, plain(ValueKind.VERSION, "number")),
    one(
        "mechanism",
        "name of the mechanism; generated functions are called after it",
        ast.Heading,
        plain(ValueKind.HEADING, "name"),
        optional("title", ValueKind.TEXT),
    ),
    one(
        "sheet",
        "name of a calculation sheet",
        ast.SheetHeading,
        plain(ValueKind.HEADING, "name"),
        optional("title", ValueKind.TEXT),
    ),
    one("source", "where it comes from", ast.SourceNote, plain(ValueKind.TEXT, "text")),
    named(
        "params",
        "parameters: a value with its unit, a range, a dimension",
        SectionEntry(ast.Param, NAMED, plain(ValueKind.MEASURE, "value", "tolerance"), PARAM_KEYS),
    ),
    bare(
        "drive",
        "the driving coordinate and its stroke",
        SectionEntry(
            ast.Drive,
            NAMED,
            plain(ValueKind.RANGE, "low", "high"),
            (
                optional("range", ValueKind.RANGE, "low", "high"),
                optional("speed", ValueKind.EXPRESSION),
            ),
        ),
    ),
    bare(
        "pivots",
        "pins fixed to the ground",
        SectionEntry(ast.Pivot, AT_POINT, plain(ValueKind.CARTESIAN, "at")),
    ),
    named(
        "sliders",
        "points guided by the ground along a direction",
        SectionEntry(
            ast.Slider,
            AT_POINT,
            plain(ValueKind.DIRECTION, "along"),
            (key("along", ValueKind.DIRECTION), optional("through", ValueKind.PLACE)),
        ),
    ),
    bare(
        "links",
        "rigid bodies by their points",
        SectionEntry(ast.Link, key("points", ValueKind.POINTS), plain(ValueKind.TEXT, "label")),
    ),
    named(
        "slides",
        "bodies that only translate",
        SectionEntry(ast.Slide, key("points", ValueKind.BODY), plain(ValueKind.DIRECTION, "along")),
    ),
    named(
        "slots",
        "pins that slide along a line of a link",
        SectionEntry(
            ast.Slot,
            AT_POINT,
            plain(ValueKind.ROD, "line"),
            (
                key("in", ValueKind.POINTS, "line"),
                optional("about", ValueKind.POINT, needs=("radius",)),
                optional("radius", ValueKind.EXPRESSION, needs=("about",)),
                optional("guiding", ValueKind.POINTS, "guided"),
            ),
        ),
    ),
    bare(
        "telescopes",
        "two-part links of variable length",
        SectionEntry(ast.Telescope, key("points", ValueKind.ROD)),
    ),
    listed(
        "gears",
        "pairs of meshing gears: pivot and radius of each",
        SectionEntry(ast.Gear, keys=(optional("inner", ValueKind.FLAG),), others=WHEELS),
    ),
    listed(
        "racks",
        "a slider's rack on a pivot's gear",
        SectionEntry(
            ast.Rack,
            keys=(key("radius", ValueKind.EXPRESSION),),
            others=(EntryKey("", ValueKind.POINT, ("point", "pivot")),),
        ),
    ),
    named(
        "contacts",
        "points that touch a line of another link",
        SectionEntry(
            ast.Contact,
            AT_POINT,
            keys=(key("with", ValueKind.POINTS, "line"), key("normal", ValueKind.DIRECTION)),
        ),
    ),
    listed(
        "belts",
        "belts or chains: pivot and radius of each wheel",
        SectionEntry(ast.Belt, keys=(optional("crossed", ValueKind.FLAG),), others=WHEELS),
    ),
    named(
        "screws",
        "sliders moved by a turning link",
        SectionEntry(
            ast.Screw,
            AT_POINT,
            keys=(key("pitch", ValueKind.EXPRESSION), key("link", ValueKind.POINTS)),
        ),
    ),
    listed(
        "ropes",
        "ropes: from a point over pulleys to another one",
        SectionEntry(ast.Rope, short=plain(ValueKind.ROUTE, "start", "falls")),
    ),
    named(
        "points",
        "where points are drawn, at the default pose",
        SectionEntry(ast.Drawn, AT_POINT, plain(ValueKind.CARTESIAN, "at")),
    ),
    named(
        "geometry",
        "vectors between two points, angles at the middle one of three",
        SectionEntry(ast.Vector, key("points", ValueKind.ROD), plain(ValueKind.VECTOR, "value")),
        SectionEntry(
            ast.Turn, key("points", ValueKind.CORNER), plain(ValueKind.EXPRESSION, "angle")
        ),
    ),
    named(
        "assembly",
        "which closure is meant at the default pose",
        SectionEntry(
            ast.Assembly,
            key("points", ValueKind.BODY),
            plain(ValueKind.WORD, "mode", words=("cw", "ccw", "forward", "back")),
        ),
    ),
    YamlSection(
        "mirror",
        "the description is one half",
        EntryShape.ONE,
        (SectionEntry(ast.Mirror, keys=(key("across", ValueKind.DIRECTION), SHARING)),),
    ),
    YamlSection(
        "copies",
        "identical branches around an axis",
        EntryShape.ONE,
        (SectionEntry(ast.Copies, keys=(key("n", ValueKind.EXPRESSION, "number"), SHARING)),),
    ),
    named(
        "forces",
        "forces on points",
        SectionEntry(
            ast.Force,
            NAMED,
            keys=(
                key("at", ValueKind.POINT, "point"),
                ON_LINK,
                key("along", ValueKind.DIRECTION),
                TIE,
                TIMES,
            ),
        ),
    ),
    named(
        "torques",
        "couples on links, positive counter-clockwise",
        SectionEntry(ast.Torque, NAMED, keys=(key("link", ValueKind.POINTS), TIE, TIMES)),
    ),
    named(
        "actuators",
        "pairs of forces that push two points apart",
        SectionEntry(ast.Actuator, NAMED, keys=(BETWEEN, TIMES)),
    ),
    listed(
        "springs",
        "springs between two points",
        SectionEntry(
            ast.Spring,
            keys=(
                BETWEEN,
                key("rate", ValueKind.EXPRESSION),
                key("free", ValueKind.EXPRESSION),
                TIMES,
            ),
        ),
    ),
    named(
        "weights",
        "weights of masses",
        SectionEntry(
            ast.Weight,
            NAMED,
            keys=(
                key("mass", ValueKind.EXPRESSION),
                key("at", ValueKind.POINT, "point"),
                ON_LINK,
                TIMES,
            ),
        ),
    ),
    named(
        "loads",
        "loads spread over a stretch of a link",
        SectionEntry(
            ast.Distributed,
            NAMED,
            keys=(
                optional("intensity", ValueKind.EXPRESSION),
                optional("to", ValueKind.EXPRESSION, "end", needs=("intensity",)),
                key("over", ValueKind.ROD, "line"),
                key("along", ValueKind.DIRECTION),
                TIMES,
            ),
        ),
    ),
    one("gravity", "direction of gravity", ast.Gravity, plain(ValueKind.DIRECTION, "along")),
    named("friction", "friction at pins, guides, rollers, contacts and transmissions", *FRICTION),
    one(
        "motion",
        "which way it moves",
        ast.Motion,
        plain(ValueKind.WORD, "sense", words=("tightening", "releasing")),
    ),
    one(
        "efficiency",
        "overrides friction by one number",
        ast.Efficiency,
        plain(ValueKind.EXPRESSION, "value"),
    ),
    named(
        "tables",
        "tables of a value for an argument, in proportion between two rows",
        SectionEntry(
            ast.Table,
            NAMED,
            plain(ValueKind.ROWS, "rows"),
            (key("rows", ValueKind.ROWS), optional("source", ValueKind.TEXT)),
        ),
    ),
    named(
        "lists",
        "sizes that there are, from the smallest",
        SectionEntry(
            ast.Sizes,
            NAMED,
            plain(ValueKind.SIZES, "sizes"),
            (key("sizes", ValueKind.SIZES), optional("source", ValueKind.TEXT)),
        ),
    ),
    named(
        "use",
        "other sheets and mechanisms, by the prefix that their names get here",
        SectionEntry(
            ast.Use,
            key("prefix", ValueKind.NAME),
            plain(ValueKind.USED, "used"),
            (
                key("name", ValueKind.USED, "used"),
                optional("with", ValueKind.GIVEN, "given"),
                optional("at", ValueKind.CARTESIAN),
                optional("turned", ValueKind.EXPRESSION),
                optional("joining", ValueKind.JOINTS),
                optional("without", ValueKind.NAMES),
            ),
        ),
    ),
    named(
        "let",
        "user-defined formulas",
        SectionEntry(
            ast.Let,
            NAMED,
            plain(ValueKind.LET_VALUE, "value"),
            (
                key("value", ValueKind.LET_VALUE),
                optional("unit", ValueKind.UNIT),
                optional("label", ValueKind.TEXT),
            ),
        ),
    ),
    YamlSection(
        "find",
        "what to derive",
        EntryShape.EITHER,
        (SectionEntry(ast.Find, NAMED, plain(ValueKind.RESULT, "target", "name", "on")),),
    ),
    listed(
        "require",
        "conditions of use",
        SectionEntry(ast.Require, short=plain(ValueKind.CONDITION, "operands", "operators")),
    ),
    listed(
        "expect",
        "what a book or a colleague says",
        SectionEntry(
            ast.Expect, short=plain(ValueKind.EXPECTATION, "subject", "value", "at", "tolerance")
        ),
    ),
    listed(
        "report",
        "what a report of it holds",
        SectionEntry(ast.Reported, short=plain(ValueKind.REPORTED, "name", "over")),
    ),
    listed(
        "translate",
        "what titles, labels and remarks are in other languages",
        SectionEntry(
            ast.Translate,
            keys=(
                key("text", ValueKind.TEXT),
                *(optional(language, ValueKind.TEXT) for language in LANGUAGES),
            ),
        ),
    ),
)

BY_NAME = {section.name: section for section in SECTIONS}
FURTHER_KEYS = {
    beside.name: [s.name for s in SECTIONS if beside in s.beside]
    for section in SECTIONS
    for beside in section.beside
}
"""The keys that go with a section, and the sections of which one must be there."""
ORDER = {entry.node: n for n, section in enumerate(SECTIONS) for entry in section.entries}
"""The place of each node's section: YAML has an order of sections, not of statements."""
