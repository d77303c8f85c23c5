"""Messages for wheels, racks, screws and pulleys, and for the links that they are fixed to."""

import math
from collections.abc import Iterable, Sequence

from ...source import Span
from ..diagnostic import Message, coded, used_at
from ..syntax import listed


@coded("E266")
def joint_of_another(at: Span, point: str, link: str, moves: str) -> Message:
    """A wheel, or a block in a slot, is fixed to a link that does not have its point.

    ::

        link OS "sun"
        link OA "arm"
        link AB "planet"
        gear O r1 on AB, A r2        # wrong: AB does not reach O
        gear O r1 on OS, A r2        # right

        slot B in OC guiding AD      # wrong: AD does not have B
        slot B in OC guiding BD      # right: BD slides along OC and turns with it
    """
    return Message(
        at,
        f"{point} is no point of {link}, expected a link on {point}",
        f"name the link that {moves}",
    )


@coded("E267")
def no_arm(at: Span, first: str, second: str, turning: str = "") -> Message:
    """The centres of two wheels keep their distance: pivots, or points of one link, the arm.

    A wheel's own link is not the arm, since the wheel turns against it::

        link OA "arm"
        link OS "sun"
        link AB "planet"
        gear O r1 on OS, A r2          # right: OA carries both
        gear O r1 on OS, B r2          # wrong: no link carries O and B
        gear O r1 on OA, A r2          # wrong: OA is the arm, no wheel turns with it
    """
    return Message(
        at,
        f"no arm carries {first} and {second}, expected two pivots, or a link through both that is "
        "neither wheel",
        f"`on` names the link that turns with the wheel: write another one than {turning}"
        if turning
        else f"add the arm: `link {first}{second}`",
    )


@coded("E268")
def several_arms(at: Span, first: str, second: str, links: Iterable[str]) -> Message:
    """Two links carry the centres of the same wheels, which makes one body of them.

    ::

        link OA
        link OAB             # wrong beside OA
        gear O r1 on OS, A r2
    """
    return Message(
        at,
        f"{' and '.join(links)} carry both {first} and {second}, expected one arm",
        "make one link of them",
    )


@coded("E292")
def wheel_without_pivot(at: Span, what: str) -> Message:
    """A gear, a pulley or a screw turns about a pin on the ground.

    ::

        pivot O1
        link O1A
        gear O1 r1, O2 r2
    """
    return Message(
        at, f"{what} turns about no pivot, expected a pin on the ground", "add a `pivot` line"
    )


@coded("E293")
def wheel_of_several(at: Span, centre: str, links: Sequence[str], arm: str) -> Message:
    """A wheel is fixed to the one link on its centre; here there is none, or there are several.

    The arm that carries both wheels does not count. ``on`` says which link is meant::

        pivot O1
        link O1A             # the gear on O1 turns with it
        link O1B
        gear O1 r1, O2 r2            # wrong: with O1A or with O1B?
        gear O1 r1 on O1A, O2 r2     # right
        gear O1 r1 on ground, A r2   # right: a gear that stands still
    """
    named = ", ".join(links)
    count = f"carries {named}" if named else "carries no link"
    beside = f" beside the arm {arm}" if arm else ""
    return Message(
        at,
        f"point {centre} {count}{beside}, expected one link to which the wheel is fixed",
        f"say which turns with the wheel: `on {links[0]}`" if links else "add its `link` line",
    )


@coded("E294")
def radius_not_positive(at: Span, shown: str, cause: Span) -> Message:
    """A radius or a pitch is zero or negative. A rack's may be negative: it lies on the left."""
    text = f"expected a positive length, found {shown}"
    return Message(cause, text, "check the value", used_at(at, cause))


@coded("E295")
def rack_without_guide(at: Span, point: str) -> Message:
    """A rack or a screw moves a point along its guide, and this point has none.

    The point is a slider, or belongs to a ``slide``.

    ::

        slider A along x
        rack A on O r
    """
    return Message(
        at,
        f"point {point} is no slider, so it has no guide to move along",
        f"add `slider {point} along x`",
    )


@coded("E298")
def wheels_across_the_mirror(at: Span, first: str, second: str, are_twins: bool) -> Message:
    """A pair of wheels joins the two halves of a mirrored mechanism.

    The mirror by itself turns a link and its twin oppositely and equally fast, as equal
    gears or a crossed belt between them do, so such a pair adds nothing::

        gear O r, O' r                 # wrong: leave it out
        mirror across y sharing K

    Any other pair across the line needs both halves described.
    """
    left_out = "leave the pair out: the mirror turns a link and its twin oppositely already"
    return Message(
        at,
        f"the wheels on {first} and {second} join the halves of the mirror",
        left_out if are_twins else "describe both halves, without the mirror",
    )


