"""Where points are and how links point, as the document lists them."""

from collections.abc import Sequence
from typing import get_args

from ...formula.walk import symbols
from ...model.result import Definition
from ...model.values import Chain
from ...named import NamedTuple
from ...pose.motion import Kind as Motion
from ...pose.motion import Quantity
from ...units import si_unit
from ..describe import quantity_words
from ..target import Compiled
from .formula import DEFINITION, FORMULA
from .kinds import FLOAT, TEXT, Kind, list_of, member, one_of, record


class Moved(NamedTuple):
    """The quantities of a motion with their values, and the definitions that they rest on."""

    quantities: tuple[tuple[Quantity, float | None], ...]
    definitions: tuple[Definition, ...]


def moved(compiled: Compiled) -> Moved | None:
    """Return the quantities of motion, with their values at the pose of the figure."""
    if compiled.motion is None:
        return None
    quantities = compiled.motion.quantities
    chain = Chain(dict(compiled.motion.definitions))
    needed = chain.needed_by(_names(quantities))
    known = compiled.figure.values if compiled.figure else {}
    values = Chain({**dict(chain.definitions), **{q.name: q.formula for q in quantities}})
    found = values.complete(known)
    definitions = tuple(Definition(*d) for d in chain.definitions if d[0] in needed)
    return Moved(tuple((q, found.get(q.name)) for q in quantities), definitions)


def _names(quantities: Sequence[Quantity]) -> frozenset[str]:
    return frozenset[str]().union(*(symbols(q.formula) for q in quantities))


QUANTITY: Kind[tuple[Quantity, float | None]] = record(
    "motion_quantity",
    "A coordinate of a point, the direction of a link, or how it changes with the drive.",
    member("name", "In the code.", TEXT, lambda q: q[0].name),
    member("kind", "What it is.", one_of(*get_args(Motion)), lambda q: q[0].kind),
    member("of", "The point, or the link.", TEXT, lambda q: q[0].of),
    member("axis", "Of a point, else empty.", one_of("x", "y", ""), lambda q: q[0].axis),
    member("about", "In words.", TEXT, lambda q: quantity_words(q[0])),
    member("unit", "SI, or empty.", TEXT, lambda q: si_unit(q[0].dimension)),
    member("formula", "What it is equal to.", FORMULA, lambda q: q[0].formula),
    member("value", "At the figure's pose, SI; null where there is none.", FLOAT, lambda q: q[1]),
)

MOVED: Kind[Moved] = record(
    "points",
    "Where points are and how links point, along the drive.",
    member("quantities", "Each by itself.", list_of(QUANTITY), lambda m: m.quantities),
    member("definitions", "In order.", list_of(DEFINITION), lambda m: m.definitions),
)
