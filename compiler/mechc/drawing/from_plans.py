"""From velocities and free bodies to their plans: polygons to scale, one below the other."""

import math
from collections.abc import Iterator, Mapping, Sequence

from ..base.frozen import replace
from ..figure.figure import Figure
from ..figure.velocities import MotionVelocities
from ..pose.places import NOWHERE, Plane
from ..statics.diagrams.diagram import Diagram, FreeBody
from .arrange import below_each_other, in_rows, joined, line_of_text
from .describe import say_forces, say_velocities
from .drawing import Drawing, TextRun
from .force_polygon import force_polygon, force_scale, is_known, visible
from .labels import AroundPoint
from .lettering import name
from .pens import SYMBOL
from .plots.ticks import TICK_STEPS
from .sheet import Layer, Sheet
from .symbols import line
from .tolerances import SAME_WHOLE_NUMBER
from .vectors import ForceVectors, VelocityVectors, heading
from .velocity_polygon import velocity_polygon, velocity_scale

VELOCITIES_IN_A_ROW = 5
"""How many velocities stand in a line below the polygon."""


def plans(
    figure: Figure,
    velocities: Sequence[MotionVelocities],
    diagrams: Sequence[Diagram],
    words: Mapping[str, str],
) -> Drawing | None:
    """Return the plans of velocities and of the forces on every body; None where there are none.

    ``words`` are those of a language.
    """
    motions = [_of_velocities(figure, velocities, i, words) for i in range(len(velocities))]
    forces = [_of_forces(ForceVectors(figure, diagram, words)) for diagram in diagrams]
    if not motions and not forces:
        return None
    title = words["plans_of"].format(name=figure.title or figure.name)
    about = [say_velocities(VelocityVectors(v), words) for v in velocities]
    about += [say_forces(ForceVectors(figure, diagram, words)) for diagram in diagrams]
    return replace(
        below_each_other([*motions, *forces]),
        title=title,
        description=" ".join(filter(None, about)),
    )


def _of_velocities(
    figure: Figure, motions: Sequence[MotionVelocities], number: int, words: Mapping[str, str]
) -> Drawing:
    """Return the plan of one motion, its scale, and how fast links turn."""
    velocities = motions[number]
    speeds, polygon = VelocityVectors(velocities), velocity_polygon(figure, velocities)
    head = words["velocities"]
    if len(motions) > 1:
        head += ", " + words["motion"].format(number=number + 1, count=len(motions))
    unit = speeds.name(velocities.per) if velocities.per else (TextRun("m/s", unit=True),)
    spins = filter(None, map(speeds.spin, velocities.spins))
    return joined(
        [
            line_of_text((TextRun(head),)),
            polygon.drawing,
            scale_bar(velocity_scale(velocities), unit),
            *_rows(polygon.left),
            *_rows(list(spins)),
        ]
    )


def _rows(parts: Sequence[tuple[TextRun, ...]]) -> Iterator[Drawing]:
    """Yield lines of what is said, a few things in each."""
    for i in range(0, len(parts), VELOCITIES_IN_A_ROW):
        said = (
            run for part in parts[i : i + VELOCITIES_IN_A_ROW] for run in (TextRun(",   "), *part)
        )
        yield line_of_text(tuple(said)[1:])


def _of_forces(forces: ForceVectors) -> Drawing:
    """Return the polygons of all bodies under one set of loads, to one scale."""
    found = [_polygon(forces, body) for body in _drawn(forces)]
    bar = scale_bar(force_scale(forces) * forces.measure, forces.unit)
    polygons = [in_rows(found, "top"), bar] if found else []
    open_ = ", ".join(forces.called(b.name) for b in forces.described if not is_known(b))
    left_out = (
        [line_of_text((TextRun(forces.words["open"].format(bodies=open_)),))] if open_ else []
    )
    head = line_of_text(heading(forces.diagram, forces.words))
    return joined([head, *polygons, *left_out])


def _drawn(forces: ForceVectors) -> Iterator[FreeBody]:
    """Yield the bodies whose forces are all known, and more than one."""
    for body in forces.described:
        if is_known(body) and len(visible(forces, body)) > 1:
            yield body


def _polygon(forces: ForceVectors, body: FreeBody) -> Drawing:
    title = line_of_text(name(forces.called(body.name)))
    return joined([title, force_polygon(forces, body)])


LONGEST_SCALE_BAR = 30.0
"""How long the bar is at most, in millimetres."""

TICK = 1.2
"""Half the height of the strokes at its ends."""


def scale_bar(size: float, unit: tuple[TextRun, ...]) -> Drawing:
    """Return a bar as long as a round number of units, one of which is ``size`` millimetres."""
    units = _round(LONGEST_SCALE_BAR / size)
    end = Plane(units * size, 0.0)
    sheet = Sheet()
    up = Plane(0.0, TICK)
    bar = [line(at.minus(up), at.plus(up), SYMBOL) for at in (NOWHERE, end)]
    sheet.draw(Layer.MEASURES, [line(NOWHERE, end, SYMBOL), *bar])
    sheet.name(AroundPoint(end, (TextRun(f"{units:g}\u2009"), *unit), SYMBOL, 0.0, TICK))
    return sheet.finished("", "")


def _round(most: float) -> float:
    """Return the largest of 1, 2, 5, 10, … that is no larger.

    >>> _round(0.19), _round(7.0), _round(20.0)
    (0.1, 5.0, 20.0)
    """
    power = 10.0 ** math.floor(math.log10(most))
    return max(
        step * power for step in TICK_STEPS if step * power <= most * (1 + SAME_WHOLE_NUMBER)
    )
