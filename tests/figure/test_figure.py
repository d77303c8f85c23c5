"""The figure: points where the description says, parts that name them, halves that mirror."""

import json
import math
from typing import get_args

import pytest

import mechc
from good_mechanisms import ALL, CLOSED, begun, tree_of
from good_mechanisms import PARTS as PLACES
from grown import Grown
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.emit.json.figure import PARTS
from mechc.emit.json.to_json import TARGET
from mechc.emit.target import Options
from mechc.figure import figure as drawn
from mechc.figure.joints import joints_shown
from mechc.formula.evaluate import evaluate
from mechc.model.parts import joints, linkage
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.vocabulary import points_of
from reference_closed import Assembled
from reference_geometry import evaluate as evaluate_tree
from reference_geometry import every
from sources import in_thirds

every_mechanism = pytest.mark.parametrize("name", in_thirds(ALL))
MIRRORED = [n for n, path in ALL.items() if "\nmirror" in path.read_text(encoding="utf-8")]


def figure_of(text, **values):
    return mechc.loads(text).figure(**values)


def parts(figure, kind):
    return [part for part in figure.parts if isinstance(part, kind)]


def cross(a, b):
    return a.turned().dot(b)


# ------------------------------------------------------------------ what is written


@every_mechanism
def test_all_lengths_and_directions_are_as_written(name):
    figure = begun(name).figure
    reference = Assembled(tree_of(name), dict(figure.values), figure.points)
    size = max(1.0, figure.size)
    assert max(map(abs, reference.equations(reference.x)), default=0) < 1e-9 * size


@every_mechanism
def test_what_has_only_a_direction_is_not_turned_round(name):
    figure = begun(name).figure
    reference = Assembled(tree_of(name), dict(figure.values), figure.points)
    for s in every(tree_of(name), ast.Vector):
        if isinstance(s.value, ast.Polar) and s.value.length is None:
            tail, head = points_of(s.points.text)
            if reference.is_given(s.value.direction):
                along = reference.direction(s.value.direction, reference.x)
                assert (reference.at(head) - reference.at(tail)) @ along > 0, s.points.text


@pytest.mark.parametrize("name", CLOSED)
def test_loops_stay_closed_along_the_stroke(name):
    drive = begun(name).mechanism.drive
    low, high = (evaluate(end, {}) for end in (drive.low, drive.high))
    for part in PLACES:
        place = low + (high - low) * part
        here = begun(name).drawn({drive.parameter: place})
        reference = Assembled(tree_of(name), dict(here.values), here.points)
        assert max(map(abs, reference.equations(reference.x))) < 1e-9
        nearby = begun(name).drawn({drive.parameter: place + 1e-7})
        moved = (math.dist(here.points[p], nearby.points[p]) for p in here.points)
        assert 0 < max(moved) < 1e-4 * here.size, "the other closure"


@pytest.mark.parametrize("seed", range(0, 120, 6))
def test_mechanisms_grown_at_random(seed):
    compilation = Compilation(Source("grown.mech", Grown(seed).text()))
    try:
        figure = compilation.figure
    except MechcError:
        return  # grown so that two closures cannot be told apart
    reference = Assembled(compilation.tree, dict(figure.values), figure.points)
    assert max(map(abs, reference.equations(reference.x))) < 1e-12


# --------------------------------------------------------------------- the halves


@pytest.mark.parametrize("name", MIRRORED)
def test_twins_are_mirror_images(name):
    figure, sharing = begun(name).figure, begun(name).mechanism.mirror.sharing
    at, along = figure.mirror.at, figure.mirror.along
    own = [p for p in figure.points if f"{p}'" in figure.points]
    assert own
    for point in own:
        here, twin = figure.points[point], figure.points[f"{point}'"]
        assert along.dot(here.minus(twin)) == pytest.approx(0, abs=1e-12)
        assert cross(along, here.plus(twin).times(0.5).minus(at)) == pytest.approx(0, abs=1e-12)
    for point in sharing:
        assert cross(along, figure.points[point].minus(at)) == pytest.approx(0, abs=1e-12)
        assert f"{point}'" not in figure.points


