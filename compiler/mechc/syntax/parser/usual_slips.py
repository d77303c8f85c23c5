"""What is often written otherwise, and what is said of it: a table for each way to look it up."""

from ...diagnostics.syntax import WITH_FRICTION

_ENDS = (
    "a cylinder is a telescope, and the actuator acts between its ends: actuator P between A and B"
)


_SQUARE = "a direction stands behind 'along': force F at A along perp OA, OA turned by 90 deg"


_TOWARDS = "a direction stands behind 'along': force F at A along AB, from A towards B"


_MOVES = (
    "a drive is what moves, drive phi from 10 deg to 80 deg; the force of a cylinder is an "
    "actuator, actuator P between A and B, that of a motor a torque, torque M on OA"
)


_GRAVITY = "gravity has a direction, gravity along -y; its size is a param g = 9.81 m/s^2"


_ALL_HOLD = (
    "all conditions hold at once, each in a line of its own; what differs from case to case is a "
    "choice: let a = 2 mm when v < 1 m/s else 3 mm"
)


_INNER = "gears of which one runs inside the other: gear O1 20 mm, O2 60 mm inner"


_ABOUT = "a circular slot is about its centre: slot B in OAC about C radius 30 mm"


DIRECTIONS = "a direction is an angle, x, -x, y, -y, or that of a vector, AB"


LINKED = "a link is named by its points, written together: OA"


_COUNTED = "couples count counter-clockwise, a clockwise one is negative: let M = -2 N*m"


STATED = {
    ("TORQUE", "at"): "a couple acts on a link: torque M on OA",
    **dict.fromkeys((("TORQUE", sense) for sense in ("cw", "ccw", "clockwise")), _COUNTED),
    ("FORCE", "="): "the size of a load stands behind its name: force T = 0.2*N at A along x",
    ("TORQUE", "="): "the size of a load stands behind its name: torque T = 0.2*M on OA",
    ("FORCE", "on"): "a force acts at a point: force F at A along x",
    ("SLIDER", "at"): "a guide has a direction, slider K along 90 deg, and its point a place in a "
    "line of its own: K at (0 mm, 80 mm)",
    ("PIVOT", "("): "the place of a pivot stands behind 'at': pivot O at (0 mm, 0 mm)",
    ("SPRING", "="): "the rate stands without a name: spring 5 N/mm between A and B free 40 mm",
    ("SPRING", "on"): "a spring that turns a link is a torque of its angle: torque M on OA, "
    "let M = -c*(phi_OA - 20 deg)",
    ("SPRING", "between"): "the rate comes first: spring 5 N/mm between A and B",
    ("WEIGHT", "="): "a weight has a mass: weight W mass 2 kg at G",
    ("ROPE", "along"): "a rope begins at a point, and each further one has the direction of the "
    "fall that ends there: rope A, K along -y, H along y",
    ("ROPE", "-"): "a ',' stands between the points of a rope: rope A, K along -y, H along y",
    ("GEAR", "inside"): _INNER,
    ("GEAR", "internal"): _INNER,
    ("GEAR", "fixed"): "a wheel that stands still is on ground: gear O 40 mm on ground, A 20 mm",
    ("SLOT", "around"): _ABOUT,
    ("SLOT", "round"): _ABOUT,
    ("GEAR", "="): "a radius stands behind its pivot: gear O1 20 mm, O2 30 mm",
    ("BELT", "="): "a radius stands behind its pivot: belt O1 20 mm, O2 30 mm",
    ("ACTUATOR", "in"): _ENDS,
    ("ACTUATOR", "on"): _ENDS,
    ("ACTUATOR", "at"): _ENDS,
    ("FORCE", "towards"): _TOWARDS,
    ("FORCE", "toward"): _TOWARDS,
    ("FORCE", "to"): _TOWARDS,
    ("FORCE", "between"): "a pair of forces between two points is an actuator: actuator P between "
    "A and B",
    ("FORCE", "perpendicular"): _SQUARE,
    ("FORCE", "normal"): _SQUARE,
    ("FORCE", "perp"): _SQUARE,
    ("FORCE", "times"): "how often it counts stands at the end: force N at D along y times 2",
    ("FRICTION", "releasing"): "the sense of motion is a line of its own: motion releasing",
    ("FRICTION", "tightening"): "the sense of motion is a line of its own: motion tightening",
    ("GRAVITY", "9.81 m/s^2"): _GRAVITY,
    ("GRAVITY", "9.81"): _GRAVITY,
    ("FIND", "in"): "a result is shown in a unit by a formula of its own: let N = N_AB in kN",
    ("FIND", "at"): "a result at other values is an expect, expect k = 0.35 at alpha = 10 deg, or "
    "comes by -D alpha=10deg behind the command",
    ("FRICTION", "overhang"): "it is written: friction slider K 0.1 guide 60 mm overhang 40 mm",
    ("FRICTION", "telescope"): "the parts of a telescope slide without friction; the pins at its "
    "ends have it by: friction pins 0.1 diameter 10 mm",
    ("REPORT", ":"): "what a report holds stands without a colon: report scheme, k",
    ("FIND", "efficiency"): WITH_FRICTION,
    ("DRIVE", "on"): _MOVES,
    ("DRIVE", "at"): _MOVES,
    ("DRIVE", "between"): _MOVES,
    ("REQUIRE", "or"): _ALL_HOLD,
    ("REQUIRE", "and"): "all conditions hold at once, each in a line of its own",
    (
        "TABLE",
        ",",
    ): 'a row is an argument and its value: table m "Table 4.9" = 1: 0.388, 0.5: 0.541',
    ("LINK", "="): "a link is declared, and its lengths are lines of their own: OA = 60 mm",
    ("TELESCOPE", "="): "a telescope is declared, and its length is a line of its own: AB = 60 mm",
    ("SLIDE", "="): "a slide is declared, and its lengths are lines of their own: WX = 60 mm",
    ("WEIGHT", "at"): "a weight has a mass: weight W mass 2 kg at G",
    ("USE", "with"): "what is given stands in brackets: use cylinder as cyl (P = 2 kN)",
    ("TRANSLATE", "ua"): 'Ukrainian is uk: translate "handle" uk "рукоятка"',
    ("LET", "otherwise"): "what is meant where no case holds stands behind 'else'",
    ("LET", "or"): "conditions are joined by 'and'; another case is one of its own behind a ','",
    ("MIRROR", "and"): "a ',' stands between points: sharing K, L",
    ("COPIES", "and"): "a ',' stands between points: sharing K, L",
    **dict.fromkeys(
        (("EXPECT", ">"), ("EXPECT", "<"), ("EXPECT", ">="), ("EXPECT", "<=")),
        "an expect has '=', within bounds expect k = 0.35 +- 0.01; a result is kept below or above "
        "something by the `require` of a sheet that uses the mechanism",
    ),
    ("EXPECT", "and"): "a ',' stands between values: at alpha = 10 deg, l = 200 mm",
}
"""What is said otherwise in a statement, by its word and what does not fit in it."""


