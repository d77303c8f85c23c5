"""Where friction alone holds a mechanism, where it jams, and through what its efficiency runs.

Places are in SI and radians.
"""

from typing import Literal

from ..base.frozen import field, frozen
from ..base.named import NamedTuple
from ..formula.tree import Formula

DriveState = Literal["free", "locked", "jammed"]
"""``locked``: the load alone does not move it; ``jammed``: no force of the drive does."""

Range = tuple[float, float]

USUAL: Range = (0.9, 0.95)
"""The efficiency that textbooks assume of oiled joints (Karpenko: η = 0.9 … 0.95)."""

LIMITS = (0.0, *USUAL, 1.0)
"""The values between which it is said how an efficiency runs."""

SHARE_DIGITS, MOST_SHARE_DIGITS = 3, 6
"""Decimals of an efficiency; so many at most where fewer round it to a limit."""


def rounded_share(value: float) -> str:
    """Return an efficiency with few digits, more where these were a limit that it is not.

    >>> rounded_share(0.949789), rounded_share(0.95), rounded_share(0.9712), rounded_share(1.0)
    ('0.9498', '0.95', '0.971', '1')
    """
    rounded = [round(value, digits) for digits in range(SHARE_DIGITS, MOST_SHARE_DIGITS + 1)]
    apart = (share for share in rounded if share not in LIMITS)
    shown = f"{next(apart, rounded[0]) + 0.0:.{MOST_SHARE_DIGITS}f}"
    return shown.rstrip("0").rstrip(".")


class Bound(NamedTuple):
    """An end of a stretch, and the same as a formula where one is known.

    At a dead centre the stretch ends because the ratio changes its sign there. A bound is
    ``left_out`` where nothing is known of the end itself.
    """

    x: float
    exact: Formula | None = None
    is_dead_centre: bool = False
    left_out: bool = False

    @property
    def is_strict(self) -> bool:
        """Return whether the stretch reaches up to its end, but not to it."""
        return self.is_dead_centre or self.left_out


class LockingInterval(NamedTuple):
    """A part of a parameter's values on which a mechanism is locked, or jammed.

    Beyond the parameter's range, or without one, it ends at the next dead centre at the latest.
    """

    state: DriveState
    low: Bound | None
    """The lower end; None where the parameter's range begins without a change of the state."""

    high: Bound | None
    """The upper end; None where the range ends without a change of the state."""

    within: Range | None
    """The part of it that lies in the parameter's range."""

    sampled: bool = False
    """Whether it was found at one of many values and its ends narrowed down, not solved for."""


@frozen
class LockingIntervals:
    """All intervals of one parameter on which a mechanism is locked, or jammed.

    The other parameters have their default values.
    """

    parameter: str
    unit: str
    """The unit that was written; angles have none."""

    range: Range | None
    """The parameter's range, if it has one."""

    stretches: tuple[LockingInterval, ...] = field(on_demand=True)
    """The intervals; where it ``moves_in_range``, looked for when they are first read."""

    moves_in_range: bool = False
    """Whether it moves at every value of the range, and no formula gives an end beyond it."""

    @property
    def of_interest(self) -> tuple[LockingInterval, ...]:
        """Return the stretches among which are all that lie in the range, or are solved for."""
        return () if self.moves_in_range else self.stretches


@frozen
class Locking:
    """The state of a mechanism at the default pose, and how it changes with parameters.

    A dead centre has no state: a motion the other way comes to another one. ``drive`` and
    ``load`` are those of the ratio; no load stands for all of them.
    """

    state: DriveState | None
    drive: str
    load: str
    reaches: tuple[LockingIntervals, ...] = ()


@frozen
class EfficiencyRange:
    """The values of an efficiency over a parameter's range, 0 where nothing moves.

    It is found by sampling; the lowest and highest are refined. ``usual`` are the stretches
    on which it is in :data:`USUAL`, which says something of pins and guides alone:
    ``is_of_joints`` where any have friction.
    """

    parameter: str
    unit: str
    range: Range
    least: float
    greatest: float
    usual: tuple[Range, ...]
    is_of_joints: bool = True
