"""Parallelograms of any frame: one direction is another one, and the other vector joins points.

They stay what they are on either side of the pose in which all of them lies flat, where the
law of cosines would go over to the crossed four-bar.
"""

import math
import random

import pytest

from mechc.compilation import Compilation
from mechc.formula.to_text import text
from mechc.model.values import completed, defaults
from mechc.power.numbers import value_of
from mechc.source import Source

TEXT = """
param phi = {start} deg
{params}
pivot O at (0 mm, 0 mm)
pivot Q at ({x} mm, {y} mm)
link OA
link QBD
link AB
OA = {crank} @ phi
QB = {rocker}
AB = {coupler}
QD = 700 mm @ QB
assembly ABQ {turn}
{drive}
torque M on OA
force F at D along {load} deg
find k = M/F
"""


def parallelogram(seed, named, drive=""):
    """Return a description, and by how many degrees the frame is ahead of the crank."""
    rng = random.Random(seed)
    x, y = rng.choice([(300, 400), (-300, 400), (120, -50), (-80, -150), (0, 260), (240, 0)])
    frame = math.degrees(math.atan2(y, x))
    start = round(rng.uniform(-170, 170))
    ahead = math.remainder(frame - start, 360)
    coupler = round(math.hypot(x, y))
    text = TEXT.format(
        start=start,
        params="param c = 200 mm in 100 mm .. 300 mm" if named else "",
        crank="c" if named else "200 mm",
        rocker="c" if named else "200 mm",
        coupler=f"{coupler} mm",
        turn="ccw" if ahead > 0 else "cw",
        load=rng.randrange(-180, 180),
        drive=drive,
        x=x,
        y=y,
    )
    return text, ahead, (x / 1000, y / 1000)


@pytest.mark.parametrize("named", [False, True])
@pytest.mark.parametrize("seed", range(12))
def test_a_parallelogram_stays_one_beyond_its_flat_pose(seed, named):
    described, ahead, frame = parallelogram(seed, named)
    compilation = Compilation(Source("m.mech", described))
    pose, (result,) = compilation.pose, compilation.solution.results
    assert compilation.verdict.agrees
    start = defaults(pose.mechanism)
    load = math.radians(float(described.rpartition("along ")[2].split()[0]))
    for turn in (0.0, 0.4, -0.4, 1.2, 2 * math.radians(ahead)):
        values = completed({**start, "phi": start["phi"] + turn}, pose.definitions)
        (coupler,) = pose.vector("AB", "A", "B")
        along = coupler.angle.evaluate(values)
        assert math.remainder(along - math.atan2(*frame[::-1]), math.tau) == pytest.approx(0)
        expected = -0.7 * math.sin(load - values["phi"])  # D moves across QD, which is along OA
        assert value_of(result, values) == pytest.approx(expected, abs=1e-9)


def test_where_it_lies_flat_it_can_go_on_in_two_ways():
    """The frame is at 180° less arctg(4/3), where the crank lies along it."""
    described, _, frame = parallelogram(4, False, "drive phi from 0 deg to 179 deg")
    stroke = Compilation(Source("m.mech", described)).stroke(7)
    flat = math.atan2(*frame[::-1])
    (branch,) = stroke.branches
    assert branch.drive == pytest.approx(flat)


def test_one_that_lies_nearly_flat_is_one():
    """Poses on either side of the flat one are looked at: the law of cosines crosses beyond."""
    described, ahead, _ = parallelogram(4, False)
    start = int(described.split("phi = ")[1].split()[0])
    near = described.replace(
        f"phi = {start} deg", f"phi = {start + ahead - math.copysign(0.3, ahead)} deg"
    )
    pose = Compilation(Source("m.mech", near)).pose
    assert [text(d.formula) for d in pose.definitions] == ["atan2(y_Q, x_Q)"]


ISOSCELES = """
param r = 50 mm
param phi = {start} deg
pivot O at (0 mm, 0 mm)
link OA
link AB
OA = r @ phi
AB = r
slider B along x through O
assembly B {ahead}
drive phi from 50 deg to 130 deg
torque M on OA
force F at B along x
find k = M/F
"""


