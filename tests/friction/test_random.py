"""Friction in random mechanisms: against free bodies with friction, by limits, in all targets.

The reference solves the nonlinear equilibrium of every body by Newton's method from
coordinates. Poses are drawn from wide ranges, in which slips and forces change their signs.
"""

import math
import shutil
from collections.abc import Iterable, Iterator
from importlib import import_module
from random import Random
from typing import NamedTuple

import numpy as np
import pytest

from force_mechanisms import Sample, given
from force_samples import (
    LARGEST_CONDITION,
    Compiled,
    compiled,
    pushing,
    reference,
    samples,
    with_friction,
)
from force_trains import train
from grown import Grown
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.formula.tree import Implicit
from mechc.formula.walk import walk
from mechc.source import Source
from paths import LIBRARY
from reference_forces import Forces, NoBalance, arms_at
from reference_geometry import Values
from reference_strokes import Strokes
from run_targets import (
    assert_close,
    built,
    by_c_in_batch,
    by_c_singly,
    by_interpreter,
    by_python,
)
from sources import in_thirds

ENOUGH = 1e-10
"""What a load with friction may be off, as a part of itself."""

MOTIONS = {"": 0, "_f": 1, "_hold": -1}


class Tally(NamedTuple):
    """Errors, and how often one side alone gave a number."""

    errors: list[float]
    only_here: list[str]
    only_there: list[str]


def compare(seed: int, made: Compiled, values: Values, forces: Forces, tally: Tally) -> None:
    """Put both motions at a pose beside the reference."""
    (find,) = (f for f in made.compilation.mechanism.finds if f.name in ("k", "P"))
    drive = find.target.above if find.name == "k" else "P"
    sizes = {"F": 1.0, **forces.known()}
    results = made.results({**values, **sizes})
    for ending, sense in MOTIONS.items():
        found = results[f"{find.name}{ending}"]
        try:
            unknowns, condition = forces.solve(drive, sizes, sense)
        except NoBalance:
            tally.only_here.extend([f"{seed} {ending}"] * math.isfinite(found))
            continue
        if condition > LARGEST_CONDITION:
            continue
        if not math.isfinite(found):
            tally.only_there.append(f"{seed} {ending}")
            continue
        expected = float(unknowns[-1])
        error = abs(found - expected) / (abs(expected) + 0.01) / max(1, condition / 1e4)
        assert error < ENOUGH, f"seed {seed}: {find.name}{ending} = {found} instead of {expected}"
        tally.errors.append(error)


def against_free_bodies(found: Iterable[tuple[int, Sample]], poses: int) -> Tally:
    """Compare samples at the default pose and at others nearby."""
    tally = Tally([], [], [])
    for seed, sample in found:
        made = with_friction(seed, sample)
        if made is not None:
            dice = Random(seed)
            for i in range(poses):
                values = made.nearby(dice) if i else made.values()
                compare(seed, made, values, reference(sample, made.tree, values), tally)
    return tally


def trains(seeds: range) -> Iterator[tuple[int, Sample]]:
    """Yield trains that can be compared."""
    for seed in seeds:
        sample = pushing(train(seed))
        if sample is not None:
            yield seed, sample


@pytest.mark.parametrize("ratio", in_thirds([True, False]))
def test_free_bodies_with_friction_balance(ratio):
    tally = against_free_bodies(samples(range(5), ratio, 1), 3)
    assert len(tally.errors) > 25
    assert len(tally.only_there) <= 3, tally.only_there
    assert len(tally.only_here) <= 2, tally.only_here


def test_trains_with_friction_balance():
    tally = against_free_bodies(trains(range(5)), 3)
    assert len(tally.errors) > 30
    assert not tally.only_there
    assert not tally.only_here


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [True, False])
def test_many_free_bodies_with_friction_balance(ratio, record_property):
    tally = against_free_bodies(samples(range(12, 16), ratio), 6)
    record_property("worst error", max(tally.errors))
    assert len(tally.errors) > 40
    assert len(tally.only_there) < 0.05 * len(tally.errors), tally.only_there
    assert len(tally.only_here) < 0.05 * len(tally.errors), tally.only_here


