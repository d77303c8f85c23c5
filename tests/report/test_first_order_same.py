"""A result of first order that is the exact one stands by its name, and is derived once."""

import pytest

from good_mechanisms import compiled
from mechc.report.text.derivation import render


def derived(name):
    return render(compiled(name).derivation, compiled(name).mechanism, unicode=False)


@pytest.mark.parametrize(("name", "load"), [("plate_clutch", "M"), ("cabinet_on_casters", "P")])
def test_what_friction_does_not_change_is_derived_once(name, load):
    shown = derived(name)
    assert f"        {load}_f1 = {load}_f\n" in shown
    assert "which here gives" in " ".join(shown.split())
    assert "r_O_collar" not in shown


def test_another_one_keeps_its_formula():
    assert "k_f1 = k_f\n" not in derived("fedoriv_fig1_with_friction")


def test_further_quantities_have_one_heading():
    assert derived("fedoriv_fig1_with_friction").count("Further quantities") == 1
