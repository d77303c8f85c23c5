"""The printer of ``mechc show``: hand-built values of every stage, and what holds of any value."""

from fractions import Fraction
from types import MappingProxyType

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechc.algebra.angle import Angle
from mechc.algebra.product import ONE, Product
from mechc.base.frozen import field, frozen
from mechc.cli.dump import DUMP_COLUMNS, dump
from mechc.figure import figure
from mechc.formula.tree import Symbol, degrees, number, product
from mechc.kinematics.graph import Flow, Relation, Rule, SpeedKind, UnknownSpeed
from mechc.kinematics.plan import Binding, Block
from mechc.model import mechanism as model
from mechc.model.result import Definition
from mechc.pose.pose import Arm
from mechc.routine.steps import Function, Guard, Input, Step
from mechc.source import Span
from mechc.study.analysis import Analysis, Vanishing
from mechc.syntax import ast
from mechc.units import ANGLE, LENGTH, NUMBER

AT = Span(3, 5)

a, alpha = Symbol("a"), Symbol("alpha")
arm = Product.symbol("a")


def shown(value: object, stage: str = "stage") -> list[str]:
    return dump(stage, value).splitlines()


@pytest.mark.parametrize(
    ("value", "line"),
    [
        (
            ast.Slider(
                point=ast.Name("K", AT),
                along=ast.Sum(((-1, ast.Number("90", "deg", AT)),), AT),
                span=AT,
            ),
            "Slider(point=K, along=-90 deg)",
        ),
        (
            model.Parameter("phi", ANGLE, AT, degrees(20), unit="deg"),
            "Parameter(name=phi, dimension=angle in rad, value=pi/9, unit=deg)",
        ),
        (
            model.Arrow("O", "A", a, model.Absolute(alpha, AT), AT),
            "Arrow(tail=O, head=A, length=a, direction=Absolute(angle=alpha))",
        ),
        (
            model.Force("P", "A'", model.AlongLine("A", "B", 1, AT), AT, times=Fraction(1, 2)),
            "Force(name=P, point=A', along=AlongLine(tail=A, head=B, quarter=1), times=1/2)",
        ),
        (
            {"A": (Arm(arm, Angle.of("alpha") - Angle.constant(90)),)},
            "A: (Arm(length=a, angle=alpha - 90 deg))",
        ),
        (
            UnknownSpeed(SpeedKind.SLIDE, "B", Angle.constant(180)),
            "UnknownSpeed(kind=slide, of=B, direction=180 deg)",
        ),
        (Flow(arm / Product(2), Angle(), 1), "Flow(size=a/2, direction=0, unknown=1)"),
        (Block((0, 1), (2,)), "Block(relations=(0, 1), unknowns=(2))"),
        (Binding("Z_1", arm), "Z_1 = a"),
        (Definition("psi", product([(number(2), 1), (alpha, 1)])), "psi = 2*alpha"),
        (
            Vanishing(alpha, ("alpha", number(0)), "other"),
            "Vanishing(factor=alpha, at=(alpha, 0), cause=other)",
        ),
        (model.Require(a, "<=", number(3), AT), "a <= 3"),
        (
            Input("a", LENGTH, "mm", 0.1, label="arm OA"),
            "Input(name=a, dimension=length in m, unit=mm, default=0.1, label=arm OA)",
        ),
        (
            figure.Pivot("O", figure.Plane(6.1e-17, -1.0)),
            "Pivot(point=O, ground=(0, -1))",
        ),
    ],
)
def test_a_short_value_of_a_stage_stands_on_one_line(value: object, line: str) -> None:
    assert shown(value) == [line]


def test_a_relation_of_velocities_has_a_line_for_each_of_its_parts() -> None:
    form = {0: arm, 1: -ONE, 2: Product.symbol("length_of_the_coupler")}
    along = Angle.of("beta") + Angle.constant(90)
    assert shown(Relation(Rule.PROJECTION, "AB", ("A", "B"), along, form, AT)) == [
        "Relation",
        "  rule: projection",
        "  link: AB",
        "  points: (A, B)",
        "  along: beta + 90 deg",
        "  form: {0: a, 1: -1, 2: length_of_the_coupler}",
    ]


def test_a_function_of_a_routine_reads_as_a_program() -> None:
    steps = (Step("s1", a), Step("s2", alpha))
    guards = (Guard(a, ">", number(0)), Guard(alpha, "!=", a))
    function = Function("k", "force ratio P/F", (), guards, steps, a, a, (), NUMBER, 3)
    assert shown(function) == [
        "Function",
        "  name: k",
        "  title: force ratio P/F",
        "  guards:",
        "    a > 0",
        "    alpha != a",
        "  steps:",
        "    s1 = a",
        "    s2 = alpha",
        "  output: a",
        "  formula: a",
        "  dimension: number",
        "  operations: 3",
    ]


