"""The seeds' friction, efficiencies and typical transmissions, from files of the library.

Each entry of ``seeds/values.json`` that a description can state is what a result of the
library comes to at the entry's own points; each case of ``seeds/friction.json`` is a file
as it stands.
"""

import math
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, NamedTuple

import pytest

import mechc
from mechc.api import SolvedMechanism
from mechc.formula.evaluate import evaluate
from mechc.formula.walk import symbols
from mechc.study.analysis import Analysis
from paths import LIBRARY
from seed_friction import entries

RIGHT = math.pi / 2

Inputs = Mapping[str, float]


@cache
def mechanism(name: str) -> SolvedMechanism:
    return mechc.load(name)


class Stated(NamedTuple):
    """A seed as ``load · result``, or as ``load / result``, of a file of the library."""

    name: str
    result: str
    load: str = ""
    over: bool = False
    renamed: Mapping[str, str] = {}

    def value(self, inputs: Inputs) -> float:
        given = {self.renamed.get(n, n): v for n, v in inputs.items() if n != self.load}
        found = mechanism(self.name).evaluate(**given)[self.result]
        load = inputs.get(self.load, 1.0)
        return load / found if self.over else load * found


TOGGLE = "fedoriv_fig2a_with_friction"
PLUNGER = "fedoriv_fig2b_with_friction"
GEAR = {"mc": "m", "zc": "z"}

STATED = {
    "S004-ideal1": Stated("fedoriv_fig1_with_friction", "k", "Q", over=True),
    "S004-beta": Stated("fedoriv_fig1_with_friction", "beta"),
    "S004-phi1": Stated("fedoriv_fig1_with_friction", "f_r"),
    "S004-1": Stated("fedoriv_fig1_with_friction", "k_f", "Q", over=True),
    "S004-k1": Stated("fedoriv_fig1_with_friction", "k_f"),
    "S004-eta1": Stated("fedoriv_fig1_with_friction", "eta_k"),
    "S004-ideal2": Stated(TOGGLE, "k", "Q", over=True),
    "S004-2": Stated(TOGGLE, "k_f", "Q", over=True),
    "S004-phi2": Stated(PLUNGER, "f_r"),
    "S004-3": Stated(PLUNGER, "i_f", "Q"),
    "S004-ideal3": Stated("fedoriv_fig2c_with_friction", "k", "Q", over=True),
    "S004-2c": Stated("fedoriv_fig2c_with_friction", "k_f", "Q", over=True),
    "S004-2d": Stated("fedoriv_fig2d_with_friction", "i_f", "Q"),
    "S002-T44-wedge": Stated("wedge_drive_with_friction", "k_f", "M"),
    "S002-T44-gear": Stated("table_4_4_gear_with_efficiency", "k_f", "M", renamed=GEAR),
    "S002-T44-lever-a": Stated("table_4_4_lever_a_with_efficiency", "k_f", "M"),
    "S002-T44-lever-b": Stated("table_4_4_lever_b_with_efficiency", "k_f", "M"),
    "S002-T44-lever-c": Stated("table_4_4_lever_c_with_efficiency", "k_f", "M"),
    "S002-49-P": Stated("tongs_fig4_9_with_friction", "k", "N", renamed={"g1": "gamma_1"}),
    "D45-01": Stated("d45_01_link_lever", "n", "P"),
    "D45-02": Stated("d45_02_rhombus", "n", "P"),
    "D45-03": Stated("d45_03_inclined_lever", "n", "P"),
    "D45-04": Stated("d45_04_bent_rhombus", "n", "P"),
    "D45-05": Stated("d45_05_wedge_roller_lever_with_friction", "n_f", "P"),
    "D45-06": Stated("d45_06_double_wedge_with_friction", "n_f", "P"),
    "D45-07": Stated("d45_07_lever_slot", "k", "P"),
    "D45-08": Stated("d45_08_double_rack", "n", "P"),
    "D45-09": Stated("d45_09_racks_pinion", "n", "P"),
    "D45-10": Stated("d45_10_two_screws_with_efficiency", "n_f", "T"),
    "D45-11": Stated("d45_11_screw_lever_with_efficiency", "n_f", "T"),
    "D45-12": Stated("d45_12_worm_sectors_with_efficiency", "n_f", "T"),
    "D45-13": Stated("d45_13_knee", "n", "P"),
    "D45-14": Stated("d45_14_parallelogram_jaw", "n", "P"),
    "D45-15": Stated("d45_15_cam_lever", "k", "P"),
    "D45-16": Stated("d45_16_wedge_hook_with_friction", "k_f", "P", over=True),
}


