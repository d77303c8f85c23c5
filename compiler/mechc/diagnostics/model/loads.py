"""Messages for forces, torques and weights (E26x)."""

from ...source import Span
from ..diagnostic import Message, Related, coded


@coded("E260")
def tie_not_linear(span: Span, load: str, hint: str = "") -> Message:
    """A load is tied by a formula that is not proportional to one other load.

    A tied load goes with another one, as friction does with the force that presses, so
    its formula is linear in exactly one load and has no other part.

        force T = f*R at C along x          # right
        force T = f*R + 5 N at C along x    # wrong: a part without R
        force T = 5 N at C along x          # wrong: let T = 5 N gives a value
    """
    message = f"the formula of '{load}' is not proportional to exactly one other load"
    return Message(span, message, hint or f"a fixed value is written 'let {load} = …'")


@coded("E261")
def load_given_again(span: Span, load: str, first: Span) -> Message:
    """A load that has a value gets one by ``let`` as well.

    A tied load follows from another one, a weight from its mass, and a load that is asked
    for from the balance.

        force T = f*R at C along x
        let T = 5 N                    # wrong
    """
    related = (Related(first, "its value comes from here"),)
    return Message(span, f"load '{load}' is given twice", "remove one of the two", related)


@coded("E331")
def known_load_asked_for(span: Span, load: str, giver: str, first: Span) -> Message:
    """A weight whose mass is given, a load of a given intensity, or a spring, is asked for.

    It has its value already; balance gives that of another load::

        weight W mass 60 kg at G
        find W                      # wrong
        find P                      # right: what balances W
        find k = P/W                # right: their ratio

    Where balance is to give a force, let it be one: `force W at G along -y`.
    """
    related = (Related(first, "its value comes from here"),)
    hint = "ask for the load that balances it"
    hint += f", or let it be a force: `force {load} at … along -y`" if giver != "spring" else ""
    return Message(span, f"'{load}' is asked for, and its {giver} gives it", hint, related)


@coded("E262")
def times_not_positive(span: Span, found: str) -> Message:
    """The factor behind ``times`` is not positive.

    It counts how often a load acts (``1/2`` for one of two jaws). An arrow is turned by
    its direction.

        force F at A along x times -1     # wrong
        force F at A along -x             # right
    """
    return Message(
        span, f"'times' is a positive number, found {found}", "turn the direction instead"
    )


@coded("E263")
def off_the_mirror(span: Span, what: str, mirror: Span) -> Message:
    """A direction does not lie along the mirror line, but symmetry wants it to.

    Gravity acts on both halves alike only along the line; so does a force on a point
    that the halves share. Such a point can move along the line only, as a guide of it must, and
    where several are drawn, they are on one line along it.

        mirror across 90 deg sharing K
        slider K along 45 deg         # wrong
        slider K along 90 deg         # right
        force F at K along x          # wrong
        force F at K along 90 deg     # right
    """
    related = (Related(mirror, "the mirror line"),)
    return Message(
        span,
        f"{what} is not along the mirror line",
        "turn the mirror line, or describe both halves",
        related,
    )


@coded("E354")
def off_the_axis(span: Span, what: str, point: str, copies: Span) -> Message:
    """A direction does not lie along the axis of the copies, but equal branches want it to.

    Branches stand around the guide of the points that they share: gravity acts on all of them
    alike only along it, and so does a force on such a point.

        slider K along y
        copies 3 sharing K
        gravity along -x              # wrong: it opens one branch and closes another
        gravity along -y              # right
    """
    related = (Related(copies, "the copies"),)
    return Message(
        span,
        f"{what} is not along the axis of the copies, the guide of {point}",
        "turn it along the axis, or describe every branch",
        related,
    )


@coded("W353")
def on_the_line_twice(span: Span, load: str, point: str, sharing: str) -> Message:
    """A load acts on a point that slides on the mirror line and that the halves do not share.

    What is not shared is there twice, and so is the load on it: the hand at the end of one rope is
    two hands at two ropes, though one is seen::

        slider K along y through (0 mm, 0 mm)
        slider H along y through (0 mm, 100 mm)
        rope A, K along -y, H along y
        mirror across y sharing K       # warned of: 2P·V_H
        mirror across y sharing K, H    # right for one hand
    """
    message = f"{load} acts on {point}, which is on the mirror line, and each half has one"
    return Message(
        span,
        message,
        f"of one {point} write 'sharing {sharing}'; of two {load} is the load on each",
    )


@coded("E219")
def mirror_turns(span: Span) -> Message:
    """A mirror line has the direction of a vector between points, which turns as they move.

    The line stands still: the halves are mirrored across it in every pose::

        mirror across OK sharing K      # wrong
        mirror across 90 deg sharing K  # right
    """
    message = "the mirror line has the direction of a vector, expected an angle, x or y"
    return Message(span, message, "write the angle of the line: mirror across 90 deg sharing K")


@coded("W260")
def idle_gravity(span: Span) -> Message:
    """A direction of gravity is given, but nothing has a weight.

    gravity along -y                  # warned of without a line such as
    weight W mass m at G
    """
    message = "gravity acts on nothing: there is no 'weight'"
    return Message(span, message, "leave it out, or add a line such as 'weight W mass 2 kg at G'")


@coded("E296")
def pair_across_the_mirror(at: Span, first: str, second: str) -> Message:
    """A pair of forces joins a point of one half to the twin of another point.

    Across the mirror an actuator or a spring joins a point to its own twin, and then lies
    across the line::

        actuator P between A and A'    # right
        actuator P between A and B'    # wrong
    """
    return Message(
        at,
        f"a pair across the mirror joins a point to its own twin, found {first} and {second}",
        "write the point described first, and its twin second: `between A and A'`",
    )


@coded("E257")
def load_on_another_link(span: Span, point: str, link: str) -> Message:
    """A load is put on a link that has no such point.

    force F at P on NP along -y     # right where link NP has the point P
    force F at P on HE along -y     # wrong
    """
    message = f"link {link} has no point {point}, so it cannot carry the load there"
    return Message(
        span,
        message,
        f"name a link through {point}, or let {point} be a point of this one: `link {link}{point}`",
    )


@coded("E258")
def load_inside_telescope(span: Span, load: str, telescope: str) -> Message:
    """A pair of forces acts in a telescope, and names links that carry its ends.

    The force of a telescope is that at its piston, along it. Friction at its end pins bends
    it besides, and the pins press with both.

        telescope AB
        friction pins 0.1 diameter 20 mm
        actuator P between A on OA and B     # wrong
        actuator P between A and B           # right
    """
    message = f"{load} acts in the telescope {telescope}, which takes it at both ends"
    return Message(span, message, "leave the links out")
