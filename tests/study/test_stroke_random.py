"""What a stroke says of random closed mechanisms, against dense sampling of emitted code."""

from functools import lru_cache

import pytest

from grown import Grown, wide
from hunted import Hunted, Made, made
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.report.text.stroke import to_table
from mechc.source import Source
from mechc.study.stroke.stroke import Stroke
from other_kinds import of_two_lengths
from stroke_curves import Curve, changes_of_sign, curves, refuted


def compiled(seed: int) -> Compilation:
    """Return a grown mechanism whose stroke goes beyond what the loops allow."""
    return Compilation(Source("grown.mech", wide(Grown(seed))))


@lru_cache(maxsize=4)
def along(seed: int) -> tuple[Compilation, Stroke]:
    """Return a grown mechanism with its stroke, once for what looks at it in turn."""
    compilation = compiled(seed)
    return compilation, compilation.stroke(3)


def curve(seed: int) -> Curve:
    (found,) = curves(*along(seed))
    return found


def sweep(seeds) -> int:
    """Check the strokes of mechanisms whose closures the lines tell apart; return how many."""
    number = 0
    for seed in seeds:
        try:
            compilation, stroke = along(seed)
        except MechcError as error:
            if {d.code for d in error.diagnostics if d.code[0] == "E"} != {"E308"}:
                raise
            continue
        assert list(refuted(compilation, stroke)) == [], seed
        number += 1
    return number


def of_dyads(seeds):
    return [seed for seed in seeds if "triad" not in Grown(seed).kinds]


def of_triads(seeds):
    return [seed for seed in seeds if "triad" in Grown(seed).kinds]


def test_strokes_of_dyads():
    assert sweep(of_dyads(range(12))) > 5


def test_a_pole_at_the_end_of_a_loop_next_to_a_zero():
    """k = 0 at 1.2789034 rad, infinite at 1.2789103 rad, where the loop ends."""
    assert sweep([1083]) == 1
    *_, zero, pole = curve(1083).singular
    assert (zero.value, pole.value) == ("0", "infinite")


def test_where_a_length_is_infinite_k_jumps_and_has_neither_pole_nor_extremum():
    """At -0.9699 rad a guide is parallel to the slot of its pin; k is 0.024 before, 0.007 after."""
    assert sweep([1356, 70264, 70380]) == 3
    seen = curve(1356)
    assert [s.value for s in seen.singular if not s.sides] == ["0", "0"]
    assert [s.kind for s in seen.jumps] == ["far", "far"]
    assert seen.jumps[0].sides == pytest.approx((0.0241564, 0.00737336), rel=1e-5)
    assert "k jumps from 0.0241564 m to 0.00737336 m at phi = -0.96993" in to_table(seen.stroke)


@pytest.mark.slow
def test_a_load_that_works_against_nothing_has_no_singular_poses():
    """An actuator between two points of one plate: what k comes to is rounding."""
    assert sweep([70006]) == 1
    assert not along(70006)[1].extrema


@pytest.mark.slow
def test_a_way_past_a_place_where_branches_nearly_meet():
    """Of a triad code had no pose at one place in thirty, at which the stroke has one."""
    assert sweep([91000715]) == 1


@pytest.mark.slow
def test_triads_next_to_folds():
    """The last has a pose on 0.003 rad between others that have none, less than is looked at."""
    assert sweep([91000332, 92000358, 91000370]) == 3


@pytest.mark.slow
def test_many_strokes():
    assert sweep(of_dyads(range(12, 32))) > 6


@pytest.mark.slow
def test_strokes_of_triads():
    assert sweep(of_triads(range(10))) > 1


def changes_its_sign(seed: int) -> bool:
    k = curve(seed).k
    return bool((k[:-1] * k[1:] < 0).any())


def test_a_zero_that_is_left_out_would_be_seen():
    compilation = compiled(next(filter(changes_its_sign, of_dyads(range(12)))))
    stroke = replace(compilation.stroke(3), singular=())
    (seen,) = curves(compilation, stroke)
    assert list(changes_of_sign(seen))


@pytest.mark.parametrize("seed", [103001117, 104001391])
def test_what_is_said_to_be_zero_throughout_does_not_change_its_sign(seed, tmp_path):
    """A toggle that folds stands still on a third, or most, of its stroke, but for 1e-14."""
    text = of_two_lengths(made("joined", seed).text, tmp_path)
    found = Hunted(Made(text), seed, tmp_path)
    assert found.stroke.zero_intervals
    assert list(refuted(found.compilation, found.stroke)) == []
