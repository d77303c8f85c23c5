"""Keys that several entries of YAML's sections have, and the entries of friction."""

from .. import ast
from .sections import EntryKey, SectionEntry, ValueKind, key, optional, word

NAMED = key("name", ValueKind.NAME)
AT_POINT = key("point", ValueKind.POINT)
TIMES = optional("times", ValueKind.EXPRESSION)
TIE = optional("is", ValueKind.EXPRESSION, "tie")
ON_LINK = optional("link", ValueKind.POINTS)
BETWEEN = key("between", ValueKind.PAIR, "first", "first_link", "second", "second_link")
SHARING = optional("sharing", ValueKind.SHARED)
WHEELS = (
    EntryKey("", ValueKind.RIM, ("first", "first_radius", "first_link")),
    EntryKey("", ValueKind.RIM, ("second", "second_radius", "second_link")),
)
PIN_FRICTION = (
    key("f", ValueKind.EXPRESSION, "coefficient"),
    key("diameter", ValueKind.EXPRESSION),
    word("pin_law", "law", "journal", "coulomb"),
    optional("link", ValueKind.POINTS),
)
GUIDE_FRICTION = (
    key("guide", ValueKind.EXPRESSION, "coefficient"),
    optional("length", ValueKind.EXPRESSION, needs=("overhang",)),
    optional("overhang", ValueKind.EXPRESSION, needs=("length",)),
    word("guide_law", "law", "couple", "linear", "edges", needs=("length",)),
)
ROLLER_FRICTION = (
    key("roller", ValueKind.EXPRESSION, "coefficient"),
    key("axle", ValueKind.EXPRESSION),
    key("wheel", ValueKind.EXPRESSION),
)
SCREW_FRICTION = (
    key("screw", ValueKind.EXPRESSION, "coefficient"),
    key("thread", ValueKind.EXPRESSION),
)
COLLAR_FRICTION = (
    key("collar", ValueKind.EXPRESSION, "coefficient"),
    optional("mean", ValueKind.EXPRESSION),
    optional("outer", ValueKind.EXPRESSION, needs=("inner",)),
    optional("inner", ValueKind.EXPRESSION, needs=("outer",)),
    word("collar_law", "law", "wear", "pressure", needs=("outer",)),
    optional("thrust", ValueKind.EXPRESSION),
    optional("faces", ValueKind.EXPRESSION, needs=("thrust",)),
    optional("collar_link", ValueKind.POINTS, "link", needs=("thrust",)),
)
ROPE_FRICTION = (
    key("rope", ValueKind.EXPRESSION, "coefficient"),
    key("wrap", ValueKind.EXPRESSION),
    optional("drum", ValueKind.EXPRESSION, needs=("drum_link",)),
    optional("drum_link", ValueKind.POINTS, "link", needs=("drum",)),
)
FRICTION = (
    SectionEntry(ast.PinFriction, key("point", ValueKind.PIN), keys=PIN_FRICTION),
    SectionEntry(ast.GuideFriction, AT_POINT, keys=GUIDE_FRICTION),
    SectionEntry(ast.RollerFriction, AT_POINT, keys=ROLLER_FRICTION),
    SectionEntry(
        ast.ContactFriction, AT_POINT, keys=(key("contact", ValueKind.EXPRESSION, "coefficient"),)
    ),
    SectionEntry(
        ast.GearFriction, AT_POINT, keys=(key("gear", ValueKind.EXPRESSION, "coefficient"),)
    ),
    SectionEntry(
        ast.BeltFriction, AT_POINT, keys=(key("belt", ValueKind.EXPRESSION, "coefficient"),)
    ),
    SectionEntry(
        ast.RackFriction, AT_POINT, keys=(key("rack", ValueKind.EXPRESSION, "coefficient"),)
    ),
    SectionEntry(ast.ScrewFriction, AT_POINT, keys=SCREW_FRICTION),
    SectionEntry(ast.CollarFriction, AT_POINT, keys=COLLAR_FRICTION),
    SectionEntry(ast.RopeFriction, AT_POINT, keys=ROPE_FRICTION),
)
PARAM_KEYS = (
    optional("value", ValueKind.MEASURE, "value", "tolerance"),
    optional("range", ValueKind.RANGE, "low", "high"),
    optional("dimension", ValueKind.DIMENSION),
    optional("label", ValueKind.TEXT),
    optional("about", ValueKind.TEXT),
)
