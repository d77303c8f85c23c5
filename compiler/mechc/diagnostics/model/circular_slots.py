"""Messages for circular slots."""

from ...source import Span
from ..diagnostic import Message, Related, coded


@coded("E237")
def centre_of_another(at: Span, point: str, body: str) -> Message:
    """The centre of a circular slot is a point of the link that has the slot.

    Name that link by any two or more of its points; the pin belongs to another one::

        link OAC
        link BD
        slot B in OAC about C radius 40 mm     # right
        slot B in OA about D radius 40 mm      # wrong
    """
    return Message(
        at,
        f"point {point} does not belong to {body}, which has the slot",
        f"name a point of {body} that is the centre of the circle",
    )


@coded("E238")
def radius_is_length(at: Span, points: str, slot: Span) -> Message:
    """The distance of a pin from the centre of its circular slot is the radius, given once.

    ::

        slot B in OAC about C radius 40 mm
        CB = 40 mm @ phi      # wrong
        CB = @ phi            # right
    """
    related = (Related(slot, "the slot"),)
    message = f"{points} has a length of its own, but the radius of a slot gives it"
    return Message(at, message, "give its direction alone, or nothing", related)


@coded("E299")
def normal_of_arc(at: Span, point: str, centre: str) -> Message:
    """The force of a circular slot on its pin acts along the line from the centre to the pin.

    It is asked for as that of a rod, which is positive where it pulls the pin to the centre::

        slot B in OAC about C radius 40 mm
        find N_CB      # right
        find N_B       # wrong
    """
    return Message(
        at,
        f"the slot of {point} is circular, its force acts along {centre}{point}",
        f"ask for N_{centre}{point}: positive towards {centre}",
    )