def test_a_long_formula_is_not_broken() -> None:
    name = "x" * DUMP_COLUMNS
    assert shown(Definition("y", Symbol(name))) == [f"y = {name}"]
    assert shown((Symbol(name), a)) == [name, "a"]


def test_tuples_and_mappings_inside_tuples_are_marked() -> None:
    long = Symbol("x" * DUMP_COLUMNS)
    assert shown({"pairs": ((a, long), {"b": long}, "c")}) == [
        "pairs:",
        "  -",
        "    a",
        f"    {long.name}",
        "  -",
        f"    b: {long.name}",
        "  c",
    ]


# --------------------------------------------------------------- of any record


@frozen
class Made:
    """A record with every kind of field that is left out."""

    name: str
    nothing: str | None
    places: MappingProxyType[str, Span]
    items: tuple[int, ...]
    usual: int = 7
    remark: str = field(default="", kw_only=True)


PLACES = MappingProxyType({"O": AT})


def test_defaults_empty_fields_and_places_are_left_out() -> None:
    assert shown(Made("x", None, PLACES, ())) == ["Made(name=x)"]
    whole = Made("x", "y", PLACES, (0,), 8, remark="z")
    assert shown(whole) == ["Made(name=x, nothing=y, items=(0), usual=8, remark=z)"]


def test_nothing_is_left_out_of_a_mapping_or_a_tuple() -> None:
    assert shown({"A": (), "B": None, "": 0.0}) == ["A: ()", "B: none", "'': 0"]
    assert shown((True, "", -0.5, float("nan"))) == ["true", "''", "-0.5", "nan"]


def test_a_set_is_printed_in_order() -> None:
    names = [f"N_{i}" for i in range(40)]
    assert shown({"inside": frozenset(names[:3])}) == ["inside: (N_0, N_1, N_2)"]
    assert shown({"inside": frozenset(names)})[1:] == [f"  {name}" for name in sorted(names)]


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("Watt's six-bar", "Watt's six-bar"),
        ("a, b", "'a, b'"),
        ("a=b", "'a=b'"),
        (" a", "' a'"),
        ("f(x)", "'f(x)'"),
        ("'a'", "\"'a'\""),
        ("a\nb", r"'a\nb'"),
        ("a\u202eb", r"'a\u202eb'"),
    ],
)
def test_text_that_could_be_read_as_something_else_is_quoted(text: str, printed: str) -> None:
    assert shown({"title": text}) == [f"title: {printed}"]


@settings(max_examples=30)
@given(*[st.lists(st.text(max_size=3), max_size=2)] * 2)
def test_different_texts_are_printed_differently(one: list[str], other: list[str]) -> None:
    same = dump("s", {"texts": tuple(one)}) == dump("s", {"texts": tuple(other)})
    assert same == (one == other)
    assert len(shown({"texts": tuple(one)})) == 1


values = st.recursive(
    st.integers() | st.sampled_from(["O", "a long remark, with a comma", "OA"]),
    lambda inner: (
        st.lists(inner, min_size=1).map(tuple)
        | st.dictionaries(st.sampled_from("ABCD"), inner, min_size=1)
        | st.builds(Step, st.sampled_from("xyz"), inner)
    ),
    max_leaves=30,
)


@given(values)
def test_lines_keep_to_the_width(value: object) -> None:
    """What is never broken is short here, so that only indentation can make a line long."""
    for line in shown(value):
        depth = len(line) - len(line.lstrip())
        assert len(line) <= max(DUMP_COLUMNS, depth + 80)


# --------------------------------------------- what was printed once is named


def points(number: int) -> tuple[model.Pivot, ...]:
    return tuple(model.Pivot(f"O{i}", AT) for i in range(number))


def test_what_an_earlier_stage_made_is_named() -> None:
    earlier = {"model": {"pivots": points(3)}}
    assert dump("pose", {"pins": points(3)}, earlier) == "pins: as in model.pivots\n"
    assert dump("pose", {"pins": points(1)}, earlier) == "pins: (Pivot(point=O0))\n"
    changed = dump("pose", {"pins": points(4)}, earlier).splitlines()
    assert changed[1:] == [f"  Pivot(point=O{i})" for i in range(4)]


def test_what_stands_twice_is_named_by_where_it_stands_first() -> None:
    result = Analysis("k", None, NUMBER, a, zeros=(Vanishing(a, None, "other"),) * 2)
    lines = shown({"results": (result,), "again": result.zeros, "once more": result.zeros}, "power")
    assert lines[-2:] == [
        "again: as in power.results.k.zeros",
        "once more: as in power.results.k.zeros",
    ]