@pytest.mark.parametrize("name", MIRRORED)
def test_what_is_off_the_line_has_a_twin(name):
    figure, mechanism = begun(name).figure, begun(name).mechanism
    shared = set(mechanism.mirror.sharing)
    alone = [k for k in mechanism.links if not shared.issuperset(k.points)]
    assert len(parts(figure, drawn.Link)) == len(mechanism.links) + len(alone)
    off = [p for p in mechanism.each(joints.Pivot) if p.point not in shared]
    assert len(parts(figure, drawn.Pivot)) == len(mechanism.each(joints.Pivot)) + len(off)


def test_twins_turn_the_other_way():
    figure = begun("mirror_beam_torque").figure
    by_link = {t.link: t for t in parts(figure, drawn.Torque)}
    assert {f"{link}'" for link in by_link if not link.endswith("'")} <= by_link.keys()
    for link, torque in by_link.items():
        if not link.endswith("'"):
            assert torque.counterclockwise != by_link[f"{link}'"].counterclockwise


# ------------------------------------------------------------------ guides, wheels


@every_mechanism
def test_pins_are_on_their_lines(name):
    figure = begun(name).figure
    at, size = figure.points, figure.size
    lines = [(s.guide, at[s.point], s.along) for s in parts(figure, drawn.Slider)]
    lines += [(s.guide, at[s.through], s.along) for s in parts(figure, drawn.Slider) if s.through]
    lines += [(s.groove, at[s.point], s.along) for s in parts(figure, drawn.Slot)]
    lines += [(c.face, at[c.point], c.normal.turned()) for c in parts(figure, drawn.Contact)]
    lines += [(s.axis, at[s.point], s.along) for s in parts(figure, drawn.Screw)]
    for line, point, along in lines:
        whole, offset = line.end.minus(line.start), point.minus(line.start)
        assert cross(whole, along) == pytest.approx(0, abs=1e-9 * size)
        assert cross(whole, offset) == pytest.approx(0, abs=1e-9 * size**2)
        assert 0 < whole.dot(offset) < whole.dot(whole)


@every_mechanism
def test_racks_touch_their_gears(name):
    figure = begun(name).figure
    for rack in parts(figure, drawn.Rack):
        centre = figure.points[rack.pivot]
        # The wheel is on the left of the rack's direction where the radius is positive.
        assert cross(rack.along, centre.minus(rack.line.start)) == pytest.approx(rack.radius)


@every_mechanism
def test_pitch_circles_touch(name):
    figure = begun(name).figure
    for pair in parts(figure, drawn.Gears):
        first, second = figure.points[pair.first], figure.points[pair.second]
        radii = pair.first_radius, pair.second_radius
        apart = abs(radii[0] - radii[1]) if pair.inner else sum(radii)
        assert math.dist(first, second) == pytest.approx(apart)
        assert math.dist(first, pair.touch) == pytest.approx(radii[0])
        assert math.dist(second, pair.touch) == pytest.approx(radii[1])
    for rack in parts(figure, drawn.Rack):
        radius = rack.touch.minus(figure.points[rack.pivot])
        assert math.hypot(*radius) == pytest.approx(abs(rack.radius))
        assert radius.dot(rack.along) == pytest.approx(0, abs=1e-12)
        assert cross(rack.along, rack.touch.minus(rack.line.start)) == pytest.approx(0, abs=1e-12)


