"""The ends of a stroke: where loops come to theirs, what lies beyond, what is not shown."""

import math

import pytest

import mechc
from good_mechanisms import loaded
from grown import Grown
from mechc.compilation import Compilation, checked, warnings
from mechc.formula.numeric.roots import roots
from mechc.report.text.stroke import to_table
from mechc.source import Source
from mechc.study.analysis import DeadCentre
from mechc.study.stroke.run import GRADED, graded, looked_at
from mechc.study.stroke.stroke import StrokeInterval
from paths import CORPUS

STROKES = CORPUS / "strokes"

FOUR_BAR = """
{parameter}
param c = 6 m
param phi = 180 deg in 0 deg .. 360 deg
pivot O at (0 m, 0 m)
pivot Q at (4 m, 0 m)
link OA
link AB
link QB
OA = 2 m @ phi
AB = {coupler}
QB = c
assembly ABQ cw
drive phi from {low} deg to {high} deg
torque M on OA
torque T on QB
find k = M/T
"""

SLIDER = """
param x = 0.3 m in -0.6 m .. 0.6 m
pivot O at (0 m, 0 m)
slider A along x through O
link AB
link OB
OA = (x, 0 m)
AB = 0.3 m
OB = 0.4 m
assembly ABO ccw
drive x from -0.6 m to 0.6 m
force P at A along x
torque T on OB
find k = P/T
"""

WAYS = {
    "a parameter": ("param b = 9 m", "b"),
    "its formula": ("param b = hypot(9 m, 0 m)", "b"),
    "a literal": ("", "9 m"),
    "in a root": ("param xB = 9 m", "hypot(xB, 0 m)"),
}
"""One length of the coupler, written in several ways."""


def four_bar(parameter="", coupler="9 m", low=0, high=360):
    return FOUR_BAR.format(parameter=parameter, coupler=coupler, low=low, high=high)


@pytest.mark.parametrize("way", WAYS)
def test_how_a_length_is_written_changes_no_end(way):
    """The coupler and the rocker make the diagonal |9 − 6| = 3: cos φ = (2² + 4² − 3²)/16."""
    found = mechc.loads(four_bar(*WAYS[way])).stroke(5)
    end = math.acos(11 / 16)
    (stretch,) = found.stretches
    assert (stretch.low, stretch.high) == pytest.approx((end, 2 * math.pi - end), abs=1e-12)
    assert stretch.before == stretch.after == "cannot be assembled"
    assert not found.branches
    locked = [s.drive for s in found.singular if s.value == "infinite"]
    assert locked == pytest.approx([end, 2 * math.pi - end], abs=1e-12)
    (still,) = [s for s in found.singular if s.value == "0"]
    assert isinstance(still.kind, DeadCentre)


def test_a_parameter_and_its_figure_say_the_same():
    texts = [four_bar(f"param {name} = 9 m", name) for name in ("b", "zeta")]
    first, second = (mechc.loads(text).stroke(9) for text in (*texts[:1], four_bar()))
    assert mechc.loads(texts[1]).stroke(9).singular == first.singular
    columns = [[r.values[0] for r in found.rows] for found in (first, second)]
    assert columns[0] == pytest.approx(columns[1], rel=1e-12, nan_ok=True)


@pytest.mark.slow
def test_a_dead_centre_in_the_last_cell_of_a_triad():
    """k is −1.7e-4 at 1.1765 rad and 8.6e-4 at 1.177; the loop ends at 1.1808."""
    text = (STROKES / "triad_last_cell.mech").read_text(encoding="utf-8")
    mechanism = mechc.loads(text)
    (still,) = [s for s in mechanism.stroke(2).singular if s.value == "0"]
    assert 1.1765 < still.drive < 1.177
    before, after = (mechanism.evaluate(phi=still.drive + d)["k"] for d in (-1e-7, 1e-7))
    assert before < 0 < after


