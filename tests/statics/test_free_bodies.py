"""Free bodies: all that acts on each one balances, where it is drawn, and is known from results."""

import json
import math
from random import Random

import pytest

import mechc
from force_mechanisms import given
from force_samples import pushing
from good_mechanisms import ALL, compiled
from mechc.compilation import Compilation
from mechc.emit.json.to_json import TARGET
from mechc.emit.target import Options
from mechc.formula.evaluate import evaluate
from mechc.model.mechanism import LoadForm, LoadRatio, WithFriction
from mechc.model.parts.friction import FaceFriction, GuideFriction, PinFriction
from mechc.report.text.free_bodies import describe
from mechc.source import Source
from small_mechanisms import slotted_lever
from sources import in_thirds

every_mechanism = pytest.mark.parametrize("name", in_thirds(ALL))
BALANCED = 1e-9


def bodies_of(text, **values):
    return mechc.loads(text).free_bodies(**values)


def named(diagram):
    return {body.name: body for body in diagram.bodies}


def largest(diagram):
    sizes = (math.hypot(*a.force) for b in diagram.bodies for a in b.forces if a.force)
    return max(sizes, default=0.0)


def complete(diagram):
    """Yield the bodies on which every force is known."""
    for body in diagram.bodies:
        if all(acting.force is not None for acting in body.forces):
            yield body


def rest(body, places):
    """Return the sums of forces and, about the origin, of moments."""
    x = math.fsum(a.force.x for a in body.forces)
    y = math.fsum(a.force.y for a in body.forces)
    moments = [a.moment for a in body.forces]
    for a in body.forces:
        if a.point:
            moments.append(places[a.point].x * a.force.y - places[a.point].y * a.force.x)
    return x, y, math.fsum(moments)


def assert_balance(diagrams, figure):
    """Assert that all is in balance in the plane of the figure; return how many bodies are."""
    number = 0
    for diagram in diagrams:
        scale = largest(diagram)
        reach = max(map(math.hypot, *zip(*figure.points.values(), strict=True)))
        for body in complete(diagram):
            x, y, moment = rest(body, figure.points)
            assert max(abs(x), abs(y)) <= BALANCED * scale, body
            couples = max((abs(a.moment) for a in body.forces), default=0.0)
            assert abs(moment) <= BALANCED * max(scale * reach, couples), body
            number += 1
    return number


# ------------------------------------------------------------------------------ balance


@every_mechanism
def test_every_body_is_in_balance(name):
    made = compiled(name)
    targets = [result.target for result in made.results]
    several = len(made.mechanism.loads) > 1
    asked = several and any(isinstance(target, LoadRatio | LoadForm) for target in targets)
    known = assert_balance(made.free_bodies, made.figure)
    gaps = any(a.gap for d in made.free_bodies for b in d.bodies for a in b.forces)
    assert known or gaps or not asked


@every_mechanism
def test_nothing_is_in_trouble_but_what_an_efficiency_stands_for(name):
    made = compiled(name)
    for diagram in made.free_bodies:
        constant = made.mechanism.friction.efficiency is not None and diagram.motion
        assert bool(diagram.trouble) == bool(constant)
        assert bool(diagram.bodies) != bool(constant)


@every_mechanism
def test_every_force_between_bodies_has_its_reaction(name):
    for diagram in compiled(name).free_bodies:
        bodies, scale = named(diagram), largest(diagram)
        for body in diagram.bodies:
            for acting in body.forces:
                if acting.by not in bodies or acting.kind in ("gear", "belt", "rack", "screw"):
                    continue
                back = [
                    a
                    for a in bodies[acting.by].forces
                    if (a.kind, a.by, a.point) == (acting.kind, body.name, acting.point)
                ]
                assert len(back) == 1
                if acting.force is not None:
                    total = acting.force.plus(back[0].force)
                    assert math.hypot(*total) <= BALANCED * scale
                    assert acting.moment + back[0].moment == pytest.approx(0, abs=1e-9 * scale)


