"""What a picture shows, in words, for whoever cannot see it."""

from collections.abc import Iterable, Iterator

from ..figure.figure import Figure, Force, Link, Part, Pivot, Slide, Slider, SpreadLoad, Torque


def describe(figure: Figure) -> str:
    """Return what a scheme shows: bodies, what holds them, loads, and whether it is to scale."""
    return " ".join(_sentences(figure))


def _sentences(figure: Figure) -> Iterator[str]:
    parts = figure.parts
    yield f"Kinematic scheme of {figure.title or figure.name}."
    yield from _listed("Links", ("".join(p.points) for p in parts if isinstance(p, Link)))
    yield from _listed("Sliding bodies", ("".join(p.points) for p in parts if isinstance(p, Slide)))
    yield from _listed("Fixed pivots", (p.point for p in parts if isinstance(p, Pivot)))
    yield from _listed("Guided points", (p.point for p in parts if isinstance(p, Slider)))
    yield from _listed("Loads", _loads(parts))
    if figure.mirror is not None:
        yield "Both mirrored halves are shown."
    if figure.copies > 1:
        yield f"It is one of {figure.copies} equal branches."
    if figure.chosen:
        yield f"Not to scale: nothing gives {', '.join(figure.chosen)}."


def _listed(what: str, names: Iterable[str]) -> Iterator[str]:
    found = list(dict.fromkeys(names))
    if found:
        yield f"{what}: {', '.join(found)}."


def _loads(parts: Iterable[Part]) -> Iterator[str]:
    for part in parts:
        if isinstance(part, Force):
            yield f"{part.name} at {part.point}"
        elif isinstance(part, SpreadLoad):
            yield f"{part.name} over {part.tail}{part.head}"
        elif isinstance(part, Torque):
            yield f"couple {part.name} on {part.link}"
