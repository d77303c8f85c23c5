"""Figures of linkages built by hand: open lengths, points, joints and what stands beside them."""

import math
from fractions import Fraction
from types import SimpleNamespace

import pytest

from mechc.algebra.product import Product
from mechc.base.frozen import replace
from mechc.figure import dimensions, from_balance, layout
from mechc.figure.figure import AngleMark, DimensionLine, MirrorLine, Pivot, Rack
from mechc.figure.from_balance import _MotionMaker
from mechc.figure.from_pose import draw
from mechc.figure.lengths import choose
from mechc.figure.linear_vectors import DrawnVector, Linear, LinearVectors, open_vector
from mechc.figure.velocities import MotionVelocities, rates
from mechc.figure.wheels import Circle, pitch_point, rope_runs
from mechc.formula.tree import ZERO, Constant, Symbol, degrees, negative, number, product, total
from mechc.model.mechanism import (
    Absolute,
    AlongLine,
    Arrow,
    Force,
    ForcePair,
    Friction,
    Mirror,
    Parameter,
)
from mechc.pose.places import Plane
from mechc.units import LENGTH, MASS
from small_poses import (
    ALONG,
    HERE,
    RACK,
    VALUES,
    at,
    driven_slider,
    force,
    lever,
    on_pivots,
    plan,
    slider_crank,
    slotted,
    torque,
    two_bars,
    wheels,
)

A, B, R, L, C = (VALUES[n] for n in "abrlc")
ALPHA, PHI, PSI = (VALUES[n] for n in ("alpha", "phi", "psi"))
ALPHA_, PHI_ = Symbol("alpha"), Symbol("phi")
X, Y = Plane(1.0, 0.0), Plane(0.0, 1.0)


def polar(size, angle):
    return Plane(size * math.cos(angle), size * math.sin(angle))


def near(plane):
    return pytest.approx(tuple(plane))


# --------------------------------------------------------------------------- lengths


def test_open_lengths_close_their_loop():
    """From O 3 ahead and 4 up, back by s along x and t along y."""
    vectors = [
        DrawnVector("O", "A", Linear(Plane(3.0, 4.0))),
        DrawnVector("A", "B", Linear(parts={"s": X.times(-1)})),
        DrawnVector("B", "O", Linear(parts={"t": Y.times(-1)})),
    ]
    assert choose(vectors, ["s", "t"], 1.0) == pytest.approx({"s": 3.0, "t": 4.0})


def test_a_length_that_no_loop_fixes_is_a_usual_one():
    assert choose([open_vector("O", "A", X)], ["OA"], 0.7) != {}
    assert choose([DrawnVector("O", "A", Linear(parts={"s": X}))], ["s"], 0.7) == {"s": 0.7}


def test_no_rod_is_turned_round_where_loops_allow_it():
    """s − t = 2 with both near 1: the nearest are 2 and 0, which is shorter than drawn."""
    vectors = [
        DrawnVector("O", "A", Linear(parts={"s": X})),
        DrawnVector("A", "B", Linear(parts={"t": X.times(-1)})),
        DrawnVector("O", "B", Linear(Plane(2.0, 0.0))),
    ]
    found = choose(vectors, ["s", "t"], 1.0)
    assert found["s"] - found["t"] == pytest.approx(2.0)
    assert found["t"] == pytest.approx(0.2)


def test_linear_vectors_add_part_by_part():
    one, other = Linear(X, {"s": Y}), Linear(Y, {"s": X, "t": Y})
    assert one.plus(other, -1).at({"s": 2.0, "t": 3.0}) == Plane(1.0 - 2.0, -1.0 + 2.0 - 3.0)


# ---------------------------------------------------------------------------- points


def between(figure, tail, head):
    return figure.points[head].minus(figure.points[tail])


def test_a_lever_is_drawn_as_its_vectors_say():
    figure = draw(lever())
    assert between(figure, "O", "A") == near(polar(A, ALPHA))
    assert between(figure, "O", "B") == near(polar(B, ALPHA + math.pi / 2))


