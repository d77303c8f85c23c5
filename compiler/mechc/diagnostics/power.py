"""Words of the power stage: loads that do no work, ratios that are not determined."""

from collections.abc import Collection, Sequence

from ..source import Span
from .diagnostic import Message, coded
from .syntax import listed


@coded("E501")
def load_not_balanced(at: Span, load: str, by: str, held: str = "", at_rest: str = "") -> Message:
    """A load does work and nothing is there to balance it.

    The force that was to hold it stands perpendicular to the motion of its point, or on a
    point that does not move, so no value of it, however large, keeps equilibrium::

        slider K along x
        force P at K along y    # wrong: K moves along x

    Turn the force, or put it where the mechanism moves. What only holds a drive that is held
    does no work either: name that drive first.
    """
    if held:
        return Message(
            at,
            f"nothing balances {load}: {by} does no work while {held} is held at its value",
            f"leave the drives out, and all move; or put the one that {by} moves first",
        )
    return Message(
        at,
        f"nothing balances {load}: {by} does no work in any motion of the mechanism",
        f"{at_rest}: put {by} where the mechanism moves, or correct what holds it"
        if at_rest
        else f"check the direction of {by} and the point it acts on",
    )


@coded("E502")
def ratio_not_determined(
    at: Span, above: str, below: str, others: Sequence[str], weights: Collection[str] = ()
) -> Message:
    """A ratio of two loads is asked for while other loads do work too.

    P/F is a number of the mechanism only where P and F alone do work (or others are tied
    to them). With more loads P is a linear form of all of them::

        find k = P / F       # wrong while a weight W does work as well
        find P               # right: P = … F + … W
    """
    free = next((name for name in others if name not in weights), "")
    return Message(
        at,
        f"{above}/{below} is not determined: {', '.join(others)} does work too",
        f"write `find {above}`, which gives {above} as a sum over all other loads"
        + (f", or tie {free} to {above} or {below}" if free else ""),
    )


@coded("E503")
def unknown_loads_do_not_match(
    at: Span, unknown: Sequence[str], motions: int, loose: str
) -> Message:
    """The number of loads asked for differs from the number of independent motions.

    A mechanism of mobility m has m power equations, so exactly m loads follow from the
    others: write one `find` for each of them. Where less mobility was meant, a link or a
    joint is missing; the hint names a part that hangs loose, if there is one.
    """
    named = ", ".join(unknown)
    number = "1 load is" if len(unknown) == 1 else f"{len(unknown)} loads are"
    return Message(
        at,
        f"{motions} independent motions give {motions} power equations, "
        f"but {number} asked for: {named}",
        f"write `find` for exactly {motions} loads, or "
        + (loose or "add the constraint that ties the motions"),
    )


@coded("E504")
def speeds_independent(at: Span, what: str) -> Message:
    """A ratio of two speeds is asked for that the constraints leave open.

    With more than one independent motion two speeds need not be related.
    """
    return Message(
        at,
        f"{what} is not determined: the two can move independently of one another",
        "ask for speeds of one motion, or add the constraint that ties them",
    )


@coded("E505")
def speed_vanishes(at: Span, what: str) -> Message:
    """A ratio is asked for whose denominator never moves."""
    message = f"{what} is at rest in every motion, so nothing can be divided by it"
    return Message(at, message, "name a point or a link that moves behind the '/'")


@coded("E506")
def length_not_given(at: Span, result: str, points: Sequence[str]) -> Message:
    """A result depends on a length that the description leaves open.

    A rod needs only its direction (``BK = @ beta``) because its length cancels. Here one
    does not::

        OA = @ alpha         # wrong: k is proportional to the arm OA
        OA = a @ alpha       # right
    """
    named = ", ".join(points)
    return Message(
        at,
        f"{result} depends on the length of {named}, which is not given",
        f"give it: `{points[0]} = l_{points[0]} @ …` with `param l_{points[0]}: length`",
    )


