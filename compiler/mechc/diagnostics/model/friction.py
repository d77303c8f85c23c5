"""Messages for friction (E27x)."""

from collections.abc import Sequence
from fractions import Fraction

from ...source import Span
from ..diagnostic import Message, Related, coded
from ..syntax import listed


@coded("E270")
def nothing_turns(span: Span, point: str) -> Message:
    """Pin friction is given at a point where no two bodies turn on one another.

    A pin joins links with each other, with the ground or with a slider. The point of one
    link at which a load acts is no pin.

        link OA
        friction pin A 0.1 diameter 10 mm     # wrong: A is the free end of OA
        friction pin O 0.1 diameter 10 mm     # right
    """
    message = f"nothing turns on a pin at {point}: only one link is there"
    return Message(span, message, "name a pivot, a slider or a pin between links")


@coded("E271")
def pin_of_another(span: Span, point: str, link: str) -> Message:
    """The link that carries a pin has no such point.

    link AB
    link BC
    friction pin C 0.1 diameter 10 mm on AB     # wrong
    """
    message = f"link {link} has no point {point}, so the pin cannot be fast in it"
    return Message(span, message, f"name a link with {point} behind 'on'")


@coded("E272")
def not_guided(span: Span, point: str, in_slot: bool) -> Message:
    """Friction of a guide or a roller is given at a point that no guide of the ground holds.

    link AB
    friction slider A 0.1     # wrong without a line such as 'slider A along x'

    A roller in the slot of a link has the friction of a contact::

        slot D in EG
        friction roller D f1 axle d wheel D0     # wrong
        friction contact D f1*d/D0               # right
    """
    if in_slot:
        hint = f"what slides or rolls in a slot has 'friction contact {point} …', a roller f1*d/D"
        return Message(span, f"point {point} is guided by a link, not by the ground", hint)
    return Message(span, f"point {point} is not guided", f"add 'slider {point} along …'")


@coded("E273")
def nothing_in_contact(span: Span, point: str) -> Message:
    """Friction of a contact is given at a point that is in no contact and no slot.

    friction contact A 0.1              # wrong without
    contact A on BC normal 60 deg       # such a line
    """
    message = f"point {point} is neither in contact nor in a slot"
    return Message(span, message, f"add 'contact {point} on … normal …'")


@coded("E274")
def senseless(span: Span, what: str, value: str) -> Message:
    """A coefficient of friction is negative, a diameter is not positive, or the like.

    An efficiency is above 0 and at most 1.

        friction pins -0.1 diameter 10 mm     # wrong
    """
    in_per_cent = what == "an efficiency" and not value.startswith(("-", "0"))
    hint = "look at its sign" if value.startswith("-") else "write one above 0"
    if in_per_cent:
        hint = "is it in per cent? A hundredth is written 0.01"
    return Message(span, f"{what} of {value} makes no sense", hint)


@coded("E421")
def axle_fills_roller(span: Span, axle: float, wheel: float) -> Message:
    """The axle of a roller is as thick as the roller, or thicker.

    The two diameters stand in this order; exchanged they make friction larger than it is.

        friction roller A 0.1 axle 40 mm wheel 10 mm     # wrong
        friction roller A 0.1 axle 10 mm wheel 40 mm     # right
    """
    message = f"the axle is {axle * 1000:g} mm thick and its roller {wheel * 1000:g} mm"
    return Message(span, message, "the axle has the smaller diameter: are they exchanged?")


@coded("W274")
def friction_of_no_pins(span: Span) -> Message:
    """Friction of all pins is given, and nothing turns on a pin.

    Wedges, racks and plungers slide: they have guides and contacts.

        slide WX along x
        friction pins 0.1 diameter 10 mm     # warned of where no link turns
        friction slider W 0.1                # right: the guide of the slide
    """
    hint = "give the guides and contacts theirs, as in `friction slider K 0.1`, or leave it out"
    return Message(span, "there is no pin that could have this friction", hint)


