"""Forces at joints of random mechanisms, against a dense equilibrium, and by their laws."""

import math
from random import Random

import numpy as np
import pytest

import force_mechanisms
import mechc
from force_samples import (
    LARGEST_CONDITION,
    Compiled,
    compiled,
    reference,
    samples,
    sizes_of,
)
from gripping_brake import gripping_brake
from mechc.compilation import Compilation, compile_source
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import is_call
from mechc.formula.walk import walk
from mechc.model.mechanism import ForcePair
from mechc.source import Source
from reference_forces import Forces
from small_mechanisms import toggle
from sources import in_thirds

ENOUGH = 1e-9
"""What a force may be off, as a part of the largest one in the mechanism."""


def known_of(forces: Forces, asked: str, found: np.ndarray) -> dict[str, float]:
    """Return the targets of one ``find``, by the names of its results."""
    name, _, link = asked.partition(" on ")
    values = [forces.value(found, w) for w in forces.weights(name, link)]
    result = f"{name}_on_{link}" if link else name
    if len(values) == 1:
        return {result: values[0]}
    return {f"{result}_x": values[0], f"{result}_y": values[1], result: math.hypot(*values)}


def compare(sample: force_mechanisms.Sample, made: Compiled, values: dict[str, float]) -> float:
    """Return the largest error among all forces at joints at a pose, 0 near singular ones."""
    forces = reference(sample, made.tree, values)
    sizes = sizes_of(sample, forces, 1.3)
    found, condition = forces.solve(sample.drive, sizes)
    if condition > LARGEST_CONDITION:
        return 0.0
    results = made.results({**values, **sizes, sample.drive: float(found[-1])})
    scale = float(np.abs(found[:-1]).max())
    errors = [
        abs(results[name] - value)
        for asked in sample.asked
        for name, value in known_of(forces, asked, found).items()
    ]
    return max(errors, default=0.0) / scale


def against_coordinates(seeds: range, ratio: bool) -> list[float]:
    errors = []
    for seed, sample in samples(seeds, ratio):
        made = compiled(sample.finding(), f"reactions_{seed}.mech")
        for values in (made.values(), made.nearby(Random(seed))):
            errors.append(compare(sample, made, values))
            assert errors[-1] < ENOUGH, f"seed {seed}: {errors[-1]}"
    return errors


@pytest.mark.parametrize("ratio", [True, False])
def test_random_mechanisms(ratio):
    assert len(against_coordinates(range(3), ratio)) > 3


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [True, False])
def test_many_random_mechanisms(ratio, record_property):
    errors = against_coordinates(range(3, 23), ratio)
    record_property("worst error", max(errors))
    assert len(errors) > 25


BOOM = """
param a = 4 m
param alpha = 20 deg in 5 deg .. 40 deg
param beta = 45 deg in 30 deg .. 60 deg
pivot O at (0 m, 0 m)
pivot B
link OGA
slider C along y
OG = a/2 @ alpha
OA = a @ alpha
rope A, B along 180 deg - beta, C along -y
force W at G along -y
force P at C along -80 deg
find P
find N_AB
find R_O
"""


def test_the_tension_of_a_rope():
    """Against the dense equilibrium; the guide of the hand is pressed, too."""
    made = compiled(BOOM, "boom.mech")
    values = made.values()
    forces = Forces(made.tree, values)
    found, _ = forces.solve("P", {"W": 1.3})
    results = made.results({**values, "W": 1.3})
    for asked in ("N_AB", "R_O"):
        for name, value in known_of(forces, asked, found).items():
            assert results[name] == pytest.approx(value, rel=1e-12)
    assert results["P"] == pytest.approx(found[-1], rel=1e-12)


# ------------------------------------------------------------------------------ laws

NOT_PLAIN = {"mirror", "copies", "slide", "M"}
"""Words of samples in which more than pins and guides of one plane presses on the ground."""

PLAIN = [
    seed for seed in range(60) if not NOT_PLAIN & set(force_mechanisms.given(seed).text.split())
][:12]


