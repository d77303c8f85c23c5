"""Words for strokes (E59x)."""

from collections.abc import Iterable

from ..source import Span
from .diagnostic import Words, coded


@coded("E591")
def no_drive(span: Span, free: Iterable[str]) -> Words:
    """A stroke was asked for, and the description names no driving coordinate.

    ::

        param phi = 30 deg
        drive phi from 10 deg to 80 deg
    """
    names = ", ".join(free)
    return Words(
        span,
        f"no driving coordinate is named, expected one of {names}" if names else "nothing drives",
        "add a line such as `drive phi from 10 deg to 80 deg`",
    )


@coded("E592")
def no_stroke(span: Span, name: str) -> Words:
    """The driving coordinate has neither a stroke nor a range.

    ::

        drive phi                          # wrong, unless phi has a range
        drive phi from 10 deg to 80 deg    # right
    """
    return Words(
        span,
        f"the stroke of {name} has no ends, expected two",
        f"write `drive {name} from … to …`, or give {name} a range",
    )


@coded("W591")
def direction_stays(span: Span, link: str, drive: str) -> Words:
    """A link does not turn along the stroke as the joints make it turn.

    A direction that is given as an angle of its own stays where it is while the drive
    moves, and so the rows of the stroke are those of another mechanism::

        drive phi from 10 deg to 80 deg
        OA = a @ phi
        gear O r, Q R
        QB = b @ psi                         # wrong for a psi that stands still
        param psi = 40 deg - r/R*phi         # right: QB turns as the gears do

    Where rods lead the link, give their lengths and leave its direction out: mechc closes
    the loop.
    """
    return Words(
        span,
        f"link {link} does not follow {drive} along the stroke as its joints demand",
        f"leave its direction to a loop, or write it as a formula of {drive}",
    )
