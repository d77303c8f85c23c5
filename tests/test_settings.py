"""Parameters from the command line are read with the language's own grammar."""

import pytest

from mechc.diagnostics import MechcError, Report
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.settings import parse, put_in
from mechc.syntax.to_dsl import to_dsl


def applied(text: str, *settings: str) -> str:
    source = Source("m.mech", text)
    return to_dsl(put_in(read(source, Report(source)), dict(map(parse, settings))))


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


def test_messages_point_at_the_declaration() -> None:
    source = Source("m.mech", "param b = 1 mm\nparam a = 10 mm\n")
    tree = put_in(read(source, Report(source)), dict([parse("a = 1 + b")]))
    value = tree.statements[1].value  # type: ignore[attr-defined]
    assert source.position(value.span.start) == (2, 11)
    assert source.position(value.terms[1][1].span.start) == (2, 11)


@pytest.mark.parametrize("setting", ["a=", "a=)", "a=1 mm\nforce P at A along x", "a b=1", "=1"])
def test_what_is_no_value_is_refused(setting: str) -> None:
    with pytest.raises(MechcError):
        parse(setting)
