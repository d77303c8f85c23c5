"""Messages for collars, and for the thrust that presses them (E41x)."""

from collections.abc import Sequence

from ...source import Span
from ..diagnostic import Message, coded
from ..syntax import listed


@coded("E410")
def collar_without_size(span: Span, twice: bool) -> Message:
    """A collar has one size: its mean diameter, or its outer and its inner one.

    friction collar A 0.1 mean 30 mm
    friction collar A 0.1 outer 40 mm inner 20 mm              # worn in: the same as mean 30 mm
    friction collar A 0.1 outer 40 mm inner 20 mm pressure     # new: pressed evenly
    """
    found = "two sizes, one of them is expected" if twice else "no size"
    return Message(span, f"the collar has {found}", "write 'mean d', or 'outer D inner d'")


@coded("E411")
def collar_inside_out(span: Span, outer: float, inner: float) -> Message:
    """The inner diameter of a collar is not below its outer one.

    friction collar A 0.1 outer 20 mm inner 40 mm     # wrong
    friction collar A 0.1 outer 40 mm inner 20 mm     # right
    """
    message = f"the collar is {outer * 1000:g} mm wide outside and {inner * 1000:g} mm inside"
    return Message(span, message, "the outer diameter is the larger one")


@coded("E412")
def collar_without_thrust(span: Span, point: str) -> Message:
    """A collar on a pivot is pressed by a force along the pivot's axis, which must be given.

    A screw presses its collar by itself. On a pivot a thrust bearing, the disc of a clutch or
    of a brake has a force that is not in the plane: a number, or a multiple of a load.

        friction collar O 0.3 outer 200 mm inner 120 mm                       # wrong
        friction collar O 0.3 outer 200 mm inner 120 mm thrust 2 kN           # right
        friction collar O 0.3 outer 200 mm inner 120 mm thrust 4*F faces 2    # right
    """
    message = f"nothing presses the collar on pivot {point}, expected a force along its axis"
    return Message(span, message, "add 'thrust …'")


@coded("E413")
def collar_of_which_link(span: Span, point: str, there: Sequence[str]) -> Message:
    """Several links turn on a pivot, and a collar is fast in one of them.

    friction collar O 0.3 mean 80 mm thrust W          # wrong where OA and OB turn on O
    friction collar O 0.3 mean 80 mm thrust W on OA    # right
    """
    if not there:
        message = f"no link turns on pivot {point}, so that its collar has no friction"
        return Message(span, message, f"add the link that turns on {point}")
    message = f"{listed(there, 'and')} turn on pivot {point}, one of them is expected"
    return Message(span, message, f"add 'on {there[0]}'")


@coded("E414")
def thrust_of_several(span: Span, loads: Sequence[str]) -> Message:
    """The thrust of a collar is no multiple of one load.

    thrust F + 200 N     # wrong
    thrust 3*F           # right
    thrust 200 N         # right
    """
    message = f"the thrust is no multiple of one load ({', '.join(loads)} in it)"
    return Message(span, message, "write a number times one load, or a given force")


@coded("E415")
def thrust_of_a_screw(span: Span, point: str) -> Message:
    """A thrust is given for the collar of a screw, which takes the thrust of the screw itself.

    friction collar A 0.1 mean 30 mm thrust 2 kN     # wrong where A is the slider of a screw
    friction collar A 0.1 mean 30 mm                 # right
    """
    message = f"the collar of the screw at {point} takes the screw's own thrust"
    return Message(span, message, "leave 'thrust …' out, or name a pivot")
