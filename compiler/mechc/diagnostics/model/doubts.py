"""Messages for what can be meant, and hardly ever is (W201 to W204, W242, W245 to W257)."""

from collections.abc import Sequence

from ...source import Span
from ..diagnostic import Message, Related, coded
from ..syntax import listed


@coded("W248")
def asked_twice(span: Span, name: str, other: str, first: Span) -> Message:
    """The same is asked for under two names.

    find k = P/F
    find j = P/F     # warned of: was another ratio meant?
    """
    related = (Related(first, f"'{other}' asks for it here"),)
    message = f"'{name}' asks for the same as '{other}'"
    return Message(span, message, "remove one, or change what was copied", related)


@coded("W288")
def both_given(span: Span, name: str, above: str, below: str, asked: Span) -> Message:
    """Both loads of a ratio have values, and the ratio says what one of them is.

    find k = P/F
    let F = 3 kN
    let P = 2 kN      # warned of: balance demands k*F
    let P = k*F       # right
    """
    related = (Related(asked, f"{name} is asked for here"),)
    message = f"'{above}' has a value, and follows from '{below}': {above} = {name}*{below}"
    hint = "leave one of the two out, or call what is there to bear it otherwise"
    return Message(span, message, hint, related)


@coded("W249")
def drive_moves_nothing(span: Span, name: str) -> Message:
    """The driving coordinate stands in no vector, angle or guide: nothing moves with it.

    param phi = 60 deg
    drive phi from 10 deg to 80 deg
    OA = a @ 60 deg     # warned of
    OA = a @ phi        # right
    """
    message = f"no vector, angle or guide depends on {name}, so nothing moves with it"
    return Message(span, message, "drive what moves, or write it into the geometry")


@coded("W250")
def drive_reshapes(span: Span, name: str, tail: str, head: str, body: str) -> Message:
    """The driving coordinate is a size of a rigid body, or a distance of pivots.

    Nothing in the mechanism changes it, so the rows of a stroke belong to as many different
    mechanisms. That is a study of sizes; speeds along it mean nothing.

        OA = r @ phi
        drive r from 20 mm to 60 mm      # warned of: OA is a link
        drive phi from 0 deg to 360 deg  # right
    """
    what = f"the length of {tail}{head}" if tail else f"the place of {head}"
    message = f"{name} is no motion: it changes {what}, and {body} is rigid"
    return Message(span, message, "drive an angle of a link, or the length of what is variable")


@coded("W252")
def pivots_coincide(span: Span, point: str, other: str, first: Span) -> Message:
    """Two pivots are at one place, so that what turns on them turns on one axis.

    A linkage between such pivots turns as one rigid body. Wheels may sit on one axis.

        pivot O at (0 mm, 0 mm)
        pivot Q at (0 mm, 0 mm)     # warned of
        pivot Q at (d, 0 mm)        # right
    """
    related = (Related(first, f"the place of {other}"),)
    message = f"pivot {point} is at the same place as pivot {other}"
    return Message(span, message, "correct the place, or use one pivot for both", related)


@coded("W253")
def link_within_link(span: Span, link: str, other: str, first: Span) -> Message:
    """All pins of a link are pins of another one, with which it moves as one body.

    It demands nothing of the motion, and the force it carries is not determined.

        link ABE
        link AE      # warned of
    """
    related = (Related(first, f"link {other}"),)
    message = f"all points of link {link} are on link {other}, so the two move as one"
    return Message(span, message, "leave it out, or correct its points", related)


@coded("W262")
def link_of_ground(span: Span, link: str, held: Sequence[str] = ()) -> Message:
    """Two pins of a link are pivots of the ground, so that it is a part of the ground.

    The ground needs no link: its pivots stand where they are said to::

        pivot O at (0 mm, 0 mm)
        pivot Q at (100 mm, 0 mm)
        link OQ                       # warned of
        link OQA                      # warned of, too: A stands still
    """
    message = f"all points of link {link} are pivots of the ground, so it cannot move"
    if held:
        message = f"{listed(held, 'and')} of link {link} are pivots, so it cannot move"
    return Message(span, message, "leave it out, or correct its points")


