"""The steps by which friction is put into a result, as a derivation shows them."""

from typing import Literal

from ..formula.tree import Formula
from ..frozen import frozen
from ..model.result import Definition

Kind = Literal[
    "crossed",
    "outer",
    "parallel",
    "single",
    "face",
    "lever",
    "slider",
    "pin",
    "straight",
    "efficiency",
    "first order",
    "iterated",
]
"""What a step is: the tangent that a rod's force takes, a body in balance, a way to sum up."""


@frozen
class Step:
    """A rod's line of force, a body in balance, or what all frictions add together.

    ``body`` is a link or a point, ``pivot`` the point that a lever turns on. ``sense`` is 1
    for a rod that is pressed or a lever that turns counter-clockwise, -1 for the opposite.
    ``equations`` are pairs that are equal, ``defined`` what gets a name by it.
    """

    kind: Kind
    body: str = ""
    pivot: str = ""
    sense: int = 0
    equations: tuple[tuple[Formula, Formula], ...] = ()
    defined: tuple[Definition, ...] = ()
