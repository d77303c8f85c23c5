"""Every name on a page of the library is introduced before, or where, it is first used."""

import pytest

from good_mechanisms import ALL, compiled
from introduced import not_introduced
from mechc.driver import emit
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options

QUICK = ("tongs_fig4_9_forces", "claw_closed", "sum_direction", "karpenko_fig9_with_friction")


def page(name: str) -> str:
    (emitted,) = emit(compiled(name), TARGET, Options(name))
    return emitted.text


@pytest.mark.parametrize("name", QUICK)
def test_a_name_is_introduced_before_it_is_used(name):
    assert list(not_introduced(page(name))) == []


def test_a_reaction_that_nothing_names_is_seen():
    unnamed = page("tongs_fig4_9_forces").replace("$R_{A,x}$ and $R_{A,y}$ are the", "The")
    assert "\nR_{A,x}=" in unnamed
    unnamed = unnamed.replace("\nR_{A,x}=", "\n0=")
    assert [name for name, _ in not_introduced(unnamed)] == ["R_{A,x}"]


def test_a_definition_that_comes_too_late_is_seen():
    late = "Given $a$:\n\\[\nb=ac\n\\]\nhence\n\\[\nc=2a\n\\]\n"
    assert [name for name, _ in not_introduced(late)] == ["c"]
    assert not list(not_introduced(late.replace("hence", "where")))


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(ALL.keys() - set(QUICK))[1::2])
def test_every_name_is_introduced_before_it_is_used(name):
    assert list(not_introduced(page(name))) == []
