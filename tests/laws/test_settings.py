"""A value from outside gives what the code gives for it, also where the mechanism is drawn."""

import math
from random import Random

import numpy as np
import pytest

import mechc
from mechc.base.frozen import replace
from mechc.compilation import compile_source
from mechc.diagnostics import MechcError
from mechc.files import library, read
from mechc.formula.evaluate import evaluate
from mechc.model.mechanism import Parameter
from mechc.report.text.derivation import render
from mechc.source import Source
from mechc.syntax.settings import parse
from mechc.units import si_unit
from small_mechanisms import drawn_four_bar

PRESS = """
mechanism press
param r = 60 mm in 40 mm .. 80 mm
param phi = 60 deg in 20 deg .. 100 deg
pivot S at (0 mm, 0 mm)
slider K along y
link SA
link AB
link OB
link BK
pivot O at (300 mm, -150 mm)
SA = r @ phi
B at (40 mm, -310 mm)
K at (0 mm, -610 mm)
drive phi from 20 deg to 100 deg
torque M on SA
let F = 40 kN
force F at K along y
find k = M/F
"""

DRAWN_DRIVE = drawn_four_bar("drive OA from -40 deg to 80 deg", "torque T on CB", "find k = M/T")


def assert_set_as_evaluated(source: Source, name: str, value: float, unit: str) -> None:
    plain = mechc.loads(source.text, source.name)
    wanted = plain.evaluate(**{name: value})
    found = compile_source(source, dict([parse(f"{name} = {value!r} {unit}")]))
    for result in found.results:
        if result.default is not None:
            there = wanted[result.name]
            np.testing.assert_allclose(
                result.default, there, rtol=1e-9, atol=1e-12, err_msg=result.name
            )


@pytest.mark.parametrize(
    ("text", "name", "value", "unit"),
    [
        (PRESS, "phi", math.radians(80), "rad"),
        (PRESS, "phi", math.radians(25), "rad"),
        (PRESS, "r", 0.066, "m"),
        (DRAWN_DRIVE, "phi_OA", math.radians(-20), "rad"),
    ],
)
def test_what_is_drawn_is_moved_and_not_drawn_again(
    text: str, name: str, value: float, unit: str
) -> None:
    assert_set_as_evaluated(Source("drawn.mech", text), name, value, unit)


def test_where_the_drawing_is_no_remark_on_a_value_from_outside() -> None:
    found = compile_source(Source("press.mech", PRESS), dict([parse("phi = 80 deg")]))
    assert "W320" not in {d.code for d in found.report.diagnostics}


def test_a_value_from_outside_at_which_a_loop_does_not_close_is_an_error_at_its_place() -> None:
    text = PRESS.replace("in 40 mm .. 80 mm", "").replace("in 20 deg .. 100 deg", "")
    with pytest.raises(MechcError) as raised:
        compile_source(Source("press.mech", text), dict([parse("r = 700 mm")]))
    (fault,) = raised.value.diagnostics
    assert fault.code == "E340"


LINES = sorted(name for name, path in library().items() if path.suffix == ".mech")


@pytest.mark.slow
@pytest.mark.parametrize("name", LINES[1::2])
def test_so_it_is_throughout_the_library(name: str) -> None:
    """What a book says of other values is left out."""
    source, draw = read(library()[name]), Random(name)
    lines = [s for s in source.text.splitlines() if not s.startswith(("expect ", "require "))]
    source = replace(source, text="\n".join(lines) + "\n")
    found = compile_source(source)
    used = {i.name for function in found.routine.functions for i in function.inputs}
    given = [p for p in found.mechanism.parameters if _is_free(p) and p.name in used]
    for parameter in draw.sample(given, min(1, len(given))):
        assert parameter.value
        value = _near(evaluate(parameter.value, {}), parameter, draw)
        there = mechc.loads(source.text, source.name).evaluate(**{parameter.name: value})
        if all(map(math.isfinite, there.values())):
            unit = si_unit(parameter.dimension)
            assert_set_as_evaluated(source, parameter.name, value, unit)


def _is_free(parameter: Parameter) -> bool:
    return bool(parameter.value) and not parameter.dependent and parameter.tolerance is None


def _near(value: float, parameter: Parameter, draw: Random) -> float:
    """Return a value 1 % away, within the range."""
    moved = value * (1 + draw.choice([-0.01, 0.01]))
    if parameter.range is None:
        return moved
    low, high = (evaluate(end, {}) for end in parameter.range)
    return min(max(moved, low), high)


def test_a_value_from_outside_beyond_the_stroke_is_remarked_on() -> None:
    text = PRESS.replace("param phi = 60 deg in 20 deg .. 100 deg", "param phi = 60 deg")
    for value, warned in (("130 deg", True), ("90 deg", False)):
        found = compile_source(Source("press.mech", text), dict([parse(f"phi = {value}")]))
        assert ("W222" in {d.code for d in found.report.diagnostics}) == warned


def test_a_page_has_the_value_from_outside_in_what_is_given_and_in_numbers() -> None:
    found = compile_source(Source("press.mech", PRESS), dict([parse("phi = 80 deg")]))
    page = render(found.derivation, found.mechanism, width=200)
    assert "φ = 80°" in page
    assert "cos 80°" in page
    assert "60°" not in page.partition("range")[0]
