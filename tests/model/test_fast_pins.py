"""Which link a pin is fast in, and which one carries a load there: said, or taken by rule."""

import pytest

import mechc
from force_samples import compiled
from mechc.compilation import Compilation
from mechc.figure import figure as drawn
from mechc.model.mechanism import PinFriction
from mechc.source import Source

TOGGLE = """
pivot H at (-2.6 m, 1.9 m)
pivot N at (-1.4 m, -0.6 m)
HE = 2.0396 m @ -11.31 deg
EP = 2.4824 m
NP = 3.1469 m
assembly EPN cw
torque M on HE
{load}
friction pins 0.1 diameter 200 mm
{more}
find k = M/F
{links}
"""

LINKS = ("link HE", "link EP", "link NP")


def solved(load="force F at P along -y", more="", links=LINKS):
    return compiled(TOGGLE.format(load=load, more=more, links="\n".join(links)), "toggle.mech")


def with_friction(made):
    values = made.results(made.values())
    return [values[name] for name in ("k_f", "k_hold", "k_f1")]


def remarks(made):
    return [d.code for d in made.compilation.report.diagnostics]


def carrier(text: str, point: str) -> str:
    """Return the link that a pin is fast in."""
    mechanism = Compilation(Source("carrier.mech", text)).mechanism
    pins = [r for r in mechanism.friction.joints if isinstance(r, PinFriction)]
    return next(pin.carrier for pin in pins if pin.point == point)


def test_the_order_of_links_makes_no_difference():
    known = with_friction(solved())
    for links in (LINKS[::-1], LINKS[1:] + LINKS[:1]):
        assert with_friction(solved(links=links)) == pytest.approx(known, rel=1e-9)


def test_a_load_acts_on_the_link_that_is_named():
    on_bar, on_rod = (solved(f"force F at P on {link} along -y") for link in ("NP", "EP"))
    assert with_friction(on_bar) == pytest.approx(with_friction(solved()), rel=1e-9)
    assert abs(with_friction(on_rod)[0] - with_friction(on_bar)[0]) > 5e-4


@pytest.mark.parametrize("link", ["NP", "EP"])
def test_it_is_the_same_to_say_where_the_pin_is_fast(link):
    load = solved(f"force F at P on {link} along -y")
    pin = solved(more=f"friction pin P 0.1 diameter 200 mm on {link}")
    assert with_friction(load) == pytest.approx(with_friction(pin), rel=1e-9)


@pytest.mark.parametrize("link", ["NP", "EP"])
def test_a_pin_between_two_links_has_one_friction_whichever_it_is_fast_in(link):
    """Where the load acts on a link, what presses the pin is action and reaction."""
    more = f"friction pin P 0.1 diameter 200 mm on {link}"
    both = solved("force F at P on NP along -y", more)
    assert with_friction(both) == pytest.approx(with_friction(solved()), rel=1e-9)


STAR = """
pivot O
pivot Q
link OB
link QB
OB = 100 mm @ {0}
QB = 100 mm @ {1}
force P at B along 20 deg
force F at B along 80 deg
friction pin B 0.1 diameter 10 mm
find k = P/F
"""


@pytest.mark.parametrize("links", [("NP", "EP"), ("EP", "NP")])
def test_names_do_not_decide_where_directions_are_given(links):
    """Two cranks alike but for their directions: the pin goes with the one drawn first."""
    first, second = links
    text = STAR.replace("OB", first).replace("QB", second).replace("pivot O", f"pivot {first[0]}")
    text = text.replace("pivot Q", f"pivot {second[0]}").replace(" at B", " at P")
    text = text.replace("pin B", "pin P").format("30 deg", "110 deg")
    assert carrier(text, "P") == first


def test_the_remark_goes_where_it_is_said():
    assert remarks(solved()) == ["W540"]
    assert not remarks(solved("force F at P on EP along -y"))
    assert not remarks(solved(more="friction pin P 0.1 diameter 200 mm on EP"))


def test_a_symmetric_toggle_needs_no_remark():
    """Both rods press the pin alike, whichever carries it."""
    assert not mechc.load("fedoriv_fig2a_with_friction").warnings


