"""Random syntax trees, as the parsers build them, for round trips and for fuzzing.

Only trees that some text means: sums and products are flat, directions named by a
vector are ``Toward``, a statement's optional fields keep the company they need.
"""

from hypothesis import strategies as st

from mechc.base.frozen import fields
from mechc.source import Span
from mechc.syntax import ast
from mechc.syntax.vocabulary import FUNCTIONS, points_of
from mechc.units import UNITS

NOWHERE = Span(0, 0)

UNIT_NAMES = sorted(set(UNITS) - {"in"})
PARAMETERS = ["a", "b", "l_1", "alpha", "beta", "lambda", "x", "f", "m", "N", "V_D", "R_O1'", "e1"]


def named(texts):
    return st.sampled_from(texts).map(lambda text: ast.Name(text, NOWHERE))


names = named([p for p in PARAMETERS if p != "pi"])
points = named(["A", "B2", "K'", "O1", "D''", "M"])
rods = named(["AB", "O1B2", "K'A", "MN"])
corners = named(["ABC", "O1B2K'"])
bodies = named(["AB", "OBA", "O1B2K'", "ABCD"])

digits = st.one_of(
    st.integers(0, 999).map(str),
    st.sampled_from(["0.5", "1e-3", "2.50", "1E+6", ".5", "7.", "12345678901234567890"]),
)
numbers = st.builds(ast.Number, digits, st.sampled_from(["", "", *UNIT_NAMES]), st.just(NOWHERE))
plain_numbers = st.builds(ast.Number, digits, st.just(""), st.just(NOWHERE))
symbols = st.sampled_from(PARAMETERS).map(lambda name: ast.Symbol(name, NOWHERE))


def flat(parts, kind):
    """Dissolve the nested sums or products that change nothing, as the parser does."""
    found = []
    for sign, part in parts:
        if sign == 1 and isinstance(part, kind):
            found.extend(part.terms if kind is ast.Sum else part.factors)
        else:
            found.append((sign, part))
    return tuple(found)


def sum_of(parts):
    match parts:
        case [(1, only)]:
            return only
    return ast.Sum(flat(parts, ast.Sum), NOWHERE)


def product_of(first, rest):
    if not rest:
        return first
    return ast.Product(flat([(1, first), *rest], ast.Product), NOWHERE)


def calls(arguments):
    def call(function):
        arity = FUNCTIONS[function]
        most = arity.most or 3
        several = st.lists(arguments, min_size=arity.least, max_size=most)
        return several.map(lambda found: ast.Call(function, tuple(found), NOWHERE))

    return st.sampled_from(sorted(FUNCTIONS)).flatmap(call)


def small_exponent(node):
    literal = node.terms[0][1] if isinstance(node, ast.Sum) and len(node.terms) == 1 else node
    return not (isinstance(literal, ast.Number) and not literal.unit and literal.value > 64)


def compound(inner):
    signs = st.sampled_from([1, -1])
    signed = st.tuples(signs, inner)
    return st.one_of(
        st.lists(signed, min_size=1, max_size=3).map(sum_of),
        st.builds(product_of, inner, st.lists(signed, min_size=1, max_size=3)),
        st.builds(ast.Power, inner, inner.filter(small_exponent), st.just(NOWHERE)),
        calls(inner),
    )


expressions = st.recursive(st.one_of(numbers, symbols), compound, max_leaves=6)


def no_direction(node):
    """Leave out what a direction reads otherwise: x, -x, AB, -AB."""
    match node:
        case ast.Sum(terms=((-1, ast.Symbol(name=name)),)) | ast.Symbol(name=name):
            return name not in ("x", "y") and len(points_of(name)) != 2
    return True


signs = st.sampled_from([1, -1])
directions = st.one_of(
    expressions.filter(no_direction),
    st.builds(ast.Axis, st.sampled_from(["x", "y"]), signs, st.just(NOWHERE)),
    st.builds(ast.Toward, rods, signs, st.booleans(), st.just(NOWHERE)),
)
cartesians = st.builds(ast.Cartesian, expressions, expressions, st.just(NOWHERE))
polars = st.one_of(
    st.builds(ast.Polar, expressions, st.none() | directions, st.just(NOWHERE)),
    st.builds(ast.Polar, st.none(), directions, st.just(NOWHERE)),
)
texts = st.text(st.characters(codec="utf-8", exclude_categories=["C", "Zl", "Zp"]), max_size=20)
spoken = st.one_of(
    texts, st.sampled_from(['a "quoted" one', "it's", "2023", "no", "a: b # c", "\\"])
)
comments = texts.map(str.rstrip)
shared = st.lists(points, max_size=2).map(tuple)
maybe = st.one_of(st.none(), expressions)


def statement(node, *fields, **named_fields):
    return st.builds(node, st.just(NOWHERE), *fields, **named_fields)


ranges = st.one_of(st.just((None, None)), st.tuples(expressions, expressions))


@st.composite
def params(draw):
    name, value, (low, high) = draw(names), draw(maybe), draw(ranges)
    dimension = draw(st.none() | named(["length", "angle", "force"]))
    if value is None and dimension is None and low is None:
        value = draw(expressions)
    texts = draw(spoken), draw(spoken)
    tolerance = draw(maybe) if value is not None else None
    return ast.Param(NOWHERE, name, value, low, high, dimension, *texts, tolerance)


