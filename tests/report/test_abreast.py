"""Equations and tables two abreast, so that a long report has few pages."""

import pytest

from good_mechanisms import compiled
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.report.latex.display import TWO_EQUATIONS_WIDTH, aligned

HALF = TWO_EQUATIONS_WIDTH / 2 - 1


def text(name: str, language: str = "en") -> str:
    (emitted,) = TARGET.emit(compiled(name), Options("page", language=language))
    return emitted.text


def test_equations_are_paired_where_both_columns_fit():
    lines = [("a&=b", HALF), ("c&=d", HALF), ("e&=f", HALF), ("g&=h", HALF + 5), ("i&=j", 3.0)]
    assert aligned(lines).split("\n\\end{align*}\n\\begin{align*}\n") == [
        "\\begin{align*}\na&=b&\nc&=d",
        "e&=f",
        "g&=h&\ni&=j\n\\end{align*}",
    ]


def test_what_takes_a_line_stays_alone():
    assert aligned([("a&=b", TWO_EQUATIONS_WIDTH), ("c&=d", 1.0)]) == (
        "\\begin{align*}\na&=b\\\\[2pt]\nc&=d\n\\end{align*}"
    )


@pytest.mark.parametrize(
    ("language", "place"),
    [("en", "(x_Z,y_Z)"), ("uk", r"(x_Z;\ y_Z)"), ("ru", r"(x_Z;\ y_Z)")],
)
def test_a_long_table_of_vectors_stands_two_abreast(language, place):
    assert f"$Z$ & ${place}$ &  & $ZD$ &" in text("jansen_leg", language)


def test_of_many_values_those_of_the_position_come_in_a_line():
    values = text("jansen_leg").partition(r"\section*{Numerical values}")[2]
    assert r"$\mu_C=47.9149^\circ$, $\gamma_B=" in values
    assert r"i_{ZBC}&=\frac{15}{41.5}\cdot" in values
    few = text("crank_rocker").partition(r"\section*{Numerical values}")[2]
    assert r"\mu_B&=\arccos" in few
