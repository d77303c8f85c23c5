"""Determinants of matrices of products.

>>> from ..formula.to_text import text
>>> a, b, c, d = map(Product.symbol, "abcd")
>>> text(determinant([[a, b], [c, d]]).formula())
'a*d - b*c'
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import combinations, permutations

from ..formula.operations import count_operations
from .product import ONE, Product
from .sums import add, shortest

ProductMatrix = Sequence[Sequence[Product]]


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
