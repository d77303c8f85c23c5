"""What code and its docstrings say of friction: the printed case, not the signs it takes."""

from pathlib import Path

import pytest

import mechc

LIBRARY = Path(__file__).parents[1] / "library"


def docstring(code: str, name: str) -> str:
    return code.partition(f"def {name}(")[2].partition('"""')[2].partition('"""')[0]


@pytest.mark.parametrize("result", ["k_f", "k_hold"])
def test_a_docstring_shows_the_printed_case(result):
    shown = docstring(mechc.load("karpenko_fig1_with_friction").emit("python"), result)
    assert "sigma" not in shown
    assert "sign(" not in shown
    assert f"{result} = 2*" in shown
    assert "    while\n" in shown
    assert "every force keeps the sense" in shown


def iterated() -> "mechc.Mechanism":
    source = (LIBRARY / "crank_rocker.mech").read_text("utf-8")
    pins = "param f_p = 0.1\nparam d_p = 12 mm\nfriction pins f_p diameter d_p\nfind R_A on AB"
    return mechc.loads(f"{source}\n{pins}\n", "crank.mech")


def test_a_docstring_shows_the_structure_of_what_is_iterated():
    shown = docstring(iterated().emit("python"), "k_f")
    assert "n = |r + D*n|" in shown
    assert "rho*n_A*Omega_A" in shown
    assert " d_A" not in shown


def test_a_report_shows_the_structure_of_what_is_iterated():
    shown = iterated().emit("latex")
    assert r"\rho n_A\Omega_A" in shown
    assert r"\left|r+Dn\right|" in shown
    assert shown.count("Newton") == 1
    assert r"\operatorname{sgn}" not in shown


def test_json_gives_the_conditions_of_a_case():
    import json

    document = json.loads(mechc.load("karpenko_fig1_with_friction").emit("json"))
    found = next(r for r in document["results"] if r["name"] == "k_f")
    assert [c["operator"] for c in found["holds"]] == [">"]
    account = next(a for a in document["derivation"]["accounts"] if a["results"] == ["k_f"])
    assert [p["says"] for p in account["passages"]][:4] == [
        "tightening",
        "unit",
        "pressed",
        "crossed",
    ]