FRICTION_OF = {
    "guide": "slider",
    "slide": "slider",
    "pivot": "pin",
    "bearing": "pin",
    "joint": "pin",
    "hinge": "pin",
    "link": "pin",
    "wheel": "roller",
    "slot": "contact",
    "cam": "contact",
    "wedge": "contact",
    "chain": "belt",
    "pulley": "rope",
    "drum": "rope",
    "band": "rope",
    "thread": "screw",
    "nut": "screw",
    "thrust": "collar",
    "brake": "collar",
}
"""The word of a friction by what it is also called; an example of it is in ``WRITTEN``."""


CHOICES = {
    "ASSEMBLY": "ccw is counter-clockwise, cw clockwise; along a guide it is forward or back",
}
"""Words of which a statement takes one, whatever does not fit in it."""


SCALARS = {
    "in": "a range is a key of its own: {value: 200 mm, range: 100 mm .. 300 mm}",
    "as": "a label is a key of its own: {value: 200 mm, label: arm}",
    "about": "in YAML 'about' is a key of its own",
    "along": "a direction stands without the word: K: 90 deg",
    "at": "in YAML 'at' is a key of its own, and a place a list: {O: [0 mm, 0 mm]}",
    "through": "in YAML 'through' is a key of its own: {along: y, through: O}",
}
"""What words of the line notation are in YAML."""


COORDINATES = "coordinates are a list: [0 mm, 0 mm]"


ASKED = {
    "at": "what a table gives is a let of its own: {}; a formula takes q by its name",
    "next": "what a list gives is a let of its own: {}; a formula takes D by its name",
    "when": "a choice is a let of its own: {}; a formula takes K by its name",
}
"""What is said of a table, a list or a choice that is asked within a formula."""