def test_an_arc_that_cannot_be_reached_is_said_to_be_one():
    mechanism = mechc.loads(SLIDER)
    behind, ahead = mechanism.stroke(5).stretches
    assert (behind.high, ahead.low) == pytest.approx((-0.1, 0.1), abs=1e-12)
    assert (behind.reached, ahead.reached) == (False, True)
    assert "x = -0.6 m to x = -0.1 m cannot be reached" in to_table(mechanism.stroke(5))


def test_an_arc_that_goes_on_over_the_ends_of_a_turn_is_one():
    """From −180° to 180° the arc about 180° is cut in two by the ends of the stroke only."""
    found = mechc.loads(four_bar(low=-180, high=180)).stroke(5)
    assert [s.reached for s in found.stretches] == [True, True]
    short = mechc.loads(four_bar(low=-170, high=180)).stroke(5)
    assert [s.reached for s in short.stretches] == [False, True]


def test_a_condition_of_use_parts_no_loop():
    text = four_bar() + "require abs(phi - 250 deg) > 5 deg\n"
    found = mechc.loads(text).stroke(5)
    assert len(found.stretches) == 2
    assert all(s.reached for s in found.stretches)


def gaps(text):
    compilation = Compilation(Source("test.mech", text))
    found = compilation.gaps
    return found, [d for d in compilation.report.diagnostics if d.code == "W594"]


def test_check_says_where_a_stroke_cannot_be_run():
    found, (warning,) = gaps(four_bar())
    end = math.acos(11 / 16)
    assert [x for part in found for x in part] == pytest.approx(
        [0, end, 2 * math.pi - end, 2 * math.pi], abs=1e-9
    )
    assert "for phi from 0 to 46.56746 deg and from 313.4325 to 360 deg" in warning.message


def test_compile_warns_of_it_too():
    compilation = checked(Compilation(Source("test.mech", four_bar())))
    assert "W594" in [d.code for d in warnings(compilation)]


def test_check_is_silent_on_a_stroke_that_can_be_run():
    assert gaps(four_bar(low=60, high=300)) == ((), [])


def test_a_flat_loop_is_no_gap():
    text = four_bar().replace("AB = 9 m", "AB = 4 m").replace("param c = 6 m", "param c = 2 m")
    text = text.replace("phi = 180 deg", "phi = 60 deg").replace("ABQ cw", "ABQ ccw")
    assert gaps(text.replace("ABQ ccw", "ABQ cw"))[0] == ()


def test_a_load_that_rests_on_others_is_not_left_out_in_silence():
    text = four_bar().replace("find k = M/T", "force F at B along x\nfind M")
    shown = to_table(mechc.loads(text).stroke(3))
    assert "M is not shown: it rests on F, T, without a value" in shown
    given = to_table(mechc.loads(text + "let F = 10 N\nlet T = 2 N*m\n").stroke(3))
    assert "not shown" not in given


def test_columns_have_names_that_differ():
    text = four_bar().replace("find k = M/T", "find mu_B = V_A/V_B\nfind k = M/T")
    names = [column.name for column in mechc.loads(text).stroke(3).columns]
    assert names[0] == "mu_B"
    assert "mu_B (angle)" in names
    assert len(set(names)) == len(names)


def test_what_is_infinite_has_no_greatest_value():
    """B stands still where coupler and crank are in one line, and V_A/V_B is infinite there."""
    text = four_bar(low=60, high=300).replace("find k = M/T", "find v = V_A/V_B")
    assert not [e for e in mechc.loads(text).stroke(3).extrema if abs(e.value) > 1e3]


# ------------------------------------------------------------------------ places and zeros


def test_places_next_to_an_end_lie_evenly_by_the_root():
    found = list(graded(1.0, 2.0))
    steps = [math.sqrt(x - 1) * GRADED for x in found]
    assert steps == pytest.approx(range(1, GRADED))


