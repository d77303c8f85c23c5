"""Names that a scope gives to numbers: one for each kind and value, none for a zero."""

from mechc.diagnostics import Report
from mechc.formula.tree import ZERO, Symbol, number
from mechc.model.names.points import PointTable
from mechc.model.names.scope import NameScope
from mechc.source import Source, Span
from mechc.units import LENGTH

HERE = Span(0, 0)


def scope():
    report = Report(Source("a.mech", ""))
    return NameScope(report, PointTable(report))


def test_a_number_has_one_name_for_each_kind_and_value():
    names = scope()
    first = names.named("d", "A", number(3), LENGTH, HERE)
    assert first == names.named("d", "B", number(3), LENGTH, HERE)
    assert first.name == "d_A"
    assert names.named("d", "A", number(4), LENGTH, HERE).name == "d_A_2"
    assert names.named("r", "", number(3), LENGTH, HERE).name == "r"


def test_a_zero_and_what_has_a_name_get_none():
    names = scope()
    assert names.named("d", "A", ZERO, LENGTH, HERE) == ZERO
    assert names.named("d", "A", Symbol("a"), LENGTH, HERE) == Symbol("a")
    assert names.constants == {}
