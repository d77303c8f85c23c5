"""Hints about the closures of a loop: which lines, or which drawing, tells them apart."""

from collections.abc import Mapping, Sequence

MEET = "the closures meet there, in one line: change a length or the default pose"


def one_of(closures: Sequence[str]) -> str:
    """Return the hint that lists the lines of each closure."""
    return "add " + " or ".join(closures)


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


def no_line_tells(closures: Sequence[str], drive: str) -> str:
    """Return the hint where closures have all turns alike: how they differ, what may help."""
    named = f"the default of {drive}" if drive else "the default pose"
    return (
        f"no turn of three points tells {' from '.join(closures)}: "
        f"draw a point of the one that is meant, or move {named} to where they are farther apart"
    )