@pytest.mark.parametrize("seed", STATED)
def test_library_gives_the_seeds_values(seed: str) -> None:
    for point in entries("values.json")[seed]["points"]:
        found = STATED[seed].value(point["inputs"])
        assert found == pytest.approx(float(point["value_30"]), rel=1e-12)


def test_none_is_left_out() -> None:
    prefixes = ("S004-", "S002-T44-", "S002-49-", "D45-", "F-")
    wanted = {seed for seed in entries("values.json") if seed.startswith(prefixes)}
    assert wanted == STATED.keys() | FINGER.keys() | LAWS.keys()


# ----------------------------------------------------------- the finger of the tongs

FINGER = {"S002-49-F": "F", "S002-49-RAx": "R_A_x", "S002-49-RAy": "R_A_y", "S002-49-RA": "R_A"}
"""The tongs' forces by the result that is each."""


@cache
def finger() -> SolvedMechanism:
    """Return the tongs with a jaw force that is open."""
    text = (LIBRARY / "tongs_fig4_9_forces.mech").read_text("utf-8")
    lines = text.splitlines(keepends=True)
    return mechc.loads("".join(n for n in lines if not n.startswith(("let N ", "expect"))))


def forces(inputs: Inputs) -> dict[str, float]:
    """Return the tongs' forces where F, N and an angle are given instead of the arms."""
    jaw, arm = inputs.get("N", 500.0), inputs.get("h2", 0.04)
    angle = inputs["g1"] if "g1" in inputs else RIGHT - inputs.get("g2", 0.0)
    long = inputs.get("h1", inputs.get("F", 0.0) / jaw * arm)
    return finger().evaluate(h1=long, h2=arm, gamma_1=angle, N=jaw)


@pytest.mark.parametrize("seed", FINGER)
def test_forces_on_the_finger(seed: str) -> None:
    drawn = [p for p in entries("values.json")[seed]["points"] if is_of_one_drawing(p["inputs"])]
    assert drawn
    for point in drawn:
        found = forces(point["inputs"])[FINGER[seed]]
        assert found == pytest.approx(float(point["value_30"]), rel=1e-12)


def is_of_one_drawing(inputs: Inputs) -> bool:
    """The rod and the jaw force are at right angles."""
    return not {"g1", "g2"} <= inputs.keys() or math.isclose(inputs["g1"] + inputs["g2"], RIGHT)


# ------------------------------------------------------------- laws at a single joint