@pytest.mark.slow
@pytest.mark.parametrize(
    "found", [samples(range(9, 10)), samples(range(109, 110)), trains(range(25, 26))]
)
def test_what_was_wrong_once(found):
    """An idle lever, a pin in a slot and fast in a rod, and a belt that friction relieves."""
    tally = against_free_bodies(found, 4)
    assert len(tally.errors) > 6


@pytest.mark.slow
def test_many_trains_with_friction_balance(record_property):
    tally = against_free_bodies(trains(range(16, 36)), 6)
    record_property("worst error", max(tally.errors))
    assert len(tally.errors) > 250
    assert len(tally.only_there) < 0.05 * len(tally.errors), tally.only_there
    assert len(tally.only_here) < 0.05 * len(tally.errors), tally.only_here


# --------------------------------------------------------------------- closed strokes


def strokes(seed: int) -> Iterator[tuple[float, float, dict[str, tuple[float, float]]]]:
    """Yield the drive, the crank and all places along a stroke, by coordinates."""
    grown = Grown(seed)
    wide = {"phi": 0.25, "s": 0.01}[grown.drive]
    drives = grown.start + wide * np.linspace(0, 1, 6)[None, :]
    cranks = np.full_like(drives, grown.size)
    for j, (x, _, alive) in enumerate(Strokes(grown).poses(drives, cranks)):
        if alive[0]:
            there = {p: tuple(x[0, i]) for p, i in Strokes(grown).index.items()}
            yield drives[0, j], grown.size, there


def closed(seed: int) -> Compiled | None:
    """Return a closed mechanism with friction, None where its loads cannot be asked."""
    sample = Sample(Grown(seed).text(), "M", "F", ())
    try:
        return with_friction(seed, sample)
    except MechcError as error:
        if not {"E308", "E511"} & {d.code for d in error.diagnostics}:
            raise
        return None


def along_strokes(seeds: Iterable[int]) -> Tally:
    """Compare closed mechanisms along strokes."""
    tally = Tally([], [], [])
    for seed in seeds:
        made = closed(seed)
        for drive, crank, places in strokes(seed) if made else ():
            values = {**made.values(), Grown(seed).drive: drive, "r": crank}
            forces = Forces(made.tree, values, arms_at(places))
            compare(seed, made, values, forces, tally)
    return tally


def test_closed_mechanisms_with_friction_along_strokes():
    tally = along_strokes([1, 22])
    assert len(tally.errors) > 30
    assert len(tally.only_there) <= 4, tally.only_there
    assert not tally.only_here


@pytest.mark.slow
def test_many_closed_mechanisms_with_friction_along_strokes(record_property):
    tally = along_strokes(range(38, 46))
    record_property("worst error", max(tally.errors))
    assert len(tally.errors) > 40
    assert len(tally.only_there) < 0.05 * len(tally.errors), tally.only_there
    assert len(tally.only_here) < 0.05 * len(tally.errors), tally.only_here


# ------------------------------------------------------------------- limits and laws

CASES = [30, 31, 33, 35, 36, 39]


@pytest.fixture(scope="module", params=in_thirds(CASES))
def case(request):
    seed = request.param
    ((_, sample),) = samples(range(seed, seed + 1), groups=1)
    return seed, sample, with_friction(seed, sample)


def ratios(made, **values):
    found = made.results({**made.values(), **values})
    return [found[name] for name in ("k", "k_f", "k_f1", "k_hold")]


def test_vanishing_friction_gives_the_ideal_ratio(case):
    _, _, made = case
    ideal, *others = ratios(made, q=1e-9)
    assert others == pytest.approx([ideal] * 3, rel=1e-6)


def test_friction_hinders_either_motion(case):
    _, _, made = case
    ideal, tightening, _, holding = ratios(made)
    assert holding < ideal < tightening
    efficiency = made.results(made.values())["eta_k"]
    part = ideal / tightening if ideal > 0 else tightening / ideal
    assert efficiency == pytest.approx(part, rel=1e-12)
    assert efficiency < 1


