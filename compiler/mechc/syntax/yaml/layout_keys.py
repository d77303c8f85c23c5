"""Keys that several entries of the YAML layout have, and the entries of friction."""

from .. import ast
from .sections import Entry, Key, Kind, key, optional, word

NAMED = key("name", Kind.NAME)
AT_POINT = key("point", Kind.POINT)
TIMES = optional("times", Kind.EXPRESSION)
TIE = optional("is", Kind.EXPRESSION, "tie")
ON_LINK = optional("link", Kind.POINTS)
BETWEEN = key("between", Kind.PAIR, "first", "first_link", "second", "second_link")
SHARING = optional("sharing", Kind.SHARED)
WHEELS = (
    Key("", Kind.RIM, ("first", "first_radius", "first_link")),
    Key("", Kind.RIM, ("second", "second_radius", "second_link")),
)
PIN_FRICTION = (
    key("f", Kind.EXPRESSION, "coefficient"),
    key("diameter", Kind.EXPRESSION),
    word("pin_law", "law", "journal", "coulomb"),
    optional("link", Kind.POINTS),
)
GUIDE_FRICTION = (
    key("guide", Kind.EXPRESSION, "coefficient"),
    optional("length", Kind.EXPRESSION, needs=("overhang",)),
    optional("overhang", Kind.EXPRESSION, needs=("length",)),
    word("guide_law", "law", "couple", "linear", "edges", needs=("length",)),
)
ROLLER_FRICTION = (
    key("roller", Kind.EXPRESSION, "coefficient"),
    key("axle", Kind.EXPRESSION),
    key("wheel", Kind.EXPRESSION),
)
SCREW_FRICTION = (key("screw", Kind.EXPRESSION, "coefficient"), key("thread", Kind.EXPRESSION))
COLLAR_FRICTION = (
    key("collar", Kind.EXPRESSION, "coefficient"),
    optional("mean", Kind.EXPRESSION),
    optional("outer", Kind.EXPRESSION, needs=("inner",)),
    optional("inner", Kind.EXPRESSION, needs=("outer",)),
    word("collar_law", "law", "wear", "pressure", needs=("outer",)),
    optional("thrust", Kind.EXPRESSION),
    optional("faces", Kind.EXPRESSION, needs=("thrust",)),
    optional("collar_link", Kind.POINTS, "link", needs=("thrust",)),
)
ROPE_FRICTION = (
    key("rope", Kind.EXPRESSION, "coefficient"),
    key("wrap", Kind.EXPRESSION),
    optional("drum", Kind.EXPRESSION, needs=("drum_link",)),
    optional("drum_link", Kind.POINTS, "link", needs=("drum",)),
)
FRICTION = (
    Entry(ast.PinFriction, key("point", Kind.PIN), keys=PIN_FRICTION),
    Entry(ast.GuideFriction, AT_POINT, keys=GUIDE_FRICTION),
    Entry(ast.RollerFriction, AT_POINT, keys=ROLLER_FRICTION),
    Entry(ast.ContactFriction, AT_POINT, keys=(key("contact", Kind.EXPRESSION, "coefficient"),)),
    Entry(ast.GearFriction, AT_POINT, keys=(key("gear", Kind.EXPRESSION, "coefficient"),)),
    Entry(ast.BeltFriction, AT_POINT, keys=(key("belt", Kind.EXPRESSION, "coefficient"),)),
    Entry(ast.RackFriction, AT_POINT, keys=(key("rack", Kind.EXPRESSION, "coefficient"),)),
    Entry(ast.ScrewFriction, AT_POINT, keys=SCREW_FRICTION),
    Entry(ast.CollarFriction, AT_POINT, keys=COLLAR_FRICTION),
    Entry(ast.RopeFriction, AT_POINT, keys=ROPE_FRICTION),
)
PARAM_KEYS = (
    optional("value", Kind.MEASURE, "value", "tolerance"),
    optional("range", Kind.RANGE, "low", "high"),
    optional("dimension", Kind.DIMENSION),
    optional("label", Kind.TEXT),
    optional("about", Kind.TEXT),
)
