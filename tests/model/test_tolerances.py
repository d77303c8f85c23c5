"""Tolerances: read in both notations, kept in the model, shown; figures checked within bounds."""

import json

import pytest

import mechc
import small_mechanisms


def toggle(length: str = "", angle: str = "", expect: str = "") -> mechc.SolvedMechanism:
    sizes = {"l": f"200 mm{length}", "alpha": f"10 deg{angle} in 2 deg .. 40 deg"}
    return mechc.loads(small_mechanisms.toggle("find k = P/F", expect, **sizes), "a.mech")


@pytest.mark.parametrize("sign", ["+-", "±", " +- ", " ± "])
def test_a_tolerance_does_not_change_the_value(sign):
    kept = json.loads(toggle(f"{sign}0.5 mm", f"{sign}6 mrad").emit("json"))["parameters"]
    assert [p["value"] for p in kept] == [p["value"] for p in parameters_without()]
    assert [p["tolerance"] for p in kept] == [0.0005, 0.006]


def parameters_without() -> list[dict[str, float]]:
    without: list[dict[str, float]] = json.loads(toggle().emit("json"))["parameters"]
    assert [p["tolerance"] for p in without] == [None, None]
    return without


@pytest.mark.parametrize(("language", "decimal"), [("en", "."), ("uk", "{,}"), ("ru", "{,}")])
def test_reports_show_it(language, decimal):
    text = toggle(" +- 0.5 mm", " +- 0.1 deg").emit("latex", language=language)
    assert rf"$(200 \pm 0{decimal}5)\,\text{{" in text
    assert rf"$(10 \pm 0{decimal}1)^\circ$" in text


@pytest.mark.parametrize("figure", ["0.3 +- 0.06", "0.35 +- 0.0027", "0.4 ± 0.05", "1 +- 0.65"])
def test_a_figure_within_bounds_agrees(figure):
    (finding,) = toggle(expect=f"expect k = {figure}")._compilation.findings
    assert finding.outcome == "agrees"


@pytest.mark.parametrize("figure", ["0.3 +- 0.05", "0.35 +- 0.0026", "0.4 ± 0.04", "1 +- 0.64"])
def test_a_figure_out_of_bounds_is_refuted(figure):
    with pytest.raises(mechc.MechcError, match="±"):
        toggle(expect=f"expect k = {figure}")


def test_plus_and_minus_apart_are_no_tolerance():
    spaced = toggle(" + -0.1 m")
    assert spaced.defaults["l"] == pytest.approx(0.1)


@pytest.mark.parametrize("target", ["python", "c"])
def test_the_comments_of_code_have_the_tolerance(target):
    text = LEVER_IN_CODE
    emitted = mechc.loads(text).emit(target)
    assert "l: m; 200 mm +- 0.5 mm, in 100 mm .. 300 mm" in emitted
    assert "b: m; 50 mm\n" in emitted


LEVER_IN_CODE = """\
mechanism lever
param l = 200 mm +- 0.5 mm in 100 mm .. 300 mm
param b = 50 mm
pivot O
link OAB
OA = l @ 0 deg
OB = b @ 180 deg
force P at A along -y
force F at B along -y
find k = P/F
"""


def test_a_tolerance_may_be_as_small_as_one_likes():
    lever = """
param a = 1 mm
param b = 2 mm
pivot O
link AOB
OA = a @ 180 deg
OB = b @ 0 deg
torque M on AOB
force F at B along -y
find k = M/F
expect k = 2 mm +- 1e-12 mm
"""
    assert mechc.loads(lever).evaluate()["k"] == pytest.approx(0.002)