def test_the_first_order_errs_by_second_order(case):
    """A quarter of the friction leaves a sixteenth of the error."""
    _, _, made = case
    errors = []
    for q in (0.04, 0.01):
        ideal, tightening, first, _ = ratios(made, q=q)
        errors.append(tightening - first)
    if abs(errors[1]) > 1e-11 * abs(ideal):
        assert errors[0] / errors[1] == pytest.approx(16, rel=0.1)


def test_releasing_is_what_holds(case):
    seed, sample, made = case
    back = with_friction(seed, sample, "motion releasing")
    if back is None:
        pytest.skip("locks")
    assert "k_hold" not in back.results(back.values())
    holding = made.results(made.values())["k_hold"]
    assert back.results(back.values())["k_f"] == pytest.approx(holding, rel=1e-12)


# ------------------------------------------------------------------------ two forms


def is_iterated(made: Compiled) -> bool:
    (found,) = (r for r in made.compilation.solution.results if r.name == "k_f")
    formulas = [found.formula, *(d.formula for d in found.where)]
    return any(isinstance(p, Implicit) for f in formulas for p in walk(f))


def test_the_closed_form_is_the_iterated_one(monkeypatch):
    """Wherever a closed form exists, at many poses."""
    drawn = samples(range(32, 35), groups=1)
    found = [(seed, sample, with_friction(seed, sample)) for seed, sample in drawn]
    straight = [case for case in found if case[2] and not is_iterated(case[2])]
    module = import_module("mechc.friction.results")
    monkeypatch.setattr(module, "ways", lambda *_: iter(()))
    compared = 0
    for seed, sample, made in straight:
        other = with_friction(seed, sample)
        assert is_iterated(other)
        dice = Random(seed)
        for _ in range(5):
            values = made.nearby(dice)
            for one, two in zip(ratios(made, **values), ratios(other, **values), strict=True):
                if math.isfinite(one) and math.isfinite(two) and abs(one) < 100:
                    assert one == pytest.approx(two, rel=1e-9, abs=1e-11), seed
                    compared += 1
    assert compared > 15


# -------------------------------------------------------------------------- targets


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no C compiler")
@pytest.mark.parametrize("seed", in_thirds([30, 33]))
def test_targets_say_what_the_interpreter_says(seed, tmp_path):
    """At poses of wide ranges, in which k and k with friction change their signs."""
    ((_, sample),) = samples(range(seed, seed + 1), groups=1)
    made = with_friction(seed, sample, f"find {sample.asked[-1]}")
    found = made.compilation
    expected = by_interpreter(found)
    assert_close(by_python(found), expected, 0, found.routine)
    library = built(found, tmp_path)
    assert_close(by_c_singly(found, library), expected, 64, found.routine)
    assert_close(by_c_in_batch(found, library), expected, 64, found.routine)
    for name in ("k", "k_f", "k_hold"):
        assert min(expected[name]) < 0 < max(expected[name])


def test_the_samples_have_everything():
    """Friction of all kinds is among what is compared."""
    texts = [given(seed).with_friction(Random(seed)) for seed in range(108)]
    for word in ("coulomb", "roller", "linear", "edges", "couple", "contact", " on ", "slot"):
        assert sum(word in text for text in texts) > 5, word
    for word in ("mirror", "copies", "slide ", "torque P", "actuator P"):
        assert sum(word in text for text in texts) > 5, word


def test_a_pin_at_rest_may_slip_either_way():
    """Hoeken's linkage at 180°, where the rocker's pin changes the sense of its slip."""
    text = (LIBRARY / "hoeken.yaml").read_text(encoding="utf-8")
    made = Compilation(
        Source("hoeken.yaml", f"{text}\nfriction: {{pins: {{f: 0.1, diameter: 8 mm}}}}")
    )
    assert made.verdict.agrees


def test_the_guide_of_a_nut_may_be_all_that_holds_its_slider():
    text = (LIBRARY / "d45_10_two_screws.mech").read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if " n =" not in line]  # T follows from N
    made = compiled("\n".join([*lines, "find N_A"]), "screws.mech")
    assert made.results(made.values())["N_A"] == 0