@pytest.mark.parametrize(("start", "ahead"), [(60, "forward"), (89.3, "forward"), (90.5, "back")])
@pytest.mark.parametrize("step", [1, -1])
def test_an_isosceles_slider_crank_is_one_near_its_pose_at_the_crank(start, ahead, step):
    """At 90° the motion meets another one, in which the slider rests at O, and the rod turns.

    The slider is ahead of O in the one until 90°, in the other from there on; whatever stands
    first in the description, the one that is meant by default goes on.
    """
    lines = ISOSCELES.format(start=start, ahead=ahead).strip().splitlines()
    compilation = Compilation(Source("m.mech", "\n".join(lines[::step])))
    (result,) = compilation.solution.results
    assert text(result.formula) == "2*r*sin(phi)"
    assert compilation.verdict.agrees


KITE = """
param phi = 50 deg in 20 deg .. 80 deg
pivot O at (0, 0)
slider S along y through O
link OA
link OB
link AS
link BS
OA = 200 mm @ phi
OB = 200 mm @ 180 deg - phi
AS = 320 mm
BS = 320 mm
assembly S forward
force P at S along -y
force F at A along y
force F2 = F at B along y
find k = P/F
"""


def test_a_rod_mirrors_the_one_that_hangs_on_the_same_pin():
    """Both arms are equal by number alone, and neither stands in k: there is one such ratio."""
    compilation = Compilation(Source("m.mech", KITE))
    assert [d.name for d in compilation.pose.definitions] == ["beta_AS"]
    (result,) = compilation.solution.results
    assert text(result.formula) == "2*cos(beta_AS)*cos(phi)/cos(beta_AS - phi)"
    assert compilation.verdict.agrees


FOUR_BAR = """
param a = 40 mm
param b = 100 mm
param phi = 60 deg
pivot O at (0 mm, 0 mm)
pivot Q at (b, 0 mm)
link OA
link AB
link QB
OA = a @ phi
AB = {coupler}
QB = {rocker}
assembly QBA {turn}
drive phi from 5 deg to 355 deg
torque M on OA
torque T on QB
find k = M/T
"""


@pytest.mark.parametrize(
    ("coupler", "rocker", "turn", "formula"),
    [
        ("b", "a", "cw", "sin(phi - 2*phi_AQ)/sin(phi)"),  # a crossed parallelogram
        ("a", "b", "ccw", "a*sin(2*phi - 2*phi_AQ)/(b*sin(phi))"),  # a kite
    ],
)
def test_the_sides_of_a_loop_that_mirror_the_known_ones_have_their_directions(
    coupler, rocker, turn, formula
):
    """They go on beyond 180°, where by the law of cosines the loop would fold on the known side."""
    text_ = FOUR_BAR.format(coupler=coupler, rocker=rocker, turn=turn)
    compilation = Compilation(Source("m.mech", text_))
    pose, (result,) = compilation.pose, compilation.solution.results
    assert [d.name for d in pose.definitions] == ["phi_AQ"]
    assert [loop.kind for loop in pose.solved] == ["mirrored"]
    assert text(result.formula) == formula
    assert compilation.verdict.agrees
    for phi in (0.5, 2.0, 4.0, 6.0):
        values = completed({**defaults(pose.mechanism), "phi": phi}, pose.definitions)
        (ab,), (qb,) = pose.vector("AB", "A", "B"), pose.vector("QB", "Q", "B")
        ends = [
            rotor(turn) * length + start
            for turn, length, start in (
                (ab.angle.evaluate(values), ab.length.evaluate(values), 0.04 * rotor(phi)),
                (qb.angle.evaluate(values), qb.length.evaluate(values), 0.1),
            )
        ]
        assert abs(ends[0] - ends[1]) < 1e-12


def rotor(phi):
    return complex(math.cos(phi), math.sin(phi))