def test_a_slider_crank_is_drawn_link_by_link():
    figure = draw(slider_crank())
    reach = polar(R, PHI).plus(polar(L, PSI))
    assert between(figure, "O", "B") == near(reach)


def test_given_values_move_the_points():
    figure = draw(lever(), {"alpha": 1.0})
    assert between(figure, "O", "A") == near(polar(A, 1.0))


def test_halves_are_images_of_one_another():
    pose = two_bars(mirror=Mirror(ALONG, ("K",), HERE), axis=at(90))
    figure = draw(pose)
    half, twin = between(figure, "K", "B"), between(figure, "K", "B'")
    assert (twin.x, twin.y) == pytest.approx((-half.x, half.y))


def test_gears_touch_and_belts_leave_room():
    gears, belt = draw(on_pivots(wheels())), draw(on_pivots(wheels("belt", same=True)))
    assert math.hypot(*between(gears, "O", "Q")) == pytest.approx(R + C)
    assert math.hypot(*between(belt, "O", "Q")) > R + C


def test_inner_gears_are_apart_by_the_difference_of_their_radii():
    figure = draw(on_pivots(wheels(same=True)))
    assert math.hypot(*between(figure, "O", "Q")) == pytest.approx(C - R)


def test_a_rack_passes_its_pivot_on_the_right_of_its_guide():
    """The guide leads up: with the pivot on its left the rack is a radius to the right of that."""
    figure = draw(driven_slider(RACK))
    assert between(figure, "O", "K").x == pytest.approx(R)
    assert any(isinstance(part, Rack) for part in figure.parts)


def test_a_pin_lies_in_its_slot():
    figure = draw(slotted())
    apart = between(figure, "Q", "A")
    turn = VALUES["theta"]
    assert apart.x * math.sin(turn) == pytest.approx(apart.y * math.cos(turn))


def test_a_slider_is_guided_along_its_direction():
    vectors = LinearVectors(slider_crank(), VALUES)
    assert vectors.guide("B") == near(X)
    assert vectors.unit(at(90)) == near(Y)


def test_a_given_length_is_measured_along_its_vector():
    pose = lever()
    entry = Arrow("O", "A", Symbol("a"), None, HERE)
    figure = draw(replace(pose, mechanism=replace(pose.mechanism, geometry=(entry,))))
    (mark,) = [part for part in figure.parts if isinstance(part, DimensionLine)]
    assert (mark.text, mark.value) == ("a", pytest.approx(A))
    assert mark.along == near(polar(1.0, ALPHA))


@pytest.mark.parametrize(
    ("given", "start", "sweep", "name"),
    [
        (ALPHA_, 0.0, ALPHA, "alpha"),
        (total([ALPHA_, degrees(30)]), math.pi / 6, ALPHA, "alpha"),
        (total([ALPHA_, number(Fraction(1, 2))]), 0.5, ALPHA, "alpha"),
        (total([negative(ALPHA_), degrees(90)]), math.pi / 2, -ALPHA, "alpha"),
        (total([PHI_, negative(ALPHA_)]), 0.0, PHI - ALPHA, "phi - alpha"),
        (total([negative(PHI_), negative(ALPHA_)]), 0.0, -PHI - ALPHA, "alpha + phi"),
    ],
)
def test_an_angle_is_marked_from_its_constant_part_on(given, start, sweep, name):
    """What turns clockwise is marked so, by its name without the minus."""
    pose = lever()
    load = Force("F", "A", Absolute(given, HERE), HERE)
    figure = draw(replace(pose, mechanism=replace(pose.mechanism, geometry=(), loads=(load,))))
    (mark,) = [part for part in figure.parts if isinstance(part, AngleMark)]
    assert (mark.vertex, mark.text) == ("A", name)
    assert (mark.start, mark.sweep) == pytest.approx((start, sweep))


