"""What every plan promises, on whole mechanisms; and that a broken promise is named."""

import pytest

from good_mechanisms import ALL, begun
from mechanisms import sample
from mechc.algebra.product import ONE
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.kinematics.promises import broken_promises
from mechc.kinematics.readable import readable_plan
from mechc.source import Source
from small_poses import (
    RACK,
    SCREW,
    driven_slider,
    lever,
    on_pivots,
    plan,
    slider_crank,
    slotted,
    two_bars,
    wheels,
)


@pytest.mark.parametrize("name", ALL)
def test_promises_are_kept(name):
    plan = begun(name).plan
    assert broken_promises(plan) == []
    assert broken_promises(readable_plan(plan)) == []


@pytest.mark.parametrize("seed", range(20))
def test_promises_are_kept_of_what_is_grown(seed):
    assert broken_promises(Compilation(Source("grown.mech", sample(seed).text)).plan) == []


SMALL = {
    "lever": lever(),
    "slider-crank": slider_crank(),
    "toggle": two_bars(),
    "gears": on_pivots(wheels()),
    "slot": slotted(),
    "rack": driven_slider(RACK),
    "screw": driven_slider(SCREW),
}


@pytest.mark.parametrize("name", SMALL)
def test_plans_of_poses_by_hand_keep_them(name):
    assert broken_promises(plan(SMALL[name])) == []


def test_an_unknown_that_nothing_finds_is_seen():
    found = plan(slider_crank())
    assert broken_promises(replace(found, blocks=())) == [
        "unknown 1 is found 0 times",
        "relation 0 is used 0 times",
    ]


def test_a_step_before_what_it_needs_is_seen():
    found = plan(slotted())
    assert found.blocks
    late = replace(found, drives=(), blocks=found.blocks)
    assert any("too early" in sentence for sentence in broken_promises(late))


def test_a_speed_that_breaks_its_relation_is_seen():
    found = plan(slider_crank())
    (drive,) = found.drives
    (other,) = found.speeds.keys() - {drive}
    wrong = {drive: (ONE,), other: (-found.speeds[other][0],)}
    assert broken_promises(replace(found, speeds=wrong)) == [
        "the projection of AB AB does not hold",
        "AB stretches from A to B",
    ]


def test_a_drive_of_another_size_is_seen():
    found = plan(slider_crank())
    (drive,) = found.drives
    speeds = {**found.speeds, drive: (-ONE,)}
    assert broken_promises(replace(found, speeds=speeds))[0] == (
        f"the speed of drive {drive} is not its own unit"
    )


def test_a_slider_beside_its_guide_is_seen():
    found = plan(slider_crank())
    velocities = {**found.graph.velocities, "B": found.graph.velocities["A"]}
    moved = replace(found, graph=replace(found.graph, velocities=velocities))
    assert broken_promises(moved) == ["B leaves its guide"]


def test_a_pivot_that_moves_is_seen():
    found = plan(lever())
    velocities = {**found.graph.velocities, "O": found.graph.velocities["A"]}
    moved = replace(found, graph=replace(found.graph, velocities=velocities))
    assert "pivot O moves" in broken_promises(moved)
