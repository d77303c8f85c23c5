"""Each construct of the language means the same in both notations."""

import pytest

from mechc.base.frozen import replace
from mechc.diagnostics import Report
from mechc.source import Source, Span
from mechc.syntax import ast, from_dsl, from_yaml
from mechc.syntax.examples import WRITTEN
from mechc.syntax.notation import read
from mechc.syntax.parser.grammar import statement_words
from notations import CONSTRUCTS, WHOLE_MECH, WHOLE_YAML


def tree(text, name="a.mech"):
    source = Source(name, text)
    report = Report(source)
    found = read(source, report)
    assert not report.diagnostics, report.diagnostics
    return found


def bare(file):
    return [replace(node, comments=(), remark="") for node in file.statements]


@pytest.mark.parametrize(("line", "entry"), CONSTRUCTS)
def test_both_notations_give_one_tree(line, entry):
    assert tree(line) == tree(entry, "a.yaml")


def test_every_statement_word_is_among_them():
    words = {line.split()[0] for text, _ in CONSTRUCTS for line in text.splitlines()}
    assert set(statement_words()) <= words


@pytest.mark.parametrize("line", WRITTEN.values())
def test_hints_show_how_a_statement_is_written(line):
    assert len(tree(line).statements) == 1


def test_every_statement_word_has_an_example():
    assert set(statement_words()) == {name.split()[0] for name in WRITTEN}


def test_every_node_is_among_them():
    found = {type(node).__name__ for text, _ in CONSTRUCTS for node in tree(text).statements}
    assert found | {"Given", "Follows", "Taken", "Brought"} == {
        node.__name__ for node in kinds(ast.Statement)
    }


def kinds(node):
    """Return the kinds of a node, and the kinds of those."""
    return {inner for kind in node.__subclasses__() for inner in (kind, *kinds(kind))}


def test_the_whole_file_is_the_same_in_both():
    left, right = bare(tree(WHOLE_MECH)), bare(tree(WHOLE_YAML, "a.yaml"))
    assert len(left) == len(right)
    assert all(node in right for node in left)


@pytest.mark.parametrize(
    ("said", "short"),
    [
        ("rack A on O radius 25 mm", "rack A on O 25 mm"),
        ("rack A on O radius (a + b)/2", "rack A on O (a + b)/2"),
        ("rack A on O radius radius", "rack A on O radius"),
        ("gear O1 radius r, O2 radius 2*radius on OS", "gear O1 r, O2 2*radius on OS"),
        ("belt O1 radius - r, O2 radius r crossed", "belt O1 radius - r, O2 r crossed"),
    ],
)
def test_a_wheel_may_say_that_its_size_is_a_radius(said, short):
    assert tree(said) == tree(short)


def test_a_wheel_of_yaml_may_say_that_its_size_is_a_radius():
    said, short = "gears: [{O1: radius 5 mm, O2: radius}]", "gears: [{O1: 5 mm, O2: radius}]"
    assert tree(said, "a.yaml") == tree(short, "a.yaml")


def test_comments_stay_with_their_statements():
    found = tree("# head\n\nparam a = 1 # first\n# above\npivot O\n# end\n")
    param, pivot = found.statements
    assert (param.comments, param.remark) == (("head",), "first")
    assert (pivot.comments, pivot.remark) == (("above",), "")
    assert found.trailing == ("end",)


def test_comments_of_yaml_stay_with_their_statements():
    text = (
        "# head\nparams:  # lengths\n  a: '#1'  # first\n  # above\n"
        "  b:\n    value: 2 # in\npivots: [O, C]  # both\n# end\n"
    )
    text = text.replace("'#1'", "{value: 1, label: '#1'}")
    found = tree(text, "a.yaml")
    a, b, o, c = found.statements
    assert (a.comments, a.remark, a.label) == (("head", "lengths"), "first", "#1")
    assert (b.comments, b.remark) == (("above",), "in")
    assert (o.remark, c.remark) == ("", "both")
    assert found.trailing == ("end",)


def test_a_comment_on_a_line_inside_a_statement_of_yaml_stands_above_it():
    found = tree("params:\n  a: 1\n  b:\n    # how wide\n    value: 2\n  c: 3\n", "a.yaml")
    assert [one.comments for one in found.statements] == [(), ("how wide",), ()]


def test_a_statement_goes_on_in_brackets_and_behind_operators():
    assert tree("let k = (a +\n b) *\n c") == tree("let k = (a + b)*c")


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("let k = alpha - 90 degg\n", "a.mech"),
        ("let: {k: alpha - 90 degg}", "a.yaml"),
        ("let:\n  k: 'alpha - 90 degg'", "a.yaml"),
        ('let:\n  k: "alpha\\x20- 90 degg"', "a.yaml"),
        ("let:\n  k: >\n    alpha\n    - 90 degg\n", "a.yaml"),
        ("let:\n  k: |\n    alpha - 90 degg\n", "a.yaml"),
        ("let:\n  k: alpha\n    - 90\n    degg\n", "a.yaml"),
    ],
)
def test_an_error_inside_a_scalar_has_its_place(text, name):
    source = Source(name, text)
    report = Report(source)
    read(source, report)
    (found,) = report.diagnostics
    assert found.code == "E103"
    assert text[found.span.start : found.span.end] == "degg"


def test_several_errors_in_one_run():
    text = "pivott O\nparam a 40 mm\nlet k = 2*(a\nlink OA\nfind P ? F\n"
    source = Source("a.mech", text)
    report = Report(source)
    found = from_dsl.parse(source, report)
    assert [d.code for d in report.sorted()] == ["E102", "E109", "E107", "E112"]
    assert [type(node) for node in found.statements] == [ast.Link]


def test_several_errors_in_one_run_of_yaml():
    source = Source("a.yaml", "params: {a: 1 +, b: 2}\nlinks: [oa, OB]\nforce: {}\n")
    report = Report(source)
    found = from_yaml.parse(source, report)
    assert [d.code for d in report.sorted()] == ["E108", "E110", "E125"]
    assert [type(node) for node in found.statements] == [ast.Param, ast.Link]


def test_a_sum_is_one_flat_node():
    (node,) = tree("let k = " + " + ".join(["a"] * 5000)).statements
    assert isinstance(node, ast.Let)
    assert isinstance(node.value, ast.Sum)
    assert len(node.value.terms) == 5000


def test_a_direction_comes_before_a_parameter_of_its_name():
    (node,) = tree("slider A along -x").statements
    assert node == ast.Slider(Span(0, 0), ast.Name("A", Span(0, 0)), ast.Axis("x", -1, Span(0, 0)))


def test_json_is_yaml():
    assert tree('{"pivots": ["O"]}', "a.json") == tree("pivot O")
    assert tree('{"pivots": ["O"]}', "<stdin>") == tree("pivot O", "<stdin>")
