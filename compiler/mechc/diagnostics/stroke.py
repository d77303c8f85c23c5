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