def test_belts_are_tangent_and_cross_where_they_are_to():
    figure = begun("belts_open_crossed").figure
    plain, crossed = parts(figure, drawn.Belt)
    for belt in plain, crossed:
        for run in belt.runs:
            for end, centre, radius in (
                (run.start, belt.first, belt.first_radius),
                (run.end, belt.second, belt.second_radius),
            ):
                spoke = end.minus(figure.points[centre])
                assert math.hypot(*spoke) == pytest.approx(radius)
                assert spoke.dot(run.end.minus(run.start)) == pytest.approx(0, abs=1e-12)
        first, second = belt.runs
        swapped = [
            cross(first.end.minus(first.start), p.minus(first.start)) < 0
            for p in (second.start, second.end)
        ]
        assert (swapped[0] != swapped[1]) == belt.crossed


def test_a_belt_has_no_runs_where_its_wheels_overlap():
    near = "param d = 90 mm\npivot O at (0 mm, 0 mm)\npivot Q at (d, 0 mm)"
    belt = LEVERS.replace("pivot O\npivot Q", near).replace("gear O", "belt O")
    crossed = belt.replace("50 mm\n", "50 mm crossed\n")
    for text, apart, runs in ((belt, 0.07, 2), (crossed, 0.09, 2), (crossed, 0.07, 0)):
        (found,) = parts(figure_of(text, c=0.07, d=apart), drawn.Belt)
        assert len(found.runs) == runs


@every_mechanism
def test_forces_point_as_written(name):
    figure = begun(name).figure
    reference = Assembled(tree_of(name), dict(figure.values), figure.points)
    drawn_forces = {(f.name, f.point): f for f in parts(figure, drawn.Force)}
    for force in every(tree_of(name), ast.Force):
        found = drawn_forces[force.name.text, force.point.text]
        along = reference.direction(force.along, reference.x)
        assert tuple(found.along) == pytest.approx(tuple(along), abs=1e-9)
        times = evaluate_tree(force.times, {}) if force.times else 1
        assert found.times == pytest.approx(times)


@every_mechanism
def test_a_free_wedge_is_on_the_side_from_which_it_pushes(name):
    figure, pose = begun(name).figure, begun(name).pose
    slides = {s.name: s for s in parts(figure, drawn.Slide)}
    for contact in parts(figure, drawn.Contact):
        if contact.body in slides and not any(pose.frames[contact.body.rstrip("'")].values()):
            at = figure.points[contact.point]
            ends = [figure.points[p] for p in slides[contact.body].points]
            assert all(contact.normal.dot(at.minus(end)) > 0 for end in ends)


def test_points_of_a_slide_stand_apart():
    figure = figure_of(RAIL)
    assert len({figure.points[p] for p in "WXY"}) == 3


RAIL = """
mechanism rail
slide WXY along 20 deg
force P at W along 20 deg
force F at X along -y
force G = F at Y along -y
find k = P/F
"""


def test_a_guide_through_a_place_is_no_pivot():
    figure = figure_of(CRANK.format(guide="along x through (0 mm, 20 mm)"))
    (slider,) = parts(figure, drawn.Slider)
    assert figure.points["K"].y == pytest.approx(0.02)
    assert slider.guide.start.y == pytest.approx(0.02)
    assert [p.point for p in parts(figure, drawn.Pivot)] == ["O"]


def test_the_place_of_a_guide_that_stands_still_is_no_pivot():
    figure = figure_of(
        "mechanism m\nslider C along x through (0 mm, 110 mm)\npivot O at (0 mm, 0 mm)\n"
        "link OB\nlink CB\nB at (-20 mm, 110 mm)\nC at (-120 mm, 110 mm)\n"
        "force P at C along x\nforce F at B along -x\nfind k = P/F\n"
    )
    assert [p.point for p in parts(figure, drawn.Pivot)] == ["O"]


CRANK = """
mechanism crank
param l = 100 mm
param a = 30 deg
pivot O at (10 mm, 0 mm)
slider K {guide}
link OA
link AK
OA = 50 mm @ a
AK = l
drive a from 10 deg to 80 deg
torque M on OA
force F at K along -x
assembly K forward
find k = M/F
"""

