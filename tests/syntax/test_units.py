"""Units are exact, told from the words of the language, and kept as they were written."""

from fractions import Fraction

import pytest

from mechc import units
from mechc.diagnostics import Report
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.notation import read
from mechc.syntax.parser.unit_words import SPELLED
from mechc.syntax.settings import params, parse
from mechc.syntax.to_dsl import to_dsl
from mechc.syntax.to_yaml import to_yaml
from mechc.units import (
    COMPOUNDS,
    FORCE,
    FREQUENCY,
    LENGTH,
    PRESSURE,
    TORQUE,
    UNITS,
    VELOCITY,
    Dimension,
    compound,
)


def param(value: str) -> ast.Param:
    source = Source("u.mech", f"param a = {value}\n")
    report = Report(source)
    (found,) = params(read(source, report).statements)
    assert not report.diagnostics, [(d.message, d.hint) for d in report.diagnostics]
    return found


@pytest.mark.parametrize(
    ("unit", "factor", "dimension"),
    [
        ("in", "0.0254", LENGTH),
        ("ft", "0.3048", LENGTH),
        ("yd", "0.9144", LENGTH),
        ("lbf", "4.4482216152605", FORCE),
        ("lbf*ft", "1.3558179483314004", TORQUE),
        ("in*lbf", "0.1129848290276167", TORQUE),
        ("mph", "0.44704", VELOCITY),
        ("km/h", "5/18", VELOCITY),
        ("kgf/cm^2", "98066.5", PRESSURE),
        ("rev/min", "1/30", FREQUENCY),
        ("l/min", "1/60000", Dimension(3, 0, -1)),
    ],
)
def test_a_unit_is_what_its_definition_says(unit, factor, dimension):
    assert UNITS[unit].factor == Fraction(factor)
    assert UNITS[unit].dimension == dimension


def test_a_pound_per_square_inch_is_a_pound_of_force_on_one():
    assert UNITS["psi"] == UNITS["lbf/in^2"]
    assert UNITS["psi"].size == pytest.approx(6894.757293168361, rel=1e-15)
    assert UNITS["rpm"] == UNITS["rev/min"]


def test_units_of_angles_keep_pi_apart():
    assert {u for u in UNITS if UNITS[u].pi} == {
        *("deg", "°", "rev", "rpm", "deg/s", "°/s", "rev/s", "rev/min"),
    }


def test_every_spelling_leads_to_a_unit_and_is_none_itself():
    assert set(SPELLED.values()) <= UNITS.keys()
    assert not SPELLED.keys() & {unit.lower() for unit in UNITS}


@pytest.mark.parametrize(
    ("line", "value", "ends"),
    [
        ("8 in", "8 in", None),
        ("8 in in 7 in .. 9 in", "8 in", ("7 in", "9 in")),
        ("8 in - 2 in in 1 in .. 9 in", "8 in - 2 in", ("1 in", "9 in")),
        ('8" in 7" .. 9"', '8"', ('7"', '9"')),
        ("5 in 1 .. 7", "5", ("1", "7")),
        ("-1 in -2 .. 7", "-1", ("-2", "7")),
        ("5 in (1 + 1) .. 7", "5", ("1 + 1", "7")),
        ("200 mm in 8 in .. 9 in", "200 mm", ("8 in", "9 in")),
        ("12° in 2 ° .. 40°", "12°", ("2°", "40°")),
        ("5 \u00b5m in 2 \u03bcm .. 9 um", "5 \u00b5m", ("2 \u03bcm", "9 um")),
        ("2 in*c", "2 in * c", None),
        ("2 in^2", "2 in^2", None),
    ],
)
def test_inches_are_not_the_word_of_a_range(line, value, ends):
    found = param(line)
    behind = f" in {' .. '.join(ends)}" if ends else ""
    assert to_dsl(ast.File((found,), ())) == f"param a = {value}{behind}\n"


@pytest.mark.parametrize("unit", UNITS)
def test_both_notations_and_the_command_line_keep_a_unit(unit):
    found = param(f"2.5{unit}" if unit == '"' else f"2.5 {unit}")
    tree = ast.File((found,), ())
    for text, name in ((to_dsl(tree), "u.mech"), (to_yaml(tree), "u.yaml")):
        source = Source(name, text)
        assert params(read(source, Report(source)).statements)[0].value == found.value
    _, (value, _) = parse(f"a=2.5 {unit}" if unit.startswith("1/") else f"a=2.5{unit}")
    assert isinstance(value, ast.Number)
    assert (value.digits, value.unit) == ("2.5", unit)


def test_a_compound_is_made_of_simple_ones():
    assert not set(COMPOUNDS.split()) & {unit for unit in UNITS if unit.isalpha()}
    assert "h" not in UNITS


def test_units_made_of_others_are_found_when_they_are_asked_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A description has a few of the hundred, and all of them took a hundredth of a compilation."""
    asked: list[str] = []
    monkeypatch.setattr(units, "compound", lambda s: asked.append(s) or compound(s))
    table = units.UnitTable({"m": UNITS["m"]}, ("m", "m/s", "m^2"))
    assert (list(table), len(table), "m/s" in table) == (["m", "m/s", "m^2"], 3, True)
    assert not asked
    assert [table["m/s"], table["m/s"]] == [UNITS["m/s"]] * 2
    assert asked == ["m/s"]
    assert table.get("s") is None


def test_joule_and_hertz_are_what_they_are_made_of() -> None:
    assert (UNITS["J"], UNITS["Hz"]) == (compound("N*m"), compound("1/s"))
