"""What stands beside results with friction: names of one meaning, forms for elsewhere, statuses."""

import math
from collections.abc import Iterable
from importlib import import_module

import pytest

import mechc
from force_samples import samples, with_friction
from mechc.compilation import Compilation
from mechc.formula.to_text import text
from mechc.formula.tree import Formula
from mechc.model.mechanism import PinFriction
from mechc.model.result import Result
from mechc.routine.evaluate import evaluate, status
from mechc.source import Source
from mechc.study.analysis import as_printed
from paths import LIBRARY

WITH_FRICTION = sorted(p.stem for p in LIBRARY.glob("*_with_friction.mech"))


def without_expectations(name: str) -> str:
    source = (LIBRARY / f"{name}.mech").read_text(encoding="utf-8")
    return "\n".join(line for line in source.splitlines() if not line.startswith("expect"))


def assert_one_meaning(results: Iterable[Result]) -> None:
    """A result itself has two formulas where it has a form for elsewhere."""
    listed, known = list(results), dict[str, Formula]()
    names = {result.name for result in listed}
    for result in listed:
        for form in (result, result.elsewhere):
            for name, formula in ((n, f) for n, f in form.where if n not in names) if form else ():
                assert known.setdefault(name, formula) == formula, (result.name, name)


def assert_names_mean_one_thing(compilation: Compilation) -> None:
    """In code, and on paper."""
    assert_one_meaning(compilation.solution.results)
    assert_one_meaning(as_printed(r) for r in compilation.solution.results)


def test_forms_for_elsewhere_are_made_only_when_they_are_read(monkeypatch):
    def made(*_):
        raise AssertionError("nobody has asked for coupled equations")

    monkeypatch.setattr(import_module("mechc.friction.problem"), "coupled", made)
    compilation = Compilation(Source("a.mech", without_expectations("karpenko_fig9_with_friction")))
    found = {r.name: r for r in compilation.solution.results}
    assert found["k_f"].default == pytest.approx(0.0728010248853)
    with pytest.raises(AssertionError, match="coupled equations"):
        assert found["k_f"].elsewhere


def test_names_do_not_depend_on_which_form_is_read_first():
    source = Source("a.mech", without_expectations("karpenko_fig9_with_friction"))
    forwards, backwards = Compilation(source), Compilation(source)
    for result in reversed(backwards.solution.results):
        assert result.name in ("k", "k_f1") or result.elsewhere
    for one, other in zip(forwards.solution.results, backwards.solution.results, strict=True):
        assert one == other


@pytest.mark.parametrize("name", WITH_FRICTION)
def test_a_name_has_one_formula_in_the_library(name):
    assert_names_mean_one_thing(Compilation(Source("a.mech", without_expectations(name))))


UNPRINTED = """
param t1 = 350 deg in 290 deg .. 410 deg
param t2 = 176.21 deg in 136.21 deg .. 216.21 deg
param t3 = 55.13 deg in -4.87 deg .. 115.13 deg
pivot O
slider A along 219.39 deg
link AB
link OBC
AB = 56 mm @ t1
OB = 62.6 mm @ t2
OC = 65.5 mm @ t3
force P at A along 219.39 deg
force F at C along 281.6 deg
friction pins 0.295 diameter 17.7 mm
friction slider A 0.265
find k = P/F
"""


def test_a_name_has_one_formula_where_one_motion_is_printed_as_code_has_it():
    """Of the other motion nothing stands at the values given; b_AB had two signs on a page."""
    compilation = Compilation(Source("a.mech", UNPRINTED))
    assert_names_mean_one_thing(compilation)
    holding = next(as_printed(r) for r in compilation.solution.results if r.name == "k_hold")
    assert "S_AB_hold*s_AB" in [text(condition.left) for condition in holding.holds]


@pytest.mark.parametrize("ratio", [True, False])
def test_a_name_has_one_formula_in_random_mechanisms(ratio):
    made = [with_friction(seed, sample) for seed, sample in samples(range(4), ratio, 1)]
    assert sum(m is not None for m in made) > 1
    for each in made:
        if each is not None:
            assert_names_mean_one_thing(each.compilation)


def test_a_formula_of_both_motions_takes_each_at_its_own_forces():
    text = without_expectations("karpenko_fig2_with_friction")
    found = mechc.loads(f"{text}\nlet r = k_f/k_hold\n").evaluate()
    assert found["r"] == pytest.approx(found["k_f"] / found["k_hold"], rel=1e-14)