@coded("W264")
def guide_along_link(span: Span, point: str, link: str) -> Message:
    """The direction of a guide is that of a link that moves; a guide is fast in the ground.

    It is as if the guide were turned with the link, for every pose anew::

        slider B along OA        # warned of, where OA moves
        slot B in OA             # right, where B slides along OA
        slider B along 30 deg    # right, where the ground guides it
    """
    message = f"the guide of {point} is fast in the ground, and its direction that of link {link}"
    hint = f"a point that slides along a link is written slot {point} in …; a guide has an angle"
    return Message(span, message, hint)


@coded("W254")
def telescope_between_fixed(span: Span, name: str, body: str) -> Message:
    """The ends of a telescope keep their distance, so it can neither extend nor push.

    link OB
    telescope OB     # warned of: link OB holds both ends
    telescope CB     # right
    """
    message = f"{body} holds both ends of telescope {name}, so its length never changes"
    return Message(span, message, "name the points that move apart")


@coded("W277")
def idle_telescope(span: Span, name: str) -> Message:
    """Nothing acts in a telescope, so that it bears no force and may as well be left out.

    A telescope is a cylinder or a spring strut: an actuator or a spring between its ends::

        telescope CA
        actuator P between C and B     # warned of: P acts beside the telescope
        actuator P between C and A     # right
    """
    message = f"no actuator and no spring acts between the ends of telescope {name}"
    hint = "it bears nothing so: let an actuator or a spring act between its ends, or leave it out"
    return Message(span, message, hint)


@coded("W281")
def condition_of_one_value(span: Span, name: str) -> Message:
    """A condition of use holds at one value of a parameter: code gives NaN at any other.

    require alpha = 10 deg     # warned of
    param alpha = 10 deg       # right: its value
    param beta = 2*alpha       # right: what follows from another
    """
    message = f"this condition holds at one value of {name}, and at any other code gives NaN"
    return Message(span, message, f"a value is given where it is declared: `param {name} = …`")


@coded("W282")
def condition_of_constants(span: Span, is_same: bool = False) -> Message:
    """A condition compares constants, or a thing with itself: it holds always, or never.

    require 1 < 2                        # warned of
    require tau <= tau                   # warned of: tau_a was meant
    let c = 0.3 when 5 mm < 6 mm else 1  # warned of
    require a < 2 mm                     # right
    """
    if is_same:
        message = "this condition compares a thing with itself, so that it states nothing"
        return Message(span, message, "is the name on one side another one?")
    hint = "name what the condition is about, as in `a < 2 mm`"
    return Message(span, "this condition compares constants, so that it states nothing", hint)


@coded("W219")
def never_met(span: Span, name: str, has_range: bool) -> Message:
    """A case of a choice never holds, whatever value its parameter has in its range.

    param v = 1 m/s in 0 m/s .. 2 m/s
    let K = 1.3 when v > 5 m/s else 1.2             # warned of
    let K = 1.3 when v > 1 m/s else 1.2             # right
    let K = 1.3 when v < 1 m/s and v > 2 m/s else 1 # warned of: two cases were meant
    """
    where = " in its range" if has_range else ""
    hint = "correct the bound or its unit; where one bound or the other is meant, write two cases"
    return Message(span, f"no value of '{name}'{where} meets this condition", hint)


@coded("W256")
def let_without_value(span: Span, name: str) -> Message:
    """A user-defined formula has no finite value at the given parameters.

    It divides by zero there, or asks for a root or an arc function of what has none.

        param l = 200 mm
        let z = 1/(l - 200 mm)     # warned of
    """
    message = f"'{name}' has no finite value at the given parameters"
    return Message(span, message, "check signs and brackets, or the values")


@coded("W206")
def keeps_its_arrow(span: Span, name: str, pressing: str) -> Message:
    """A force that is a share of another one, and across it, seems to be friction.

    Friction turns round with the motion, and a load does not: ``k_f`` and ``k_hold`` are both
    found with this force as its arrow has it, which is right for one of them at most. What
    loses by it does not enter the efficiency either::

        force N at A along -y
        force T = mu*N at A along x     # warned of beside friction elsewhere
        friction pins 0.1 diameter 10 mm

    Describe the other sense by itself, with ``motion releasing`` and this arrow turned.
    """
    return Message(
        span,
        f"{name} keeps its arrow where the motion turns round: as friction under {pressing} it is "
        "right in one sense of the motion only",
        "for the other sense turn its arrow, in a description of its own",
    )


