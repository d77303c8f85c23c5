"""What every pose promises, on whole mechanisms; and that a broken promise is named."""

import math

import pytest

from good_mechanisms import ALL, begun
from mechanisms import sample
from mechc.algebra.product import ONE, Product
from mechc.algebra.trigonometry import cosine
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.formula.tree import Call, Symbol, number, product
from mechc.model.mechanism import Drive
from mechc.pose.promises import broken_promises
from mechc.source import Source
from small_poses import HERE, VALUES, arm, at, lever, slider_crank, two_bars


@pytest.mark.parametrize("name", ALL)
def test_promises_are_kept(name):
    assert broken_promises(begun(name).pose) == []


@pytest.mark.parametrize("seed", range(20))
def test_promises_are_kept_of_what_is_grown(seed):
    pose = Compilation(Source("grown.mech", sample(seed).text)).pose
    assert broken_promises(pose) == []


def closed():
    """The slider-crank with its rod's direction found: psi = -asin(r/l·sin(phi))."""
    ratio = product([(number(-1), 1), (Symbol("r"), 1), (Symbol("l"), -1)])
    sine = product([(ratio, 1), (Call("sin", (Symbol("phi"),)), 1)])
    crank, rod = Product.symbol("r"), Product.symbol("l")
    frames = {"OA": {"O": (), "A": arm("r", at(phi=1))}, "AB": {"A": (), "B": arm("l", at(beta=1))}}
    given = slider_crank(definitions=[("beta", Call("asin", (sine,)))], drive=DRIVE)
    rate = -(crank * cosine(at(phi=1)) / (rod * cosine(at(beta=1))))
    return replace(given, frames=frames, rates={"phi": ONE, "beta": rate})


DRIVE = Drive("phi", None, None, HERE)


@pytest.mark.parametrize("build", [lever, slider_crank, closed])
def test_poses_by_hand_keep_them(build):
    assert broken_promises(build()) == []


def test_a_name_that_nothing_defines_is_seen():
    frame = {"O": (), "A": arm("a", at(gamma=1)), "B": arm("b", at(90, alpha=1))}
    assert broken_promises(replace(lever(), frames={"OAB": frame})) == [
        "vector to A of OAB uses gamma"
    ]


def test_a_definition_before_what_it_needs_is_seen():
    definitions = [("beta", Symbol("gamma")), ("gamma", Symbol("phi"))]
    assert broken_promises(lever(definitions=definitions)) == ["beta uses gamma too early"]


def test_a_second_definition_is_seen():
    definitions = [("beta", Symbol("phi")), ("beta", Symbol("psi"))]
    assert broken_promises(lever(definitions=definitions)) == ["beta is defined 2 times"]


def test_what_has_no_direction_is_seen():
    bare = replace(slider_crank(), guides={}, lines={}, frames={})
    assert broken_promises(bare) == [
        "body OA has no frame",
        "body AB has no frame",
        "guide of B has no direction",
        "force F has no direction",
    ]


def test_a_frame_of_other_points_is_seen():
    frames = {"OAB": {"O": (), "A": arm("a", at(alpha=1))}}
    assert broken_promises(replace(lever(), frames=frames)) == [
        "the frame of OAB is of other points"
    ]


def test_a_loop_that_stays_open_is_seen():
    """Beside OA and AB a rod OB: the loop closes for the right length and direction alone."""
    pose = two_bars()
    frames = {**pose.frames, "OK": {"O": (), "K": arm("a", at(90))}}
    gap = abs(VALUES["a"] - 2 * VALUES["l"] * math.cos(VALUES["alpha"]))
    assert broken_promises(replace(pose, frames=frames)) == [f"body OK misses K by {gap:.3g} m"]


def test_a_wrong_rate_is_seen():
    pose = closed()
    rates = {"phi": ONE, "beta": -pose.rates["beta"]}
    (found,) = broken_promises(replace(pose, rates=rates))
    assert found.startswith("beta changes by -0.2")
