"""Words of the pose stage: directions and lengths that are missing, loops that disagree."""

from collections.abc import Iterable, Sequence

from ..source import Span
from .diagnostic import Message, Related, coded


@coded("E301")
def missing_direction(
    at: Span,
    points: str,
    for_what: str,
    guided: str = "",
    near: str = "",
    rod: str = "",
    fall_to: str = "",
    unplaced: str = "",
    loose: str = "",
) -> Message:
    """A direction is needed and nothing gives it.

    Velocities are related through the directions of links, so the direction of every
    rod and of every arm of a body that carries a load or a pin must be given::

        link OB
        OB = a               # wrong: only the length
        OB = a @ alpha       # right: length and direction

    A direction may also come from a turn (``angle ABC = gamma``), from other vectors
    that lead from one point to the other, or from a loop of given lengths, which closes
    through a slider only where its guide has a place::

        slider B along x             # wrong: on which line does B run?
        slider B along x through O   # right

    A loop closes where all its lengths are given; one rod without its length opens it.
    The line of an actuator, a spring or a telescope follows where both ends have a place: that
    of a pivot is given by ``pivot C at (50 mm, 0 mm)``.
    """
    line = f"`{points} = @ 30 deg`"
    place = f"say where the guide of {guided} lies, `slider {guided} along … through {near}`, or "
    length = f"give the length of {rod}, `{rod} = 100 mm`, for a loop to close, or "
    fall = f"write it behind the point at which the fall ends, `{fall_to} along y`, or "
    pivot = f"say where {unplaced} is, `pivot {unplaced} at (0 mm, 0 mm)`, or "
    ground = f"write `pivot {loose} at (…)`, if it is pinned to the ground, or "
    hints = ((guided, place), (rod, length), (fall_to, fall), (unplaced, pivot), (loose, ground))
    first = next((hint for name, hint in hints if name), "")
    return Message(
        at,
        f"{for_what} needs the direction of {points}, and nothing gives it",
        f"{first}add a line such as {line}",
    )


@coded("E302")
def directions_disagree(at: Span, points: str, other: Span) -> Message:
    """The direction of one vector is given twice, and differently.

    A direction can be written down, or follow from a turn::

        AB = @ alpha
        angle ABC = gamma
        BC = @ beta          # wrong, unless beta is alpha + 180 deg + gamma

    Give as many directions as are free, and leave the others out.
    """
    return Message(
        at,
        f"the direction of {points} is given twice, and not alike",
        "leave one of the two out",
        (Related(other, "the other one follows from here"),),
    )


@coded("E303")
def loop_does_not_close(at: Span, loop: str, gap: str, brought: Sequence[str]) -> Message:
    """The vectors around a loop, with the values given, do not add up to zero.

    Going around a closed chain of vectors one must come back to where one started::

        OA = 100 mm @ 0 deg
        AB = 100 mm @ 90 deg
        OB = 150 mm @ 45 deg    # wrong: OB is sqrt(2)*100 mm

    Leave one length open (``OB = @ 45 deg``) or correct the values. An angle that a joined
    part has ``brought`` in with its value is given by the loop where it stays behind::

        use toggle as T joining T.B = B                  # wrong: T_alpha keeps its value
        use toggle as T joining T.B = B without alpha    # right: the loop gives it
    """
    hint = "leave a length of the loop open, or correct its values"
    if brought:
        prefix, _, own = brought[0].partition("_")
        hint = f"let the loop give {brought[0]}: use … as {prefix} … without {own}"
    return Message(
        at, f"the loop {loop} does not close: the gap is {gap} at the values given", hint
    )


@coded("E304")
def loop_ties_symbols(at: Span, loop: str, names: Iterable[str], relation: str) -> Message:
    """A loop closes for special values only, so it ties symbols that are given as free.

    With directions and lengths given as independent parameters, a closed loop is a
    relation between them, and k could be written in many ways::

        OA = a @ alpha
        AB = l @ beta
        OB = (c, 0 mm)       # wrong: then a*sin(alpha) + l*sin(beta) = 0 ties them
        AB = @ beta          # right: the length of AB follows from the rest

    Leave one length of the loop out: k does not depend on it, or mechc will tell.
    """
    tied = list(names)
    free = "which are given as independent" if len(tied) > 1 else "which is given as free"
    detail = f": {relation}" if relation else ""
    return Message(
        at,
        f"the loop {loop} ties {', '.join(tied)}, {free}{detail}",
        "leave a length of the loop open (`AB = @ beta`), or define one parameter by the others",
    )