@every_mechanism
def test_all_bodies_of_the_figure_are_there(name):
    made = compiled(name)
    drawn = {p.name for p in made.figure.parts if type(p).__name__ in ("Link", "Slide")}
    for diagram in made.free_bodies:
        if diagram.bodies:
            assert {b.name for b in diagram.bodies if b.kind in ("link", "slide")} == drawn
        points = {a.point for b in diagram.bodies for a in b.forces if a.point}
        assert points <= made.figure.points.keys()


@every_mechanism
def test_loads_are_those_of_the_results(name):
    made = compiled(name)
    for result in made.results:
        target = result.target
        motion = ""
        if isinstance(target, WithFriction) and target.order == "exact":
            target, motion = target.of, target.sense
        if result.default is None or made.mechanism.friction.efficiency is not None:
            continue
        if isinstance(target, LoadRatio):
            for diagram in made.free_bodies:
                sizes = diagram.loads
                both = {target.above, target.below} <= sizes.keys()
                if both and diagram.motion == motion and diagram.result != target.below:
                    found = sizes[target.above] / sizes[target.below]
                    if not motion or result.name.startswith(diagram.result):
                        assert found == pytest.approx(result.default, rel=1e-9)


def test_ratios_and_friction_are_compared_above():
    ratios = [r for n in ALL for r in compiled(n).results if isinstance(r.target, LoadRatio)]
    with_friction = [
        r for n in ALL for r in compiled(n).results if isinstance(r.target, WithFriction)
    ]
    assert len(ratios) > 100
    assert len(with_friction) > 30


# --------------------------------------------------------------------- grown at random


@pytest.mark.parametrize("seed", range(8))
def test_mechanisms_grown_at_random(seed):
    sample = pushing(given(seed))
    if sample is None:
        pytest.skip("near a singular pose")
    made = Compilation(Source("grown.mech", sample.finding()))
    assert assert_balance(made.free_bodies, made.figure) > 1
    (diagram,) = made.free_bodies[:1]
    assert_joints_as_asked(diagram, made)


@pytest.mark.parametrize("seed", in_thirds([*range(6), *range(7, 12)]))
def test_friction_in_mechanisms_grown_at_random(seed):
    sample = pushing(given(seed, 2))
    if sample is None:
        pytest.skip("near a singular pose")
    made = Compilation(Source("grown.mech", sample.with_friction(Random(seed))))
    ideal, with_friction = made.free_bodies
    assert with_friction.motion
    assert_balance((ideal, with_friction), made.figure)
    result = next(r for r in made.solution.results if r.name == "k_f")
    k = value_of(result, made.figure.values)
    assert bool(with_friction.trouble) == math.isnan(k)
    if with_friction.trouble:
        return
    assert with_friction.loads["P"] / with_friction.loads["F"] == pytest.approx(k, rel=1e-9)
    assert_friction_is_of_its_size(with_friction, made)


def value_of(result, values):
    known = dict(values)
    for definition in result.where:
        known[definition.name] = evaluate(definition.formula, known)
    held = all(evaluate(g.left, known) > evaluate(g.right, known) for g in result.guards)
    return evaluate(result.formula, known) if held else math.nan


def assert_joints_as_asked(diagram, made):
    """Assert that forces of the ground are those that virtual power found."""
    scale = largest(diagram)
    values = {**made.figure.values, **diagram.loads}
    for result in made.solution.results:
        point, _, part = result.name.removeprefix("R_").rpartition("_")
        if result.name.startswith("R_") and part in ("x", "y") and "_on_" not in point:
            acting = [
                a
                for b in diagram.bodies
                for a in b.forces
                if a.point == point and a.kind == "ground" and a.force
            ]
            expected = value_of(result, values)
            for a in acting:
                found = getattr(a.force, part)
                assert found == pytest.approx(expected, abs=1e-9 * scale)