@pytest.mark.parametrize("given", [Absolute(degrees(30), HERE), AlongLine("O", "A", 0, HERE)])
def test_no_angle_is_marked_where_none_has_a_name(given):
    pose = lever()
    load = Force("F", "A", given, HERE)
    figure = draw(replace(pose, mechanism=replace(pose.mechanism, geometry=(), loads=(load,))))
    assert not [part for part in figure.parts if isinstance(part, AngleMark)]


@pytest.mark.parametrize(("down", "touches"), [(-1.0, 1.0), (1.0, -1.0)])
def test_a_rope_runs_on_the_outside_of_a_bend(down, touches):
    """From the left over a pulley at the origin: bent down it lies on top, bent up below."""
    ends = (Plane(-3.0, 0.0), Plane(0.0, 0.0), Plane(3.0, down))
    first, second = rope_runs(ends, (None, None, None), 0.5)
    for run, rim in ((first, first.end), (second, second.start)):
        assert math.hypot(*rim) == pytest.approx(0.5)
        assert rim.y * touches > 0.4
        assert run.end.minus(run.start).dot(rim) == pytest.approx(0.0, abs=1e-12)


def test_gears_touch_on_the_line_of_their_centres_wherever_it_leads():
    small, large = Circle(Plane(1.0, 1.0), 1.0), Circle(Plane(1.0, 4.0), 2.0)
    assert pitch_point(small, large, inner=False) == pytest.approx((1, 2))
    assert pitch_point(large, small, inner=False) == pytest.approx((1, 2))


@pytest.mark.parametrize(
    ("gaps", "chosen"),
    [
        ({1.0: 0.02, 1.3: 0.03, 1.6: 0.4}, 1.6),  # twins that nearly meet are no layout
        ({1.0: 0.02, 1.3: 0.4}, 1.3),
        ({1.0: 0.4}, 1.0),
        ({1.0: 0.0}, 1.0),  # a point on the mirror line is its own twin
    ],
)
def test_open_lengths_grow_until_twins_are_apart(monkeypatch, gaps, chosen):
    def laid_out(vectors, factor):
        points = {"B": Plane(gaps.get(factor, 1.0), 0.0)}
        return layout.FigureLayout(points, MirrorLine(Plane(0.0, 0.0), Y), {"a": factor}, 1.0, 0.0)

    monkeypatch.setattr(layout, "_laid_out", laid_out)
    mirror = SimpleNamespace(mirror=SimpleNamespace(sharing=()))
    found = layout.lay_out(SimpleNamespace(pose=SimpleNamespace(mechanism=mirror)))
    assert found.lengths == {"a": chosen}


# ------------------------------------------------------------------------ velocities


def velocities(pose):
    """Return the velocities per unit of the crank's angular velocity."""
    found = plan(pose)
    (drive,) = found.drives
    return rates(found, draw(pose), VALUES, drive)


def test_the_rod_of_a_crank_turns_as_its_slider_stays_on_its_guide():
    """r cos φ + ω l cos ψ = 0 across the guide."""
    found = velocities(slider_crank())
    spin = -R * math.cos(PHI) / (L * math.cos(PSI))
    assert found.spins == pytest.approx({"OA": 1.0, "AB": spin})
    assert found.points["A"] == near(polar(R, PHI + math.pi / 2))
    speed = -R * math.sin(PHI) - spin * L * math.sin(PSI)
    assert found.points["B"] == near(Plane(speed, 0.0))
    assert found.largest == pytest.approx(R)


def test_a_pin_slides_along_its_slot():
    """The velocity of A less that of the point of the slot under it leads along the slot."""
    (sliding,) = velocities(slotted()).slidings
    theta = VALUES["theta"]
    along = A * math.cos(PHI + math.pi / 2 - theta)
    assert (sliding.point, sliding.body) == ("A", "QB")
    assert sliding.velocity == near(polar(along, theta))


