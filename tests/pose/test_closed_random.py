"""Closed mechanisms grown at random, along strokes, against their coordinates.

Of each, eight strokes are looked at: both ways from the default pose, with the crank of the
description and with ones that grow or shrink on the way. The emitted Python, the
interpreter and, of some, the compiled C are compared; statics has agreed before, in every
compilation.
"""

import ctypes
import math
import shutil
import subprocess
from collections import Counter
from functools import cache

import numpy as np
import pytest

from grown import GROUPS, Grown
from mechc.compilation import Compilation, emit
from mechc.diagnostics import MechcError
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.formula.walk import symbols
from mechc.routine.evaluate import evaluate
from mechc.source import Source
from reference_strokes import LAX, STEPS, Strokes, conditions, errors, inputs_of, strokes_of


class Seen:
    """What was compared."""

    def __init__(self):
        self.worst, self.strokes, self.poses = 0.0, 0, 0
        self.kinds, self.undecided = Counter(), 0

    def compare(self, grown, found, expected):
        """Compare all strokes of a mechanism, as far as the reference goes."""
        error = errors(found, expected)
        assert np.all(error < LAX), f"seed {grown.seed}: off by {max(error)}\n{grown.text()}"
        self.worst = max(self.worst, *error, 0.0)

    def count(self, grown, expected):
        self.strokes += len(expected)
        self.poses += int(np.isfinite(expected).sum())
        self.kinds.update(set(grown.kinds))

    def report(self, record_property):
        for name, value in vars(self).items():
            record_property(name, str(value))
        print(f"{self.strokes} strokes, {self.poses} poses, worst error {self.worst:.2g}")


def compiled(grown):
    text = f"mechanism m{grown.seed}\n{grown.text()}"
    return Compilation(Source("grown.mech", text))


def by_python(compilation, given):
    (file,) = emit(compilation, registry.load("python"), Options("module"))
    space = {"__name__": "module"}
    exec(compile(file.text, "module.py", "exec"), space)
    return space["k"](**given)


def by_c(code, grown, given):
    batch = code[f"m{grown.seed}_k_n"]
    array = np.ctypeslib.ndpointer(dtype=np.float64)
    batch.restype, batch.argtypes = None, [ctypes.c_size_t] + [array] * (len(given) + 1)
    drives, _ = strokes_of(grown)
    found = np.empty(drives.size)
    batch(drives.size, *(column.ravel() for column in given.values()), found)
    return found.reshape(drives.shape)


@cache
def expected_of(seed):
    return Strokes(Grown(seed)).followed(*strokes_of(Grown(seed)))


def decided(seeds, seen):
    """Yield the mechanisms whose closures the lines tell apart, some triads' are too alike."""
    for grown in map(Grown, seeds):
        try:
            compilation = compiled(grown)
            (function,) = compilation.routine.functions
        except MechcError as error:
            if {d.code for d in error.diagnostics if d.code[0] == "E"} != {
                "E308"
            } or "triad" not in grown.kinds:
                raise
            seen.undecided += 1
        else:
            yield grown, compilation, inputs_of(grown, function)


def sweep(seeds):
    """Compare the strokes of many mechanisms."""
    seen = Seen()
    for grown, compilation, given in decided(seeds, seen):
        (function,) = compilation.routine.functions
        expected = expected_of(grown.seed)
        for k in (by_python(compilation, given), evaluate(function, given)):
            seen.compare(grown, np.broadcast_to(k, expected.shape), expected)
        seen.count(grown, expected)
    assert seen.kinds.keys() == {grow.__name__ for grow in GROUPS}
    assert seen.poses > 0.6 * STEPS * seen.strokes
    return seen


def test_strokes(record_property):
    seen = sweep(range(15))
    seen.report(record_property)
    assert seen.strokes > 100
    assert seen.worst < 1e-10


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_strokes_in_c(tmp_path, record_property):
    seen, made = Seen(), []
    for grown, compilation, given in decided(range(30), seen):
        for file in emit(compilation, registry.load("c"), Options(f"m{grown.seed}")):
            (tmp_path / file.name).write_text(file.text, encoding="utf-8")
        made.append((grown, given))
    sources = [f"m{grown.seed}.c" for grown, _ in made]
    command = ["gcc", "-std=c99", "-O1", "-fPIC", "-shared", *sources, "-o", "code.so", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    code = ctypes.CDLL(str(tmp_path / "code.so"))
    for grown, given in made:
        expected = expected_of(grown.seed)
        seen.compare(grown, by_c(code, grown, given), expected)
        seen.count(grown, expected)
    seen.report(record_property)
    assert seen.strokes > 200


def test_a_loop_of_class_three_is_seen_to_close_by_what_else_it_finds():
    """Of four unknowns of the loop the pose needs others than the one that its margin is of."""
    ((_, compilation, _),) = decided([251], Seen())
    known = {d.name for d in compilation.pose.definitions} | {"r", "phi"}
    assert all(symbols(loop.margin) <= known for loop in compilation.pose.loops)


@pytest.mark.parametrize("seed", [60002, 60078, 61269])
def test_lines_say_which_closure_of_a_link_with_a_pin_in_two_slots_is_meant(seed):
    """By points of the ground and of the link, by the pin, or by words of the pin in its slot."""
    seen = Seen()
    ((grown, compilation, given),) = decided([seed], seen)
    (function,), expected = compilation.routine.functions, expected_of(seed)
    seen.compare(grown, np.broadcast_to(evaluate(function, given), expected.shape), expected)
    assert seen.worst < 1e-10


@pytest.mark.slow
def test_many_strokes(record_property):
    seen = sweep(range(30, 80))
    seen.report(record_property)
    assert seen.strokes >= 200


def test_a_reference_that_fails_says_so_and_ends_that_stroke_alone(monkeypatch):
    whole = np.linalg.cond

    def of_well_scaled_ones(matrices):
        if np.max(np.abs(matrices)) > 1:
            raise np.linalg.LinAlgError("SVD did not converge")
        return whole(matrices)

    monkeypatch.setattr(np.linalg, "cond", of_well_scaled_ones)
    with pytest.warns(UserWarning, match="the reference found no condition"):
        found = conditions(np.array([np.eye(3), 2 * np.eye(3)]))
    assert found.tolist() == [1.0, math.inf]


def test_a_jump_to_the_other_closure_would_be_seen():
    grown_alone = [g for g in map(Grown, range(60)) if g.kinds == ["rrr"]]
    seen = 0
    for grown in grown_alone:
        *others, last = grown.assemblies
        turned = last.replace(" ccw", " cw") if " ccw" in last else last.replace(" cw", " ccw")
        grown.assemblies = [*others, turned]
        (function,) = compiled(grown).routine.functions
        found = evaluate(function, inputs_of(grown, function))
        if np.any(np.nan_to_num(found)):
            seen += 1
            with pytest.raises(AssertionError):
                Seen().compare(grown, found, expected_of(grown.seed))
    assert seen > 3