def assert_friction_is_of_its_size(diagram, made):
    values, bodies = made.figure.values, diagram.bodies
    for pair in made.mechanism.friction.joints:
        at = [a for b in bodies for a in b.forces if a.point == pair.point and a.force]
        slips = [a for a in at if a.kind == "friction"]
        on_guide = [math.hypot(*a.force) for a in slips if a.by == "ground"]
        on_face = [math.hypot(*a.force) for a in slips if a.by not in ("ground", "")]
        match pair:
            case PinFriction(radius=radius):
                size = evaluate(radius, values)
                off = [abs(a.offset) for a in at if a.kind in ("pin", "ground") and a.moment]
                links = [k for k in made.mechanism.links if pair.point in k.points]
                if len(links) == 2 and pair.carrier and len(at) == 2:
                    assert off == pytest.approx([size] * len(off))
            case FaceFriction(factor=factor):
                normal = max(math.hypot(*a.force) for a in at if a.kind in ("slot", "contact"))
                assert on_face == pytest.approx([evaluate(factor, values) * normal] * len(on_face))
            case GuideFriction(factor=factor):
                normals = [math.hypot(*a.force) for a in at if a.kind == "guide"]
                expected = [evaluate(factor, values) * normal for normal in normals]
                if normals:  # that of a slide is at its first point
                    assert on_guide == pytest.approx(expected[: len(on_guide)])


# ----------------------------------------------------------------------------- by hand

LEVER = """
mechanism lever
param f = 0.2
param d = 20 mm
pivot O
link AOB
OA = 300 mm @ 0 deg
OB = 100 mm @ 180 deg
force P at A along -y
force F at B along -y
friction pin O f diameter d
find k = P/F
"""


def test_a_lever():
    ideal, with_friction = bodies_of(LEVER, F=300)
    assert (ideal.per, ideal.loads) == ("", {"P": pytest.approx(100), "F": 300})
    (lever,) = ideal.bodies
    by = {a.by: a for a in lever.forces}
    assert by["ground"].force == pytest.approx((0, 400))
    # P moves down, the lever turns clockwise, friction holds it counter-clockwise:
    # 300·0.1 = P·0.3 − (P + 300)·0.002.
    effort = 30.6 / 0.298
    assert with_friction.loads["P"] == pytest.approx(effort)
    ground = {a.by: a for a in with_friction.bodies[0].forces}["ground"]
    assert ground.force == pytest.approx((0, effort + 300))
    assert ground.offset == pytest.approx(0.002)


def test_an_unknown_size_is_one():
    ideal, with_friction = bodies_of(LEVER)
    assert ideal.per == with_friction.per == "F"
    assert ideal.loads["F"] == with_friction.loads["F"] == 1


def test_the_size_of_either_load_gives_the_other():
    clamp = compiled("karpenko_fig7_single_lever")
    (diagram,) = clamp.free_bodies
    by_name = {r.name: r.default for r in clamp.results}
    assert diagram.per == ""
    assert diagram.loads["P"] == pytest.approx(by_name["P"])
    assert diagram.loads["F"] == pytest.approx(by_name["F_clamp"])


def test_loads_without_sizes_act_one_by_one_and_weights_together():
    text = """
        mechanism beam
        param m = 10 kg
        pivot O
        link OAB
        OA = 1 m @ 0 deg
        OB = 2 m @ 0 deg
        force P at B along y
        force F at A along -y
        weight W mass m at A
        find P
    """
    own, unit = bodies_of(text)
    assert (own.per, own.left_out, own.loads["P"]) == ("", ("F",), pytest.approx(49.03325))
    assert (unit.per, unit.left_out, unit.loads["P"]) == ("F", ("W",), pytest.approx(0.5))
    (both,) = bodies_of(text, F=100)
    assert both.left_out == ()
    assert both.loads["P"] == pytest.approx(99.03325)
    with_friction = text.replace("find P", "friction pin O 0.1 diameter 30 mm\nfind P")
    assert [bool(d.trouble) for d in bodies_of(with_friction)] == [False, True, False, True]
    assert not any(d.trouble for d in bodies_of(with_friction, F=100))


