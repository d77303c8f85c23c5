"""Whatever is said of friction holds against sampling of code, over random mechanisms."""

import math
import re
from collections.abc import Iterable
from functools import cache

import pytest

from friction_chains import chain
from friction_mechanisms import closed, opened
from friction_statements import Ratios, as_given, printed, refuted, throughout
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.formula.tree import Symbol
from mechc.routine.evaluate import evaluate
from mechc.source import Source
from paths import LIBRARY


def hold(texts: Iterable[str | None]) -> int:
    """Compile descriptions and try what is said; return how many had a result."""
    compiled = 0
    for text in filter(None, texts):
        compilation = Compilation(Source("sampled.mech", text))
        try:
            _ = compilation.results
        except MechcError as error:
            if {d.code for d in error.diagnostics} & {"E601", "E817"}:
                raise
            continue
        assert list(refuted(compilation)) == [], text
        compiled += 1
    return compiled


@pytest.mark.slow
@pytest.mark.parametrize("seed", [70031, 70149])
def test_beside_the_end_of_a_loop_friction_is_looked_at(seed):
    assert hold([closed(seed)]) == 1


@pytest.mark.slow
def test_an_efficiency_that_is_highest_between_a_jump_and_the_next_place():
    assert hold([closed(70081)]) == 1


@pytest.mark.slow
def test_a_pin_that_nothing_loads_but_its_own_friction_jams_nothing():
    """Beside the end of a loop a jam was told; all forces balance with none in that pin."""
    text = re.sub(r"(assembly A4P.*\n)+", "assembly A4 forward\n", closed(91000313))
    assert hold([text]) == 1
    (held,) = (r for r in Compilation(Source("pin.mech", text)).results if r.name == "k_hold")
    (reach,) = (r for r in held.locking.reaches if r.parameter == "phi")
    assert "jammed" not in {s.state for s in reach.stretches}


@pytest.mark.slow
def test_an_efficiency_that_is_highest_at_a_kink():
    """It rises to 0.842 and falls by a hundredth within 0.0002 rad, as a pin is pressed anew."""
    assert hold([opened(6000195)]) == 1


ISLAND = """
param t1 = 335.15 deg in 310 deg .. 350 deg
pivot O
slider A along 153.38 deg
link OB
link ABC
BA = 70.2 mm @ t1
OB = 133.2 mm @ 123.13 deg
BC = 84.2 mm @ 204.89 deg
force P at A along 153.38 deg
force F at C along 347.32 deg
friction pins 0.054 diameter 13.7 mm
friction slider A 0.185
find k = P/F
"""


def test_between_places_where_nothing_moves_something_may():
    """F alone moves it from 321.1 to 324.7 degrees, k_hold being 0.0008 at most."""
    compilation = Compilation(Source("island.mech", ISLAND))
    assert list(refuted(compilation)) == []
    (held,) = (r.locking.reaches[0] for r in compilation.results if r.name == "k_hold")
    assert [s.state for s in held.stretches] == ["locked", "locked"]


FLAT_TRIANGLE = """
pivot O at (0 m, 0 m)
pivot P5 at (-0.05057409178558583 m, 0.012031212600128606 m)
param s = 0.06809140590232102 m
param r = 0.09852701819996858 m
telescope P5A4
P5A4 = s
link OA4
OA4 = r
slot T7 in OA4
pivot G8 at (0.03869348847101853 m, 0.08116002377487655 m)
slider T7 along 2.8634872702108636 rad through G8
assembly OP5A4 cw
actuator M between P5 and A4
force F at T7 along 2.2406593176157106 rad
find k = M / F
drive s from 0.028091405902321016 m to 0.10809140590232102 m
friction pins 0.031 diameter 6 mm journal
friction contact T7 0.031
"""


