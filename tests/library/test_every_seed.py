"""Every formula of the papers comes out of a file of the library, as ``library/seeds.json`` says.

Each is held at its reference points, known to 30 digits, and at points near them against
the arithmetic of its entry in ``seeds/values.json``.
"""

import json
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
import pytest

import mechc
from mechc.api import SolvedMechanism
from mechc.cli import make_formulas
from paths import LIBRARY
from seed_friction import entries

SEEDS: dict[str, dict[str, Any]] = json.loads((LIBRARY / "seeds.json").read_text("utf-8"))

COMPUTED = [seed for seed, entry in entries("values.json").items() if entry["points"]]

every_file = pytest.mark.parametrize("name", sorted({SEEDS[seed]["file"] for seed in COMPUTED}))
"""Each file is compiled by one test."""

UNITS = {"S002-T46": 1e-3, "S002-T47": 1e6, "S002-T410": 1e6, "S002-HB": 1.0, "S002-allow": 1.0}
"""The tables of data, and the unit that each is printed in."""

FUNCTIONS = {
    "pi": np.pi,
    "Min": np.minimum,
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    **{name: getattr(np, name) for name in ("sin", "cos", "tan", "sqrt")},
}


@cache
def file(name: str) -> SolvedMechanism:
    return mechc.load(name)


def computed(seed: str, inputs: Mapping[str, Any]) -> Any:
    """Return the library's value of a formula at inputs by the formula's own names."""
    where = SEEDS[seed]
    given = {where["inputs"][name]: value for name, value in inputs.items()}
    return file(where["file"]).evaluate(**given)[where["result"]]


def columns(points: list[dict[str, Any]]) -> dict[str, np.ndarray]:
    names = points[0]["inputs"]
    return {name: np.array([p["inputs"][name] for p in points]) for name in names}


def test_every_formula_has_its_place() -> None:
    assert list(SEEDS) == list(entries("values.json"))
    assert set(SEEDS) == {*COMPUTED, *UNITS}


@every_file
def test_formulas_of_a_file(name: str) -> None:
    for seed in (s for s in COMPUTED if SEEDS[s]["file"] == name):
        entry = entries("values.json")[seed]
        wanted = [float(p["value_30"]) for p in entry["points"]]
        found = computed(seed, columns(entry["points"]))
        np.testing.assert_allclose(found, wanted, rtol=1e-12, atol=1e-14, err_msg=seed)
        if entry["formula"] != "table":
            agrees_beside(seed, entry)


def agrees_beside(seed: str, entry: dict[str, Any]) -> None:
    """Compare beside the reference points; what a condition excludes there is left aside."""
    dice = np.random.default_rng(1)
    at = {name: np.repeat(v, 12) for name, v in columns(entry["points"]).items()}
    near = {name: v * dice.uniform(0.97, 1.03, v.shape) for name, v in at.items()}
    found = np.asarray(computed(seed, near))
    wanted = eval(entry["formula"], {"__builtins__": {}}, {**FUNCTIONS, **near})
    holds = np.isfinite(found)
    assert holds.mean() > 0.3, seed
    wanted = np.broadcast_to(wanted, found.shape)[holds]
    np.testing.assert_allclose(found[holds], wanted, rtol=1e-10, atol=1e-13, err_msg=seed)


def test_data_of_the_tables() -> None:
    for seed, unit in UNITS.items():
        if seed != "S002-T46":
            found = file(SEEDS[seed]["file"]).evaluate()
            for row, printed in entries("values.json")[seed]["data"].items():
                values = [found[name] / unit for name in SEEDS[seed]["data"][row]]
                assert values == pytest.approx(printed), (seed, row)


def test_sizes_of_jaws() -> None:
    seed = SEEDS["S002-T46"]
    for size, printed in entries("values.json")["S002-T46"]["data"].items():
        found = file(seed["file"]).evaluate(**{seed["inputs"]["size"]: float(size)})
        sizes = [float(str(size).lstrip("M")) for size in printed]
        assert [found[name] * 1e3 for name in seed["columns"]] == pytest.approx(sizes)


def test_readme_lists_them() -> None:
    readme = (LIBRARY / "README.md").read_text("utf-8")
    assert make_formulas.made(readme) == readme, "python -m mechc.cli.make_formulas"
