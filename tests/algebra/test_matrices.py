"""Determinants of products, and Cramer's rule with them."""

from mechc.algebra.matrices import determinant, with_column
from mechc.algebra.product import Product
from mechc.algebra.sums import add


def test_a_determinant_of_two_rows_is_the_difference_of_two_products():
    a, b, c, d = (Product.symbol(name) for name in "abcd")
    assert determinant([[a, b], [c, d]]) == add([a * d, -(b * c)])


def test_one_column_is_replaced_and_the_others_stay():
    rows = [[Product.symbol(f"{name}{i}") for i in range(3)] for name in "abc"]
    column = [Product.symbol(name) for name in "xyz"]
    for place in range(3):
        found = with_column(rows, place, column)
        others = [i for i in range(3) if i != place]
        assert [row[place] for row in found] == column
        assert all(found[i][j] is rows[i][j] for i in range(3) for j in others)
        assert {len(row) for row in found} == {3}
