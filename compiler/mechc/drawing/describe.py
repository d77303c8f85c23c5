"""A picture in words, for whoever cannot see it."""

from collections.abc import Iterable, Iterator, Mapping

from ..figure.figure import Figure, Force, Link, Part, Pivot, Slide, Slider, SpreadLoad, Torque

Words = Mapping[str, str]


def describe(figure: Figure, words: Words) -> str:
    """Return the description of a scheme: bodies, joints, loads, and whether it is to scale."""
    return " ".join(_sentences(figure, words))


def _sentences(figure: Figure, words: Words) -> Iterator[str]:
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
