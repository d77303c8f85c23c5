"""Which parameters say where things are and how they are joined."""

from collections.abc import Iterator, Mapping

from ..formula.tree import Formula
from ..formula.walk import symbols
from ..frozen import contents, fields
from .mechanism import Mechanism


def in_geometry(mechanism: Mechanism) -> frozenset[str]:
    """Return the parameters by which places, lengths, directions and joints are given.

    Those that these follow from are among them; what gives loads alone is not.
    """
    whole = (mechanism.geometry, mechanism.drawn, mechanism.joints, mechanism.slides)
    ways = [getattr(load, "along", None) for load in mechanism.loads]
    named = frozenset[str]().union(*_names((whole, ways, mechanism.mirror, mechanism.copies)))
    for parameter in reversed(mechanism.parameters):  # which follow from those before them
        if parameter.name in named and parameter.value:
            named |= symbols(parameter.value)
    return named


def _names(value: object) -> Iterator[frozenset[str]]:
    """Yield the names in the formulas that a value holds, whatever it is."""
    if isinstance(value, Formula):
        yield symbols(value)
    elif isinstance(value, Mapping):
        yield from _names(tuple(value.values()))
    elif isinstance(value, (tuple, list)):
        for part in value:
            yield from _names(part)
    elif fields(value):
        yield from _names(tuple(contents(value, value).values()))
