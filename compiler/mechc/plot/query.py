"""What is to be plotted, as a person writes it."""

from ..frozen import frozen

POINTS = 101
"""How many rows the table has where nothing else is asked for."""

Given = str | float


@frozen
class Query:
    """Results ``ys`` against ``x``, once for each setting of the ``family``.

    Values are in SI and radians, or texts with their units. Without ``x`` the drive varies,
    without ``ys`` the first result is shown; ``paths`` are points whose paths are shown instead,
    ``ends`` a range other than that of the description.
    """

    x: str = ""
    ys: tuple[str, ...] = ()
    family: tuple[tuple[str, tuple[Given, ...]], ...] = ()
    ends: tuple[Given, Given] | None = None
    paths: tuple[str, ...] = ()
    points: int = POINTS
