"""Which status a result with friction has, by the load of the drive without friction and with."""

import math

import numpy as np
import pytest

from gripping_brake import gripping_brake
from mechc.compilation import compile_source
from mechc.formula.tree import ZERO, Symbol
from mechc.model.result import DrivingLoad
from mechc.routine.evaluate import evaluate, status
from mechc.routine.steps import Function, Guard, Input, ResultStatus
from mechc.source import Source
from mechc.units import NUMBER
from small_mechanisms import lever

INPUTS = tuple(Input(name, NUMBER) for name in ("R", "P", "P_f"))
DRIVE, FORCE = Symbol("P"), Symbol("R")


def result(sense: int = 1, guards: tuple[Guard, ...] = (), is_idle: bool = False) -> Function:
    """Return a force R that stands for itself; the drive is P without friction, P_f with it."""
    drive = DrivingLoad(Symbol("P"), Symbol("P_f"))
    asked = ResultStatus("R_status", drive, sense, INPUTS, (), guards, is_idle)
    return Function("R", "", INPUTS, (), (), FORCE, FORCE, (), NUMBER, 0, status=asked)


def status_of(r: float, ideal: float, load: float, sense: int = 1, *guards: Guard) -> float:
    function = result(sense, guards)
    return float(status(function, function, {"R": r, "P": ideal, "P_f": load}))


@pytest.mark.parametrize(
    ("ideal", "load", "forwards", "backwards"),
    [
        (1.0, 2.0, 0, 0),
        (1.0, -1.0, 4, 3),
        (-1.0, 1.0, 3, 4),
        (-1.0, -2.0, 0, 0),
        (0.0, 1.0, 0, 0),
        (0.0, -1.0, 4, 3),
        (1.0, 0.0, 4, 3),
        (-1.0, 0.0, 3, 4),
    ],
)
def test_the_drive_moves_where_its_load_keeps_its_sign(
    ideal: float, load: float, forwards: int, backwards: int
) -> None:
    assert status_of(5.0, ideal, load) == forwards
    assert status_of(5.0, ideal, load, -1) == backwards


@pytest.mark.parametrize(("ideal", "load"), [(0.0, 0.0), (1e-31, -1e-31), (-1e-31, 1e-31)])
def test_without_a_load_nothing_has_to_be_overcome(ideal: float, load: float) -> None:
    assert status_of(0.0, ideal, load) == 0


@pytest.mark.parametrize(("ideal", "load", "known"), [(1e-31, -1.0, 4), (-1.0, 1e-31, 3)])
def test_one_load_that_is_none_is_not_enough(ideal: float, load: float, known: int) -> None:
    assert status_of(0.0, ideal, load) == known


@pytest.mark.parametrize(
    ("value", "effort", "known"),
    [(5.0, 1.0, 0), (5.0, 0.0, 0), (5.0, -1.0, 2), (math.inf, 1.0, 4), (math.nan, 1.0, 2)],
)
@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("ideal", [0.0, 1e-17, -1e-17])
def test_a_load_that_has_friction_alone_to_overcome_drives_either_way(
    value: float, effort: float, known: int, sense: int, ideal: float
) -> None:
    """What remains of its size without friction is rounding, and says nothing."""
    function = result(sense, is_idle=True)
    values = {"R": value, "P": ideal, "P_f": sense * effort}
    assert float(status(function, function, values)) == known


ASKED = "find M\nfind R_C\nlet P = 300 N"


@pytest.mark.parametrize(("mu", "state"), [(0.0, "free"), (0.3, "free"), (0.4, "jammed")])
def test_code_says_of_a_brake_what_is_said_of_it(mu: float, state: str) -> None:
    """Against the arrow of M nothing grips; code said that the load alone does not move it."""
    compilation = compile_source(Source("brake.mech", gripping_brake(f"{mu} in 0 .. 0.5", ASKED)))
    said = {r.name: r.locking.state for r in compilation.results if r.locking}
    assert said == {"M_f": state, "M_hold": "free"}
    functions = {f.name: f for f in compilation.routine.functions}
    for name, expected in (*said.items(), ("R_C_f", state)):
        found = status(functions[name], functions[name.partition("_f")[0]], {"mu": mu})
        assert {0: "free", 4: "jammed"}[int(found)] == expected


LEVER = lever("find i = F/P", "friction pins 0.1 diameter 10 mm")


def test_a_ratio_is_held_against_the_same_without_friction() -> None:
    routine = compile_source(Source("lever.mech", LEVER)).routine
    states = {f.name: f.status.drive for f in routine.functions if f.status}
    assert states == {"k_f": "k", "k_hold": "k", "i_f": "i", "i_hold": "i"}


def test_what_is_infinite_does_not_move() -> None:
    assert status_of(math.inf, 1.0, 2.0) == 4
    assert status_of(-math.inf, -1.0, -2.0) == 3


def test_where_a_condition_fails_there_is_no_pose() -> None:
    fails, holds = (Guard(Symbol("P"), operator, ZERO) for operator in ("<", ">"))
    assert status_of(math.nan, 1.0, 2.0, 1, fails) == 1
    assert status_of(math.nan, 1.0, 2.0, 1, holds, fails) == 1
    assert status_of(math.nan, 1.0, 2.0, 1, holds) == 2
    assert status_of(5.0, 1.0, 2.0, 1, fails) == 0


def test_many_poses_have_a_status_each() -> None:
    function = result()
    poses = {"R": 5.0, "P": np.array([1.0, 1.0, -1.0, 0.0]), "P_f": np.array([2.0, -1.0, 1.0, 0.0])}
    assert status(function, function, poses).tolist() == [0, 4, 3, 0]


def test_where_there_is_no_number_another_form_is_taken() -> None:
    guarded = Function(
        "k", "", INPUTS, (Guard(Symbol("P"), ">", ZERO),), (), FORCE, FORCE, (), NUMBER, 0,
        otherwise=Function("p", "", INPUTS, (), (), DRIVE, DRIVE, (), NUMBER, 0),
    )  # fmt: skip
    assert evaluate(guarded, {"R": 7.0, "P": 1.0, "P_f": 0.0}) == 7.0
    assert evaluate(guarded, {"R": 7.0, "P": -1.0, "P_f": 0.0}) == -1.0
    both = evaluate(guarded, {"R": 7.0, "P": np.array([1.0, -1.0]), "P_f": 0.0})
    assert np.asarray(both).tolist() == [7.0, -1.0]