def test_only_cells_next_to_the_end_of_a_loop_are_divided():
    places = [i / 720 for i in range(721)]
    plain = looked_at(StrokeInterval(0.0, 1.0, "", ""), places)
    ended = looked_at(StrokeInterval(0.0, 1.0, "", "cannot be assembled"), places)
    assert plain == places
    assert [x for x in ended if x <= places[-2]] == places[:-1]
    assert len(ended) == len(places) + GRADED - 1


def test_two_zeros_in_one_cell_are_two():
    places = [i / 10 for i in range(11)]
    found = roots(lambda x: (x - 0.52) * (x - 0.57), places)
    assert [r.x for r in found] == pytest.approx([0.52, 0.57], abs=1e-12)


def test_a_stroke_says_at_how_many_places_it_was_looked_at() -> None:
    table = to_table(loaded("crank_rocker").stroke(3))
    assert table.splitlines()[-1].startswith("Looked at 721 places: zeros, poles, jumps, extrema")
    assert loaded("claw_with_friction").stroke(3).looked == 721


def test_where_iteration_finds_nothing_there_may_be_a_pose():
    """Nothing has shown that this triad has no pose there."""
    lines = [line for line in Grown(70179).text().split("\n") if not line.startswith("drive ")]
    text = "\n".join([*lines, "drive phi from -0.9 rad to 0.9 rad"])
    compilation = Compilation(Source("triad.mech", text))
    assert compilation.gaps
    (warning,) = [w for w in warnings(compilation) if w.code == "W594"]
    assert warning.message.startswith("iteration finds no pose for phi from -51.56")


NEXT_TO_ITS_END = """
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OA
link AB
link CB
OA = 40 mm @ phi
param phi = 59.9993 deg
AB = 60 mm
CB = 27.178 mm
assembly ABC cw
drive phi from 40 deg to 60 deg
torque M on OA
torque T on CB
find k = M/T
"""


def test_links_follow_the_drive_next_to_the_end_of_their_loop():
    """There differences do not show how fast they turn: W591 was false, and B had no path."""
    compilation = Compilation(Source("m.mech", NEXT_TO_ITS_END))
    assert compilation.out_of_step == ()
    assert {q.of for q in compilation.motion.quantities} >= {"A", "B", "AB", "CB"}


def test_where_a_closure_that_is_followed_ends_another_one_may_be():
    """A triad has up to six, and that one of them ends does not show that there is none."""
    compilation = Compilation(Source("triad.mech", Grown(70179).text()))
    assert compilation.gaps
    (warning,) = [w for w in warnings(compilation) if w.code == "W594"]
    assert warning.message.startswith("no pose is reached from the default one for phi from 152.7")


UPRIGHT = """
param a = 50 mm
param phi = 30 deg
pivot O at (-50 mm, 0 mm)
pivot Q at (0 mm, 0 mm)
link OA
link AB
OA = a @ phi
AB = a
slider B along y through Q
assembly B back
drive phi from 25 deg to {high} deg
force F at B along y
torque M on OA
find k = M/F
"""


def test_a_loop_that_ends_where_the_drive_does_has_its_pole_there():
    """The rod lies across its guide at 90°: its cosine is the root of a difference that is 0."""
    stroke = Compilation(Source("m.mech", UPRIGHT.format(high=90))).stroke(5)
    (pole,) = [s for s in stroke.singular if s.value == "infinite"]
    assert pole.drive == pytest.approx(math.pi / 2)
    short = Compilation(Source("m.mech", UPRIGHT.format(high=89.9999999))).stroke(5)
    assert not [s for s in short.singular if s.value == "infinite"]


def test_the_greatest_value_is_not_met_where_all_values_are_small_beside_the_least():
    compilation = Compilation(Source("m.mech", UPRIGHT.format(high=89.9999999)))
    (result,) = compilation.reported.results
    (extent,) = result.extents
    assert extent.greatest.x == pytest.approx(math.radians(40.5555), abs=1e-5)
    assert not extent.greatest.again
