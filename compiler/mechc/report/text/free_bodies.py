"""Free bodies as text, for ``mechc show bodies``: forces in N, couples in N m."""

import math
from collections.abc import Iterable, Iterator

from ...statics.diagrams.diagram import Acting, Diagram, FreeBody

NOTHING = (
    "There are no free bodies: no load is asked for, friction alone holds it, or no pose"
    " of the mechanism is found."
)

GAPS = {
    "indeterminate": "not determined by equilibrium",
    "transmission": "not known: how teeth, belts or threads press is undetermined",
}


def describe(diagrams: Iterable[Diagram]) -> str:
    """Return all that acts on each body, one force to a line.

    >>> describe([]).split(":")[0]
    'There are no free bodies'
    """
    blocks = ["\n".join(_lines(diagram)) for diagram in diagrams]
    return "\n\n".join(blocks or [NOTHING]) + "\n"


def _lines(diagram: Diagram) -> Iterator[str]:
    friction = "with friction" if diagram.motion else "without friction"
    loads = ", ".join(f"{name} = {_number(size)}" for name, size in diagram.loads.items())
    yield f"{diagram.result}, {friction}: {loads}"
    if diagram.per:
        yield f"  forces are per unit of {diagram.per}"
    if diagram.left_out:
        yield f"  without {', '.join(diagram.left_out)}"
    if diagram.trouble:
        yield f"  none: {diagram.trouble}"
    for body in diagram.bodies:
        yield from _body(body)


def _body(body: FreeBody) -> Iterator[str]:
    yield f"  {body.kind} {body.name}"
    for acting in body.forces:
        yield f"    {_what(acting)}: {_size(acting)}"


def _what(acting: Acting) -> str:
    kind = acting.kind if acting.by in ("", acting.kind) else f"{acting.kind} {acting.by}"
    return f"{acting.point}, {kind}" if acting.point else kind


def _size(acting: Acting) -> str:
    if acting.force is None:
        return GAPS[acting.gap]
    return ", ".join(_figures(acting)) or "0"


def _figures(acting: Acting) -> Iterator[str]:
    x, y = acting.force or (0.0, 0.0)
    if acting.point:
        yield f"({_number(x)}, {_number(y)}), size {_number(math.hypot(x, y))}"
    if acting.moment:
        yield f"couple {_number(acting.moment)}"
    if acting.moment and acting.offset is not None:
        yield f"{_number(acting.offset * 1000)} mm off"
    if acting.chosen:
        yield "depends on what was chosen for the figure"


def _number(value: float) -> str:
    return f"{value:.6g}"