def test_what_teeth_press_with_is_not_guessed():
    (diagram, *_) = compiled("d45_12_worm_sectors").free_bodies
    pivots = {a.point: a for b in diagram.bodies for a in b.forces if a.kind == "ground"}
    assert all((a.force, a.gap) == (None, "transmission") for a in pivots.values())
    couples = {a.by: a.moment for b in diagram.bodies for a in b.forces if a.kind == "gear"}
    assert couples["SE"] == pytest.approx(40 * couples["OD"])


def test_the_force_of_a_rack_is_at_its_pitch_point():
    diagram = compiled("table_4_4_gear").free_bodies[0]
    (wheel,) = [b for b in diagram.bodies if b.kind == "link"]
    (teeth,) = [a for a in wheel.forces if a.kind == "rack"]
    (rack,) = [p for p in compiled("table_4_4_gear").figure.parts if type(p).__name__ == "Rack"]
    assert abs(teeth.offset) == pytest.approx(abs(rack.radius))


def test_what_equilibrium_leaves_open_is_not_guessed():
    (diagram,) = compiled("second_parallel_bar").free_bodies
    open_ = [a for b in diagram.bodies for a in b.forces if a.gap == "indeterminate"]
    assert open_
    assert all(a.force is None for a in open_)


def test_forces_that_rest_on_chosen_lengths_are_marked():
    (diagram,) = compiled("d45_14_parallelogram_jaw").free_bodies
    jaw = {a.point: a for a in named(diagram)["BCJ"].forces}
    assert [jaw[p].chosen for p in "BCJ"] == [True, True, False]
    (clamp,) = compiled("karpenko_fig9_packet_clamp").free_bodies
    assert not any(a.chosen for b in clamp.bodies for a in b.forces)
    (hook,) = compiled("d45_16_wedge_hook").free_bodies
    guides = {a.point: a for b in hook.bodies for a in b.forces if a.kind == "guide"}
    assert guides["W"].chosen


def test_a_branch_takes_its_share_and_is_held_by_the_others():
    (diagram,) = compiled("three_claw_gripper").free_bodies
    on_slider = {a.kind: a for a in named(diagram)["B"].forces}
    assert on_slider["load"].force.y == pytest.approx(-diagram.loads["P"] / 3)
    assert on_slider["guide"].by == "branches"
    guides = [
        a
        for name in ("slider_crank_claw", "copies_rack")
        for b in compiled(name).free_bodies[0].bodies
        for a in b.forces
        if a.kind == "guide"
    ]
    assert [(a.by, a.gap) for a in guides] == [("ground", ""), ("branches", "transmission")]


def test_what_a_mirror_adds_is_marked_and_what_both_halves_share_is_not():
    (diagram, *_) = compiled("bolt_cutter").free_bodies
    halves = {body.name: body.twin for body in diagram.bodies}
    described = [name for name, is_twin in halves.items() if not is_twin]
    added = [name for name, is_twin in halves.items() if is_twin]
    assert added
    assert {name + "'" for name in described} >= {*added}
    assert not any(name.endswith("'") for name in described)


@pytest.mark.parametrize("name", ["jansen_leg", "whitworth", "crank_shaper", "stephenson_closed"])
def test_bodies_are_in_balance_along_the_stroke(name):
    made = compiled(name)
    drive = made.mechanism.drive
    low, high = (evaluate(end, {}) for end in (drive.low, drive.high))
    for part in (0.1, 0.35, 0.6, 0.85):
        here = {drive.parameter: low + part * (high - low)}
        assert assert_balance(made.cut_free(here, {}), made.drawn(here)) >= 3


def test_names_differ():
    lever = mechc.load("lever_first_class")
    with pytest.raises(TypeError, match="'Q' is no parameter"):
        lever.free_bodies(Q=1)


def test_it_is_in_the_document():
    (file,) = TARGET.emit(compiled("lever_first_class"), Options("x"))
    document = json.loads(file.text)
    (diagram,) = document["free_bodies"]
    assert (diagram["result"], diagram["motion"], diagram["per"]) == ("k", "", "F")
    ((_, ground, _),) = [body["forces"] for body in diagram["bodies"]]
    assert ground == {
        "kind": "ground",
        "by": "ground",
        "point": "O",
        "force": [0.0, pytest.approx(1.25)],
        "magnitude": pytest.approx(1.25),
        "moment": 0.0,
        "offset": 0.0,
        "gap": "",
        "chosen": False,
    }
    assert ground["point"] in document["figure"]["points"]


