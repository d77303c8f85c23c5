"""Words for friction in the balance of power (E510, E511, E513, E514)."""

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


@coded("E513")
def another_load_presses(span: Span, load: str, result: str) -> Words:
    """A ratio of two loads depends on a third one that presses a joint with friction.

    A load that does no work has no influence on k, but it presses guides and pins, and their
    friction does work. The ratio of the two others is no number then.

        weight W mass m at A          # on a horizontal guide
        friction slider A 0.1
        find k = P/F                  # wrong
        find P                        # right: P as a form of F and W
    """
    message = f"{load} presses a joint with friction, so {result} is no ratio of two loads alone"
    return Words(span, message, "ask for the driving load by itself, as in 'find P'")


@coded("E514")
def slips_either_way(span: Span, point: str) -> Words:
    """A joint with friction can slip without any load moving.

    A part that can be turned or shifted idly, such as a roller or a link without a load,
    moves as friction leads it, and which way that is follows from no load.
    """
    message = f"the joint at {point} can slip while no load moves, so nothing tells which way"
    return Words(span, message, "hold what moves idly, or give that joint no friction")
