"""Messages for loads that are spread over a stretch of a link."""

from ...source import Span
from ..diagnostic import Message, coded


@coded("E239")
def stretch_without_length(at: Span, tail: str, head: str, start: str = "") -> Message:
    """A load is spread over a stretch whose length the description does not give.

    Its resultant is the intensity times that length, and acts at a point in between::

        load Q intensity q on OA along -y
        OA = 400 mm @ phi      # right
        OA = @ phi             # wrong

    Where both ends are in one direction from a third point, ``start``, it is the difference of
    their distances.
    """
    message = f"nothing gives the length of {tail}{head}, over which the load is spread"
    length, direction = "length", "direction"
    if start:
        length = f"(length of {start}{head}) - (length of {start}{tail})"
        direction = f"direction of {start}{head}"
    return Message(at, message, f"give it in one line: {tail}{head} = {length} @ {direction}")


@coded("E249")
def spread_along_rod(at: Span, link: str) -> Message:
    """A load is spread over a rod, so that the force along the rod is another at every place.

    ::

        load Q intensity q on AB along -y
        find N_AB      # wrong
        find R_A on AB # right: what the pin at A does to the rod
    """
    return Message(
        at,
        f"a load is spread over {link}, so that no one force is along it",
        f"ask for the force on one of its pins: R_A on {link}",
    )


@coded("E269")
def spread_without_resultant(at: Span, load: str) -> Message:
    """A spread load adds up to nothing: it is a couple, and has no point to act at.

    With q at one end and -q at the other it is a couple of q·l²/6::

        load Q intensity q to -q on AB along -y     # wrong
        torque M = ... on AB                        # right
    """
    return Message(
        at,
        f"the load {load} adds up to nothing, so that it has no resultant",
        "state it as a couple: torque M on the link",
    )
