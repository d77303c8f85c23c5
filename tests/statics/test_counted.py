"""The referee counts the pins with friction for itself, and misses one that was left out."""

from collections.abc import Mapping

import pytest

from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.pose.pose import Pose
from mechc.source import Source
from mechc.statics.counted import uncounted
from mechc.statics.poses import candidates
from mechc.statics.referee import cross_check
from mechc.statics.surfaces import pairs_of
from mechc.statics.unfold import Unfolding
from small_mechanisms import boom

BOOM = boom("friction pins 0.1 diameter 300 mm", "find k = P/T", "find R_G")


def compiled(text: str) -> Compilation:
    return Compilation(Source("counted.mech", text))


def missed(pose: Pose, values: Mapping[str, float]) -> list[str]:
    """Return the pins that a referee would miss friction at."""
    unfolding = Unfolding(pose, values)
    pairs = ((pair.on, pair.actions) for pair in pairs_of(unfolding))
    return sorted(uncounted(unfolding, pairs))


def without(compilation: Compilation, point: str) -> Pose:
    """Return the pose without the friction of one pin, as a fault would leave it out."""
    mechanism = compilation.pose.mechanism
    joints = tuple(r for r in mechanism.friction.joints if r.point != point)
    friction = replace(mechanism.friction, joints=joints)
    return replace(compilation.pose, mechanism=replace(mechanism, friction=friction))


@pytest.mark.parametrize(("point", "missing"), [("O", ["O on OC"]), ("C", ["C on OC", "C on GC"])])
def test_the_referee_misses_a_pin_without_friction(point, missing):
    compilation = compiled(BOOM)
    values = next(iter(candidates(compilation.pose, 1)))
    assert not missed(compilation.pose, values)
    pose = without(compilation, point)
    assert missed(pose, values) == sorted(missing)
    with pytest.raises(MechcError) as caught:
        cross_check(pose, compilation.solution.results, compilation.report)
    assert "E540" in {d.code for d in caught.value.diagnostics}


def test_a_pin_between_twins_is_counted():
    """K is no slider: its pin joins a rod and its twin, and stands by symmetry."""
    text = """
    pivot O
    link OB
    link BK
    OB = 100 mm @ 100 deg
    BK = 80 mm @ 40 deg
    mirror across y sharing K
    torque M on OB
    force F at K along -y
    friction pins 0.1 diameter 8 mm
    find k = M/F
    """
    compilation = compiled(text)
    assert compilation.verdict.agrees
    guided = compiled(text.replace("link OB", "slider K along y\nlink OB"))
    one, two = ({r.name: r.formula for r in c.solution.results} for c in (compilation, guided))
    assert one == two
    values = next(iter(candidates(compilation.pose, 1)))
    assert missed(without(compilation, "K"), values) == ["K on BK", "K on BK'"]
