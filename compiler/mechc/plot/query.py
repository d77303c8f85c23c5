"""What is to be plotted, as a person writes it."""

from typing import Literal

from ..frozen import frozen
from ..named import NamedTuple

POINTS = 101
"""How many rows the table has where nothing else is asked for."""

Given = str | float


Sign = Literal["<=", ">="]
SIGNS: tuple[Sign, ...] = ("<=", ">=")


class Condition(NamedTuple):
    """What holds in a zone."""

    name: str
    sign: Sign
    bound: str


def condition(text: str) -> Condition:
    """Return a condition that is written as text; ValueError where it is none.

    >>> condition("gamma >= 1.5 rad")
    Condition(name='gamma', sign='>=', bound='1.5 rad')
    """
    for sign in SIGNS:
        name, found, bound = (part.strip() for part in text.partition(sign))
        if name and found and bound:
            return Condition(name, sign, bound)
    raise ValueError(f"{text!r} is not NAME >= VALUE, as in 'gamma >= 1.5 rad'")


@frozen
class Query:
    """Results ``ys`` against ``x``, once for each setting of the ``family``.

    Values are in SI and radians, or texts with their units. Without ``x`` the drive varies,
    without ``ys`` the first result is shown; ``paths`` are points whose paths are shown instead,
    ``ends`` a range other than that of the description. The
    ``zone`` in which conditions hold is marked.
    """

    x: str = ""
    ys: tuple[str, ...] = ()
    family: tuple[tuple[str, tuple[Given, ...]], ...] = ()
    ends: tuple[Given, Given] | None = None
    paths: tuple[str, ...] = ()
    zone: tuple[Condition, ...] = ()
    points: int = POINTS