def test_the_drive_is_as_fast_as_the_coordinates_of_points_say():
    """Per unit of the drive A moves by (−1.5, 2); it moves by (−3, 4) in a second."""

    class Known(_MotionMaker):
        def _slopes(self):
            yield from [("A", "x", -3.0), ("A", "y", 4.0)]

    here = MotionVelocities("", {"A": Plane(-1.5, 2.0)}, {}, ())
    assert Known(None, None, None, 0)._rate(here) == pytest.approx(2.0)
    assert _MotionMaker(None, None, None, 0)._rate(here) == 0


class Asked(_MotionMaker):
    """What is driven is told, as a balance would tell it."""

    def __init__(self, load, *quantities):
        graph = SimpleNamespace(pose=slider_crank(definitions=[("w", number(2))]))
        solved, term = SimpleNamespace(above=load.name), SimpleNamespace(load=load)
        balance = SimpleNamespace(solved=[solved], terms=[term], plan=SimpleNamespace(graph=graph))
        motion = SimpleNamespace(quantities=quantities, definitions=[("v", product_of("w", "r"))])
        super().__init__(balance, SimpleNamespace(values=VALUES), motion, 0)


def product_of(*names):
    return product((Symbol(name), 1) for name in names)


@pytest.mark.parametrize(
    ("load", "points"),
    [
        (torque("T", "AB"), ("A", "B")),
        (force("F", "B"), ("B",)),
        (ForcePair("S", "O", "B", HERE), ("B", "O")),
    ],
)
def test_velocities_are_measured_by_what_the_driving_load_acts_on(load, points):
    assert Asked(load)._loaded() == points


def test_velocities_and_slopes_of_coordinates_say_how_fast_the_drive_is():
    """v = w r with w = 2 of the pose; accelerations and directions say nothing of it."""

    def quantity(kind, axis):
        return SimpleNamespace(kind=kind, axis=axis, of="B", formula=Symbol("v"))

    asked = [("velocity", "x"), ("slope", "y"), ("acceleration", "x"), ("velocity", "")]
    found = Asked(torque("M", "OA"), *(quantity(*each) for each in asked))._slopes()
    assert list(found) == [("B", "x", pytest.approx(2 * R)), ("B", "y", pytest.approx(2 * R))]


@pytest.mark.parametrize(("phi", "ground"), [(90, (0, -1)), (-90, (0, 1)), (-30, (0, -1))])
def test_the_ground_of_a_pivot_is_down_unless_a_bar_hangs_there(phi, ground):
    figure = draw(slider_crank(), {"phi": math.radians(phi)})
    (pivot,) = (part for part in figure.parts if isinstance(part, Pivot))
    assert pivot.ground == ground


@pytest.mark.parametrize(
    ("speeds", "per"),
    [
        ({"O": 0.0, "A": 2.0, "B": 3.0}, "A"),
        ({"O": 1e-14, "A": 2.0, "B": 3.0}, "A"),
        ({"O": 0.5, "A": 2.0, "B": 3.0}, "O"),
        ({"O": 0.0, "A": 0.0, "B": 3.0}, "B"),
    ],
)
def test_the_unit_is_the_speed_of_the_first_point_of_the_load_that_moves(speeds, per):
    """A couple on OA: of O where it moves by more than rounding, of A, else of the fastest."""
    here = MotionVelocities("", {name: Plane(0.0, v) for name, v in speeds.items()}, {}, ())
    assert Asked(torque("M", "OA"))._reference(here) == per


@pytest.mark.parametrize("largest", [0.0, math.inf, math.nan])
def test_there_are_no_velocities_where_the_drive_moves_nothing(monkeypatch, largest):
    here = MotionVelocities("", {"A": Plane(0.0, largest)}, {}, ())
    monkeypatch.setattr(from_balance, "rates", lambda *_: here)
    monkeypatch.setattr(_MotionMaker, "_at_other_lengths", lambda self: VALUES)
    monkeypatch.setattr(_MotionMaker, "_pace", lambda self, here: 1.0)
    assert Asked(torque("M", "OA")).made() is None


