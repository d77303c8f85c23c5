"""Standstills, efficiencies and dead centres along strokes of random mechanisms, against code."""

from collections.abc import Iterable

import pytest

import mechc
from friction_mechanisms import small_closed
from grown import Grown, wide
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.source import Source
from mechc.study.analysis import DeadCentre
from mechc.study.stroke.stroke import Singular
from small_mechanisms import slider_crank
from stroke_statements import moving, refuted


def hold(seeds: Iterable[int]) -> int:
    """Try what is stated of strokes with friction; return how many standstills there are."""
    found = 0
    for seed in seeds:
        compilation = Compilation(Source("small.mech", small_closed(seed)))
        try:
            stroke = compilation.stroke(3)
        except MechcError as error:
            if {d.code for d in error.diagnostics} & {"E601", "E817"}:
                raise
            continue
        assert list(refuted(compilation, stroke)) == [], seed
        found += len(stroke.standstills)
    return found


def centres(seeds: Iterable[int]) -> int:
    """Try which dead centres along strokes are of which kind; return how many there are."""
    found = 0
    for seed in seeds:
        mechanism = mechc.loads(wide(Grown(seed)))
        stroke = mechanism.stroke(3)
        assert list(moving(mechanism, stroke)) == [], seed
        found += sum(isinstance(s.kind, DeadCentre) for s in stroke.singular)
    return found


CRANK = slider_crank(
    "friction pins 0.12 diameter 20 mm", "find k = M/F", drive="from 10 deg to 200 deg"
)


def test_the_sampler_refutes_what_is_false_along_a_stroke():
    mechanism, compilation = mechc.loads(CRANK), Compilation(Source("crank.mech", CRANK))
    stroke = compilation.stroke(3)
    assert stroke.standstills
    assert list(refuted(compilation, stroke)) == list(moving(mechanism, stroke)) == []
    assert list(refuted(compilation, replace(stroke, standstills=())))
    singular = tuple(map(turned_round, stroke.singular))
    assert singular != stroke.singular
    assert list(moving(mechanism, replace(stroke, singular=singular)))


def turned_round(pose: Singular) -> Singular:
    """Return a dead centre at which what moves is said to stand still."""
    kind = pose.kind
    is_dead = isinstance(kind, DeadCentre)
    return pose._replace(kind=DeadCentre(kind.moving, kind.still)) if is_dead else pose


@pytest.mark.slow
def test_what_is_said_along_a_stroke_with_friction():
    assert hold([80160009]) == 1


@pytest.mark.slow
def test_what_is_said_along_many_strokes_with_friction():
    assert hold(range(80160000, 80160012)) > 4


@pytest.mark.slow
def test_what_stands_still_along_many_strokes():
    assert centres(seed for seed in range(20) if "triad" not in Grown(seed).kinds) > 5
