"""What formulas ask for by the points: ``phi_AB``, ``len_AB``, ``x_B``, ``y_B``.

What a loop gives keeps its name, being a definition of the pose; what the description
gives is put in.
"""

from collections.abc import Iterator, Mapping

from ..algebra.angle import HALF_TURN, Angle, principal
from ..algebra.from_formula import to_angle, to_product
from ..algebra.sums import add
from ..algebra.trigonometry import cosine
from ..base.frozen import replace
from ..diagnostics import Report
from ..diagnostics import pose as messages
from ..formula.layout import TRIGONOMETRIC
from ..formula.tree import Call, Formula
from ..formula.walk import children, rebuild, substitute, symbols
from ..model.mechanism import ForcePair, Mechanism
from ..model.names.forms import COORDINATES, ReservedName, form_of_pose
from ..source import Span
from .pose import Vector
from .vectors import Vectors, start_of


def with_directions(mechanism: Mechanism, vectors: Vectors, report: Report) -> Mechanism:
    """Return the mechanism with what its formulas ask for of vectors.

    Reports E301, E305, E306 and E310 where a vector has none of that, E346 where a point has
    no place.
    """
    found: dict[str, Formula] = {}
    start = start_of(mechanism, [point for ends in vectors.given() for point in ends])
    own = {named.name for named in (*mechanism.parameters, *mechanism.lets, *mechanism.loads)}
    for formula, span in _formulas(mechanism):
        for name in sorted(symbols(formula) - found.keys()):
            form = form_of_pose(name) if name not in own else None
            answer = _answer(form, start, vectors, span, report) if form else None
            if answer is not None:
                found[name] = answer
    return _with(mechanism, found) if found else mechanism


def _formulas(mechanism: Mechanism) -> Iterator[tuple[Formula, Span]]:
    """Yield the formulas that may ask, with their places."""
    for let in mechanism.lets:
        yield let.value, let.span
    for require in (*mechanism.requires, *mechanism.implied):
        yield from ((require.left, require.span), (require.right, require.span))
    for expect in mechanism.expects:
        yield expect.value, expect.span
    for load in mechanism.loads:
        if load.tie is not None and not isinstance(load, ForcePair):
            yield load.tie, load.span


def _answer(
    form: ReservedName, start: str, vectors: Vectors, span: Span, report: Report
) -> Formula | None:
    """Return the length, direction or coordinate that a form asks for; None without an answer."""
    if form.prefix in COORDINATES:
        return _coordinate(form, start, vectors, span, report)
    return _of_vector(form, vectors, span, report) if form.prefix in ("phi", "len") else None


def _of_vector(form: ReservedName, vectors: Vectors, span: Span, report: Report) -> Formula | None:
    """Return the direction or the length of the vector between two points."""
    tail, head = form.points
    vector = vectors.path(tail, head)
    if vector is None:
        report.add(messages.missing_direction(span, f"{tail}{head}", "the formula"))
    elif not vector:
        report.add(messages.points_coincide(span, f"{tail}{head}"))
    elif vectors.is_open(vector) and form.prefix == "len":
        report.add(messages.length_open(span, f"{tail}{head}"))
    elif len(vector) > 1 and vectors.is_open(vector):
        report.add(messages.no_direction_of_its_own(span, f"{tail}{head}"))
    else:
        return _direction_or_length(form, vector, vectors)
    return None


def _direction_or_length(form: ReservedName, vector: Vector, vectors: Vectors) -> Formula:
    """Return the length or direction that a form asks for; a vector of several arms is made one."""
    if len(vector) > 1:
        vectors.straighten(*form.points)
        vector = vectors.path(*form.points) or ()
    ((length, angle),) = vector
    if length.coefficient < 0:
        length, angle = -length, angle + HALF_TURN
    return principal(angle).formula() if form.prefix == "phi" else length.formula()


def _coordinate(
    form: ReservedName, start: str, vectors: Vectors, span: Span, report: Report
) -> Formula | None:
    """Return how far a point is from where places count from, along an axis."""
    (point,) = form.points
    vector = vectors.path(start, point)
    if vector is None or vectors.is_open(vector):
        report.add(messages.point_without_place(span, point))
        return None
    axis = Angle.constant(0 if form.prefix == "x" else 90)
    return add(arm.length * cosine(arm.angle - axis) for arm in vector).formula()


def _with(mechanism: Mechanism, found: Mapping[str, Formula]) -> Mechanism:
    """Return a mechanism with formulas in place of names of the pose, wherever it has formulas."""
    lets = tuple(replace(x, value=_put(x.value, found)) for x in mechanism.lets)
    expects = tuple(replace(x, value=_put(x.value, found)) for x in mechanism.expects)
    requires, implied = (
        tuple(replace(x, left=_put(x.left, found), right=_put(x.right, found)) for x in conditions)
        for conditions in (mechanism.requires, mechanism.implied)
    )
    loads = tuple(
        load
        if load.tie is None or isinstance(load, ForcePair)
        else replace(load, tie=_put(load.tie, found))
        for load in mechanism.loads
    )
    return replace(
        mechanism, lets=lets, expects=expects, requires=requires, implied=implied, loads=loads
    )


def _put(formula: Formula, found: Mapping[str, Formula]) -> Formula:
    """Return a formula with names put in; differences of directions are added up, inside too."""
    names = symbols(formula) & found.keys()
    if not names:
        return formula
    whole = substitute(formula, found)
    angle = to_angle(whole) if any(name.startswith("phi_") for name in names) else None
    if angle is not None:
        return angle.formula()
    parts = children(formula)
    if not parts:
        return whole
    put = rebuild(formula, tuple(_put(part, found) for part in parts))
    if isinstance(put, Call) and put.function in TRIGONOMETRIC and to_angle(put.arguments[0]):
        return to_product(put).formula()
    return put