def test_between_two_jams_next_to_a_flat_triangle_the_drive_moves_it():
    """For 1e-5 m it moves, 7e-7 m from where loops end: one jam was stated up to that end."""
    compilation = Compilation(Source("flat.mech", FLAT_TRIANGLE))
    (k_f,) = (r for r in compilation.results if r.name == "k_f")
    (reach,) = k_f.locking.reaches
    first, second = reach.stretches
    assert [s.state for s in reach.stretches] == ["jammed", "jammed"]
    assert (first.high.x, second.low.x) == pytest.approx((0.0465422551, 0.0465516727), abs=1e-9)
    assert list(refuted(compilation)) == []


TRAMMEL = """
param a = 60 mm
param phi = 90 deg
drive phi from 60 deg to 180 deg
pivot O at (0 mm, 0 mm)
link OA
link BAC
OA = a @ phi
AB = a
AC = 2*a @ BA
slider B along y through O
assembly B forward
friction pins 0.1 diameter 8 mm
force F at C along 45 deg
torque M on OA
find k = M/F
"""


def test_it_is_looked_at_beside_an_end_at_which_nothing_is_known():
    """At 180 degrees two ways go on, and k is finite; k_hold grows without end up to 179.24."""
    compilation = Compilation(Source("trammel.mech", TRAMMEL))
    (held,) = (r for r in compilation.results if r.name == "k_hold")
    (reach,) = held.locking.reaches
    ratios = Ratios(compilation, held)
    inside, beyond = reach.stretches[-1].within
    assert [s.state for s in reach.stretches] == ["locked", "jammed"]
    assert beyond == pytest.approx(math.pi, abs=1e-6)
    assert ratios.states({"phi": [inside - 1e-6, inside + 1e-6, 3.14]}).tolist() == [0, 4, 4]


@pytest.mark.slow
def test_up_to_a_jam_it_moves_with_a_force_that_grows_beyond_all():
    """k_f grows from 0.15 at -0.3 rad to 16 at 0.39: by short steps it was said to jam there."""
    text = closed(91000317)
    assert text is not None
    compilation = Compilation(Source("island.mech", text))
    assert list(refuted(compilation)) == []
    (k_f,) = (r for r in compilation.results if r.name == "k_f")
    (reach,) = (r for r in k_f.locking.reaches if r.parameter == "phi")
    assert [round(end, 2) for s in reach.stretches[:2] for end in s.within] == [
        0.41,
        0.97,
        3.55,
        4.12,
    ]
    code = next(f for f in compilation.routine.functions if f.name == "k_f")
    given = {i.name: i.default for i in code.inputs}
    grown = [evaluate(code, {**given, "phi": 0.03 * i}) for i in range(-10, 14)]
    assert grown == sorted(grown)
    assert grown[0] == pytest.approx(0.1535, abs=1e-3)
    assert grown[-1] == pytest.approx(15.87, abs=1e-2)


@pytest.mark.slow
def test_a_zero_next_to_a_pole_parts_what_is_locked_from_what_jams():
    """k_hold is locked to 284.233 deg, where k is 0, jams to 284.24, where k is infinite."""
    compilation = Compilation(Source("chain.mech", chain(79050003)))
    assert list(refuted(compilation)) == []
    (held,) = (r for r in compilation.results if r.name == "k_hold")
    (reach,) = (r for r in held.locking.reaches if r.parameter == "t2")
    assert [s.state for s in reach.stretches] == ["locked", "jammed"]


@pytest.mark.slow
def test_between_an_end_of_a_loop_and_a_jam_it_moves():
    """k_hold is infinite at the end, and smaller than any at -1.6415 rad, and again at -1.636."""
    assert hold([closed(144000543)]) == 1


@pytest.mark.slow
def test_an_efficiency_is_lowest_two_places_after_it_is_highest():
    compilation = Compilation(Source("stroke.mech", closed(144000543)))
    turns = [e for e in compilation.stroke(0).extrema if e.result == "eta_k"]
    least = next(e for e in turns if e.kind == "minimum")
    assert (least.drive, least.value) == (
        pytest.approx(-4.53108, abs=1e-5),
        pytest.approx(0.879514, abs=1e-6),
    )


@cache
def next_to_a_pole():
    return Compilation(Source("chain.mech", chain(79050003)))


