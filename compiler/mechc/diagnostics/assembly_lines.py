"""Words of how a loop closes: lines of `assembly`, and hints at what decides between closures."""

from collections.abc import Mapping, Sequence

from ..source import Span
from .diagnostic import Message, Related, coded

MEET = "the closures meet there, in one line: change a length or the default pose"


@coded("E307")
def closure_open(at: Span, loop: str, number: int, hint: str) -> Message:
    """A loop closes in two ways or more, and the description does not say which is meant.

    With its lengths and the drive given, a triangle can lie on either side of its base,
    and a slider can stand on either side along its guide::

        OA = a @ phi
        AB = b
        CB = c
        assembly ABC ccw     # A, B, C turn counter-clockwise at the default pose

    ``assembly B forward`` takes the place of B farther along its guide, ``back`` the other.
    A point as it is drawn says as much: ``B at (80 mm, 60 mm)`` takes the nearest closure.
    """
    ways = "two" if number == 2 else str(number)
    message = f"the loop {loop} closes in {ways} ways, and nothing says which is meant"
    return Message(at, message, hint)


@coded("E308")
def assembly_undecided(at: Span, points: str, hint: str) -> Message:
    """An ``assembly`` line does not tell the closures of its loop apart at the default pose.

    Either both closures have the turn that it asks for, or none has, or the default pose
    is a dead centre, where the two are one::

        assembly OAB ccw     # wrong: O, A, B turn alike in both closures
        assembly ABC ccw     # right: the turn at the pin that closes the loop

    A default pose away from the dead centre helps where the line is right.
    """
    message = f"the assembly of {points} does not tell the closures apart at the default pose"
    return Message(at, message, hint)


@coded("W301")
def assembly_idle(at: Span, points: str) -> Message:
    """An ``assembly`` line decides nothing: all its points are placed without it.

    Only a loop that two closures fit asks for one. Here the directions are given, or the
    points do not hang together::

        OA = a @ phi
        AB = b @ beta
        assembly OAB ccw     # decides nothing: both directions are given
    """
    return Message(
        at,
        f"the assembly of {points} decides nothing",
        "leave it out, or name the points of a loop that mechc is to close",
    )


@coded("W304")
def assembly_of_one_slot(at: Span, pin: str, loop: str, other: str) -> Message:
    """An ``assembly`` line of a pin that slides in two slots decides one of two loops alone.

    The other loop closes with the pin ahead, as it does without a line. Three points say
    which loop is meant::

        slot A in PC
        slot A in QD
        assembly A back      # in PC, or in QD?
        assembly APE ccw     # right: E is a point of link PCE, off the line PC
    """
    return Message(
        at,
        f"the assembly of {pin} decides the loop {loop}; {pin} slides in another slot, too, "
        f"and the loop {other} closes with it ahead",
        "name three points of the loop that is meant, one of them off the line of its slot",
    )


@coded("E318")
def assembly_refuted(at: Span, points: str, mode: str) -> Message:
    """An ``assembly`` line says of given points what they are not.

    The directions given, or loops that close in one way only, place its points, and they
    turn the other way round at the default pose::

        OB = l @ 100 deg
        BK = l @ 80 deg
        assembly OBK ccw     # wrong: O, B, K turn clockwise
    """
    return Message(
        at,
        f"{points} turns {mode} at the default pose, whatever an assembly says",
        "leave the line out, or correct the directions",
    )


@coded("E319")
def assemblies_contradict(at: Span, points: str, other: str, first: Span) -> Message:
    """Two ``assembly`` lines ask for opposite closures.

    Which way round three points turn is said once; the order in which a line begins with
    them does not matter, the sense does::

        assembly ABC ccw
        assembly CBA ccw     # wrong: then A, B, C turn clockwise
    """
    return Message(
        at,
        f"the assembly of {points} contradicts that of {other}",
        "leave one of the two out",
        (Related(first, "the other one"),),
    )


def one_of(closures: Sequence[str]) -> str:
    """Return the hint that lists the lines of each closure.

    A closure in which points lie on one another, or on a line, has no line of its own.
    """
    return "add " + " or ".join(filter(None, closures))


def the_closures(closures: Sequence[str]) -> str:
    """Return the hint that says what the closures are."""
    return "the closures are " + " and ".join(closures)


def one_row(
    point: str, lines: Sequence[Mapping[str, str]], angles: Sequence[Mapping[str, str]]
) -> str:
    """Return the hint that lists many closures as a table: turns of points, and directions.

    >>> lines = [{"ABC": "cw"}, {"ABC": "ccw", "CDE": "cw"}, {"ABC": "ccw", "CDE": "ccw"}]
    >>> print(one_row("B", lines, [{"phi_AB": "30"}, {"phi_AB": "-4.5"}, {"phi_AB": "100"}]))
    draw its points, as in `B at (x, y)`, or add `assembly` lines as in one row:
    ABC  CDE   phi_AB [deg]
    cw         30
    ccw  cw    -4.5
    ccw  ccw   100
    """
    advice = f"draw its points, as in `{point} at (x, y)`, or add `assembly` lines as in one row:"
    names = [list(dict.fromkeys(n for row in half for n in row)) for half in (lines, angles)]
    head = [[*names[0], "", *(f"{name} [deg]" for name in names[1])]]
    rows = [
        [*(along.get(n, "") for n in names[0]), "", *(turned.get(n, "") for n in names[1])]
        for along, turned in zip(lines, angles, strict=True)
    ]
    widths = [max(map(len, column)) for column in zip(*head, *rows, strict=True)]
    padded = ([cell.ljust(w) for cell, w in zip(row, widths, strict=True)] for row in head + rows)
    return "\n".join([advice, *("  ".join(row).rstrip() for row in padded)])


def no_line_decides(closures: Sequence[str], drive: str) -> str:
    """Return the hint where closures have all turns alike: how they differ, what may help."""
    named = f"the default of {drive}" if drive else "the default pose"
    return (
        f"no turn of three points tells {' from '.join(closures)}: "
        f"draw a point of the one that is meant, or move {named} to where they are farther apart"
    )
