"""The hunt for false statements, tests/support/hunt.py: what it looks at, and that it sees."""

import math
from itertools import count
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import free_bodies_shown
import hunt
import plotted_marks
from conclusions import is_rough, slopes
from hunt import Outcome, looked_at, outcome, summary
from hunted import KINDS, Hunted, Made, made
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.formula.tree import Call, Symbol, number, product, total
from mechc.model.result import Definition
from mechc.plot.plot import Mark
from mechc.plot.query import Query
from mechc.pose.places import Plane
from mechc.source import Source
from page import Page
from refuters import REFUTERS
from small_mechanisms import slotted_lever
from stroke_curves import PLACES, Curve, extrema, values_of_extrema

RISING = """
param alpha = 20 deg in 5 deg .. 80 deg
pivot O
slider K along y
link OB
link BK
OB = 200 mm @ 90 deg + alpha
BK = 200 mm @ 90 deg - alpha
force P at B along x
force F at K along -y
find k = P/F
"""


@pytest.mark.parametrize(
    ("function", "rough"),
    [
        (lambda x: 3 + 2 * x, False),
        (lambda x: 1 / x, True),
        (abs, True),
        (lambda x: math.copysign(1, x) + x, True),
        (lambda x: 1 / (x + 1.5), True),
    ],
)
def test_no_slope_is_known_over_a_pole_a_kink_or_a_jump(function, rough):
    assert is_rough([function(x) for x in (-2, -1, 1, 2)]) is rough


def hunted(folder: Path, text: str = RISING) -> Hunted:
    return Hunted(Made(text), 0, folder)


def with_result(found: Hunted, **changes: object) -> Hunted:
    """Return a mechanism of whose result something else is said."""
    (k,) = found.compilation.results
    found.compilation.__dict__["results"] = (replace(k, **changes),)
    return found


def test_nothing_is_refuted_where_all_holds(tmp_path):
    done = looked_at("toggle", hunted(tmp_path))
    assert (done.results, done.refuted, done.refused, done.late) == (1, (), (), "")
    assert done.traits == ("open",)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"trends": {"alpha": "falls"}}, "limits: k falls with alpha: rises 239 times"),
        ({"zeros": ()}, "left out: k has order 1.00"),
        ({"independent": ("alpha",)}, "limits: k depends on alpha"),
        ({"default": 0.4}, "curves: k is marked at 0.727"),
    ],
)
def test_a_falsehood_is_found(tmp_path, changes, said):
    wider = RISING.replace("5 deg .. 80 deg", "-40 deg .. 80 deg")
    found = with_result(hunted(tmp_path, wider if "zeros" in changes else RISING), **changes)
    refuted = looked_at("toggle", found).refuted
    assert any(one.startswith(said) for one in refuted), refuted


@pytest.mark.parametrize(("part", "is_refuted"), [(1.0, False), (1.001, True)])
def test_rounding_beside_a_fold_is_no_falsehood_of_a_slope(tmp_path, part, is_refuted):
    """β = arcsin(sin α) is α up to 90°: k = α·sin(α + β)/cos β is 2α·sin α."""
    alpha, beta = Symbol("alpha"), Symbol("beta")
    sine = Call("sin", (alpha,))
    both = Call("sin", (total([alpha, beta]),))
    k = with_result(
        hunted(tmp_path),
        formula=product([(alpha, 1), (both, 1), (Call("cos", (beta,)), -1)]),
        where=(Definition("beta", Call("asin", (sine,))),),
    ).compilation.results[0]
    slope = total([sine, product([(alpha, 1), (Call("cos", (alpha,)), 1)])])
    k = replace(k, derivatives={"alpha": product([(number(2), 1), (number(part), 1), (slope, 1)])})
    pose = {"alpha": math.pi / 2 - 2e-4, "beta": math.pi / 2 - 2e-4}
    refuted = [*slopes(hunted(tmp_path).compilation.mechanism, k, pose)]
    assert bool(refuted) == is_refuted, refuted


def test_an_extremum_below_the_curve_is_found(tmp_path):
    made = hunted(tmp_path).compilation
    plot = made.plot(Query("alpha", ("k",)))
    (curve,) = plot.curves
    at = curve.pieces[0][100]
    for lower, is_refuted in ((0.0, False), (0.1, True)):
        mark = Mark("maximum", at._replace(y=at.y - lower))
        alone = tuple(p for p in curve.pieces[0] if p.x <= at.x)
        (panel,) = plot.panels
        other = replace(panel, curves=(replace(curve, pieces=(alone,), marks=(mark,)),))
        found = [*plotted_marks.refuted(made.results[0], replace(plot, panels=(other,)))]
        assert bool(found) == is_refuted, found


