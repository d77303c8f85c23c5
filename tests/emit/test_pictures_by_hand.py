"""A drawing of a few shapes as SVG and as TikZ: where each is, how it looks, and its letters."""

import math
import re

import pytest

from mechc.drawing.drawing import Arc, Drawing, Label, Polyline, TextRun
from mechc.drawing.pens import AXIS, BODY, FORCE, SYMBOL
from mechc.emit.svg.picture import to_svg
from mechc.emit.tikz.picture import mathematics, tikzpicture, to_tikz
from mechc.pose.places import Plane

BAR = Polyline((Plane(-4.0, 1.0), Plane(6.0, 3.5)), BODY)
PLATE = Polyline((Plane(0.0, 0.0), Plane(2.0, 0.0), Plane(0.0, 1.0)), SYMBOL, True, "light")
DOTTED = Polyline((Plane(0.0, 0.0), Plane(0.0, 5.0)), AXIS)
RING = Arc(Plane(1.0, 2.0), 0.5, SYMBOL, fill="white")
QUARTER = Arc(Plane(1.0, 2.0), 2.0, FORCE, 0.0, math.pi / 2)
BACK = QUARTER._replace(sweep=-math.pi / 2)


def drawn(*shapes, labels=()):
    """Return a drawing on paper from 5 left of and 1 below the origin to 7 and 6 beyond it."""
    low, high = Plane(-5.0, -1.0), Plane(7.0, 6.0)
    return Drawing("A <b>", "Bar & ring", shapes, tuple(labels), low, high)


def paths(drawing):
    return re.findall(r'<path d="([^"]*)"([^/]*)/>', to_svg(drawing))


@pytest.mark.parametrize(
    ("shape", "way", "look"),
    [
        (BAR, "M1 5 11 2.5", ' stroke="#000000" stroke-width=".7"'),
        (PLATE, "M5 6 7 6 5 5Z", ' fill="#e8edf2" stroke="#000000" stroke-width=".35"'),
        (
            DOTTED,
            "M5 6 5 1",
            ' stroke="#777777" stroke-width=".18" stroke-dasharray="3 .8 .4 .8"',
        ),
        (
            RING,
            "M6.5 4A.5 .5 0 0 0 5.5 4A.5 .5 0 0 0 6.5 4Z",
            ' fill="#fff" stroke="#000000" stroke-width=".35"',
        ),
        (
            QUARTER,
            "M8 4A2 2 0 0 0 7.41 2.59A2 2 0 0 0 6 2",
            ' stroke="#b00020" stroke-width=".5"',
        ),
        (BACK, "M8 4A2 2 0 0 1 7.41 5.41A2 2 0 0 1 6 6", ' stroke="#b00020" stroke-width=".5"'),
    ],
)
def test_svg_counts_from_the_upper_left_corner_downwards(shape, way, look):
    assert paths(drawn(shape)) == [(way, look)]


def test_shapes_that_look_alike_are_one_path_and_keep_their_order():
    other = BAR._replace(points=(Plane(-5.0, 6.0), Plane(7.0, -1.0)))
    found = [way for way, _ in paths(drawn(BAR, other, RING, BAR))]
    assert found[0] == "M1 5 11 2.5M0 0 12 7"
    assert (len(found), found[2]) == (3, "M1 5 11 2.5")


def test_a_picture_is_as_large_as_its_paper_and_says_what_it_shows():
    text = to_svg(drawn(BAR))
    assert 'width="12mm" height="7mm" viewBox="0 0 12 7"' in text
    assert "<title>A &lt;b&gt;</title>\n<desc>Bar &amp; ring</desc>" in text


def label(*runs, pen=SYMBOL):
    return Label(Plane(1.0, 2.0), runs, pen, 4.0, 3.0, 4.0)


def test_the_foot_of_a_letter_is_below_its_middle_and_an_index_below_that():
    runs = TextRun("F", italic=True), TextRun("A", level=-1), TextRun("2", level=1), TextRun(" < 1")
    (text,) = re.findall("<text.*</text>", to_svg(drawn(labels=[label(*runs, pen=FORCE)])))
    assert text.startswith('<text x="6" y="5.28" font-size="4" fill="#b00020">')
    assert re.findall(r"<tspan([^>]*)>([^<]*)<", text) == [
        (' font-style="italic"', "F"),
        (' font-size="2.8" dy=".88"', "A"),
        (' font-size="2.8" dy="-2.4"', "2"),
        (' dy="1.52"', " &lt; 1"),
    ]


@pytest.mark.parametrize(
    ("shape", "path"),
    [
        (BAR, r"\path[body, draw] (-4,1) -- (6,3.5);"),
        (PLATE, r"\path[symbol, draw, fill=mechctint] (0,0) -- (2,0) -- (0,1) -- cycle;"),
        (RING, r"\path[symbol, draw, fill=white] (1,2) circle[radius=0.5];"),
        (QUARTER, r"\path[force, draw] (3,2) arc[start angle=0, end angle=90, radius=2];"),
        (BACK, r"\path[force, draw] (3,2) arc[start angle=0, end angle=-90, radius=2];"),
    ],
)
def test_tikz_draws_in_millimetres_from_the_origin(shape, path):
    _, _, paper, found, end = tikzpicture(drawn(shape))
    assert (paper, found) == (r"\path (-5,-1) rectangle (7,6);", path)
    assert end == r"\end{tikzpicture}"


@pytest.mark.parametrize(
    ("runs", "tex"),
    [
        ((TextRun("F", italic=True), TextRun("A", level=-1)), r"\mathit{F}_{\mathrm{A}}"),
        (
            (TextRun("x", italic=True), TextRun("B", level=-1), TextRun("1", level=-2)),
            r"\mathit{x}_{\mathrm{B}_{1}}",
        ),
        ((TextRun("10"), TextRun("−3", level=1)), "10^{{-}3}"),
        (
            (TextRun("α", italic=True), TextRun("=", level=0), TextRun("2,5°")),
            r"\alpha {=}2{,}5^{\circ}",
        ),
        ((TextRun("50%"),), r"50\text{\%}"),
    ],
)
def test_letters_become_mathematics(runs, tex):
    assert mathematics(runs) == tex


def test_fonts_for_cyrillic_letters_are_asked_for_where_there_are_any():
    assert "fontenc" not in to_tikz(drawn(labels=[label(TextRun("N"))]))
    assert "fontenc" in to_tikz(drawn(labels=[label(TextRun("Н"))]))