LEVERS = """
mechanism levers
param a = 20 mm
param c: length
pivot O
pivot Q
link AO
link QB
OA = a @ 90 deg
QB = c @ 90 deg
gear O 30 mm, Q 50 mm
force P at A along x
force F at B along -x
find k = P/F
"""


def test_gears_without_places_touch():
    figure = figure_of(LEVERS, c=0.07)
    (gears,) = parts(figure, drawn.Gears)
    assert math.dist(figure.points["O"], figure.points["Q"]) == pytest.approx(0.08)
    assert (gears.first_radius, gears.second_radius, gears.inner) == (0.03, 0.05, False)
    assert figure.points["B"].minus(figure.points["Q"]) == pytest.approx((0, 0.07))


def test_what_nothing_connects_is_side_by_side():
    text = LEVERS.replace("gear O 30 mm, Q 50 mm", "").replace("force F at B along -x", "")
    text = text.replace("find k = P/F", "force F at A along -x\nforce H at B along y\nfind k = P/F")
    figure = figure_of(text, c=0.07)
    left = max(figure.points[p].x for p in "OA")
    assert min(figure.points[p].x for p in "QB") > left


# ----------------------------------------------------------------- what is not given


def test_open_lengths_close_the_loop_and_are_positive():
    figure = begun("quaternary_platform").figure
    assert figure.chosen == ("len_P1A", "len_P2B", "len_DC")
    assert all(figure.values[name] > 0 for name in figure.chosen)


@every_mechanism
def test_chosen_lengths_are_positive(name):
    figure = begun(name).figure
    assert all(figure.values[n] > 0 for n in figure.chosen if n.startswith("len_"))


def test_a_parameter_without_a_value_is_chosen():
    assert "c" in figure_of(LEVERS).chosen
    assert "c" not in figure_of(LEVERS, c=0.07).chosen


def test_there_is_no_figure_where_nothing_can_be_assembled():
    short = mechc.loads(CRANK.format(guide="along x through O"))
    assert short.figure().points["K"].y == pytest.approx(0, abs=1e-12)
    with pytest.raises(ValueError, match="no pose of the mechanism is found"):
        short.figure(l=0.02, a=1.2)
    with pytest.raises(TypeError, match="did you mean 'theta'"):
        mechc.load("lazy_tongs").figure(teta=1)


def test_there_is_no_figure_where_halves_do_not_meet():
    rhombus = """
        mechanism rhombus
        param alpha = 35 deg
        slider A along x
        pivot O
        link AB
        link BO
        AB = 40 mm @ alpha
        BO = 40 mm @ {back}
        mirror across 0 deg sharing A O
        force P at A along x
        force F at B along y
        find k = P/F
    """
    assert figure_of(rhombus.format(back="-alpha")).points["O"].y == pytest.approx(0)
    with pytest.raises(ValueError, match="no pose of the mechanism is found"):
        figure_of(rhombus.format(back="180 deg - alpha"))
    assert mechc.loads(rhombus.format(back="90 deg"))._compilation.free_bodies == ()


# --------------------------------------------------------------------------- parts

SPRUNG = """
mechanism sprung
param a     = 80 mm
param alpha = 70 deg
param c     = 500 N/m
slider K along y
pivot O
link OA
link AK
KA = a @ alpha - 60 deg
OA = a @ alpha
mirror across 90 deg sharing K
spring c between A and A' free 20 mm
actuator P between O and K
find P
"""


def test_what_joins_a_point_and_its_twin_is_there_once():
    figure = figure_of(SPRUNG)
    assert [(s.first, s.second) for s in parts(figure, drawn.Spring)] == [("A", "A'")]
    assert [(s.first, s.second) for s in parts(figure, drawn.Actuator)] == [("O", "K"), ("O'", "K")]


def test_every_kind_of_part_appears():
    found = {type(part) for name in ALL for part in begun(name).figure.parts}
    found |= {type(part) for part in figure_of(SPRUNG).parts}
    assert found == set(get_args(drawn.Part))
    assert set(PARTS) == set(get_args(drawn.Part))


