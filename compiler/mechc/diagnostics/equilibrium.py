"""Messages for loads that sums of forces and moments are to give (E73x)."""

from ..source import Span
from .diagnostic import Message, coded


@coded("E730")
def no_equilibrium_by_hand(span: Span, load: str) -> Message:
    """A load that sums of forces and moments do not give step by step.

    ``--by equilibrium`` takes one sum after another, each with one force that is not known
    yet, or up to three together. Where bodies hang together more closely (two beams and two
    pans in a parallelogram), where a bar is redundant, or where a length that is not given
    would be needed, virtual power gives the load all the same: the derivation without
    ``--by equilibrium`` has it.
    """
    return Message(
        span,
        f"no three sums of forces and moments at a time lead to {load}: expected bodies whose"
        " forces follow one after another",
        "leave out --by equilibrium: virtual power finds it",
    )


@coded("E731")
def no_load_to_find(span: Span, name: str) -> Message:
    """Equilibrium was asked for where no load is: a ratio of velocities does not follow from it.

    Wrong: ``find V_D/V_A``
    Right: ``find k = P/F``
    """
    return Message(
        span,
        f"{name} asks for no load: expected one for equilibrium to give",
        "add `find k = P/F` with two loads of yours, or leave out --by equilibrium",
    )