LOOKED_UP = """
param v = 1.2 in 0 .. 3
table m = 0: 0.8, 2: 1.4, 5: 1.1
list sizes = 80 mm, 120 mm, 200 mm
let a = 50 mm when v < 2 else 30 mm
let b = next 2*a in sizes
let w = m at v
pivot O
slider K along y
link OB
link BK
OB = a*w @ 70 deg
BK = b @ 110 deg
torque M on OB
force F at K along -y
friction slider K 0.1
find k = M/F
"""


@pytest.mark.parametrize(("at", "stage"), [("page", "reported"), ("sums", "by_equilibrium")])
def test_a_formula_that_is_off_is_found_on_a_page_with_tables(tmp_path, at, stage):
    found = hunted(tmp_path, LOOKED_UP)
    assert list(REFUTERS[at](found)) == []
    derivation = getattr(found.compilation, stage)
    k, *others = derivation.results
    twice = replace(k, formula=product([(number(2), 1), (k.formula, 1)]))
    found.compilation.__dict__[stage] = replace(derivation, results=(twice, *others))
    assert any(said.startswith("k is ") for said in REFUTERS[at](found))


@pytest.mark.parametrize("change", [{"force": Plane(1.0, 2.0)}, {"moment": 0.3}])
def test_a_free_body_with_friction_that_is_off_is_found(tmp_path, change):
    found = hunted(
        tmp_path, LOOKED_UP.replace("friction slider K 0.1", "friction pins 0.1 diameter 9 mm")
    )
    assert list(REFUTERS["bodies"](found)) == []
    *others, last = found.compilation.free_bodies
    assert last.motion == "tightening"
    body = next(b for b in last.bodies if b.forces[0].kind in ("pin", "ground"))
    forces = (body.forces[0]._replace(**change), *body.forces[1:])
    bodies = (b._replace(forces=forces) if b is body else b for b in last.bodies)
    found.compilation.__dict__["free_bodies"] = (*others, last._replace(bodies=tuple(bodies)))
    said = " ".join(REFUTERS["bodies"](found))
    assert "k tightening: the " in said
    assert f"on {body.name} come to" in said


def test_an_order_of_lines_that_changes_a_result_is_found(tmp_path):
    found = hunted(tmp_path)
    assert list(REFUTERS["order"](found)) == []
    (k,) = found.compilation.solution.results
    off = SimpleNamespace(results=(replace(k, default=2 * k.default),))
    found.compilation.__dict__["solution"] = off
    (said,) = REFUTERS["order"](found)
    assert said.startswith("k is 1.4558")


def test_a_code_that_is_off_is_found(tmp_path, monkeypatch):
    monkeypatch.setattr("refuters.by_python", lambda made: {"k": [0.0] * 40})
    assert any(one.startswith("code: ") for one in looked_at("toggle", hunted(tmp_path)).refuted)


def test_what_takes_too_long_is_named(tmp_path, monkeypatch):
    monkeypatch.setitem(REFUTERS, "causes", lambda found: sum(0 for _ in count()))
    done = looked_at("toggle", hunted(tmp_path), seconds=1)
    assert done.late == "causes"
    assert list(done.lines()) == ["toggle 0: out of time, causes"]


def test_an_error_of_a_description_is_counted_and_one_of_the_compiler_is_shown(tmp_path):
    done = looked_at("toggle", hunted(tmp_path, RISING.replace("slider K along y\n", "")))
    assert (done.results, done.refuted) == (0, ())
    assert done.refused
    (refuted,) = hunt.tried(Outcome("toggle", 0), "page", lambda: [1 / 0]).refuted
    assert refuted == "page: ZeroDivisionError division by zero"


def test_a_summary_counts_what_was_looked_at():
    outcomes = [
        Outcome("flat", 1, 2, ("closed",), refuted=("stroke: k is 1",)),
        Outcome("rope", 2, refused=("E343",)),
        Outcome("rope", 3, 1, ("open",), late="page"),
    ]
    assert list(summary(outcomes)) == [
        "3 mechanisms, 2 of them with results, 3 in all",
        "of which: closed 1, open 1",
        "kinds: flat 1, rope 1",
        "refused: E343 1",
        "out of time: rope 3",
        "statements refuted: 1",
    ]


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_makes_mechanisms(kind):
    assert any(made(kind, seed) for seed in range(5))


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_nothing_that_is_said_of_a_mechanism_of_each_kind_is_refuted(kind):
    outcomes = filter(None, (outcome(kind, seed) for seed in range(98000000, 98000010)))
    done = next(one for one in outcomes if one.results)
    assert list(done.lines()) == []


