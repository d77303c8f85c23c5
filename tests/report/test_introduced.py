"""Every name on a page of the library is introduced before, or where, it is first used."""

from contextlib import suppress

import pytest

from good_mechanisms import ALL, compiled
from grown import Grown
from introduced import never_introduced, not_introduced
from mechc.compilation import Compilation, emit
from mechc.diagnostics import MechcError
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.source import Source
from mechc.syntax.vocabulary import points_of

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


ROCKER = """
param phi = 60 deg
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OA
link AB
link CB
OA = 30 mm @ phi
AB = 90 mm
CB = 70 mm
assembly ABC cw
drive phi from 0 deg to 360 deg
torque M on OA
torque T on CB
find k = M/T
require 20 deg < phi_CB < 160 deg
require x_B > 10 mm
require len_BO > 1 mm
"""


def page_of(text: str) -> str:
    (emitted,) = emit(Compilation(Source("m.mech", text)), TARGET, Options("m"))
    return emitted.text


def test_what_a_condition_of_use_asks_of_the_pose_is_introduced():
    """The direction of the rocker is that of the coupler and the angle between them."""
    tex = page_of(ROCKER)
    said = tex.partition("The result holds for ")[2].partition(".\n")[0]
    assert said.startswith(
        r"$20^\circ<\mu_B+\varphi_{AB}<160^\circ$, $CB\cos(\mu_B+\varphi_{AB})+x_C>10"
    )
    assert never_introduced(tex) == set()
    assert never_introduced(tex.replace(r"\mu_B+\varphi_{AB}<", r"\varphi_{CB}<")) == {
        r"\varphi_{CB}"
    }


def with_conditions(seed: int) -> str:
    """Return a closed mechanism with a condition on each of its links, its default pose inside."""
    grown = Grown(seed)
    points = (points_of(line.split()[1]) for line in grown.lines if line.startswith("link "))
    links = ["".join(found[:2]) for found in points]
    asked = (f"require -1000 deg < phi_{v} < 1000 deg\nrequire len_{v} < 9 m" for v in links)
    return grown.text() + "\n" + "\n".join(asked)


@pytest.mark.slow
@pytest.mark.parametrize("seeds", [range(70110, 70120), range(70120, 70130)])
def test_conditions_on_every_link_are_introduced(seeds):
    for seed in seeds:
        with suppress(MechcError):
            assert never_introduced(page_of(with_conditions(seed))) == set(), seed