@coded("W276")
def strange_thread(span: Span, point: str, climb: float, diameter: float, expected: str) -> Message:
    """The thread of a screw climbs at more than 40 deg or less than 0.1, as hardly a thread does.

    Mostly the unit of the pitch or of the diameter is wrong, or a number of one of them.

        screw A pitch 600 mm on OB             # a pitch of 6 mm is meant
        friction screw A 0.12 thread 30 mm     # warned of: 81 deg
    """
    message = (
        f"the thread of {diameter * 1000:g} mm at {point} climbs at {climb:.3g} deg, "
        f"expected {expected} deg"
    )
    return Message(
        span, message, "check the pitch, which is the travel of a turn, and the diameter"
    )


@coded("E420")
def range_makes_no_sense(span: Span, what: str, name: str, value: str) -> Message:
    """The range of a parameter takes a coefficient of friction, a diameter or the like too far.

    A coefficient is not negative, a diameter is above zero, an efficiency at most 1.

        param mu = 0.1 in -0.2 .. 0.3     # wrong
        param mu = 0.1 in 0 .. 0.3        # right
        friction slider B mu
    """
    message = f"the range of {name} takes {what} to {value}, which makes no sense"
    return Message(span, message, f"correct the range of {name}")


@coded("E275")
def friction_again(span: Span, point: str, first: Span) -> Message:
    """Friction of one kind is given twice at one point.

    friction pin O 0.1 diameter 10 mm
    friction pin O 0.2 diameter 10 mm     # wrong

    ``friction pins`` gives it for every pin that no other line names.
    """
    message = f"friction at {point} is given twice"
    related = (Related(first, "it stands here first"),)
    return Message(span, message, "remove one of the two lines", related)


@coded("E276")
def nothing_presses(span: Span, point: str) -> Message:
    """Friction is given at a slider that nothing presses on its guide.

    slider B along x
    friction slider B 0.1     # wrong unless a link or a load is at B, or B touches a link
    """
    message = f"no link and no load is at {point}, so nothing presses it on its guide"
    return Message(span, message, f"join a link to {point}, or leave this friction out")


@coded("E277")
def no_transmission(span: Span, kind: str, what: str, point: str, there: Sequence[str]) -> Message:
    """Friction of a gear, belt, rack or screw, or of its collar, is given where there is none.

    A pair of gears and a belt are named by the pivot of their first wheel, a rack and a
    screw by their slider.

        gear O1 20 mm, O2 40 mm
        friction gear O2 0.02     # wrong
        friction gear O1 0.02     # right
    """
    named = {"gear": "no pair of gears begins at", "belt": "no belt begins at"}
    message = f"{named.get(kind, f'there is no {kind} at')} {point}"
    hint = f"write 'friction {what} {there[0]} …'" if there else f"no line begins with '{kind}'"
    return Message(span, message, hint)


@coded("E279")
def several_transmissions(span: Span, kind: str, point: str) -> Message:
    """Friction of a gear, belt, rack or screw is given where several have the same name.

    Two wheels that mesh may be written in either order.

        gear O1 20 mm, O2 40 mm
        gear O1 20 mm, O3 30 mm     # wrong beside 'friction gear O1 0.02'
        gear O3 30 mm, O1 20 mm     # right: 'friction gear O3 0.02' names it
    """
    named = {"gear": "pairs of gears begin", "belt": "belts begin"}
    message = f"several {named.get(kind, f'{kind}s are')} at {point}, and this does not tell which"
    hint = "write the other wheel of one of them first"
    if kind not in named:
        hint = f"give each {kind} a slider of its own"
    return Message(span, message, hint)


@coded("E278")
def half_of_a_whole(span: Span, point: str, load: str, other: str, share: Fraction) -> Message:
    """A guide has friction in one half, or branch, of a mechanism whose other halves are left out.

    A load that counts twice as often as the one on the guide suggests a second half. In the
    whole the side forces of both halves cancel on the guide that they share; one half alone
    presses it to one side, and friction would be overstated.

        force P at A along x
        force F at D along y times 2
        friction slider A 0.1                # wrong
        mirror across 0 deg sharing A        # right, without 'times 2': both halves are solved

    Where two equal forces do act on one side, the second is tied to the first:
    ``force F2 = F at D along y``.
    """
    message = (
        f"the guide of {point} has friction, but {other} counts {share} times for each {load} "
        "there: the side forces of what is left out would cancel"
    )
    whole = f"copies {share}" if share.denominator == 1 and share > 2 else "mirror across …"
    return Message(span, message, f"describe the rest with '{whole} sharing {point}'")


