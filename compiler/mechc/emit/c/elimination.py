"""What is eliminated before a correction's system is solved, from where its zeros are.

The direction of a link that closes one loop occurs in two equations only, the components
of that loop. One combination of the two, by the slopes, is without it; as a rotation it
loses nothing. Half the unknowns may go like this, and the rest is left to pivoting.
"""

from collections.abc import Iterator, Sequence

from ...base.named import NamedTuple
from ...formula.tree import ZERO, Formula

Rows = Sequence[Sequence[Formula]]


class EquationPair(NamedTuple):
    """An unknown, and the two equations that it occurs in."""

    unknown: int
    first: int
    second: int


class Reduced(NamedTuple):
    """The system that is left, in C: its rows and right sides, and all corrections.

    ``turn`` is 1 where its determinant has the sign of the whole one, else -1.
    """

    matrix: list[list[str]]
    right: list[str]
    change: list[str]
    turn: int


def reduced(jacobian: Rows) -> Reduced:
    """Return the system without the unknowns that occur in two equations."""
    size = len(jacobian)
    pairs = list(_pairs(jacobian))
    gone = {p.unknown for p in pairs}
    kept = [c for c in range(size) if c not in gone]
    second = {p.second: p for p in pairs}
    rows = [r for r in range(size) if r not in {p.first for p in pairs}]
    places = {c: f"right[{i}]" for i, c in enumerate(kept)}
    known = places | {p.unknown: _back(jacobian, p, places) for p in pairs}
    return Reduced(
        [[_entry(jacobian, second.get(r), r, c) for c in kept] for r in rows],
        [_without(second.get(r), r, size) for r in rows],
        [known[c] for c in range(size)],
        _turn(pairs, size),
    )


def _pairs(jacobian: Rows) -> Iterator[EquationPair]:
    used: set[int] = set()
    for unknown in range(len(jacobian)):
        rows = [i for i, row in enumerate(jacobian) if row[unknown] != ZERO]
        if len(rows) == 2 and used.isdisjoint(rows):
            used.update(rows)
            yield EquationPair(unknown, *rows)


def _turn(pairs: Sequence[EquationPair], size: int) -> int:
    """Return the sign that the rotations and the places of what they leave alone make."""
    rows, columns, sign = [*range(size)], [*range(size)], 1
    for pair in pairs:
        place = rows.index(pair.first) + columns.index(pair.unknown)
        sign = sign if place % 2 else -sign
        rows.remove(pair.first)
        columns.remove(pair.unknown)
    return sign


def _slope(row: int, column: int, size: int) -> str:
    return f"slope[{row * size + column}]"


def _entry(jacobian: Rows, pair: EquationPair | None, row: int, column: int) -> str:
    """Return an entry of the matrix that is left."""
    size = len(jacobian)
    if not pair:
        return _slope(row, column, size)
    terms = []
    for mine, other, sign in ((pair.first, pair.second, ""), (pair.second, pair.first, "-")):
        if jacobian[mine][column] != ZERO:
            factors = _slope(other, pair.unknown, size), _slope(mine, column, size)
            terms.append(sign + "*".join(factors))
    return " + ".join(terms).replace("+ -", "- ") or "0.0"


def _without(pair: EquationPair | None, row: int, size: int) -> str:
    """Return a right side of the system that is left."""
    if not pair:
        return f"residual[{row}]"
    first, second = (_slope(r, pair.unknown, size) for r in (pair.first, pair.second))
    return f"{second}*residual[{pair.first}] - {first}*residual[{pair.second}]"


def _back(jacobian: Rows, pair: EquationPair, places: dict[int, str]) -> str:
    """Return the correction of an unknown that was eliminated."""
    size = len(jacobian)
    parts, squares = [], []
    for row in (pair.first, pair.second):
        own = _slope(row, pair.unknown, size)
        rest = [f"residual[{row}]"]
        rest += [
            f"{_slope(row, c, size)}*{place}"
            for c, place in places.items()
            if jacobian[row][c] != ZERO
        ]
        parts.append(f"{own}*({' - '.join(rest)})")
        squares.append(f"{own}*{own}")
    return f"1.0/({' + '.join(squares)})*({' + '.join(parts)})"