@coded("E305")
def no_direction_of_its_own(at: Span, points: str) -> Message:
    """A direction is asked of two points whose vector rests on a length that is not given.

    ``along AC`` takes the direction of the vector AC. Where that is a sum of other
    vectors, their lengths decide which way it points::

        AB = @ alpha         # wrong: AC = AB + BC turns with the length of AB
        AB = b @ alpha       # right
        BC = c @ beta
        force P at A along AC
    """
    return Message(
        at,
        f"{points} is a sum of other vectors, not all of known length, so its direction is open",
        f"give the lengths, or the direction: `{points} = @ gamma`",
    )


@coded("E306")
def points_coincide(at: Span, points: str) -> Message:
    """Two points of one link are at the same place, so no direction leads from one to the other."""
    return Message(
        at,
        f"the two points of {points} are at the same place",
        "check the lengths and angles that lead from one to the other",
    )


@coded("E310")
def length_open(at: Span, points: str) -> Message:
    """A formula asks for the length of a vector, and nothing gives it.

    ``len_AB`` is what the description says of AB, or what a loop makes it::

        BK = @ beta          # the length is open
        let s = len_BK/2     # wrong
        BK = l @ beta        # right
    """
    return Message(
        at,
        f"the formula needs the length of {points}, and nothing gives it",
        f"give it: `{points} = l @ …`",
    )


@coded("E346")
def point_without_place(at: Span, point: str) -> Message:
    """A formula asks where a point is, and nothing leads there from the origin.

    ``x_B`` and ``y_B`` are the coordinates of B, where vectors that are given or found lead to
    it from a pivot with a place, or from the first pivot where none has one::

        pivot O
        OA = @ alpha         # the length is open
        let h = y_A          # wrong
        OA = a @ alpha       # right
    """
    message = f"the formula needs the place of {point}, and nothing gives it"
    return Message(at, message, "give the vectors that lead to it their lengths")


@coded("E311")
def side_of_the_mirror(at: Span, point: str, load: str) -> Message:
    """A pair acts across the mirror line, and the place of that line is undetermined.

    The line passes through the points that both halves share; from one of them vectors
    lead to the point that is pushed::

        mirror across y                    # wrong: no point is on the line
        mirror across y sharing O          # right
        actuator P between B and B'
    """
    message = (
        f"the side of the mirror line is undetermined on which {point} is, where {load} pushes it"
    )
    return Message(at, message, "name a point on the line, as in `mirror across y sharing O`")


@coded("W302")
def gears_apart(at: Span, pivots: str, apart: float, wanted: float, meant: str) -> Message:
    """Two gears stand where their pitch circles do not touch.

    Where the places of both pivots are given, the distance between them is the sum of the
    radii, or their difference for inner gears. Speeds and forces follow from the ratio of
    the radii alone, so results stand; the drawing does not::

        pivot O at (0, 0)
        pivot Q at (60 mm, 0)
        gear O 20 mm, Q 30 mm     # warned of: 50 mm
        gear O 20 mm, Q 40 mm     # right
    """
    return Message(
        at,
        f"the gears on {pivots} are {apart * 1000:.7g} mm apart, "
        f"their radii make {wanted * 1000:.7g} mm",
        OF_GEARS[meant],
    )


@coded("W305")
def halves_apart(at: Span, points: str, gap: float) -> Message:
    """Points that both halves of a mirror share are not on one line across it.

    Velocities and forces follow from the directions alone, so that formulas stand; the values
    given are those of no pose, and there is no picture of it::

        AB = 40 mm @ alpha
        BO = 40 mm @ 90 deg          # warned of: O is off the line along x through A
        BO = 40 mm @ -alpha          # right
        mirror across x sharing A O
    """
    return Message(
        at,
        f"{points}, which both halves share, are not on one line across the mirror: the gap is "
        f"{gap * 1000:.4g} mm at the values given",
        "correct the values, or leave a length between them open",
    )


OF_GEARS = {
    "": "fix the radii or the places; with the radii of other wheels leave the places out",
    "diameters": "are they diameters? A gear has its radius there",
    "inner": "add `inner` for a gear inside the other one, or fix the radii or the places",
    "outer": "leave `inner` out for gears side by side, or fix the radii or the places",
}
"""Hints at centres that do not fit, by what the radii would fit as."""
