"""One mechanism, written down in several ways, has one formula."""

import re
from functools import cache
from random import Random

import pytest

import mechc
from good_mechanisms import ALL
from mechc.algebra.equality import equal
from mechc.formula.to_text import text
from sources import in_thirds

NAMES = [
    "class_four_block",
    "coupler_point_cartesian",
    "double_angles",
    "half_angles",
    "mirror_beam_torque",
    "mirror_torque_other_angle",
    "number_angles",
    "opposite_sliders",
    "quaternary_platform",
    "rod_torque",
    "six_bar_watt_turns",
    "ternary_chain",
    "tied_chain",
    "toggle_on_lever",
    "torque_on_floating",
    "trammel",
    "triad_press",
    "two_coupled_triads",
    "watt_six_bar",
]
TOO_LONG = ["class_four_block", "ternary_chain"]
"""What is read as the speeds stand, in their order: multiplied out it has over 64 operations."""

POINT = r"[A-Z]\d?"
AXES = {"x": "0 deg", "y": "90 deg", "-x": "180 deg", "-y": "270 deg"}


def source(name):
    lines = ALL[name].read_text(encoding="utf-8").splitlines()
    bare = [line.split("#")[0].rstrip() for line in lines]
    return [line for line in bare if line and not line.startswith(("expect", "source"))]


def results(lines):
    return mechc.loads("\n".join(lines), "a.mech").results


def formulas(lines):
    """Return the results as text; a length has its name from the vector as it is written."""
    found = {n: text(r.formula) for n, r in results(lines).items()}
    return {
        n: re.sub(r"(?<=len_)[A-Z]+", lambda m: "".join(sorted(m[0])), f) for n, f in found.items()
    }


@cache
def as_filed(name):
    return formulas(source(name))


def shuffled(lines):
    rest = list(lines[1:])
    Random(4).shuffle(rest)
    return [lines[0], *rest]


def reordered(lines):
    """Name links by their points in another order."""
    return [_backwards(line) if line.startswith("link ") else line for line in lines]


def _backwards(line):
    return "link " + "".join(reversed(re.findall(POINT, line.split()[1])))


def reversed_vectors(lines):
    """Write vectors from head to tail."""
    return [_reversed(line) for line in lines]


def _reversed(line):
    polar = re.fullmatch(rf"({POINT})({POINT})\s*=\s*(.*)@ (?!perp|-?[A-Z])(.*)", line)
    if polar:
        tail, head, length, angle = polar.groups()
        return f"{head}{tail} = {length}@ {angle} + 180 deg"
    return line


def wound(lines):
    """Add whole turns to directions, half turns to guides."""
    return [_turned(_turned(line, "360 deg", "along"), "180 deg", "slider") for line in lines]


def turned_by_a_number(lines):
    return [_turned(line, "27 deg", "") for line in lines]


def turned_by_a_symbol(lines):
    return [lines[0], "param turn = 40 deg", *(_turned(line, "turn", "") for line in lines[1:])]


def _turned(line, by, where):
    """Add an angle to every direction of a line that is an angle of its own."""
    direction = re.fullmatch(r"(.*(?:@|along|across)) (?!perp|-?[A-Z]{2})(.*?)( times .*)?", line)
    guide = line.startswith("slider")
    meant = {"": True, "along": "along" in line and not guide, "slider": guide}[where]
    if not (direction and meant):
        return line
    head, angle, times = direction.groups()
    angle, *shared = re.split(r"(?= sharing)", angle)
    return f"{head} {AXES.get(angle, angle)} + {by}{''.join(shared)}{times or ''}"


EVERYWHERE = [shuffled, reordered, reversed_vectors, wound]
BY_AN_AXIS = {"class_four_block"}
"""A rod at 15 degrees and a load along y: turned, they are two lines at 75 degrees."""

TURNED = [turned_by_a_number, turned_by_a_symbol]


@pytest.mark.parametrize("rewritten", EVERYWHERE, ids=lambda f: f.__name__)
@pytest.mark.parametrize("name", in_thirds(NAMES))
def test_the_formula_does_not_depend_on_how_it_is_written(name, rewritten):
    lines = source(name)
    if rewritten(lines) == lines:
        pytest.skip("nothing to rewrite")
    if name in TOO_LONG:
        found, filed = results(rewritten(lines)), results(lines)
        assert all(equal(found[n].formula, filed[n].formula) for n in filed)
        return
    found, expected = formulas(rewritten(lines)), as_filed(name)
    same = [n for n in found if rewritten is not wound or n == "k"]  # a guide has a sense
    assert {n: found[n] for n in same} == {n: expected[n] for n in same}


@pytest.mark.parametrize("rewritten", TURNED, ids=lambda f: f.__name__)
@pytest.mark.parametrize(
    "name", in_thirds(n for n in NAMES if not any("(" in line for line in source(n)))
)
def test_turning_the_drawing_leaves_the_formula(name, rewritten):
    if name in BY_AN_AXIS:
        found, filed = results(rewritten(source(name))), results(source(name))
        assert all(equal(found[n].formula, filed[n].formula) for n in filed)
        return
    assert formulas(rewritten(source(name))) == as_filed(name)