@pytest.fixture(params=in_thirds(PLAIN), scope="module")
def plain(request):
    (case,) = list(samples(range(request.param, request.param + 1))) or [None]
    if case is None:
        pytest.skip("near a singular pose")
    seed, sample = case
    return sample, compiled(sample.finding(), f"law_{seed}.mech")


def evaluated(sample, made, turned=0.0, size=1.0):
    """Return values and results with P in balance, the drawing turned, loads times a size."""
    values = {
        n: v + turned if n.startswith("t") and n[1:].isdigit() else v
        for n, v in made.values().items()
    }
    loads = {"F": size, "P": made.results(values)["k"] * size}
    return {**values, **loads}, made.results({**values, **loads})


def test_turning_the_drawing_turns_the_forces(plain):
    sample, made = plain
    (_, before), (_, after) = evaluated(sample, made), evaluated(sample, made, turned=0.7)
    size = max(abs(v) for n, v in before.items() if n[0] in "RN" and "direction" not in n)
    for name, value in before.items():
        if name.endswith("_x"):
            pin = name.removesuffix("_x")
            force, turned = (complex(r[f"{pin}_x"], r[f"{pin}_y"]) for r in (before, after))
            assert abs(turned - force * np.exp(0.7j)) < 1e-9 * size
        elif name[0] == "N" or (name[0] == "R" and f"{name}_x" in before):
            assert after[name] == pytest.approx(value, rel=1e-9, abs=1e-9 * size)


def test_loads_and_forces_grow_together(plain):
    """Three times the loads turned round: components and N turn too, sizes stay positive."""
    sample, made = plain
    (_, once), (_, thrice) = evaluated(sample, made), evaluated(sample, made, size=-3.0)
    for name, value in once.items():
        if name[0] in "RN" and not name.endswith("direction"):
            turns = name[0] == "N" or name.endswith(("_x", "_y"))
            assert thrice[name] == pytest.approx((-3 if turns else 3) * value, rel=1e-12)


def loads_on(made, values):
    """Return the forces of the loads on each point."""
    found: dict[str, complex] = {}
    for load in made.compilation.mechanism.loads:
        line = made.compilation.pose.lines.get(load.name)
        if line is not None:
            size = values[load.name] if load.tie is None else evaluate(load.tie, values)
            push = float(load.times) * size * np.exp(1j * line.evaluate(values))
            pair = isinstance(load, ForcePair)
            ends = [(load.second, 1), (load.first, -1)] if pair else [(load.point, 1)]
            for point, sign in ends:
                found[point] = found.get(point, 0) + sign * push
    return found


def test_what_acts_on_links_at_a_pin_adds_up_to_what_acts_on_the_pin(plain):
    """Action is reaction: forces on links at a pin, ground, loads."""
    sample, made = plain
    values, results = evaluated(sample, made)
    loads, size = loads_on(made, values), max(abs(v) for v in results.values())
    pins = {name.split("_")[1] for name in results if "_on_" in name}
    touched = {t.point for t in made.compilation.pose.contacts}
    for pin in pins - touched:
        names = [n for n in results if n.startswith(f"R_{pin}_on_") and n.endswith("_x")]
        links = [k for k in made.compilation.mechanism.links if pin in k.points]
        if len(names) < len(links):
            continue
        on_links = sum(complex(results[n], results[f"{n[:-1]}y"]) for n in names)
        ground = complex(results.get(f"R_{pin}_x", 0.0), results.get(f"R_{pin}_y", 0.0))
        assert abs(on_links - ground - loads.get(pin, 0)) < 1e-9 * size


def test_the_ground_carries_all_loads(plain):
    sample, made = plain
    values, results = evaluated(sample, made)
    ground = [n for n in results if n.startswith("R_") and n.endswith("_x") and "_on_" not in n]
    held = sum(complex(results[n], results[f"{n[:-1]}y"]) for n in ground)
    size = max(abs(v) for v in results.values())
    assert abs(held + sum(loads_on(made, values).values())) < 1e-9 * size