def efficiency_at_the_end_of_a_part(value: float) -> Curve:
    """An efficiency that rises from 0.1, where on the other side nothing moves; seen at 0.1."""
    seen = Curve.__new__(Curve)
    seen.name, seen.size, seen.poles, seen.branches = "eta_k", 0.5, [], []
    seen.places, seen.cell = np.linspace(0.0, 1.0, PLACES), 1 / (PLACES - 1)
    seen.k = seen.places - 0.1
    seen.at = lambda places: np.asarray(places) - 0.1
    seen.stroke = SimpleNamespace(standstills=[SimpleNamespace(low=0.0999, high=0.1)])
    seen.extrema = [SimpleNamespace(drive=0.1, value=value)]
    return seen


def turning_twice_in_a_cell(places: tuple[float, ...]) -> Curve:
    """A cubic with extrema an eighth of a cell beside 0.5, said to turn at some places."""
    seen = Curve.__new__(Curve)
    seen.name, seen.size, seen.poles, seen.branches = "k_f", 1.0, [], []
    seen.places, seen.cell = np.linspace(0.0, 1.0, PLACES), 1 / (PLACES - 1)
    seen.at = lambda x: (
        ((np.asarray(x) - 0.5) / seen.cell) ** 3 - 3 / 64 * np.asarray(x) / seen.cell
    )
    seen.k = seen.at(seen.places)
    seen.extrema = [SimpleNamespace(drive=0.5 + x * seen.cell, value=1.0) for x in places]
    return seen


def test_extrema_nearer_to_each_other_than_half_a_cell_are_looked_at_as_near():
    assert list(extrema(turning_twice_in_a_cell((-1 / 8, 1 / 8)))) == []
    assert len(list(extrema(turning_twice_in_a_cell((-1 / 8, 0.0))))) == 1


def test_an_efficiency_of_zero_where_nothing_moves_on_one_side_is_a_minimum():
    assert list(extrema(efficiency_at_the_end_of_a_part(0.0))) == []
    assert list(extrema(efficiency_at_the_end_of_a_part(0.2))) == ["k does not turn at 0.1"]


AT_REST = """
param t1 = 360 deg in 292.60 deg .. 412.60 deg
param t2 = 270 deg in 200.17 deg .. 280.17 deg
param t3 = 180 deg in 126.11 deg .. 306.11 deg
pivot O
slider A along 90 deg
link AB
link OBC
AB = 137.2 mm @ t1
OB = 137.4 mm @ t2
OC = 81.3 mm @ t3
force P at A along 90 deg
force F at C along 180 deg
friction pins 0.116 diameter 11.1 mm
find k = P/F
"""


def test_a_picture_of_a_pose_at_rest_has_the_friction_beside_it():
    """The lever stands still for an instant: k_f is what it comes to next to that pose."""
    made = Compilation(Source("rest.mech", AT_REST))
    with_friction = next(r for r in made.results if r.name == "k_f")
    assert with_friction.sides
    assert with_friction.default
    assert list(free_bodies_shown.refuted(made)) == []


def test_on_a_page_of_a_pose_at_rest_a_number_is_what_code_comes_to_beside_it(tmp_path):
    found = hunted(tmp_path, slotted_lever())
    assert list(REFUTERS["page"](found)) == []
    page = Page(found.compilation)
    limit = found.compilation.results[1].default
    assert page.printed()["k_f"] == pytest.approx(limit, rel=1e-7)
    assert page.code["k_f"] != pytest.approx(limit, rel=1e-5)


def at_a_place_of_its_own(value: float) -> Curve:
    """A result that is least at 0.5, where code has no friction: it is 1 there, not 2."""
    seen = Curve.__new__(Curve)
    seen.size, seen.range, seen.cell, seen.jumps = 2.0, 1.0, 1 / (PLACES - 1), []
    seen.at = lambda places: np.where(np.asarray(places) == 0.5, 1.0, 2 + abs(places - 0.5))
    seen.extrema = [SimpleNamespace(drive=0.5, value=value)]
    return seen


def test_an_extremum_at_a_pose_at_rest_is_the_limit_from_both_sides():
    assert list(values_of_extrema(at_a_place_of_its_own(2.0))) == []
    assert len(list(values_of_extrema(at_a_place_of_its_own(1.5)))) == 1