def test_no_joint_of_the_model_is_forgotten():
    """Every class of bodies and joints goes into the figure."""
    found = set()
    for name in ALL:
        mechanism = begun(name).mechanism
        found |= {type(part) for part in (*mechanism.bodies, *joints_shown(mechanism))}
    assert found == {*get_args(linkage.Body), *get_args(joints.Joint)}


@every_mechanism
def test_parts_name_points_that_have_a_place(name):
    figure = begun(name).figure
    for part in figure.parts:
        for field in ("point", "first", "second", "tail", "head", "vertex", "pivot"):
            assert getattr(part, field, "") in {"", *figure.points}
        for field in ("points", "outline"):
            assert set(getattr(part, field, ())) <= figure.points.keys()
    links = parts(figure, drawn.Link)
    assert all({p for rod in k.rods for p in rod} == set(k.points) for k in links)


@every_mechanism
def test_outlines_go_counter_clockwise(name):
    figure = begun(name).figure
    for link in parts(figure, drawn.Link):
        corners = [figure.points[p] for p in link.outline]
        for i in range(len(corners) if len(corners) > 2 else 0):
            a, b, c = (corners[(i + j) % len(corners)] for j in range(3))
            assert cross(b.minus(a), c.minus(b)) > 0


def test_measures_are_named_by_parameters():
    figure = begun("crank_rocker").figure
    lengths = {(d.tail, d.head): (d.text, d.value) for d in parts(figure, drawn.DimensionLine)}
    assert lengths["O1", "A"] == ("a", pytest.approx(0.04))
    assert lengths["O2", "B"] == ("c", pytest.approx(0.08))
    angles = {(a.vertex, a.text): a for a in parts(figure, drawn.AngleMark)}
    assert angles["O1", "phi"].sweep == pytest.approx(math.radians(60))
    clamp = begun("karpenko_fig9_packet_clamp").figure
    beta = next(a for a in parts(clamp, drawn.AngleMark) if a.text == "beta")
    assert (beta.start, beta.sweep) == pytest.approx((-math.pi / 2, math.radians(-7)))


def test_a_coordinate_less_a_number_is_measured_in_its_unit():
    """D is h − 50 mm below A; where the guides pass, A_0 and B_0, nothing in the drawing shows."""
    figure = figure_of(
        "mechanism f\nparam h = 100 mm\nparam d = 60 mm\nslider A along y through (0 mm, 0 mm)\n"
        "slider B along y through (d, 0 mm)\nlink ABCD\nA at (0 mm, h)\nB at (d, 0 mm)\n"
        "C at (200 mm, 0 mm)\nD at (d/2, 50 mm)\nforce P at D along y\n"
        "force F at C along -y\nfind k = P/F\n"
    )
    found = {(d.tail, d.head, d.text) for d in parts(figure, drawn.DimensionLine)}
    assert ("A", "D", "h - 50 mm") in found
    assert not {tail for tail, _, _ in found} & {"", "A_0", "B_0"}


def test_a_length_between_varying_intensities_is_a_length():
    figure = figure_of(
        "mechanism f\npivot A at (0 mm, 0 mm)\npivot B at (0 mm, -400 mm)\nlink AC\nlink BC\n"
        "C at (900 mm, 0 mm)\nload Q intensity 2 N/mm to 1 N/mm on AC along -y\nfind N_BC\n"
    )
    (to_resultant,) = [d for d in parts(figure, drawn.DimensionLine) if d.head == "M"]
    assert (to_resultant.text, to_resultant.value) == ("400 mm", pytest.approx(0.4))


def test_it_is_in_the_document():
    (file,) = TARGET.emit(begun("crank_rocker"), Options("x"))
    document = json.loads(file.text)["figure"]
    assert document["points"]["O2"] == [0.1, 0.0]
    assert {"part": "pivot", "point": "O1", "ground": [0.0, -1.0]} in document["parts"]
