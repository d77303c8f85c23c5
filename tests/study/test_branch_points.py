"""Branch points, at which a loop "can go on in two ways", against the loop equations themselves."""

import tempfile
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pytest

import mechc
from branchings import Flat, dyad, folding, four_bar, refuted, slider_crank, toggle, ways_on
from mechc.api import SolvedMechanism
from mechc.base.frozen import replace
from mechc.diagnostics import MechcError
from mechc.study.stroke.extrema import parted
from mechc.study.stroke.stroke import ZeroInterval
from other_kinds import other, put_toggle
from stroke_statements import zero_throughout


def hold(flats: Iterable[tuple[Flat, Path | None]]) -> tuple[int, int]:
    """Try every branch point that is stated, and that none is left out; return both numbers."""
    strokes = tried = 0
    for flat, folder in flats:
        try:
            mechanism = loaded(flat.text, folder)
            stroke = mechanism.stroke(3)
        except MechcError as error:
            if {d.code for d in error.diagnostics if d.code[0] == "E"} != {"E343"}:
                raise
            continue
        assert list(zero_throughout(mechanism, stroke)) == [], flat.text
        assert list(refuted(flat, mechanism, stroke)) == [], flat.text
        tried += len(stroke.branches)
        strokes += 1
    return strokes, tried


def loaded(text: str, folder: Path | None) -> SolvedMechanism:
    """Compile a text, from a folder if it uses what is there."""
    if folder is None:
        return mechc.loads(text)
    path = folder / "press.mech"
    path.write_text(text, "utf-8")
    return mechc.load(path)


def joined(seeds: range):
    with tempfile.TemporaryDirectory() as name:
        put_toggle(Path(name))
        yield from ((toggle(other("joined", seed)), Path(name)) for seed in seeds)


def test_a_loop_that_lies_flat_goes_on_in_two_ways():
    assert hold((folding(seed), None) for seed in range(12)) == (12, 12)
    kinds = {folding(seed).equations.__qualname__.split(".")[0] for seed in range(12)}
    assert kinds == {kind.__name__ for kind in (dyad, four_bar, slider_crank)}


def test_a_toggle_that_folds_goes_on_in_two_ways():
    assert hold(joined(range(95000033, 95000038))) == (5, 2)


def test_a_zero_that_is_none_would_be_seen():
    mechanism = mechc.loads(four_bar_of(100).text)
    stroke = mechanism.stroke(3)
    (part,) = stroke.stretches
    false = ZeroInterval("k", part.low, part.high)
    assert list(zero_throughout(mechanism, replace(stroke, zero_intervals=(false,))))


def test_at_the_end_of_a_loop_it_does_not():
    """A four-bar linkage comes to its end where rod and rocker are straight: no second way."""
    flat = four_bar_of(100)
    mechanism = mechc.loads(flat.text)
    stroke = mechanism.stroke(3)
    assert not stroke.branches
    (end,) = (s.high for s in stroke.stretches)
    place, _ = mechanism.points(phi=end - 1e-9)
    pose = np.array([*(1000 * place[f"{c}_{q}"] for q in "AB" for c in "xy"), end])
    assert ways_on(flat.equations, pose) is None


def test_a_loop_that_closes_at_one_pose_alone_has_no_way_on():
    """B is reached where A is nearest to C, and nowhere else."""
    flat = four_bar_of(70)  # |AC| is 70 mm at least, at phi = 0, and b + c is 70 mm
    assert ways_on(flat.equations, np.array([30.0, 0, 60, 0, 0])) == 0


def four_bar_of(both: int) -> Flat:
    """Return a four-bar linkage whose rod and rocker are so long together, half each but for 5."""
    a, d, b = 30, 100, both // 2 - 5
    c = both - b
    text = (
        "param phi = 20 deg\ndrive phi from 10 deg to 120 deg\n"
        f"pivot O at (0 mm, 0 mm)\npivot C at ({d} mm, 0 mm)\nlink OA\nlink AB\nlink CB\n"
        f"OA = {a} mm @ phi\nAB = {b} mm\nCB = {c} mm\nassembly ABC cw\n"
        "torque M on OA\ntorque F on CB\nfind k = M/F\n"
    )

    def equations(z: np.ndarray) -> np.ndarray:
        ax, ay, bx, by, phi = z
        gaps = ax - a * np.cos(phi), ay - a * np.sin(phi)
        return np.array([*gaps, np.hypot(bx - ax, by - ay) - b, np.hypot(bx - d, by) - c])

    return Flat(text, ("A", "B"), equations, None)


@pytest.mark.slow
def test_many_loops_that_lie_flat():
    assert hold((folding(seed), None) for seed in range(12, 72)) == (60, 60)


@pytest.mark.slow
def test_many_toggles_that_fold():
    strokes, tried = hold(joined(range(95001000, 95001050)))
    assert strokes > 35
    assert tried > 2


def test_beside_a_branch_point_rounding_makes_no_extrema():
    """k falls from -0.00645564 m on; a millionth of a radian from the branch it was least."""
    stroke = mechc.loads(folding(98030056).text).stroke(3)
    (branch,) = stroke.branches
    assert not [e for e in stroke.extrema if abs(e.drive - branch.drive) < 1e-3]


def test_up_to_a_branch_point_a_result_is_no_greatest_at_the_last_place_looked_at():
    """k rises from 47.3088 mm at 139.972 to 47.3175 at 140 deg, and is 0.3861 and rises beyond."""
    stroke = mechc.loads(folding(103001836).text).stroke(3)
    assert stroke.branches
    assert not stroke.extrema


def test_where_a_result_passes_zero_on_its_way_over_a_jump_it_has_no_zero():
    """k is 11.3 mm up to the branch point and -35.3 beyond: 0 for 3e-8 of a radian of rounding."""
    (jump,) = mechc.loads(folding(103002078).text).stroke(3).singular
    assert (jump.value, jump.kind) == ("undetermined", "jump")


def test_parts_between_breaks_end_where_rounding_is_small():
    grid = [0.0, 1.0, 2.0, 3.0, 4.0]
    assert [*parted(grid, {})] == [[0, 0.01, *grid[1:-1], 3.99, 4]]
    first, second = parted(grid, {2.0: 0.125, 9.0: 0.125})
    assert first == pytest.approx([0, 0.01, 1, 1.86625, 1.875])
    assert second == pytest.approx([2.125, 2.13375, 3, 3.99, 4])
    ((low, *_, high),) = parted(grid, {0.0625: 0.125, 4.0: 1e-8})
    assert (low, high) == (0.1875, 4.0 - 1e-8)