@pytest.mark.parametrize("degrees", [284.2405, 284.241, 284.25, 284.27])
def test_where_k_is_nearly_infinite_it_moves_with_a_force_that_is_not(degrees):
    """k is 12.2 next to 284.24 deg and k_hold 0.692 all the way: it was told to lock to 284.273."""
    compilation = next_to_a_pole()
    code = next(f for f in compilation.routine.functions if f.name == "k_hold")
    given = {i.name: i.default for i in code.inputs}
    assert evaluate(code, {**given, "t2": math.radians(degrees)}) == pytest.approx(0.692, abs=2e-3)


SPRING = """
param a = 60 mm
param b = 150 mm
param phi = 90 deg in 60 deg .. 180 deg
pivot O at (0 mm, 0 mm)
pivot Q at (b, 0 mm)
link OA
telescope QA
OA = a @ phi
friction pins 0.1 diameter 10 mm
spring 3 N/mm between Q and A free 60 mm
torque M on OA
find M
"""


def test_a_case_is_compared_with_the_spring_as_long_as_the_pose_has_it():
    compilation = Compilation(Source("spring.mech", SPRING))
    printed_cases = [r for r in compilation.results if r.holds]
    assert {r.name for r in printed_cases} >= {"M_f", "M_hold", "eta_M"}
    assert [said for r in printed_cases for said in printed(compilation, r)] == []


def test_the_sampler_refutes_what_is_false_of_friction():
    """A state as given, a stretch outside the range that is wider, a case printed wrong."""
    text = (LIBRARY / "fedoriv_fig2a_with_friction.mech").read_text(encoding="utf-8")
    text = text.replace("10 deg in 1 deg .. 45 deg", "70 deg in 60 deg .. 100 deg")
    compilation = Compilation(Source("toggle.mech", text))
    assert list(refuted(compilation)) == []
    held = next(r for r in compilation.results if r.name == "k_hold")
    ratios = Ratios(compilation, held)
    assert list(as_given(ratios, replace(held, locking=replace(held.locking, state="locked"))))
    (reach,) = (r for r in held.locking.reaches if r.parameter == "alpha")
    stuck = next(s for s in reach.stretches if s.within is None)
    wider = stuck._replace(high=stuck.high._replace(x=2 * stuck.high.x))
    assert list(throughout(ratios, held, reach, wider))
    assert held.holds
    assert list(printed(compilation, replace(held, formula=Symbol("alpha"))))


@pytest.mark.slow
def test_an_efficiency_that_turns_before_it_jumps():
    """It falls from 0.966 to 0.961 and jumps to 0.962: the cell looked at ends at the jump."""
    assert hold([chain(311034)]) == 1


@pytest.mark.slow
def test_a_slip_that_is_zero_at_any_pose_has_no_sign():
    """Three rods make one rigid body: no pin in it slips, and nothing is stated by rounding."""
    text = closed(70038)
    assert text is not None
    compilation = Compilation(Source("triangle.mech", text))
    stroke = compilation.stroke(60)
    (code,) = (f for f in compilation.routine.functions if f.name == "k_f")
    given = {i.name: i.default for i in code.inputs}
    column = [c.name for c in stroke.columns].index("k_f")
    stated = [(row.drive, row.values[column]) for row in stroke.rows if not row.trouble]
    assert len(stated) > 10
    for phi, value in stated:
        found = evaluate(code, {**given, "phi": phi})
        assert found == pytest.approx(value, rel=1e-9, nan_ok=True)


def test_what_is_said_of_closed_mechanisms_with_friction():
    assert hold(map(closed, range(400, 402))) > 0


def test_what_is_said_of_an_open_chain_with_friction():
    assert hold([chain(400)]) == 1


@pytest.mark.slow
def test_what_is_said_of_many_mechanisms_with_friction():
    assert hold(map(closed, [70160, 70299, *range(410, 415)])) > 1
    assert hold(map(opened, [311051, 401, *range(410, 412)])) > 1
