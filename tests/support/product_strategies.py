"""Random products of letters, sines and cosines, with values of their letters."""

from fractions import Fraction

from hypothesis import strategies as st

from mechc.algebra.angle import Angle
from mechc.algebra.product import Product
from mechc.algebra.trigonometry import cosine, sine

CONSTANTS = [0, 0, 0, 90, 180, 45, 30, -60, 40, 80, Fraction("12.3456789")]


VALUES = {"alpha": 0.41, "beta": -0.83, "gamma": 1.27, "a": 1.3, "b": 0.7, "c": 2.1}


@st.composite
def angles(draw, constants=CONSTANTS):
    names = draw(st.lists(st.sampled_from(["alpha", "beta", "gamma"]), max_size=2, unique=True))
    angle = Angle.constant(draw(st.sampled_from(constants)))
    for name in names:
        angle = angle + Angle.of(name) * draw(st.sampled_from([1, 1, -1, 2, -2, Fraction(1, 2)]))
    return angle


@st.composite
def products(draw, constants=CONSTANTS, trigs=2):
    result = Product(draw(st.sampled_from([1, 1, -1, 2, -3, Fraction(1, 2), Fraction(-2, 3)])))
    for name in draw(st.lists(st.sampled_from("abc"), max_size=2)):
        result = result * Product.symbol(name)
    for angle in draw(st.lists(angles(constants), max_size=trigs)):
        result = result * draw(st.sampled_from([sine, cosine]))(angle)
    return result