@pytest.mark.parametrize(
    ("sharing", "at", "along"),
    [((), (-1.0 - layout.PARTS_APART * 2.0, 0.0), Y), (("B",), (-1.0, 4.0), Y)],
)
def test_a_mirror_line_goes_through_what_halves_share_or_beside_all_points(sharing, at, along):
    """Its left is −x: of A at 3 and B at −1 the line is left, by some room."""
    points = {"A": Plane(3.0, 0.0), "B": Plane(-1.0, 4.0)}
    line = layout._Table(Y, 2.0)._line(points, sharing)
    assert (line.at, line.along) == (near(Plane(*at)), along)
    assert layout._Table(None, 2.0)._line(points, sharing) is None


def test_numbers_of_a_length_are_in_the_unit_that_they_were_written_in():
    """One in inches alone, one that is no length, and one that nothing says: millimetres."""
    inch = Parameter("len_OA", LENGTH, HERE, number(1), unit="in")
    mass = Parameter("m", MASS, HERE, number(1), unit="kg")
    mechanism = replace(lever().mechanism, parameters=(), literals=(mass, inch))
    assert dimensions._unit(Constant("len_OA", number(1)), mechanism) == "in"
    assert dimensions._unit(Constant("m", number(1)), mechanism) != "kg"
    other = replace(mechanism, literals=(inch, replace(inch, name="len_OB", unit="cm")))
    assert dimensions._unit(Constant("len_OB", number(1)), other) == "cm"


@pytest.mark.parametrize(
    ("first", "second", "inner", "at"),
    [(1.0, 2.0, False, 1.0), (1.0, 4.0, True, -1.0), (4.0, 1.0, True, 4.0)],
)
def test_inner_gears_touch_beyond_the_centre_of_the_smaller_one(first, second, inner, at):
    wheels = Circle(Plane(0.0, 0.0), first), Circle(Plane(3.0, 0.0), second)
    assert pitch_point(*wheels, inner=inner) == Plane(at, 0.0)


@pytest.mark.parametrize("x", [2.0, -2.0])
def test_what_nothing_connects_goes_on_the_side_of_its_half(x):
    line = MirrorLine(Plane(1.0, 0.0), Y)
    side = layout._Table(Y, 1.0)._side({"A": Plane(x, 0.0), "B": Plane(x, 3.0)}, line)
    assert side == Plane(math.copysign(1.0, x - 1.0), 0.0)
    assert layout._Table(None, 1.0)._side({"A": Plane(x, 0.0)}, None) == X


@pytest.mark.parametrize(("sense", "power"), [("tightening", 2.5), ("releasing", -2.5)])
def test_the_driving_load_does_work_unless_it_is_released(sense, power):
    made = Asked(torque("M", "OA"))
    plan = made.balance.plan
    pose = replace(
        plan.graph.pose,
        mechanism=replace(plan.graph.pose.mechanism, friction=Friction(sense=sense)),
    )
    plan.graph.pose, made.balance.terms[0].power = pose, [Product(Fraction(5, 2))]
    assert made._work() == power


@pytest.mark.parametrize(("shared", "ground"), [("O", (-1, 0)), ("", (0, -1))])
def test_the_ground_of_a_shared_pivot_is_where_no_bar_of_either_half_is(shared, ground):
    """OB goes up at 60°; its image across the x-axis comes as near to straight down."""
    mirror = Mirror(Absolute(ZERO, HERE), tuple(shared), HERE)
    figure = draw(two_bars(mirror=mirror, axis=at(0)), {"alpha": math.radians(-30)})
    pivot = next(part for part in figure.parts if isinstance(part, Pivot) and part.point == "O")
    assert pivot.ground == pytest.approx(ground)