@pytest.fixture(scope="module")
def tongs():
    compilation = mechc.load("karpenko_fig2_with_friction")._compilation
    return {f.name: f for f in compilation.routine.functions}


@pytest.mark.parametrize(
    ("alpha", "name", "value", "state"),
    [
        (88, "k_f", 0.2065173821, 0),
        (89.8, "k_f", None, 4),
        (89.9, "k_f", None, 4),
        (90.5, "k_f", 0.00236980963, 3),
        (88, "k_hold", 0.01723316958, 0),
        (89.9, "k_hold", -0.02324828711, 3),
        (90.5, "k_hold", -0.283583631, 0),
    ],
)
def test_beside_a_dead_centre_a_status_states_what_is_stuck(tongs, alpha, name, value, state):
    """The values are those of free bodies, followed in from no friction."""
    function = tongs[name]
    values = {i.name: i.default for i in function.inputs} | {"alpha": math.radians(alpha)}
    found = evaluate(function, values)
    assert found == pytest.approx(math.nan if value is None else value, rel=1e-8, nan_ok=True)
    assert status(function, tongs["k"], values) == state
    eta = evaluate(tongs["eta_k"], values)
    assert math.isnan(eta) or 0 <= eta < 1


TOGGLE = """\
mechanism toggle
param al = 20 deg in 10 deg .. 40 deg
pivot O
slider K along x
link OB
link BK
OB = 100 mm @ al
BK = 100 mm @ -al
force P at B along -60 deg
force F at K along -x
friction pins 0.1 diameter 10 mm
let F = 400 N
find R_O
"""

LEVER = """\
mechanism lever
pivot O
link AOB
OA = 100 mm @ 180 deg
OB = 100 mm @ 0 deg
force P at A along -y
force F at B along -y
friction pin O 10 diameter 20 mm
find k = P/F
"""


@pytest.mark.parametrize(("text", "code"), [(TOGGLE, "W540"), (LEVER, "W513")])
def test_what_is_taken_and_what_is_infinite_is_stated(text, code):
    """A load on a pin where forces alone are asked for; an arm as long as the friction circle."""
    assert code in [d.code for d in mechc.loads(text).warnings]


TOGGLE = """mechanism toggle
pivot O at (0 mm, 0 mm)
slider B along y through O
link OA
link AB
OA = 150 mm @ 90 deg - theta
AB = 150 mm @ 90 deg + theta
param theta = 12 deg in 3 deg .. 20 deg
force P at A along -x
force Q at B along -y
friction pins {pins} diameter 20 mm
friction slider B {guide}
find k = P/Q
"""


def test_coefficients_that_are_numbers_have_names():
    toggle = mechc.loads(TOGGLE.format(pins="0.15", guide="0.1"))
    joints = toggle._compilation.mechanism.friction.joints
    assert "f*d/2" in [text(j.radius) for j in joints if isinstance(j, PinFriction)]
    named = {symbol.name for symbol in toggle["k_f1"].free_symbols}
    assert named == {"theta", "d", "f", "f_B", "len_AB", "len_OA"}


@pytest.mark.parametrize(
    "pins", ["friction pins 0.1 diameter 20 mm", "friction pin A 0.1 diameter 20 mm"]
)
def test_a_coefficient_of_several_is_called_after_none_of_them(pins):
    """rho = d*f_B/2 would be read as the friction circle of the slider's coefficient."""
    text = TOGGLE.format(pins="0.1", guide="0.1")
    for line in ("friction pins 0.1 diameter 20 mm\n", "friction slider B 0.1\n"):
        text = text.replace(line, "")
    for lines in (f"{pins}\nfriction slider B 0.1\n", f"friction slider B 0.1\n{pins}\n"):
        named = {symbol.name for symbol in mechc.loads(text + lines)["k_f1"].free_symbols}
        assert {name for name in named if name.startswith("f")} == {"f"}


def test_one_number_is_one_coefficient():
    toggle = mechc.loads(TOGGLE.format(pins="0.1", guide="0.1"))
    assert {s.name for s in toggle["k_f1"].free_symbols} == {"theta", "d", "f", "len_AB", "len_OA"}


def test_results_are_those_of_coefficients_that_are_parameters():
    given = TOGGLE.format(pins="f", guide="mu") + "param f = 0.15\nparam mu = 0.1\n"
    by_number, by_name = (
        mechc.loads(t).evaluate() for t in (TOGGLE.format(pins="0.15", guide="0.1"), given)
    )
    for name in ("k_f", "k_f1", "k_hold", "eta_k"):
        assert by_number[name] == pytest.approx(by_name[name], rel=1e-13)