def test_it_is_printed():
    shown = describe(bodies_of(LEVER, F=300)).splitlines()
    assert shown[0] == "k, without friction: P = 100, F = 300"
    assert "    O, ground: (0, 400), size 400" in shown
    assert any(line.endswith("2 mm off") for line in shown)
    teeth = describe(compiled("d45_12_worm_sectors").free_bodies)
    assert "O, ground: not known: how teeth" in teeth


TIED = """mechanism lever
pivot O at (0 mm, 0 mm)
link AOBC
A at (-200 mm, 0 mm)
B at (100 mm, 0 mm)
C at (50 mm, 0 mm)
force P at A along -y
force F at B along -y
force G{tie} at C along -y
friction pins 0.2 diameter 40 mm
find P
{lets}"""


@pytest.mark.parametrize(
    ("tie", "lets"), [(" = F", "let F = 1 kN"), ("", "let F = 1 kN\nlet G = F"), (" = F", "")]
)
def test_a_tied_load_acts_once_with_friction(tie, lets):
    """200 P = 150 F + 0.2·20 (P + 2 F), so that P = 158/196 F."""
    _, diagram = bodies_of(TIED.format(tie=tie, lets=lets))
    size = diagram.loads["F"]
    assert diagram.loads == pytest.approx({"P": 158 / 196 * size, "F": size, "G": size}, rel=1e-9)
    assert len(list(complete(diagram))) == 1


@pytest.mark.parametrize("friction", ["", "friction pins 0.2 diameter 40 mm"])
def test_a_load_that_is_another_of_no_size_is_checked(friction):
    """The free bodies are asked under one load after another, of which none is another then."""
    text = TIED.format(tie="", lets="let G = F")
    checked = mechc.loads(text.replace("friction pins 0.2 diameter 40 mm", friction))
    assert {trial.result for trial in checked._compilation.verdict.trials} >= {"P/F", "P/G"}


JACK_BESIDE_A_ROD = """
param r = 50 mm
param phi = 60 deg
param f = 0.1
pivot O at (0 mm, 0 mm)
link OA
link AB
OA = r @ phi
AB = 200 mm
slider B along x through O
assembly B back
torque M on OA
actuator F between A and B
find k = M/F
friction pins f diameter 20 mm journal
"""


def test_a_pin_passes_on_a_couple_of_friction_where_it_passes_on_no_force():
    made = Compilation(Source("jack.mech", JACK_BESIDE_A_ROD))
    diagram = next(d for d in made.free_bodies if d.motion)
    assert assert_balance([diagram], made.figure) == len(diagram.bodies)
    (at_crank,) = (a for a in named(diagram)["OA"].forces if a.kind == "pin")
    assert math.hypot(*at_crank.force) == 0.0
    assert abs(at_crank.moment) == pytest.approx(0.1 * 0.01 * 1.0)


def test_the_bodies_of_a_joint_that_does_not_slide_show_what_its_result_is():
    """Friction is 0.3 of the normal force, one way or the other, and M is the limit of both."""
    mechanism = mechc.loads(slotted_lever())
    _, diagram = mechanism.free_bodies()
    stroke = mechanism.stroke(3)
    k_f = dict(zip((c.name for c in stroke.columns), stroke.rows[1].values, strict=True))["k_f"]
    assert diagram.loads["M"] == pytest.approx(k_f, rel=1e-9)
    slot = [a for a in named(diagram)["OE"].forces if a.point == "A"]
    along, across = (abs(math.fsum(getattr(a.force, axis) for a in slot)) for axis in "yx")
    assert along == pytest.approx(0.3 * across, rel=1e-9)
    assert_balance([diagram], mechanism.figure())