@st.composite
def drives(draw):
    return ast.Drive(NOWHERE, draw(names), *draw(ranges))


@st.composite
def pin_friction(draw):
    point = draw(st.none() | points)
    link = draw(st.none() | bodies) if point else None
    law = draw(st.sampled_from(["", "journal", "coulomb"]))
    return ast.PinFriction(NOWHERE, point, draw(expressions), draw(expressions), law, link)


@st.composite
def guide_friction(draw):
    point, mu = draw(points), draw(expressions)
    if draw(st.booleans()):
        return ast.GuideFriction(NOWHERE, point, mu)
    law = draw(st.sampled_from(["", "couple", "linear", "edges"]))
    return ast.GuideFriction(NOWHERE, point, mu, draw(expressions), draw(expressions), law)


@st.composite
def requires(draw):
    operands = draw(st.lists(expressions, min_size=2, max_size=4))
    operator = st.sampled_from(["<", "<=", ">", ">=", "=", "!="])
    operators = draw(st.lists(operator, min_size=len(operands) - 1, max_size=len(operands) - 1))
    return ast.Require(NOWHERE, tuple(operands), tuple(operators))


@st.composite
def wheels(draw, node):
    first, second = draw(points), draw(points)
    if first == second:
        second = ast.Name("Q", NOWHERE)
    return node(NOWHERE, first, draw(expressions), second, draw(expressions), draw(st.booleans()))


@st.composite
def racks(draw):
    return ast.Rack(NOWHERE, draw(points), draw(points), draw(expressions))


def places():
    return st.one_of(st.none(), points, cartesians)


modes = st.sampled_from(["cw", "ccw", "forward", "back"])
settings = st.lists(st.tuples(names, expressions), max_size=2).map(tuple)

ONCE = [
    st.builds(ast.Version, st.just(NOWHERE), st.just("1")),
    statement(ast.Heading, names, spoken),
    statement(ast.SourceNote, spoken),
    statement(ast.Gravity, directions),
    statement(ast.Mirror, directions, shared),
    statement(ast.Copies, expressions, shared),
    statement(ast.Motion, st.sampled_from(["tightening", "releasing"])),
    statement(ast.Efficiency, expressions),
    drives(),
]


def ropes():
    falls = st.lists(st.tuples(points, st.none() | directions), min_size=1, max_size=3)
    return statement(ast.Rope, points, falls.map(tuple))


MANY = [
    params(),
    statement(ast.Pivot, points, st.none() | cartesians),
    statement(ast.Slider, points, directions, places()),
    statement(ast.Link, bodies, spoken),
    statement(ast.Slide, bodies, directions),
    statement(ast.Slot, points, rods),
    statement(ast.Telescope, rods),
    wheels(ast.Gear),
    racks(),
    ropes(),
    statement(ast.Contact, points, rods, directions),
    wheels(ast.Belt),
    statement(ast.Screw, points, expressions, bodies),
    statement(ast.Vector, rods, polars | cartesians),
    statement(ast.Turn, corners, expressions),
    statement(ast.Assembly, bodies, modes),
    statement(ast.Force, names, points, directions, maybe, maybe),
    statement(ast.Torque, names, bodies, maybe, maybe),
    statement(ast.Actuator, names, points, points, maybe),
    statement(ast.Spring, expressions, points, points, expressions, maybe),
    statement(ast.Weight, names, expressions, points, maybe),
    pin_friction(),
    guide_friction(),
    statement(ast.RollerFriction, points, expressions, expressions, expressions),
    statement(ast.ContactFriction, points, expressions),
    statement(ast.Let, names, expressions),
    statement(ast.Find, expressions, st.none() | names, st.none() | bodies),
    requires(),
    statement(ast.Expect, expressions, expressions, settings, maybe),
]


def remarked(node):
    """Give a statement comments and a remark."""
    return st.builds(
        lambda made, above, remark: type(made)(
            **{f.name: getattr(made, f.name) for f in fields(made) if f.name not in KEPT},
            comments=tuple(above),
            remark=remark,
        ),
        node,
        st.lists(comments, max_size=2),
        comments.map(str.strip),
    )


KEPT = ("comments", "remark")


def keyed(node):
    """Return the key of a statement in YAML, which may not stand twice."""
    if isinstance(node, (ast.Vector, ast.Turn)):
        return ("geometry", node.points.text)
    return id(node)


@st.composite
def files(draw):
    """Draw a whole description: the version first, what is said once at most once."""
    version, *once = ONCE
    head = [draw(remarked(version))] if draw(st.booleans()) else []
    singles = [draw(remarked(node)) for node in once if draw(st.integers(0, 3)) == 0]
    many = draw(st.lists(st.one_of([remarked(node) for node in MANY]), max_size=6))
    unique = list({keyed(node): node for node in many}.values())
    body = draw(st.permutations(singles + unique))
    return ast.File((*head, *body), tuple(draw(st.lists(comments, max_size=2))))