@coded("E218")
def inner_of_one_radius(span: Span, first: str, second: str, radius: float) -> Message:
    """A ring has teeth inside, and the wheel that runs in it is smaller.

    Of one radius they would be one about the other, on one axis, and pass no motion on::

        gear O 40 mm, A 40 mm inner     # wrong
        gear O 40 mm, A 15 mm inner     # right
    """
    message = f"the ring and the wheel inside it, on {first} and {second}, have one radius"
    return Message(span, f"{message}, {radius * 1000:.7g} mm", "make one of them smaller")


@coded("E236")
def wheels_overlap(span: Span, pivots: str, apart: float, radii: float) -> Message:
    """The wheels of a belt stand where they overlap.

    A belt runs round both wheels in one plane, so that their pivots are no nearer than the sum
    of their radii::

        pivot O at (0, 0)
        pivot Q at (60 mm, 0)
        belt O 40 mm, Q 30 mm     # wrong: 70 mm
        belt O 20 mm, Q 30 mm     # right
    """
    message = f"the wheels on {pivots} are {apart * 1000:.7g} mm apart and overlap"
    hint = f"their radii make {radii * 1000:.7g} mm: are they diameters?"
    return Message(span, message, hint)


@coded("E416")
def pulley_of_rope(span: Span, point: str, times: int, axles: Sequence[str]) -> Message:
    """Friction of a rope is given where no rope, or more than one, runs over a pulley.

    rope A, B along y, H along -y
    friction rope A 0.2 wrap 180 deg     # wrong: the rope ends there
    friction rope B 0.2 wrap 180 deg     # right
    """
    if times:
        message = f"ropes run over pulleys on {point} {times} times, expected once"
        return Message(span, message, "give one of them an axle of another name at the same place")
    hint = f"lead a rope over it, from a point to another: rope A, {point} along y, H along -y"
    if axles:
        named = listed(dict.fromkeys(f"'friction rope {axle} …'" for axle in axles))
        hint = f"write {named}"
    return Message(span, f"no rope runs over a pulley on {point}", hint)


@coded("E417")
def wrap_unlike_falls(span: Span, point: str, turn: float, wrap: float) -> Message:
    """A rope turns by another angle than its wrap says, whole turns aside.

    The wrap is positive where the rope goes counter-clockwise around the pulley, on its way
    from the first point that its line names; on a pulley that is held, the sign is free.

        rope A, B along y, H along -y
        friction rope B 0.2 wrap 90 deg      # wrong: up and down again are 180 deg
        friction rope B 0.2 wrap 540 deg     # right: one turn more
    """
    shown = f"{math.degrees(wrap):.6g} deg"
    turned = math.degrees(turn) % 360
    message = f"the rope turns by {turned:.6g} deg at {point}, the wrap is {shown}"
    near = turned if turned <= 180 else turned - 360
    return Message(span, message, f"write 'wrap {near:.6g} deg', or whole turns more")


@coded("E418")
def drum_of_another(span: Span, point: str, link: str) -> Message:
    """A drum is fast in a link that does not turn about the drum's axle.

    rope A, O along x, B along -x
    friction rope O 0.3 wrap 180 deg drum 300 mm on CD     # wrong: CD has no point O
    """
    message = f"link {link} has no point {point}, so the drum cannot be fast in it"
    return Message(span, message, f"name the link that turns about {point} behind 'on'")


@coded("W208")
def screw_in_each_part(span: Span, point: str, link: str, load: str, number: int) -> Message:
    """A screw along the mirror line, or the axis of copies, is in each half, or branch.

    So is all that does not go through shared points only. Then there are several of them, and
    the torque on each is a part of what one screw takes that is alone on the line::

        mirror across x sharing A
        screw A pitch p on SE
        torque T on SE              # warned of: 2T·ω, T is the torque on one of two screws
        torque T on SE times 1/2    # right for one screw: T·ω

    A screw that has its place in its own half, ``pivot S at (0 mm, 50 mm)``, is one of two.
    """
    load = load or "T"
    return Message(
        span,
        f"the screw that moves the shared {point} is described {number} times, as {link} is: "
        f"{load} is the torque on each",
        f"of one screw it counts once: 'torque {load} on {link} times 1/{number}'",
    )


@coded("W209")
def wheel_on_the_line(span: Span, kind: str, pivot: str, link: str) -> Message:
    """A wheel on the mirror line is in both halves, and the two turn oppositely about one pivot.

    One wheel there turns one way: what it drives on one side goes with it, on the other side
    against it, and that is no mirror image::

        pivot S
        gear S r, O r
        mirror across y sharing S    # warned of: two wheels at S, one for each half
    """
    return Message(
        span,
        f"the {kind} has a wheel at {pivot}, on the mirror line, and both halves have one: the two "
        "turn oppositely",
        f"of one wheel at {pivot}, fast in {link}, describe both halves, without the mirror",
    )
