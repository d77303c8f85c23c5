"""Matrices of products: determinants, and ranks for independent symbols or at one numeric pose.

Rows are sparse where a rank is asked for: column → entry.

>>> from ..formula.to_text import text
>>> a, b, c, d = map(Product.symbol, "abcd")
>>> text(determinant([[a, b], [c, d]]).formula())
'a*d - b*c'
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from itertools import combinations, permutations

from ..formula.operations import count_operations
from .modular import PRIME, ModularPoint
from .product import ONE, Product
from .sums import add, shortest
from .tolerances import DEPENDENT

ProductMatrix = Sequence[Sequence[Product]]
Residues = dict[int, int]
"""Entries of a row at a random point of a finite field, those that are not zero."""


def determinant(matrix: ProductMatrix) -> Product:
    """Return a determinant by expansion along rows, each minor computed once."""
    return _expanded(matrix, add)


def with_column(matrix: ProductMatrix, place: int, column: Sequence[Product]) -> ProductMatrix:
    """Return a matrix with one column replaced, as Cramer's rule takes it."""
    rows = zip(matrix, column, strict=True)
    return [[*row[:place], value, *row[place + 1 :]] for row, value in rows]


def shortest_determinant(matrix: ProductMatrix) -> Product:
    """Return a determinant as it is shortest to read, of all orders of its rows and columns.

    >>> from ..formula.to_text import text
    >>> from .angle import Angle
    >>> from .trigonometry import cosine, sine
    >>> a, b, c, d = (sine(Angle.of(n)) for n in "abcd")
    >>> text(shortest_determinant([[a, b], [c, d]]).formula())
    'sin(a)*sin(d) - sin(b)*sin(c)'
    """
    forms = (_expanded(ordered, shortest).scaled(sign) for ordered, sign in _orders(matrix))
    return min(forms, key=lambda form: count_operations(form.formula()))


def _orders(matrix: ProductMatrix) -> Iterator[tuple[ProductMatrix, int]]:
    """Yield a matrix with its rows, or its columns, in every order, and the sign of that."""
    for turned in (matrix, list(zip(*matrix, strict=True))):
        for order in permutations(range(len(matrix))):
            swaps = sum(a > b for a, b in combinations(order, 2))
            yield [turned[i] for i in order], (-1) ** swaps


def _expanded(matrix: ProductMatrix, added: Callable[[Iterable[Product]], Product]) -> Product:
    """Return a determinant by its minors, each of which is found once."""

    @cache
    def minor(row: int, columns: tuple[int, ...]) -> Product:
        if not columns:
            return ONE
        return added(
            (matrix[row][c] * minor(row + 1, columns[:i] + columns[i + 1 :])).scaled((-1) ** i)
            for i, c in enumerate(columns)
            if matrix[row][c]
        )

    return minor(0, tuple(range(len(matrix))))


def residues(row: Mapping[int, Product], point: ModularPoint) -> Residues:
    """Return the entries of a row at a random point of a finite field."""
    values = {u: p.residue(point) for u, p in row.items()}
    return {u: v for u, v in values.items() if v}


class Echelon:
    """Rows of a matrix over the field, reduced as they come; a column is named by a number."""

    def __init__(self) -> None:
        self._rows: dict[int, Residues] = {}

    @property
    def pivots(self) -> frozenset[int]:
        """Return the columns that the rows so far determine."""
        return frozenset(self._rows)

    def take(self, row: Residues) -> bool:
        """Take a row in; False if it follows from the earlier ones."""
        rest = self._reduced(row)
        if not rest:
            return False
        pivot = min(rest)
        inverse = pow(rest[pivot], -1, PRIME)
        self._rows[pivot] = {u: v * inverse % PRIME for u, v in rest.items()}
        return True

    def _reduced(self, row: Residues) -> Residues:
        """Return a row without the pivots of the rows so far."""
        rest = dict(row)
        while pivots := [u for u in rest if u in self._rows]:
            pivot = min(pivots)
            factor = rest[pivot]
            for u, v in self._rows[pivot].items():
                value = (rest.get(u, 0) - factor * v) % PRIME
                if value:
                    rest[u] = value
                else:
                    rest.pop(u, None)
        return rest


def independent(rows: Iterable[Residues]) -> list[bool]:
    """Return for each row whether it is independent of those before it."""
    echelon = Echelon()
    return [echelon.take(row) for row in rows]


def independent_of(rows: Sequence[Mapping[int, Product]]) -> list[bool]:
    """Return which rows of products are independent of those before; a single one if not zero."""
    point = ModularPoint()
    if len(rows) == 1:
        return [any(entry.residue(point) for entry in rows[0].values())]
    return independent(residues(row, point) for row in rows)


def numeric_rank(rows: Sequence[Mapping[int, float]], scaled: bool = True) -> int:
    """Return the rank of a numeric matrix by elimination with complete pivoting.

    A pivot below :data:`~.tolerances.DEPENDENT` counts as zero. Rows are scaled to a largest
    entry of 1 first, unless they are ``scaled`` otherwise already (then say False).
    """
    rest = [_normalised(row) for row in rows] if scaled else [dict(row) for row in rows]
    rank = 0
    while True:
        best = max(((abs(v), i, u) for i, r in enumerate(rest) for u, v in r.items()), default=None)
        if best is None or best[0] < DEPENDENT:
            return rank
        _, index, column = best
        pivot = rest.pop(index)
        rest = [_eliminated(row, pivot, column) for row in rest]
        rank += 1


def _normalised(row: Mapping[int, float]) -> dict[int, float]:
    size = max(map(abs, row.values()), default=0.0) or 1.0
    return {u: v / size for u, v in row.items()}


def _eliminated(
    row: Mapping[int, float], pivot: Mapping[int, float], column: int
) -> dict[int, float]:
    factor = row.get(column, 0.0) / pivot[column]
    if not factor:
        return dict(row)
    columns = row.keys() | pivot.keys()
    return {u: row.get(u, 0.0) - factor * pivot.get(u, 0.0) for u in columns if u != column}
