"""The stretches of a stroke on which there is a pose, by where there is none."""

from types import SimpleNamespace

import pytest

from mechc.study.stroke.stretches import stretches_of

GRID = [i / 8 for i in range(9)]


def run(*gaps):
    """Return a stroke from 0 to 1 that breaks a condition of use within some gaps."""
    return SimpleNamespace(
        grid=GRID,
        range=1.0,
        branches=[],
        along=SimpleNamespace(
            trouble=lambda x: "require" if any(low < x < high for low, high in gaps) else ""
        ),
    )


@pytest.mark.parametrize(
    ("gaps", "ends"),
    [
        ([], [(0, 1)]),
        ([(-1, 2)], []),
        ([(0.3, 0.45)], [(0, 0.3), (0.45, 1)]),
        ([(-1, 0.3)], [(0.3, 1)]),
        ([(0.7, 2)], [(0, 0.7)]),
        ([(-1, 0.2), (0.7, 2)], [(0.2, 0.7)]),
        ([(0.2, 0.3), (0.6, 0.8)], [(0, 0.2), (0.3, 0.6), (0.8, 1)]),
    ],
)
def test_a_stretch_goes_from_one_gap_to_the_next(gaps, ends):
    found, crossings = stretches_of(run(*gaps))
    assert [(s.low, s.high) for s in found] == [pytest.approx(end, abs=1e-9) for end in ends]
    assert not crossings


def test_a_stretch_says_why_it_ends_where_the_stroke_goes_on():
    (first, second), _ = stretches_of(run((0.3, 0.45)))
    said = [(s.before, s.after) for s in (first, second)]
    assert said == [("", "require"), ("require", "")]
