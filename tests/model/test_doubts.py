"""Remarks on loads that stand for friction: which are made, and which are not."""

from contextlib import suppress

import pytest

from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.source import Source
from small_mechanisms import slider_crank

LEVER = """
param mu = 0.2
param a = 100 mm
pivot O
link OA
OA = a @ 0 deg
force N at A along -y
torque M on OA
find k = M/N
friction pin O 0.1 diameter 10 mm
"""


@pytest.mark.parametrize(
    ("load", "is_friction"),
    [
        ("force T = mu*N at A along x", True),
        ("force T = mu*N at A along perp OA", False),  # along y, as N is
        ("force T = mu*N at A along y", False),
        ("force T = N/5 at A along x", False),  # a number is no coefficient
        ("force T = mu*N at O along x", False),
    ],
)
def test_a_share_of_a_force_across_it_looks_like_friction(load: str, is_friction: bool) -> None:
    compilation = Compilation(Source("lever.mech", f"{LEVER}{load}\n"))
    assert compilation.mechanism
    codes = [d.code for d in compilation.report.diagnostics]
    assert ("W206" in codes) == is_friction


def test_without_friction_elsewhere_nothing_is_remarked_upon() -> None:
    text = LEVER.replace("friction pin", "# friction pin") + "force T = mu*N at A along x\n"
    compilation = Compilation(Source("lever.mech", text))
    assert compilation.mechanism
    assert "W206" not in [d.code for d in compilation.report.diagnostics]


SHEET = "sheet pin\nparam d = 3\nparam F = 12 kN\nparam a = 5 mm\n"


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("list sizes = 1,2,3", ""),
        ("list sizes = 1, 2,3, 4", "W292"),
        ("list sizes = 0,5 mm", "W292"),
        ("list sizes = 5 mm,6 mm, 8 mm", ""),
        ("let A = a^2/4 mm^2", "W293"),
        ("let A = a^2/4 in mm^2", ""),
        ("param A = a^2/4 mm^2", "W293"),
        ("let A = a^2*0.25 mm^2", "W294"),
        ("let A = 0.25 mm^2*a^2", "W294"),
        ("let A = a^2*0.25 in mm^2", ""),
        ("let A = a*10 mm", ""),
        ("let I = a^2*(4 mm^2)", ""),
        ("let A = a^2\nlet I = A*12 mm^2", ""),
        ("let A = a^2\nlet I = 3*A*12 mm^2", "W294"),
        ("let A = pi*a^2*0.25 mm^2", "W294"),
        ("let A = pi*50 mm^2/4", "W279"),
        ("param T = F*2 N", "W294"),
        ("let n = F/(5 kN)", ""),
        ("let n = 10 kN / 5 kN", ""),
        ("let p = F/5 mm^2", ""),
    ],
)
def test_numbers_and_units_that_belong_to_others_than_meant(line: str, code: str) -> None:
    compilation = Compilation(Source("pin.mech", f"{SHEET}{line}\n"))
    with suppress(MechcError):
        assert compilation.mechanism
    found = {d.code for d in compilation.report.diagnostics} & {"W279", "W292", "W293", "W294"}
    assert found == ({code} if code else set())


CRANK = """
param phi = 40 deg
slider C along x
link OB
link BC
OB = 50 mm @ phi
BC = 120 mm @ -20 deg
torque M on OB
force F at C along -x
find k = M/F
"""


@pytest.mark.parametrize(
    ("lines", "warned"),
    [
        ("pivot O\nB at (30 mm, 40 mm)", True),
        ("pivot O at (0 mm, 0 mm)\nB at (38.3 mm, 32.14 mm)", False),
        ("pivot O", False),
    ],
)
def test_a_place_beside_vectors_rests_on_a_pivot_with_a_place(lines: str, warned: bool) -> None:
    compilation = Compilation(Source("crank.mech", f"{CRANK}{lines}\n"))
    assert compilation.results
    assert ("W321" in {d.code for d in compilation.report.diagnostics}) == warned


BRAKE = """
pivot O at (0 mm, 0 mm)
pivot C at (-120 mm, -250 mm)
link OA
A at (0 mm, 60 mm)
link CDE
D at (120 mm, -250 mm)
E at (480 mm, -250 mm)
rope C, O along y, D along -y
torque M on OA
force P at E along -y
find k = M/P
"""


@pytest.mark.parametrize(
    ("friction", "codes"),
    [
        ("friction rope O 0.3 wrap -180 deg drum 240 mm on OA", set()),
        ("friction rope O 0.3 wrap 180 deg drum 240 mm on OA", {"W349"}),
        ("friction rope O 0.3 wrap 540 deg drum 240 mm on OA", {"W349"}),
    ],
)
def test_a_wrap_goes_around_the_drum_as_the_rope_is_drawn(friction: str, codes: set[str]) -> None:
    """P works through friction alone, so that nothing is said of a load without influence."""
    compilation = Compilation(Source("brake.mech", f"{BRAKE}{friction}\n"))
    assert compilation.solution
    assert {d.code for d in compilation.report.diagnostics} == codes


