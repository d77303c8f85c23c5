"""Messages for friction in the balance of power (E419, W261, E510 … E514, E540, W511 … W541)."""

from collections.abc import Sequence

from ..source import Span
from .diagnostic import Message, coded


@coded("E510")
def several_degrees_of_freedom(span: Span, number: int) -> Message:
    """Friction is asked for in a mechanism of several degrees of freedom.

    Which way surfaces slip on one another follows from the motion, and a mechanism of two
    degrees of freedom can move in many ways.
    """
    message = (
        f"the mechanism has {number} degrees of freedom: which way its joints slip is undetermined"
    )
    return Message(span, message, "add a constraint, or leave friction out")


@coded("E511")
def loaded_how_much(span: Span, point: str) -> Message:
    """Equilibrium leaves open how hard a joint with friction is pressed.

    Where a mechanism is held more often than it needs (a redundant bar, two guides on one
    line) its joints may press against each other without any load.
    """
    message = f"equilibrium leaves open how hard the joint at {point} is pressed"
    return Message(span, message, "leave the redundant bar or guide out, or give it no friction")


@coded("W261")
def ranges_not_looked_at(span: Span, result: str) -> Message:
    """It takes too much work to look at a result with friction along the ranges given.

    Where friction locks or jams a mechanism, and how its efficiency changes, is found by solving
    it at many places of every range. For many bodies with friction and many ranges that is more
    than one compilation may do. The formula, its values and its code are as they would be; code
    tells at any pose by its status what locks. Give fewer ranges to have them looked at::

        param t1 = 60 deg in 50 deg .. 70 deg
        param t2 = 15 deg                       # no range: nothing is looked for along t2
    """
    message = f"{result} was not looked at along all ranges: that takes too much work"
    return Message(span, message, "leave out ranges of which nothing has to be known")


@coded("E513")
def another_load_presses(span: Span, load: str, result: str, drive: str) -> Message:
    """A ratio of two loads depends on a third one that presses a joint with friction.

    A load that does no work has no influence on k, but it presses guides and pins, and their
    friction does work. The ratio of the two others is no number then.

        weight W mass m at A          # on a horizontal guide
        friction slider A 0.1
        find k = P/F                  # wrong
        find P                        # right: P as a form of F and W
    """
    message = f"{load} presses a joint with friction, so {result} is no ratio of two loads alone"
    return Message(span, message, f"ask for the driving load by itself: 'find {drive}'")


@coded("E419")
def thrust_of_the_drive(span: Span, point: str, load: str) -> Message:
    """The load that is asked for presses a collar by itself.

    Its friction then grows with the load that overcomes it, so that no balance gives either.

        friction collar O 0.3 mean 80 mm thrust 2*P
        find P                                         # wrong
        find k = F/P                                   # right: P is given
    """
    message = f"the collar on {point} is pressed by {load}, which is the load that is asked for"
    return Message(span, message, "let a given load press it")


@coded("E514")
def slips_either_way(span: Span, point: str) -> Message:
    """A joint with friction can slip without any load moving.

    A part that can be turned or shifted idly, such as a roller or a link without a load,
    moves as friction leads it, and which way that is follows from no load.
    """
    message = f"the joint at {point} can slip while no load moves: which way is undetermined"
    return Message(span, message, "hold what moves idly, or give that joint no friction")


@coded("W511")
def efficiency_beside_friction(span: Span, given: float, found: Sequence[str]) -> Message:
    """A constant efficiency stands beside friction that makes another one.

    An efficiency overrides friction. It is no property of the joints: near a dead centre
    friction takes ever more. Where both are given they are compared, at the default pose
    and over the ranges, and a difference of more than 0.05 is remarked on::

        friction pins 0.1 diameter 10 mm
        efficiency 0.9          # wrong near the dead centre: leave it out
    """
    message = f"the efficiency is given as {given:.3g}, but friction makes it {', '.join(found)}"
    return Message(span, message, "leave the efficiency out, or narrow the ranges")