WEDGE = """
param beta = 8 deg
param a = 30 mm
param b = 60 mm
slide WX along x
pivot O
link OAC
OA = a @ 180 deg
OC = b @ 90 deg
contact A on WX normal 90 deg + beta
force P at W along -x
force F at C along -x
find P
find N_W
"""


def test_the_guide_of_a_slide_has_a_normal_force():
    """F·b = N·a·cos β about O, and the guide holds what the wedge pushes down: N·cos β."""
    assert mechc.loads(WEDGE).evaluate(F=10.0)["N_W"] == pytest.approx(20.0)


FRAME = """
param h = 1 m
param s = 2.4 m
pivot E at (0 m, 0 m)
slider F along x
link ACE
link BDF
link AB
link CD
EC = (0 m, h)
EA = (0 m, 4*h)
FD = (0 m, 2*h)
FB = (0 m, 3*h)
AB = (s, -h)
CD = (s, h)
force P at A along x
force Q at F along x
force W at F along -y
find Q, N_F, N_AB, N_CD
expect N_F = 4*h*P/s + W
expect N_AB = -8*sqrt(h^2 + s^2)*P/(5*s)
expect N_CD = 12*sqrt(h^2 + s^2)*P/(5*s)
"""


def test_a_slanting_rod_given_by_components_has_its_whole_force():
    """Two uprights and two braces: after Beer, Johnston, Vector mechanics, problem 6.6."""
    results = mechc.loads(FRAME).evaluate(P=3000.0, W=0.0)
    assert results["N_AB"] == pytest.approx(-5200)
    assert results["N_CD"] == pytest.approx(7800)


def test_a_load_that_a_reaction_shows_has_an_influence():
    """W does no work, but presses the guide of F."""
    assert not mechc.loads(FRAME).warnings
    (warning,) = mechc.loads(FRAME.replace("N_F, ", "").replace("expect N_F", "#")).warnings
    assert warning.code == "W501"


@pytest.mark.parametrize("friction", ["", "friction slider K 0.1\nfriction pins 0.1 diameter 2 cm"])
def test_a_component_that_is_exactly_zero_is_no_disagreement(friction):
    """Its weight in equilibrium is the rounded cosine of 90°."""
    text = toggle("find k = P/F", "find R_K, N_K, R_K on BK", friction)
    assert mechc.loads(text).evaluate(F=1.0)["R_K_y"] == 0


def test_two_points_of_a_link_in_one_place_move_alike():
    """Two rods on the ground press on one point of a body, once with two names for it."""
    body = "link DE{}\nDE = 100 mm @ 45 deg\n{}link BE\nBE = 80 mm @ 0 deg\n"
    given = "pivot A\npivot C\nlink AD\nAD = 60 mm @ 135 deg\nlink C{}\nC{} = 70 mm @ 90 deg\n"
    loads = "slider B along 20 deg\nforce P at B along 20 deg\nforce F at E along {}\nfind k = P/F"
    apart = body.format("G", "DG = 100 mm @ 45 deg\n") + given.format("G", "G")
    once = body.format("", "") + given.format("E", "E")
    for along in ("90 deg", "10 deg"):
        one, two = (mechc.loads(t + loads.format(along)).evaluate()["k"] for t in (once, apart))
        assert one == pytest.approx(two, rel=1e-12)


def test_sizes_of_forces_and_speeds_are_positive_for_whatever_lengths():
    lever = mechc.loads("""param a = 30 mm
param b = 80 mm
pivot O
link OAB
OA = a @ 20 deg
AB = b @ 200 deg
force P at A along y
force F at B along y
find k = F/P
find R_O
find V_B/V_A
""")
    a, b = np.array([0.03, 0.08, 0.1]), 0.08
    found = lever.evaluate(a=a, b=b, P=1.0)
    assert found["R_O"] == pytest.approx(np.abs(found["R_O_y"]))
    assert found["V_B_over_V_A"] == pytest.approx(np.abs(b - a) / a)


