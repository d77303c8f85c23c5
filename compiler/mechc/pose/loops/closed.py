"""What closing the loops finds."""

from collections.abc import Mapping

from ...algebra.product import Product
from ...model.mechanism import Assembly, Mechanism
from ...named import NamedTuple
from ..pose import ClosedLoop, Limit, SolvedLoop


class OpenUnknowns(NamedTuple):
    """What loops leave open: all their unknowns, and how many of these they do not determine."""

    unknown: frozenset[str]
    missing: int


ALL_CLOSED = OpenUnknowns(frozenset(), 0)
"""No loop is left."""


class Closed(NamedTuple):
    """The mechanism with the parameters that were found made dependent, and the names found.

    ``rates`` are the derivatives by the drive of all that moves with it; ``limits`` are where
    the closures of the loops meet, ``loops`` those that may fail to close. ``left`` are the
    unknowns of the loops that did not close, ``idle`` the lines that decided nothing. Lengths
    that are ``put_in`` are no longer mentioned by vectors.
    """

    mechanism: Mechanism
    found: frozenset[str]
    rates: Mapping[str, Product]
    limits: tuple[Limit, ...]
    loops: tuple[ClosedLoop, ...]
    left: OpenUnknowns
    idle: tuple[Assembly, ...]
    put_in: frozenset[str] = frozenset()
    solved: tuple[SolvedLoop, ...] = ()