@coded("E507")
def pole_at_default(at: Span, result: str, factor: str) -> Message:
    """A result is infinite at the pose that the parameters' values describe.

    The mechanism is in a dead centre there: the drive is locked while the output could
    move, or a load stands perpendicular to the motion it should balance. k as a formula
    would still be right elsewhere, but every number at the default pose would not.
    """
    reason = f": {factor} = 0" if factor else ""
    return Message(
        at,
        f"{result} is infinite at the default pose{reason}",
        "move the default values away from the dead centre",
    )


@coded("E508")
def branch_point(at: Span, links: Sequence[str]) -> Message:
    """At the default pose the constraints lose their independence: a branch point.

    The mechanism could go on in more than one way (a parallelogram laid flat, for
    example), so the velocities are not determined there.
    """
    named = ", ".join(links)
    return Message(
        at,
        f"the default pose is a branch point: the motion of {named} is not determined there",
        "choose other default values; links that lie in one line are the usual cause",
    )


@coded("E544")
def nothing_balances(at: Span, loads: Sequence[str], tied: Sequence[str]) -> Message:
    """The loads that do work are in equilibrium only where all of them are zero.

    A lever with one load turns: another load is missing, or what holds the lever. Of two that are
    tied the tie is too much, as their ratio follows from the mechanism::

        force P at A along y
        find R_O                        # wrong: with P alone R_O is that of P = 0
        force F = 2*P at B along -y
        find k = P/F                    # wrong: the arms say what k is
    """
    if tied:
        return Message(
            at,
            f"{listed(loads, 'and')} balance only where they are zero: nothing else does work",
            f"leave out the tie of {tied[0]}: their ratio follows from the mechanism",
        )
    return Message(
        at,
        f"nothing balances {listed(loads, 'and')}: in equilibrium there is no such load",
        "name the load that balances it, or hold what it moves",
    )


@coded("E546")
def balanced_but_for_rounding(at: Span, loads: Sequence[str]) -> Message:
    """Tied loads balance whatever they are, but for the rounding of drawn coordinates.

    Nothing follows from them, and what rounding leaves of their power is no equation::

        A at (-100 mm, 0 mm)
        B at (60 mm, 10 mm)
        force P at A along -y
        force F = 5/3*P at B along -y
        find R_O                       # wrong; right with OA = 100 mm @ 180 deg and so on
    """
    return Message(
        at,
        f"{listed(loads, 'and')} balance whatever they are, but for the rounding of coordinates",
        "give the places by lengths and angles, or leave out the tie",
    )


@coded("E545")
def tied_with_friction(at: Span, result: str, tied: str) -> Message:
    """A ratio of two loads is asked for that are tied to each other, and there is friction.

    The tie says what their ratio is, whatever resists the motion::

        force P at A along y
        force F = 2*P at B along -y
        friction pins 0.1 diameter 10 mm
        find k = P/F                       # wrong: 1/2, with friction or without it
    """
    return Message(
        at,
        f"friction has no part in {result}, which the tie of {tied} gives",
        f"leave out the tie of {tied}, or the friction",
    )


@coded("E543")
def loads_stand_still(at: Span) -> Message:
    """At the default pose the mechanism can move only so that no load does work.

    What is asked for is 0/0 there: any load is balanced by the joints alone, so equilibrium leaves
    them open. Such poses come with right angles::

        slider A along y
        slider B along x
        AB = @ 90 deg       # the rod holds A, whatever pushes it, and lets B slide
        AB = @ 89 deg       # right: both move

    The formulas hold beside the pose, where they go on without a break.
    """
    message = "no load does any work at the default pose, so nothing determines one by another"
    return Message(at, message, "move the default values; right angles are the usual cause")


@coded("W501")
def load_does_no_work(at: Span, load: str, held: str = "", at_rest: str = "") -> Message:
    """A load does no work in any motion: it stands on a fixed point or across the motion.

    Such a load changes reactions, not k. If that was not meant, check the point and the
    direction. What only holds a drive that is held does no work while another one moves.
    """
    if held:
        return Message(
            at,
            f"{load} does no work while {held} is held at its value",
            f"leave the drives out to find what {load} has to be, or put its drive first",
        )
    message = f"{load} does no work in any motion of the mechanism, so it has no influence"
    check = f"{at_rest}: check where it acts" if at_rest else "check its point and its direction"
    return Message(at, message, f"{check}, or leave it out")