@coded("W291")
def label_is_value(span: Span, link: str, label: str) -> Message:
    """What a link is called reads as a length: the text of a link gives it none.

    links: {OB: 200 mm}         # warned of: the link is called so
    geometry: {OB: 200 mm}      # right

    link OB "200 mm"            # warned of
    OB = 200 mm                 # right
    """
    message = f"link {link} is called '{label}', which reads as a value"
    return Message(span, message, f"its length stands in a line of its own: {link} = {label}")


@coded("W201")
def unused_parameter(span: Span, name: str, is_vector: bool = False) -> Message:
    """A parameter is declared and nothing uses it.

    Often a formula mentions another name than was meant.

        param a = 40 mm
        param b = 50 mm      # warned of: b stands in no formula
        OB = a @ 90 deg
    """
    hint = "use it or remove it"
    if name in ("x", "y"):
        hint = f"in a direction {name} is the axis: call the parameter otherwise"
    if is_vector:
        hint = f"in a formula {name} is a vector or its length: call the parameter otherwise"
    return Message(span, f"nothing uses the parameter '{name}'", hint)


@coded("W202")
def lonely_point(span: Span, point: str, link: str) -> Message:
    """Only one link goes through a point, and nothing acts there.

    Most often it is a mistyped pin, the point being meant to join two links, or the line is
    missing that pins it to the ground.

        link OA
        link BC      # warned of, where AC was meant
    """
    short = link if len(link) <= 40 else f"{link[:40]}…"
    message = f"only link {short} goes through point {point}, and nothing acts there"
    return Message(span, message, f"is it a mistyped pin, or is `pivot {point}` missing?")


@coded("W210")
def copies_off_axis(at: Span, point: str) -> Message:
    """A point that equal branches share is not guided, so that nothing keeps it on their axis.

    The branches stand around a line, which is the guide of what they share. A load on a shared
    point counts once; on a point that each branch has it counts as often as there are branches::

        copies 3 sharing D         # warned of where D is a point of a claw
        slider K along y
        copies 3 sharing K         # right: K moves along the axis
    """
    message = f"the copies share {point}, which no guide keeps on their axis"
    return Message(at, message, f"share a point that is guided, or add 'slider {point} along …'")


@coded("W203")
def halves_apart(at: Span, along: str) -> Message:
    """The halves of a mirror share no point that moves, and nothing acts between them.

    Then each half is a mechanism of its own, and a load on both counts twice. A pivot alone may
    be meant, as in a pair of tongs, but hardly where a point slides along the mirror line.

        slider K along 90 deg
        mirror across 90 deg               # warned of
        mirror across 90 deg sharing O     # warned of where O is a pivot: there are two K
        mirror across 90 deg sharing K     # right: K belongs to both halves
    """
    message = "the halves share no point that moves, so each stands alone"
    return Message(at, message, f"add `sharing {along or 'K'}`")


@coded("W204")
def stated_again(span: Span, first: Span) -> Message:
    """A line stands twice.

    A ``find``, an ``expect``, a ``require``, an ``assembly``, a ``telescope``, or a joint such
    as a ``slot`` or a ``gear`` that is written over again changes nothing; perhaps a copied line
    was to be changed.

        expect k = 2*tan(alpha)
        expect k = 2*tan(alpha)     # warned of
    """
    related = (Related(first, "first stated here"),)
    return Message(
        span, "this is stated once more", "remove it, or change what was copied", related
    )


@coded("W242")
def copies_apart(at: Span) -> Message:
    """Equal branches share no point that moves, so that each is a mechanism of its own.

    copies 3               # warned of: k is that of one branch alone
    copies 3 sharing O     # warned of where O is a pivot
    copies 3 sharing K     # right: K belongs to all three
    """
    message = "the copies share no point that moves, so each stands alone"
    return Message(at, message, "add `sharing K`")
