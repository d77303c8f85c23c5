"""Words for friction in the balance of power (E510, E511)."""

from ..source import Span
from .diagnostic import Words, coded


@coded("E510")
def several_freedoms(span: Span, number: int) -> Words:
    """Friction is asked for in a mechanism of several freedoms.

    Which way surfaces slip on one another follows from the motion, and a mechanism of two
    freedoms can move in many ways.
    """
    message = f"the mechanism has {number} freedoms, so nothing tells which way its joints slip"
    return Words(span, message, "add a constraint, or leave friction out")


@coded("E511")
def pressed_how_hard(span: Span, point: str) -> Words:
    """Equilibrium leaves open how hard a joint with friction is pressed.

    Where a mechanism is held more often than it needs (a redundant bar, two guides on one
    line) its joints may press against each other without any load.
    """
    message = f"equilibrium leaves open how hard the joint at {point} is pressed"
    return Words(span, message, "leave the redundant bar or guide out, or give it no friction")
