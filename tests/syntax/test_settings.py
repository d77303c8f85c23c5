"""Parameters from the command line are read with the language's own grammar."""

import pytest

from mechc.compilation import Compilation
from mechc.diagnostics import Diagnostic, MechcError, Report
from mechc.diagnostics.render import render
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.settings import attached, parse, with_settings
from mechc.syntax.to_dsl import to_dsl


def applied(text: str, *settings: str) -> str:
    given = dict(map(parse, settings))
    source = attached(Source("m.mech", text), given)
    return to_dsl(with_settings(read(source, Report(source)), given, source))


@pytest.mark.parametrize(
    ("setting", "value"),
    [
        ("a=30mm", "30 mm"),
        ("a = 0.5 m", "0.5 m"),
        ("a=1e-3m", "1e-3 m"),
        ("a=-5mm", "-5 mm"),
        ("a=2*b", "2*b"),
        ("a=.5N/mm", ".5 N/mm"),
        ("a=sin(30deg)", "sin(30 deg)"),
    ],
)
def test_setting_replaces_the_value(setting: str, value: str) -> None:
    assert applied("param a = 10 mm\n", setting) == f"param a: length = {value}\n"


def test_range_label_and_other_parameters_stay() -> None:
    text = 'param a = 10 mm in 1 mm .. 50 mm as "arm"\nparam b = 2 mm\n'
    first, second = applied(text, "a=20mm").splitlines()
    assert first == 'param a: length = 20 mm in 1 mm .. 50 mm as "arm"'
    assert second.split() == ["param", "b", "=", "2", "mm"]


def test_messages_point_at_the_setting() -> None:
    given = dict(map(parse, ["b=30mm", "a = 1 + b"]))
    source = attached(Source("m.mech", "param b = 1 mm\nparam a = 10 mm\n"), given)
    tree = with_settings(read(source, Report(source)), given, source)
    first, second = (s.value for s in tree.statements)  # type: ignore[attr-defined]
    assert source.written(first.span) == "30 mm"
    assert source.written(second.terms[1][1].span) == "b"
    warning = Diagnostic("W999", "example", first.span, "it is long")
    assert render(warning, source, "concise") == "-D:1:5: warning[W999]: it is long"
    assert render(warning, source).splitlines()[1:] == ["  1 | b = 30 mm", "    |     ^^^^^"]
    assert '"file": "-D"' in render(warning, source, "json")


@pytest.mark.parametrize("behind", ["+- 1 mm", "+- 0.5 mm"])
def test_only_a_value_is_set(behind: str) -> None:
    assert parse("a = 2 mm")[0] == "a"
    with pytest.raises(MechcError):
        parse(f"a = 2 mm {behind}")


@pytest.mark.parametrize("setting", ["a=", "a=)", "a=1 mm\nforce P at A along x", "a b=1", "=1"])
def test_what_is_no_value_is_refused(setting: str) -> None:
    with pytest.raises(MechcError):
        parse(setting)


@pytest.mark.parametrize(
    ("setting", "code", "used"),
    [("l=-1mm", "E245", 4), ("r=0mm", "E294", 6), ("m=-2kg", "E235", 7)],
)
def test_a_wrong_value_is_shown_at_the_setting_it_comes_from(setting, code, used):
    text = """param l = 90 mm
param r = 20 mm
param m = 2 kg
OA = l @ 40 deg
QB = 40 mm @ 50 deg
gear O r, Q 20 mm
weight W mass m at A
pivot O at (0 mm, 0 mm)
pivot Q at (50 mm, 0 mm)
link OA
link QB
torque M on QB
find k = M/W"""
    name, value = parse(setting)
    compilation = Compilation(Source("m.mech", text), {name: value})
    with pytest.raises(MechcError) as raised:
        assert compilation.balance
    (found,) = raised.value.diagnostics
    source = raised.value.source
    assert (found.code, source.part(found.span)[0].name) == (code, "-D")
    (related,) = found.related
    assert source.position(related.span.start).line == used


@pytest.mark.parametrize(
    ("setting", "code"), [("a=100m", "W247"), ("phi=400deg", "W245"), ("phi=2*phi", "E208")]
)
def test_a_doubted_value_is_shown_at_the_setting(setting, code):
    text = """param a = 40 mm
param b = 60 mm
param phi = 30 deg
pivot O
link OAB
OA = a @ phi
OB = b @ phi + 20 deg
force P at A along x
force F at B along y
find k = P/F"""
    name, value = parse(setting)
    compilation = Compilation(Source("m.mech", text), {name: value})
    try:
        said = compilation.balance and compilation.report.diagnostics
    except MechcError as error:
        said = list(error.diagnostics)
    (place,) = (d.span for d in said if d.code == code)
    assert place is not None
    assert place.start > len(text)


@pytest.mark.parametrize("behind", ["+- 1 mm", "+- 0.5 mm"])
def test_what_stands_behind_a_value_is_quoted(behind):
    with pytest.raises(MechcError) as caught:
        parse(f"a=30mm {behind}")
    (found,) = caught.value.diagnostics
    assert f"'{behind}'" in found.message
    assert found.span.end - found.span.start == len(f" {behind}")
