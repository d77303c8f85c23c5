"""Long chains of lets: functions that share their steps, the same numbers, files of their size."""

import json
import shutil
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from mechc.compilation import Compilation, compile_source
from mechc.emit.c.to_c import TARGET as C
from mechc.emit.json.to_json import TARGET as JSON
from mechc.emit.python.to_python import TARGET as PYTHON
from mechc.emit.target import Options
from mechc.routine.common_steps import STRETCH
from mechc.routine.promises import broken_promises
from mechc.routine.steps import Common, names_of, programs
from mechc.source import Source
from run_targets import (
    Outputs,
    built,
    by_c_in_batch,
    by_c_singly,
    by_interpreter,
    by_python,
    poses,
)

HEAD = """
mechanism crank
param a = 40 mm
param b = 120 mm
param c = 80 mm
param phi = 60 deg in 20 deg .. 80 deg
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OA
link AB
link CB
OA = a @ phi
AB = b
CB = c
drive phi from 20 deg to 80 deg
assembly ABC ccw
torque M on OA
torque T on CB
find k = T/M
require phi < 70 deg
let q0 = k
let q1 = sin(phi_AB)*k
"""


@cache
def chain(n: int) -> Compilation:
    """Return a chain of lets, each made of the two before: written out, it doubles each time."""
    lets = (f"let q{i} = q{i - 1}*cos(phi) - q{i - 2}/{i}" for i in range(2, n))
    return compile_source(Source("chain.mech", HEAD + "\n".join(lets) + "\n"))


def by_hand(k: np.ndarray, q1: np.ndarray, phi: np.ndarray, n: int) -> Outputs:
    found = {"k": k, "q0": k, "q1": q1}
    for i in range(2, n):
        found[f"q{i}"] = found[f"q{i - 1}"] * np.cos(phi) - found[f"q{i - 2}"] / i
    return found


def commons(n: int) -> list[Common]:
    return [p for p in programs(chain(n).routine) if isinstance(p, Common)]


def test_few_functions_compute_all_that_they_need() -> None:
    assert not commons(20)
    assert len(commons(120)) == 1


def test_what_is_shared_keeps_every_promise() -> None:
    for function in chain(120).routine.functions:
        assert not broken_promises(function)


@pytest.mark.skipif(not shutil.which("gcc"), reason="needs a C compiler")
def test_shared_steps_give_the_values_of_their_formulas(tmp_path: Path) -> None:
    found = chain(120)
    made, last = built(found, tmp_path), by_interpreter(found)
    inputs = poses(found.routine.functions[0])
    expected = by_hand(last["k"], last["q1"], inputs["phi"], 120)
    assert np.isnan(last["k"]).any()
    assert not np.isnan(last["k"]).all()
    for outputs in (last, by_python(found), by_c_singly(found, made), by_c_in_batch(found, made)):
        for name, values in outputs.items():
            np.testing.assert_allclose(values, expected[name], rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("target", [PYTHON, C])
def test_files_grow_as_the_chain_does(target: object) -> None:
    few, many = (len(target.emit(chain(n), Options("chain"))[0].text) for n in (60, 120))  # type: ignore[attr-defined]
    assert many < 2.2 * few


def test_comments_state_where_other_results_come_from() -> None:
    (module,) = PYTHON.emit(chain(120), Options("chain"))
    stated = "q119 = q118*cos(phi) - q117/119\n        where q117, q118 are results, too\n"
    assert stated in module.text


@cache
def growing(n: int) -> Compilation:
    """Return a chain of lets of which each has a parameter of its own, and a branch beside it."""
    parameters = (f"param c{i} = {1 + i / 100}" for i in range(n))
    lets = (f"let r{i} = sin(r{i - 1})*c{i} + phi*r{i - 2}" for i in range(2, n))
    beside = (f"let s{i} = s{i - 1}*c{i} + r{i}" for i in range(n - 5, n))
    first = ("let r0 = k*c0", "let r1 = r0*c1", f"let s{n - 6} = r{n - 40}*phi")
    text = HEAD + "\n".join((*parameters, *first, *lets, *beside)) + "\n"
    return compile_source(Source("growing.mech", text))


def test_functions_of_ever_more_inputs_write_each_step_once_on_a_way_of_calls() -> None:
    functions = [f for f in growing(52).routine.functions if f.common]
    commons = [p for p in programs(growing(52).routine) if isinstance(p, Common)]
    written = [n for common in commons for step in common.steps for n in names_of(step)]
    assert len(functions) > 25
    assert len(commons) > 1
    assert len(written) == len(set(written))
    assert max(len(f.own) for f in functions) == STRETCH
    for function in functions:
        assert not broken_promises(function)


@pytest.mark.skipif(not shutil.which("gcc"), reason="needs a C compiler")
def test_functions_that_call_others_give_the_values_of_their_formulas(tmp_path: Path) -> None:
    found = growing(52)
    made, expected = built(found, tmp_path), by_interpreter(found)
    assert np.isfinite(expected["s51"]).any()
    for outputs in (by_python(found), by_c_singly(found, made), by_c_in_batch(found, made)):
        for name, values in outputs.items():
            np.testing.assert_allclose(values, expected[name], rtol=1e-9, atol=1e-12)


def test_a_document_states_a_long_let_by_the_results_that_it_mentions() -> None:
    (file,) = JSON.emit(growing(52), Options("growing"))
    document = json.loads(file.text)
    results = {r["name"]: r for r in document["results"]}
    where = {d["name"] for d in results["r51"]["where"]}
    assert results["r51"]["formula"]["text"] == "sin(r50)*c51 + phi*r49"
    assert not where & results.keys()
    assert {d["name"] for d in results["r4"]["where"]} >= {"r3", "r2", "r1", "r0", "k"}
    assert sum(len(r["where"]) for r in results.values()) < 25 * len(results)