@pytest.mark.parametrize(
    ("route", "wrap", "warned"),
    [
        ("A, O, B", "60 deg", False),
        ("A, O, B", "-60 deg", False),  # a pulley that is held may be rounded either way
        ("A, O, B", "420 deg", False),
        ("A, O, B", "90 deg", True),
        ("A, O along y, B along x", "90 deg", False),
    ],
)
def test_a_wrap_is_the_turn_of_the_drawn_falls(route: str, wrap: str, warned: bool) -> None:
    text = f"""
pivot O at (0 mm, 0 mm)
slider A along y
slider B along x
A at (-100 mm, -300 mm)
B at (400 mm, 100 mm)
rope {route}
force P at B along x
force F at A along -y
friction rope O 0.25 wrap {wrap}
find k = P/F
"""
    compilation = Compilation(Source("rope.mech", text))
    assert compilation.solution
    assert ("W350" in {d.code for d in compilation.report.diagnostics}) == warned


@pytest.mark.parametrize(
    ("stroke", "codes"),
    [
        ("from 20 deg to 160 deg speed 60 rpm", set()),
        ("from 20 deg to 160 deg speed 6 rad/s", set()),
        ("from 20 deg to 160 deg speed 6 1/s", set()),
        ("from 20 deg to 160 deg speed 1 Hz*1 rev", set()),
        ("from 20 deg to 160 deg speed 1 Hz", {"W296"}),
        ("from 20 deg to 160 deg speed 60 1/min", {"W296"}),
        ("from 20 deg to 160 deg speed 2*pi*60 1/min", set()),
        ("from 20 deg to 160 deg speed w\nlet w = 2*pi*n\nparam n = 60 1/min", set()),
        ("from 0 deg to 2.5 rad", set()),
        ("from 20 deg to 2.5 rad", {"W297"}),
        ("from 20 deg to 160 rad", {"W245"}),
    ],
)
def test_speeds_and_strokes_in_units_that_are_hardly_meant(stroke: str, codes: set[str]) -> None:
    text = CRANK.replace("BC = 120 mm @ -20 deg", "BC = 120 mm").replace("40 deg", "40 deg", 1)
    lines = f"pivot O at (0 mm, 0 mm)\nassembly C forward\ndrive phi {stroke}\n"
    text = text.replace("slider C along x", "slider C along x through O")
    compilation = Compilation(Source("crank.mech", f"{text}{lines}"))
    assert compilation.mechanism
    found = {d.code for d in compilation.report.diagnostics}
    assert found & {"W245", "W296", "W297"} == codes


@pytest.mark.parametrize(
    ("lines", "codes"),
    [
        ("let f = n in Hz", {"W267"}),
        ("let f = n/(2*pi) in Hz", set()),
        ("let Q = V*n", {"W268"}),
        ("let Q = V*n/(2*pi)", set()),
        ("let A = pi*d^2/4\nparam d = 20 mm\nlet S = A*d\nlet Q = S*n", {"W268"}),
    ],
)
def test_turns_that_pi_brings_to_radians(lines: str, codes: set[str]) -> None:
    text = f"sheet pump\nparam n = 1500 rpm\nparam V = 20 cm^3\n{lines}\n"
    compilation = Compilation(Source("pump.mech", text))
    assert compilation.mechanism
    found = {d.code for d in compilation.report.diagnostics}
    assert found & {"W267", "W268"} == codes


JACK = """
param p = 4 mm
pivot S{place}
link SE
SE = 10 mm @ 0 deg
slider A along x
screw A pitch p on SE
torque T on SE{times}
force N at A along x
mirror across x sharing A
find m = T/N
"""


@pytest.mark.parametrize(
    ("place", "times", "warned"),
    [
        ("", "", True),
        ("", " times 1/2", False),
        (" at (0 mm, 50 mm)", "", False),  # one of two screws, each on its side
    ],
)
def test_a_screw_along_the_mirror_line_is_in_both_halves(place, times, warned) -> None:
    compilation = Compilation(Source("jack.mech", JACK.format(place=place, times=times)))
    assert compilation.mechanism
    assert ("W208" in {d.code for d in compilation.report.diagnostics}) == warned


def test_one_screw_that_moves_a_nut_in_each_part_is_no_part_of_one() -> None:
    """The link SE is shared, the nut A is in each of three branches: nothing is there 0 times."""
    branches = JACK.format(place="", times="").replace(
        "mirror across x sharing A", "copies 3 sharing S, E"
    )
    compilation = Compilation(Source("jack.mech", branches))
    assert compilation.mechanism
    assert "W208" not in {d.code for d in compilation.report.diagnostics}


@pytest.mark.parametrize(("speed", "doubted"), [("10 rad/s", False), ("0 rad/s", True)])
def test_a_drive_of_no_speed_is_doubted(speed: str, doubted: bool) -> None:
    crank = slider_crank("find k = M/F", drive=f"from 0 deg to 90 deg speed {speed}")
    compilation = Compilation(Source("crank.mech", crank))
    assert compilation.mechanism
    said = [d.message for d in compilation.report.diagnostics if "the speed of phi" in d.message]
    assert len(said) == doubted


DRAWN = """
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OA
link AB
link CB
A at (20 mm, 35 mm)
B at {place}
drive OA
torque M on OA
torque T on CB
find k = M/T
"""


@pytest.mark.parametrize(
    ("place", "codes"),
    [
        ("(80 m, 60 mm)", {"W295"}),
        ("(80 m, 60 m)", {"W266"}),
        ("(80 mm, 60 mm)", set()),
    ],
)
def test_a_size_is_not_doubted_where_the_units_of_its_place_are(place, codes):
    compilation = Compilation(Source("bar.mech", DRAWN.format(place=place)))
    with suppress(MechcError):
        _ = compilation.mechanism
    found = {d.code for d in compilation.report.diagnostics}
    assert found & {"W295", "W266"} == codes