BEAM = """
pivot A at (0 mm, 0 mm)
slider B along x
link ACDB
C at (30 mm, 0 mm)
D at (80 mm, 0 mm)
B at (100 mm, 0 mm)
force F at C along -y
force G at D along -y
find R_A
"""

BRAKE = gripping_brake("0.4", "find M, R_C")


@pytest.mark.parametrize(("text", "name"), [(BEAM, "R_A"), (BRAKE, "R_C"), (BRAKE, "R_C_f")])
def test_a_force_of_one_component_is_the_size_of_that(text, name):
    """With several loads, or friction that is found by iteration."""
    result = mechc.loads(text).results[name]
    assert not any(is_call(part, "hypot") for part in walk(result.formula))


def test_a_force_of_one_component_is_positive():
    assert mechc.loads(BEAM).evaluate(F=10.0, G=-50.0)["R_A"] == pytest.approx(3)


def test_a_force_that_is_zero_has_no_direction_with_friction_or_without():
    balanced = mechc.loads("""
pivot O
link OA
OA = 1 m @ 0 deg
torque M on OA
torque T on OA
friction pin O 0.1 diameter 10 mm
find k = M/T
find R_O
""")
    for name in ("R_O_direction", "R_O_direction_f"):
        result = balanced.results[name]
        assert result.undetermined
        assert result.default is None


LEVER_OF_TWO_FORCES = """
mechanism lever
param phi = 180 deg in 0 deg .. 180 deg
pivot O
link OA
OA = 100 mm @ phi
force Q at A along x
force P at A along phi
torque M on OA
find k = M/Q
find R_O
"""


def test_a_force_that_is_zero_at_a_pose_has_no_direction_there():
    """R_O is −Q·i − P·e: nothing but rounding where e is −i and P is Q, and −2Q·i where it is i."""
    lever = mechc.loads(LEVER_OF_TWO_FORCES)
    here = lever.evaluate(Q=2000.0, P=2000.0)
    assert math.isnan(here["R_O_direction"])
    assert abs(here["R_O_x"]) < ENOUGH
    angles = lever.evaluate(phi=[0.0, math.pi, math.pi / 2], Q=2.0, P=2.0)["R_O_direction"]
    assert np.abs(angles[[0, 2]]) == pytest.approx([math.pi, 0.75 * math.pi])
    assert math.isnan(angles[1])
    assert not math.isnan(lever.evaluate(phi=math.pi - 1e-9, Q=2.0, P=2.0)["R_O_direction"])
    header = "".join(str(part) for part in lever.emit("python"))
    assert "the force is more than what rounding leaves of one that is zero" in header


def test_a_force_that_is_zero_in_every_pose_has_no_direction_in_code():
    source = LEVER_OF_TWO_FORCES.replace("force Q at A along x", "torque Q on OA")
    lever = mechc.loads(source.replace("force P at A along phi", ""))
    assert lever.evaluate()["R_O"] == 0
    assert math.isnan(lever.evaluate()["R_O_direction"])


def test_forces_at_joints_have_the_sine_that_the_load_has():
    """It is that of the angle between cylinder and boom, positive: R_O_x had the opposite one."""
    source = """
    mechanism loader
    pivot O at (0 mm, 0 mm)
    pivot Q at (300 mm, -450 mm)
    link OAB
    telescope QA
    A at (900 mm, -150 mm)
    B at (2200 mm, -300 mm)
    drive OA from -20 deg to 40 deg
    actuator P between Q and A
    weight W mass 1200 kg at B
    find P
    find R_O
    """
    found = compile_source(Source("loader.mech", source))
    assert isinstance(found, Compilation)
    shown = [text(result.formula) for result in found.results[:3]]
    assert all("sin(phi_QA - phi_OA)" in formula for formula in shown)
    assert shown[1].startswith("-")
