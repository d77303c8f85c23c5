"""Linear equations by elimination: for any size, and written out for a size that is met often.

Rows are exchanged for the largest pivot. Both ways do the same operations, to the last bit.
"""

import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import Any

from ...work import spend

Matrix = list[list[float]]

Elimination = Callable[[Matrix, list[float]], int]
"""Solves ``matrix · x = right`` in place: ``right`` becomes x.

Returns the sign of the determinant, 0 where there is no solution.
"""

CUBES = 24
"""An elimination takes a third of the cube of its size, eight times as fast as algebra's steps."""

WRITTEN_OUT_UNKNOWNS = 8
"""The most unknowns for which operations are written out: they are some three hundred lines."""


def eliminate(matrix: Matrix, right: list[float]) -> int:
    """Solve ``matrix · x = right`` in place, rows exchanged for the largest pivot.

    ``right`` becomes x. Return the sign of the determinant, 0 where there is no solution.
    """
    size, sign = len(right), 1
    spend(size**3 // CUBES)
    for k in range(size):
        best, largest = k, abs(matrix[k][k])
        for i in range(k + 1, size):
            if abs(matrix[i][k]) > largest:
                best, largest = i, abs(matrix[i][k])
        if not 0 < largest < math.inf:
            return 0
        if best != k:
            matrix[k], matrix[best] = matrix[best], matrix[k]
            right[k], right[best] = right[best], right[k]
            sign = -sign
        sign = -sign if matrix[k][k] < 0 else sign
        _clear(matrix, right, k)
    for k in reversed(range(size)):
        row, known = matrix[k], right[k]
        for j in range(k + 1, size):
            known -= row[j] * right[j]
        right[k] = known / row[k]
    return sign


def _clear(matrix: Matrix, right: list[float], pivot: int) -> None:
    """Take a row off those below it, so that nothing is left there in the pivot's column."""
    top, above = matrix[pivot], right[pivot]
    columns = range(pivot + 1, len(right))
    for i in columns:
        row = matrix[i]
        if times := row[pivot] / top[pivot]:
            for j in columns:
                row[j] -= times * top[j]
            right[i] -= times * above


def quick(size: int) -> Elimination:
    """Return the elimination for a size that is met often."""
    return _written_out(size) if size <= WRITTEN_OUT_UNKNOWNS else eliminate


@lru_cache(maxsize=WRITTEN_OUT_UNKNOWNS + 1)
def _written_out(size: int) -> Elimination:
    """Return the operations for one size as a function without loops."""
    lines = [
        "def written_out(matrix, right):",
        f"  spend({size**3 // CUBES})",
        "  sign = 1",
        *(line for k in range(size) for line in _cleared(k, size)),
        f"  [{', '.join(f'b{i}' for i in range(size))}] = right",
        *(f"  b{k} = ({_known(k, size)})/a{k}_{k}" for k in reversed(range(size))),
        f"  right[:] = [{', '.join(f'b{i}' for i in range(size))}]",
        "  return sign",
    ]
    names: dict[str, Any] = {"spend": spend, "inf": math.inf}
    exec("\n".join(lines), names)
    written_out: Elimination = names["written_out"]
    return written_out


def _cleared(k: int, size: int) -> Iterator[str]:
    """Yield the lines that bring the largest pivot up, and take its row off those below."""
    yield f"  best, largest = {k}, abs(matrix[{k}][{k}])"
    for i in range(k + 1, size):
        yield f"  if abs(matrix[{i}][{k}]) > largest: best, largest = {i}, abs(matrix[{i}][{k}])"
    yield "  if not 0 < largest < inf: return 0"
    yield f"  if best != {k}:"
    for listed in ("matrix", "right"):
        yield f"    {listed}[{k}], {listed}[best] = {listed}[best], {listed}[{k}]"
    yield "    sign = -sign"
    yield f"  [{', '.join(f'a{k}_{j}' for j in range(k, size))}] = matrix[{k}][{k}:]"
    yield f"  if a{k}_{k} < 0: sign = -sign"
    for i in range(k + 1, size):
        yield f"  row = matrix[{i}]"
        yield f"  times = row[{k}]/a{k}_{k}"
        yield "  if times:"
        yield from (f"    row[{j}] -= times*a{k}_{j}" for j in range(k + 1, size))
        yield f"    right[{i}] -= times*right[{k}]"


def _known(k: int, size: int) -> str:
    return f"b{k}" + "".join(f" - a{k}_{j}*b{j}" for j in range(k + 1, size))