ROD_TOGGLE = """
pivot O
slider C along x
OB = {first} mm @ 60 deg
BC = {second} mm @ -60 deg
torque M on OB
force F at C along -x
friction pins 0.1 diameter 10 mm
find k = M/F
{links}
"""


@pytest.mark.parametrize(
    ("links", "point", "known"),
    [
        (("OB", "BCD"), "B", "BCD"),  # a lever before a rod, though both can be bent
        (("OB", "BC"), "B", "OB"),  # the crank before the coupler
        (("OB", "BC"), "O", ""),  # the ground
        (("OB", "BC"), "C", ""),  # the slider
    ],
)
def test_what_a_pin_is_fast_in(links, point, known):
    names = [f"link {link}" for link in links]
    lever = "CD = 20 mm @ 10 deg\nforce G = F at D along x\n" if "BCD" in links else ""
    for order in (names, names[::-1]):
        drawn = ROD_TOGGLE.format(first=80, second=80, links="\n".join(order)).replace(
            "torque M on OB", "force M at B along x" if lever else "torque M on OB"
        )
        assert carrier(drawn + lever, point) == known


SLIDERS = """
slider A along x
slider C along x
AB = {first} mm @ 50 deg
CB = {second} mm @ 130 deg
force F at A along -x
force G at C along x
force P at B along -y
friction pins 0.1 diameter 10 mm
find P
{links}
"""


def test_of_two_rods_that_stand_alike_the_longer_one_carries_the_pin():
    for order in ("link AB\nlink CB", "link CB\nlink AB"):
        assert carrier(SLIDERS.format(first=80, second=81, links=order), "B") == "CB"
        assert carrier(SLIDERS.format(first=81, second=80, links=order), "B") == "AB"


@pytest.mark.parametrize(("first", "second"), [("AB", "CB"), ("CB", "AB")])
def test_of_two_rods_that_are_alike_the_couples_on_them_decide(first, second):
    couples = f"torque T on {first}\ntorque U = 2*P*10 mm on {second}"
    for order in ("link AB\nlink CB", "link CB\nlink AB"):
        drawn = SLIDERS.format(first=80, second=80, links=order) + couples
        assert carrier(drawn, "B") == first


def test_the_force_along_a_rod_is_that_of_the_pin_without_a_load():
    """F acts on the rod itself at C, so the pin at B gives the whole of N."""
    text = ROD_TOGGLE.format(
        first=80, second=80, links="link OB\nlink BC\nfind N_BC\nfind R_C on BC"
    )
    on_rod = text.replace("force F at C", "force F at C on BC")
    one, two = (mechc.loads(t).evaluate(F=10.0) for t in (text, on_rod))
    assert one["N_BC"] == pytest.approx(-20)
    assert two["N_BC"] == pytest.approx(-20)
    assert abs(one["R_C_on_BC_x"] - two["R_C_on_BC_x"]) == pytest.approx(10)


def test_a_load_on_what_both_halves_have_counts_for_each():
    """At the shared slider K, F on BK is one force on each of the twins."""
    text = """
    pivot O
    slider K along y
    link OB
    link BK
    OB = 100 mm @ 100 deg
    BK = 80 mm @ 40 deg
    mirror across y sharing K
    torque M on OB
    force F at K along -y
    find k = M/F
    """
    whole, each = (mechc.loads(t) for t in (text, text.replace("at K", "at K on BK")))
    assert each.evaluate()["k"] == pytest.approx(2 * whole.evaluate()["k"])


CARRIED = """
pivot O
pivot D
link OA
link AB
slider B along x
OA = 50 mm @ 60 deg
AB = @ -20 deg
OD = 40 mm @ 100 deg
force P at A on OA along 0 deg
spring 5 N/mm between A on AB and D free 30 mm
force F at B along 180 deg
find P
"""


def test_loads_name_the_links_that_carry_them():
    figure = mechc.loads(CARRIED, "carried.mech").figure()
    force = {f.name: f.link for f in figure.parts if isinstance(f, drawn.Force)}
    assert force == {"P": "OA", "F": ""}
    (spring,) = [p for p in figure.parts if isinstance(p, drawn.Spring)]
    assert (spring.first_link, spring.second_link) == ("AB", "")
