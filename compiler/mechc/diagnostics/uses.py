"""Messages about sheets and mechanisms that are used (E555 to E568, W518)."""

from collections.abc import Collection

from ..source import Span
from ..units import Dimension, described
from .diagnostic import Message, Related, coded, near_miss
from .model.quantities import lost_factor


@coded("E555")
def used_in_a_circle(span: Span, name: str) -> Message:
    """A sheet uses itself, or one that uses it::

    use "b.mech" as b                          # in a.mech
    use "a.mech" as a                          # in b.mech

    Put what both need into a third sheet.
    """
    message = f"{name!r} uses itself, by way of this line"
    return Message(span, message, "put what both need into a sheet of its own")


@coded("E557")
def no_such_parameter(
    span: Span, name: str, used: str, known: Collection[str], heading: Span
) -> Message:
    """What is given to a used sheet is not among its parameters::

    use cylinder as cyl (F = 2 kN)             # wrong: F is a result
    use cylinder as cyl (P = 2 kN)             # right

    Its formulas are results: they come in under the prefix, and nothing is given to them.
    """
    there = f"it has {', '.join(known)}" if known else "it has none"
    related = (Related(heading, "this is what is used"),)
    message = f"{used} has no parameter {name!r}"
    return Message(span, message, near_miss(name, known) or there, related)


@coded("E558")
def given_twice(span: Span, name: str, before: Span) -> Message:
    """A parameter of a used sheet is given two values::

    use cylinder as cyl (P = 2 kN, P = 3 kN)   # which one?
    """
    related = (Related(before, "it is given here"),)
    return Message(span, f"{name!r} is given twice", "take one of them out", related)


@coded("E559")
def given_another_kind(
    span: Span, name: str, found: Dimension, wanted: Dimension, declared: Span
) -> Message:
    """What is given to a parameter of a used sheet measures something else than it does::

    use cylinder as cyl (P = 2 mm)             # wrong: P is a force
    use cylinder as cyl (P = 2 kN)             # right
    """
    message = f"{name} is {described(wanted)}, and {described(found)} is given to it"
    related = (Related(declared, "the parameter is declared here"),)
    return Message(span, message, lost_factor(found, wanted), related)


@coded("E560")
def outside_used_range(
    span: Span, left: str, operator: str, right: str, declared: Span | None
) -> Message:
    """What is given to a parameter of a used sheet lies outside the range that it may run over.

    Beyond its range a sheet says nothing: its formulas may not hold there::

        param P = 2 kN in 0 N .. 30 kN             # in the sheet that is used
        use cylinder as cyl (P = 40 kN)            # wrong
    """
    side = "at least" if operator == ">=" else "at most"
    related = (Related(declared, "its range is given here"),) if declared else ()
    return Message(span, f"{left}, expected {side} {right}", "change what is given", related)


@coded("E561")
def prefix_clashes(span: Span, name: str, other: Span) -> Message:
    """A name that a used sheet brings in is there already.

    The names of a used sheet come in behind the prefix: of ``use pin_joint as pin`` its ``d`` is
    ``pin_d`` here. Two uses have two prefixes, and no name of your own may be one of these::

        param pin_d = 5 mm
        use pin_joint as pin                       # wrong: its d would be pin_d, too
        use pin_joint as bolt                      # right
    """
    related = (Related(other, "it stands here"),)
    message = f"what is used here would bring in {name!r}, which is there already"
    return Message(span, message, "choose another prefix", related)


@coded("E562")
def too_much_used(span: Span, most: int) -> Message:
    """A sheet uses more sheets than anybody reads, counted with those that they use themselves.

    At most 64 are put in, a text of 1 MB in all, and 16 that use one another in a row.
    """
    message = f"too much is used, expected {most} sheets at most, 16 in a row"
    return Message(span, message, "compile a part of them by itself")