def changed(name: str, *changes: tuple[str, str]) -> SolvedMechanism:
    """Return a mechanism of the library with other friction; formulas are no more expected."""
    text = (LIBRARY / f"{name}.mech").read_text("utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    kept = [n for n in text.splitlines() if not n.startswith(("expect", "let"))]
    return mechc.loads("\n".join(kept))


@cache
def of_two_pins() -> SolvedMechanism:
    return changed(
        "fedoriv_fig1_with_friction",
        (
            "friction pins f diameter d\nfriction roller A f1 axle d wheel D",
            "friction pin A f1 diameter 2*r1 coulomb\nfriction pin C f2 diameter 2*r2 coulomb",
        ),
        ("param d  ", "param r1 = 5 mm\nparam r2 = 5 mm\nparam f2 = 0.1\nparam d "),
    )


@cache
def on_a_rough_track() -> SolvedMechanism:
    return changed(
        "fedoriv_fig1_with_friction",
        ("friction pins f diameter d\n", ""),
        ("roller A f1 axle d wheel D", "slider A tan(asin(d/D*sin(atan(f1))))"),
    )


@cache
def in_its_guide(law: str) -> SolvedMechanism:
    return changed(PLUNGER, ("overhang l couple", f"overhang l {law}"))


def turned_by(inputs: Inputs) -> float:
    """Return the angle by which pins turn the force of a rod, from k_f = tan(alpha + beta)."""
    return math.atan(of_two_pins().evaluate(alpha=0.2, **inputs)["k_f"]) - 0.2


def of_the_track(inputs: Inputs) -> float:
    return on_a_rough_track().evaluate(alpha=0.2, **inputs)["k_f"] - math.tan(0.2)


def of_the_plunger(law: str) -> Callable[[Inputs], float]:
    """Return the part of a guide, from i_f = (cot(alpha) − factor)/2 on pins without friction."""

    def factor(inputs: Inputs) -> float:
        found = in_its_guide(law).evaluate(alpha=0.2, f=0.0, **inputs)
        return 1 / math.tan(0.2) - 2 * found["i_f"]

    return factor


LAWS: dict[str, Callable[[Inputs], float]] = {
    "F-beta-exact": turned_by,
    "F-roller-exact": of_the_track,
    "F-plunger-linear": of_the_plunger("linear"),
    "F-plunger-edges": of_the_plunger("edges"),
}


@pytest.mark.parametrize("seed", LAWS)
def test_laws_of_friction(seed: str) -> None:
    for point in entries("values.json")[seed]["points"]:
        assert LAWS[seed](point["inputs"]) == pytest.approx(float(point["value_30"]), rel=1e-11)


# ------------------------------------------------------------------ whole mechanisms

CASES = {
    "F-G000-1": "karpenko_fig1_with_friction",
    "F-G000-2": "karpenko_fig2_with_friction",
    "F-G000-3": "karpenko_fig3_with_friction",
    "F-G000-4": "karpenko_fig4_with_friction",
    "F-G000-7": "karpenko_fig7_with_friction",
    "F-G000-8": "karpenko_fig8_with_friction",
    "F-G000-9": "karpenko_fig9_with_friction",
    "F-G002-49": "tongs_fig4_9_with_friction",
    "F-G003": "claw_with_friction",
    "F-G004-1": "fedoriv_fig1_with_friction",
    "F-G004-2cd": "fedoriv_fig2c_with_friction",
}
"""The file that is each case."""

OTHERWISE = {"F-G000-9": {"L": 0.12}}
"""Cases of other lengths than the file: the levers of this one would cross in the drawing."""

KEYS = {
    "k": "k_ideal",
    "k_f": "k_real",
    "k_f1": "k_first_order",
    "k_hold": "k_holding",
    "eta_k": "eta",
}


@pytest.mark.parametrize("case", CASES)
def test_cases_of_friction(case: str) -> None:
    found = mechanism(CASES[case]).evaluate(**OTHERWISE.get(case, {}))
    for result, key in KEYS.items():
        expected = entries("friction.json")[case][key]
        assert found[result] == pytest.approx(expected, rel=1e-10), result


def test_plunger_of_the_other_ratio() -> None:
    """F-G004-2ab asks for Q/W, the file for W/Q: one is the other upside down."""
    case: dict[str, Any] = entries("friction.json")["F-G004-2ab"]
    found = mechanism(PLUNGER).evaluate()
    assert 1 / found["i_f"] == pytest.approx(case["k_real"], rel=1e-10)
    assert found["eta_i"] == pytest.approx(case["eta"], rel=1e-10)
    assert CASES.keys() | {"F-G004-2ab"} == entries("friction.json").keys()


# ------------------------------------------------------------------- what is printed

WITH_FRICTION = sorted(p.stem for p in LIBRARY.glob("*_with_friction.mech"))


def moved(values: Inputs, step: float) -> dict[str, float]:
    """Return a pose nearby, every quantity moved by a step of its own."""
    return {n: v * (1 + step * math.sin(i + 1)) for i, (n, v) in enumerate(values.items())}


@pytest.mark.parametrize("name", WITH_FRICTION)
@pytest.mark.parametrize("step", [0.0, 0.02, -0.02])
def test_what_is_printed_is_what_code_gives(name: str, step: float) -> None:
    """A printed case holds wherever its conditions do, not at the default pose alone."""
    solved = mechanism(name)
    dependent = {p.name for p in solved._compilation.mechanism.parameters if p.dependent}
    free = {n: v for n, v in solved.defaults.items() if n not in dependent}
    values = moved(free, step)
    found, compared = solved.evaluate(**reaching(solved, values)), 0
    for result in solved._compilation.results:
        known = dict(values)
        for named in result.where:
            if symbols(named.formula) <= known.keys():
                known[named.name] = evaluate(named.formula, known)
        if symbols(result.formula) <= known.keys() and holds_there(result, known):
            printed = evaluate(result.formula, known)
            assert printed == pytest.approx(found[result.name], rel=1e-12), result.name
            compared += 1
    assert compared >= 4


def reaching(solved: SolvedMechanism, values: Inputs) -> dict[str, float]:
    """Return the values that a result depends on."""
    wanted = {i.name for f in solved._compilation.routine.functions for i in f.inputs}
    return {name: value for name, value in values.items() if name in wanted}


def holds_there(result: Analysis, values: Inputs) -> bool:
    return all(
        math.copysign(1, evaluate(h.left, values)) == (1 if h.operator == ">" else -1)
        for h in result.holds
    )
