"""Determinants of matrices of products.

>>> from ..formula.to_text import text
>>> a, b, c, d = map(Product.symbol, "abcd")
>>> text(determinant([[a, b], [c, d]]).formula())
'a*d - b*c'
"""

from collections.abc import Sequence
from functools import cache

from .product import ONE, Product
from .sums import add


def determinant(matrix: Sequence[Sequence[Product]]) -> Product:
    """Return a determinant by expansion along rows, each minor computed once."""

    @cache
    def minor(row: int, columns: tuple[int, ...]) -> Product:
        if not columns:
            return ONE
        return add(
            (matrix[row][c] * minor(row + 1, columns[:i] + columns[i + 1 :])).scaled((-1) ** i)
            for i, c in enumerate(columns)
            if matrix[row][c]
        )

    return minor(0, tuple(range(len(matrix))))