@coded("E564")
def result_without_value(span: Span, name: str, asked: Span, loop: str = "") -> Message:
    """A result of a used mechanism has no value at what is given to that.

    A loop does not close there (the message names it), the mechanism stands at a dead centre,
    friction locks it, or a condition of it fails. ``mechc check FILE -D NAME=VALUE`` says which::

        use crank_rocker as R (phi = 200 deg)           # does it close there?
    """
    said = f": no closure of loop {loop} is found there" if loop else ""
    message = f"{name} has no value at what is given to the mechanism{said}"
    related = (Related(asked, "it is asked for here"),)
    hint = "change what is given" if loop else "change what is given, or check it by itself"
    return Message(span, message, hint, related)


@coded("W518")
def result_at_rest(span: Span, name: str, asked: Span) -> Message:
    """A result with friction is taken from a mechanism in whose pose a joint does not slide.

    Which way its friction acts is undetermined there, and a formula has none. The mechanism by
    itself states what the result comes to on both sides, or that it jumps; a sheet has that side
    whose pose it gives::

        use slotted_lever as S (phi = 90 deg)      # warned of: the slot turns back there
        use slotted_lever as S (phi = 89.99 deg)   # the limit on one side
    """
    message = f"{name} is without the friction of a joint that does not slide at this pose"
    related = (Related(asked, "it is asked for here"),)
    return Message(span, message, "give the mechanism a pose beside it", related)


@coded("E565")
def given_both_loads(span: Span, above: str, below: str, before: Span) -> Message:
    """Both loads of a ratio are given to a used mechanism, of which one follows from the other.

    Of a mechanism with ``find k = P/F`` one of both loads is given, the other one is a result::

        use packet_clamp as C (F = 2 kN, P = 100 N)     # wrong
        use packet_clamp as C (F = 2 kN)                # right: C_P is k*F
    """
    related = (Related(before, "it is given here"),)
    message = f"{below} and {above} are given, of which one follows from the other"
    return Message(span, message, "give one of them", related)


@coded("E566")
def mechanism_in_a_mechanism(span: Span, heading: Span) -> Message:
    """A mechanism uses another one, or a sheet that does; mechanisms use plain sheets only.

    Joined at a point, the other one becomes a part of this one, and both move as one::

        use toggle_clamp as T joining T.H = B

    Or put both mechanisms into a sheet, which hands the force of one on to the other::

        sheet press
        use toggle_clamp as first (F = 2 kN)
        use "lever.mech" as second (F = first_P)
    """
    related = (Related(heading, "this is what is used"),)
    message = "a mechanism that is used here has no part in this one, expected a joint"
    return Message(span, message, "join it: joining T.C = B; or use both in a sheet", related)


@coded("E567")
def range_of_results(span: Span, name: str, declared: Span | None) -> Message:
    """What a mechanism gives to a sheet rests on loads or results, and has a range to keep to.

    In a mechanism the conditions of use are those of its dimensions and its pose. A sheet that
    uses the mechanism may check its forces::

        sheet strength
        use toggle_clamp as clamp (F = 2 kN)
        use cylinder as cyl (P = clamp_P)
    """
    related = (Related(declared, "its range is given here"),) if declared else ()
    message = f"{name} has a range, which loads and results cannot be held to in a mechanism"
    return Message(span, message, "use the mechanism and the sheet in a sheet", related)


@coded("E568")
def prefix_makes_quantities(span: Span, prefix: str, name: str, meaning: str) -> Message:
    """Behind this prefix a used name would mean a quantity of a mechanism.

    ``V_P`` is the velocity of a point P, ``R_O`` the force on a pin, ``N_AB``, ``phi_AB``,
    ``len_AB`` and ``omega_AB`` are such names, too::

        use clamp as V (F = 2 kN)          # wrong: its P would be V_P
        use clamp as vise (F = 2 kN)       # right
    """
    message = f"the prefix {prefix!r} makes {name!r}, which means {meaning}"
    return Message(span, message, "choose another prefix")
