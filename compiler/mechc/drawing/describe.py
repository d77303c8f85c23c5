"""Pictures in words, for whoever cannot see them: schemes, and plans of velocities and forces."""

import math
from collections.abc import Iterable, Iterator, Mapping

from ..figure.figure import Figure, Force, Link, Part, Pivot, Slide, Slider, SpreadLoad, Torque
from ..formula.names import split_points
from ..pose.places import Plane
from .drawing import TextRun
from .force_polygon import visible
from .lettering import figures
from .vectors import ForceVectors, VelocityVectors, heading, in_words

Words = Mapping[str, str]


def describe(figure: Figure, words: Words) -> str:
    """Return the description of a scheme: bodies, joints, loads, and whether it is to scale."""
    return " ".join(_sentences(figure, words))


def _sentences(figure: Figure, words: Words) -> Iterator[str]:
    """Yield the sentences that say what a scheme shows."""
    parts = figure.parts
    yield words["scheme_of"].format(name=figure.title or figure.name)
    yield from _listed(words["links"], (_link(p) for p in parts if isinstance(p, Link)))
    yield from _listed(words["slides"], ("".join(p.points) for p in parts if isinstance(p, Slide)))
    yield from _listed(words["pivots"], (p.point for p in parts if isinstance(p, Pivot)))
    yield from _listed(words["sliders"], (p.point for p in parts if isinstance(p, Slider)))
    yield from _listed(words["loads"], _loads(parts, words))
    if figure.mirror is not None:
        yield words["halves"]
    if figure.copies > 1:
        yield words["branches"].format(count=figure.copies)
    if figure.chosen:
        lengths = (name.removeprefix("len_") for name in figure.chosen)
        yield words["open_scale"].format(names=", ".join(lengths))


def _link(link: Link) -> str:
    """Return a link by its points, and what it is called."""
    return "".join(link.points) + (f" ({link.label})" if link.label else "")


def _listed(what: str, names: Iterable[str]) -> Iterator[str]:
    found = list(dict.fromkeys(names))
    if found:
        yield f"{what}: {', '.join(found)}."


def _loads(parts: Iterable[Part], words: Words) -> Iterator[str]:
    for part in parts:
        if isinstance(part, Force):
            yield words["load_at"].format(load=part.name, point=part.point)
        elif isinstance(part, SpreadLoad):
            yield words["load_over"].format(load=part.name, line=part.tail + part.head)
        elif isinstance(part, Torque):
            yield words["couple_on"].format(load=part.name, link=part.link)


def say_velocities(speeds: VelocityVectors, words: Mapping[str, str]) -> str:
    """Return how fast every point moves, and in which direction."""
    said = "; ".join(_velocities(speeds))
    return f"{words['velocities']}: {said}."


def _velocities(speeds: VelocityVectors) -> Iterator[str]:
    velocities = speeds.velocities
    for point, velocity in velocities.points.items():
        if split_points(point) and velocities.speed(point) > 0:
            size = speeds.size(velocities.speed(point), point)
            yield _towards((*speeds.name(point), *size), velocity)


def say_forces(forces: ForceVectors) -> str:
    """Return the forces on every body in the order of its polygon."""
    said = "; ".join(_bodies(forces))
    return f"{in_words(heading(forces.diagram, forces.words))}: {said}." if said else ""


def _bodies(forces: ForceVectors) -> Iterator[str]:
    for body in forces.described:
        acting = visible(forces, body)
        sides = ", ".join(
            _towards((*forces.name(body, one), *forces.size(one)), one.force)
            for one in acting
            if one.force
        )
        if sides:
            yield f"{forces.called(body.name)}: {sides}"


def _towards(runs: tuple[TextRun, ...], vector: Plane) -> str:
    angle = round(math.degrees(vector.angle) % 360, 1) % 360
    return f"{in_words(runs)} ∠ {figures(angle)}°"