@coded("W502")
def result_negative(at: Span, result: str, hint: str) -> Message:
    """A force ratio is negative: the loads as directed can't balance.

    k is the ratio for which the loads, acting as their arrows say, are in equilibrium. A
    negative one means that one arrow points the other way.

    Nothing is said where no arrow is wrong: a torque is positive counter-clockwise, an
    actuator where it pushes its points apart, and a ratio with one of them is negative where
    it acts clockwise or pulls; a ratio that is positive on a part of the stroke changes its
    sign. Of several ratios with the same load the first is spoken of.
    """
    message = f"{result} is negative at the default pose: the arrows do not balance as drawn"
    return Message(at, message, hint)


def turn_round(forces: Sequence[str], touching: bool) -> str:
    """Return the hint at a force that points the wrong way, or at one of several.

    Where bodies touch, only one of two forces presses them together when it is turned.
    """
    if not forces:
        return "both weights act downwards, on the same side"
    so_that = ", so that bodies that touch push" if touching and len(forces) > 1 else ""
    return f"turn {listed(forces, 'or')} round (add 180 deg to its direction){so_that}"


@coded("W505")
def drive_is_back_driven(at: Span, result: str, drive: str, forces: Sequence[str]) -> Message:
    """A ratio with friction is negative, so that the drive acts against its own motion.

    With friction the drive moves along its arrow: a torque counter-clockwise, an actuator
    apart. A torque that has to act clockwise, an actuator that has to pull, or a force whose
    arrow points the wrong way is negative, and in that motion the load drives. The ratio with
    friction is then the smaller one, which holds the load back, and k_hold is the larger one,
    which moves it::

        torque M on OA               # it turns the handle clockwise: k = M/F is negative
        friction pins 0.1 diameter 10 mm
        find k = M/F                 # warned of
        motion releasing             # right: M moves against its arrow, clockwise

    Where the arrow of one of the ``forces`` is wrong, turning it makes the ratio positive.
    """
    message = (
        f"{result} is negative at the default pose: with friction {drive} is back-driven, as it "
        "moves along its arrow"
    )
    ways = [] if drive in forces else ["write 'motion releasing'"]
    if forces:
        what = "it" if drive in forces else forces[0]
        ways.append(f"turn {what} round (add 180 deg to its direction)")
    return Message(at, message, f"where {drive} is to drive, {' or '.join(ways)}")


@coded("W503")
def result_zero(at: Span, result: str, idle: str = "") -> Message:
    """A result is zero at the default pose: the output stands still, or the load is across.

    That of a load which does no work in any motion is zero in every pose.
    """
    if idle:
        hint = f"if that was not meant, check the point and the direction of {idle}"
        return Message(at, f"{result} is zero in every pose: {idle} does no work", hint)
    hint = "if that was not meant, check points and directions of the loads, or move the pose"
    return Message(at, f"{result} is zero at the default pose", hint)


@coded("W504")
def idle_freedom(at: Span, what: Sequence[str]) -> Message:
    """Something can move without moving any load.

    A rod that may spin about its own line, a link that hangs free: k is not changed by
    it, but it may show a constraint that was forgotten.
    """
    message = f"{listed(what, 'and')} can move without moving any load"
    return Message(at, message, "is a constraint missing?")


@coded("E831")
def too_many_lets(span: Span, name: str, number: int) -> Message:
    """So many formulas rest on one another that no report or code could show them.

    Every result stands with all that it rests on, so that a chain of a thousand lets
    stands for half a million definitions. Such descriptions come from a program: let it
    write the sum that it means.
    """
    return Message(span, f"'{name}' rests on {number} other formulas", "write fewer, longer ones")