@coded("W270")
def less_than_plain(span: Span, share: float) -> Message:
    """The couple part of a plunger's pressure is below plain friction.

    The default law, 3l/s, counts the couple that tilts the plunger and leaves the side force
    itself out. For l < s/3 that is less than a guide without any overhang would give.

        friction slider K 0.1 guide 40 mm overhang 10 mm            # 0.75 times plain friction
        friction slider K 0.1 guide 40 mm overhang 10 mm linear     # right: 1.08 times
    """
    message = f"with an overhang of {share:.3g} of the guide's length, 3l/s is below plain friction"
    return Message(span, message, "name the law 'linear' or 'edges'")


@coded("W271")
def motion_for_nothing(span: Span) -> Message:
    """``motion`` says which way friction acts, and there is no friction.

    motion releasing     # warned of where no line begins with 'friction' or 'efficiency'
    """
    message = "without friction it makes no difference which way the mechanism moves"
    return Message(span, message, "leave it out, or give friction")


@coded("W272")
def halves_cancel(span: Span, point: str) -> Message:
    """Friction is given on a guide that mirrored halves, or equal branches, share.

    The side forces of the halves cancel there, so the guide is not pressed and has no
    friction. The line has no influence.

        mirror across 0 deg sharing A
        friction slider A 0.1            # warned of
    """
    message = f"the side forces on the guide of {point} cancel, so that it has no friction"
    return Message(span, message, "remove the line, or the symmetry if there is none")


@coded("W273")
def perhaps_a_half(span: Span, point: str, load: str) -> Message:
    """A guide has friction in a mechanism of which perhaps one half is described only.

    A load that counts twice, or by half, suggests a second half that is not there. In the
    whole the side forces of the halves cancel on a guide that they share; one half alone
    presses it to one side, and its friction is overstated.

        force F at D along y times 2
        friction slider A 0.1                # warned of where no load acts at A, else E278
        mirror across 0 deg sharing A        # right: both halves are solved
    """
    message = (
        f"the guide of {point} has friction, but {load} does not count once: side forces of a "
        "half that is left out would cancel there"
    )
    return Message(span, message, f"describe the half with 'mirror across … sharing {point}'")


@coded("W243")
def pair_without_pins(
    span: Span, load: str, ends: tuple[str, str], loose: Sequence[str], can_be_held: bool
) -> Message:
    """Every pin is said to have friction, and a pair of forces has no pins of its own.

    An actuator or a spring is a pair of forces at two points. A telescope between them has
    pins at its ends, whose friction bends it. Without pins each end acts on a link.

        friction pins 0.1 diameter 10 mm
        actuator P between A and B                # warned of without a line such as
        telescope AB
        actuator P between A on OA and B on BC    # right where no pins hold its ends
    """
    message = f"{load} is a pair of forces: its ends at {' and '.join(ends)} have no friction"
    pins = f"add 'telescope {''.join(ends)}' if pins hold its ends; if not, " if can_be_held else ""
    links = listed((f"'{point} on …'" for point in loose), "and")
    return Message(span, message, f"{pins}say on which link it acts: {links}")


@coded("W244")
def slot_without_friction(span: Span, point: str) -> Message:
    """Every pin is said to have friction, and one of them slides in a slot without any.

    A pin in a slot has friction as a contact has, along the slot.

        friction pins 0.1 diameter 10 mm
        slot B in OC                     # warned of without a line such as
        friction contact B 0.1
    """
    message = f"the pin {point} slides in its slot without friction"
    return Message(span, message, f"add 'friction contact {point} …'")


@coded("W205")
def couple_without_friction(span: Span, link: str) -> Message:
    """A block with friction passes on a couple, and only the force across the slot is counted.

    Without its length it is undetermined how the edges of a block press. Two pins in the same
    slot, as far apart as the block is long, have the friction of its edges::

        slot B in CD guiding BE      # counts mu*|N_B|
        friction contact B 0.1

        slot B in CD                 # counts both edges, with BG the block's length
        slot G in CD
        friction contact B 0.1
        friction contact G 0.1
    """
    return Message(
        span,
        f"the couple that keeps {link} from turning in its slot adds no friction here",
        "for the friction of the edges let two pins of it slide in the slot",
    )