@coded("W512")
def efficiency_near_dead_centre(span: Span, name: str, where: Sequence[str]) -> Message:
    """A constant efficiency is used near a dead centre, where it is far from the truth.

    Friction in pins turns a rod's line of force by an angle δ, and the efficiency is about
    1/(1 + |d ln k/dφ|·δ). Pins of an eighth of a rod's length with f = 0.1 make δ = 0.0125;
    where |d ln k/dφ| is above 8 they take a tenth, and near a dead centre everything::

        param alpha = 10 deg in 1 deg .. 45 deg
        efficiency 0.9                            # wrong: near alpha = 1 deg it is about 0.5
        friction pins 0.1 diameter 10 mm          # right
    """
    message = f"near a dead centre of {name} no constant efficiency is true, {', '.join(where)}"
    hint = "give the joints friction, as in 'friction pins 0.1 diameter 10 mm', or narrow the range"
    return Message(span, message, hint)


@coded("W513")
def drive_jams(
    span: Span, name: str, drive: str, grips: bool, is_driven: bool = False, idle: str = ""
) -> Message:
    """Friction is so large at the default pose that no force of the drive moves anything.

    The drive's line of force passes the friction circle of a pivot, or stands within the
    angle of friction: friction grows faster than the drive. There is no balance, so the
    result has no value there, and the code gives NaN.

    Of a ratio P/F the drive is P. A screw that does not yield to its load jams where F/P is
    asked for, for then the load drives. Where it is the other load that moves the mechanism, the
    motion is against the arrow of the drive::

        motion releasing

    A band brake with both ends of its band on the lever grips by itself where the end that is
    tightened by friction opens the brake less than the other end closes it, times e^(μθ).

    A load that does no work in any motion, as one across its guide, is felt through friction
    alone: it presses on what slides. Perhaps its direction was meant to be another.
    """
    message = f"{name} has no value at the default pose: no force {drive} overcomes the friction"
    hint = "look at the friction, move the values from a dead centre, or let the other load drive"
    if is_driven:
        hint += ": add `motion releasing`"
    if idle:
        hint = f"{idle} does no work, and acts through friction alone: check its direction"
    if grips:
        hint = "the rope grips by itself: take a smaller wrap, or a shorter arm of its tight end"
    return Message(span, message, hint)


@coded("W517")
def no_slip_as_drawn(span: Span, joint: str, link: str = "") -> Message:
    """A joint with friction does not slide at the one pose that a description has.

    A pin in a slot turns back where the crank is square to it: for an instant it does not slide,
    and which way its friction acts is undetermined. As long as the pose is all that is known the
    joint has no friction in any result. Where something moves it, results are the limits from
    both sides of the pose, or are said to jump there::

        slot A in OE                        # warned of where CA and OE are in line
        friction contact A 0.3
        drive CA from 10 deg to 170 deg     # right: it slides on either side
    """
    message = f"{joint} at this pose, so that it has no friction"
    drive = f"say what moves: 'drive {link} from … to …'"
    way = drive if link else "give the pose by a parameter: an angle, or a length with a range"
    return Message(span, message, f"if it does on either side of it, {way}")


@coded("W540")
def load_on_a_pin(at: Span, load: str, point: str, link: str, links: Sequence[str]) -> Message:
    """A load acts at a pin with friction, and nobody says on which link.

    A load at a shared pin is taken to act on the pin, which is fast in one of the links. The
    friction of the pin is that of the others on it, and so depends on which link that is: a
    lever before a rod, then the link nearest to a pivot.

        force F at P along -y             # warned of where the pin at P has friction
        force F at P on NP along -y       # right
        spring c between O and P on NP    # right
    """
    named = [f"'{point} on {each}'" for each in dict.fromkeys((link, *links))]
    message = f"{load} acts on the pin at {point}, which is taken to be fast in {link}"
    return Message(at, message, f"say so: {', or '.join(named)}")


@coded("W541")
def pin_fast_in(at: Span, point: str, link: str, links: Sequence[str]) -> Message:
    """Three bodies meet at a pin with friction, and nobody says in which of them it is fast.

    The others turn on the pin, each with friction of its own: which link carries the pin
    makes a difference.

        friction pins 0.1 diameter 10 mm                  # warned of with links AB, BC and BD
        friction pin B 0.1 diameter 10 mm on AB           # right
    """
    others = ", ".join(other for other in links if other != link)
    message = f"the pin at {point} is taken to be fast in {link}; {others} turn on it"
    hint = f"say so: 'friction pin {point} … on {link}', or on another one"
    return Message(at, message, hint)
