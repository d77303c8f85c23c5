"""Laws of the two notations: what is printed is read back, and printing is settled at once."""

import pytest
import yaml
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from mechc.base.frozen import fields
from mechc.diagnostics import Report
from mechc.source import Source
from mechc.syntax import from_dsl, from_yaml
from mechc.syntax.to_dsl import to_dsl
from mechc.syntax.to_yaml import in_yaml_order, to_yaml
from strategies import files

# Shrinking a whole file takes minutes: the failing one is printed as it was drawn.
some = settings(
    max_examples=30,
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.generate],
)


def read(parser, text, name):
    source = Source(name, text)
    report = Report(source)
    tree = parser.parse(source, report)
    assert not report.diagnostics, (text, report.diagnostics)
    return tree


@some
@given(files())
def test_the_line_notation_gives_the_tree_back(tree):
    printed = to_dsl(tree)
    again = read(from_dsl, printed, "a.mech")
    assert again == tree
    assert to_dsl(again) == printed


@some
@given(files())
def test_yaml_gives_the_tree_back_in_its_own_order(tree):
    printed = to_yaml(tree)
    again = read(from_yaml, printed, "a.yaml")
    assert again == in_yaml_order(tree)
    assert to_yaml(again) == printed


@some
@given(files())
def test_yaml_has_one_order(tree):
    ordered = in_yaml_order(tree)
    assert in_yaml_order(ordered) == ordered
    assert sorted(map(str, ordered.statements)) == sorted(map(str, tree.statements))


def spans(node):
    """Yield the spans of a node and of all that is in it."""
    if isinstance(node, tuple):
        for part in node:
            yield from spans(part)
    elif fields(node):
        yield node.span
        for field in fields(node):
            if field.name != "span":
                yield from spans(getattr(node, field.name))


@some
@given(files(), st.sampled_from([(from_dsl, to_dsl), (from_yaml, to_yaml)]))
def test_every_node_has_its_place(tree, notation):
    parser, printer = notation
    printed = printer(tree)
    again = read(parser, printed, "a")
    for statement in again.statements:
        for span in spans(statement):
            assert 0 <= span.start < span.end <= len(printed)


@pytest.mark.parametrize(
    ("written", "printed"),
    [
        ("(a + b) - (c - d)", "a + b - (c - d)"),
        ("a/(b*c)", "a/(b*c)"),
        ("(a/b)*c", "a/b*c"),
        ("-(a*b)", "-a*b"),
        ("(-a)*b", "(-a)*b"),
        ("-a^2", "-a^2"),
        ("(-a)^2", "(-a)^2"),
        ("2^(3^4)", "2^3^4"),
        ("(2^3)^4", "(2^3)^4"),
        ("a^(-2)", "a^-2"),
        ("(5 N)*m", "5 N * m"),
        ("5 N*m", "5 N*m"),
        ("(5 mm)^2", "(5 mm)^2"),
        ("40mm", "40 mm"),
        ("tg(x)+ctg(x)", "tan(x) + cot(x)"),
        ("a - -b", "a - (-b)"),
        ("a*-b", "a*(-b)"),
    ],
)
def test_brackets_only_where_they_are_needed(written, printed):
    tree = read(from_dsl, f"let k = {written}", "a.mech")
    assert to_dsl(tree) == f"let k = {printed}\n"


WORDS_OF_YAML = ["null", "Null", "NULL", "true", "false", "yes", "no", "off", "y", "n", "NO", "e1"]


@pytest.mark.parametrize("name", WORDS_OF_YAML)
def test_a_name_that_yaml_gives_a_meaning(name):
    text = f"param {name} = 2\nlet z = {name}\nlet {name}_1 = z\nfind {name}_2 = {name}_1/z\n"
    tree = read(from_dsl, f'mechanism {name} "a\tb"\n{text}', "a.mech")
    printed = to_yaml(tree)
    assert read(from_yaml, printed, "a.yaml") == in_yaml_order(tree)
    assert read(from_dsl, to_dsl(tree), "a.mech") == tree
    keys = yaml.safe_load(printed)["params"]
    assert name in "yn" or list(keys) == [name]


def test_a_product_behind_a_unit_in_an_exponent_keeps_apart():
    text = "let a = b^2 N * m^-3 kN * c\n"
    assert to_dsl(read(from_dsl, text, "a.mech")) == text


def test_a_question_mark_in_a_flow_mapping_is_quoted():
    tree = read(from_dsl, 'param a = 2 mm in 1 mm .. 3 mm about "what?why"\n', "a.mech")
    assert "'what?why'" in to_yaml(tree)
    read(from_yaml, to_yaml(tree), "a.yaml")


@pytest.mark.parametrize("word", ["drive", "slot", "at", "mirror", "mechanism", "sheet"])
def test_a_description_may_be_called_by_a_word_of_the_language(word):
    """No line refers to its name, so none can be read two ways."""
    for heading in ("mechanism", "sheet"):
        tree = read(from_dsl, f'{heading} {word} "T"\n', "a.mech")
        assert tree.statements[0].name.text == word
        assert read(from_dsl, to_dsl(tree), "a.mech") == tree
        assert read(from_yaml, to_yaml(tree), "a.yaml") == tree


def test_a_divisor_with_a_unit_keeps_its_brackets():
    """Without them `F/5 kN` reads as if the result were in kN (W293)."""
    printed = to_dsl(read(from_dsl, "sheet a\nparam F = 12 kN\nlet n = F/(5 kN)\n", "a.mech"))
    assert "let n = F/(5 kN)" in printed
