"""Targets by name and suffix; those of other packages; templates and their contexts."""

import subprocess
import sys
from importlib.metadata import EntryPoint

import pytest
from hypothesis import given
from hypothesis import strategies as st
from jinja2 import meta, nodes

from mechc.diagnostics import MechcError, Report
from mechc.emit import registry
from mechc.emit.c import reserved, to_c
from mechc.emit.make_templates import EMIT, MADE, TARGETS, environment, written
from mechc.emit.names import TargetNames, mangle, transliterate
from mechc.emit.python import to_python
from mechc.source import Source

STRANGERS = [
    EntryPoint("gone", "no.such.module:TARGET", registry.GROUP),
    EntryPoint("hollow", "math:pi", registry.GROUP),
    EntryPoint("python", "math:pi", registry.GROUP),
    EntryPoint("second", "mechc.emit.c.to_c:TARGET", registry.GROUP),
]


@pytest.fixture
def strangers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "entry_points", lambda group: STRANGERS)


def test_targets_by_name_and_by_suffix() -> None:
    assert registry.names()[:4] == ("latex", "python", "c", "json")
    assert registry.load("c") is to_c.TARGET
    assert {s: registry.by_suffix(s) for s in (".c", ".h", ".py", ".xyz")} == {
        ".c": "c", ".h": "c", ".py": "python", ".xyz": None,
    }  # fmt: skip
    with pytest.raises(LookupError):
        registry.load("fortran")


def test_each_target_says_its_own_name_and_suffixes() -> None:
    for name, place in registry.BUILT_IN.items():
        target = registry.load(name)
        assert (target.name, target.suffixes) == (name, place.suffixes)


@pytest.mark.usefixtures("strangers")
def test_a_broken_target_of_another_package_is_a_diagnostic() -> None:
    report = Report(Source("x", ""))
    assert list(registry.targets(report)) == ["latex", "python", "c", "json", "second"]
    assert [(d.code, d.message) for d in report.sorted()] == [
        (
            "W701",
            "the target 'gone' (no.such.module:TARGET) is left out: expected an emitter,"
            " found ModuleNotFoundError: No module named 'no'",
        ),
        (
            "W701",
            "the target 'hollow' (math:pi) is left out: expected an emitter,"
            " found an object without name, suffixes, emit",
        ),
    ]
    with pytest.raises(MechcError, match="E702: the target 'gone'"):
        registry.load("gone")


@pytest.mark.usefixtures("strangers")
def test_no_package_replaces_our_own_target() -> None:
    assert registry.load("python") is to_python.TARGET
    assert registry.load("second") is to_c.TARGET


def test_the_registry_imports_no_target_and_no_target_imports_numpy() -> None:
    code = (
        "import sys; from mechc.emit import registry; "
        "assert not [m for m in sys.modules if m.startswith('mechc.emit.to_')], 'eager'; "
        "[registry.load(n) for n in ('python', 'c', 'json')]; import mechc.routine.from_results; "
        "assert not {'numpy', 'sympy'} & set(sys.modules), 'heavy'"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("template", "context"),
    [
        ("python/module.jinja", to_python.ModuleContext),
        ("c/header.jinja", to_c.HeaderContext),
        ("c/source.jinja", to_c.SourceContext),
        ("c/functions.jinja", to_c.CodeContext),
    ],
)
def test_a_template_mentions_exactly_its_context(
    template: str, context: type[to_c.SourceContext]
) -> None:
    assert mentioned(template) == set(context._fields)


def mentioned(template: str) -> set[str]:
    """Return the variables of a template and of those that it includes, its loops' own apart."""
    reader = environment(template.partition("/")[0])
    tree = reader.parse((EMIT / template).read_text(encoding="utf-8"))
    includes = [node.template for node in tree.find_all(nodes.Include)]
    included = [str(node.as_const()) for node in includes if isinstance(node, nodes.Const)]
    loops = {name.name for loop in tree.find_all(nodes.For) for name in _targets(loop)}
    inner = set[str]().union(*map(mentioned, included)) - loops
    return meta.find_undeclared_variables(tree) | inner


@pytest.mark.parametrize("target", TARGETS)
def test_the_functions_are_those_of_the_templates(target: str) -> None:
    """``python -m mechc.emit.make_templates`` writes them anew."""
    assert (EMIT / target / MADE).read_text("utf-8") == written(target)


def _targets(loop: nodes.For) -> list[nodes.Name]:
    return [loop.target] if isinstance(loop.target, nodes.Name) else []


def test_a_name_that_needs_no_change_keeps_it() -> None:
    assert mangle(["β", "beta", "class", "class_"], TargetNames({"class"})) == {
        "β": "beta_2", "beta": "beta", "class": "class_2", "class_": "class_",
    }  # fmt: skip


@given(st.lists(st.text("aαAΑ_'1βbжЖé²x", min_size=1, max_size=5), unique=True, max_size=12))
def test_no_two_names_become_one(names: list[str]) -> None:
    found = mangle(names, TargetNames(reserved.RESERVED))
    assert len(set(found.values())) == len(names)
    assert all(n.isidentifier() and n.isascii() and "__" not in n for n in found.values())
    assert not any(name in reserved.RESERVED for name in found.values())
    assert mangle(names, TargetNames(reserved.RESERVED)) == found


@given(st.text(min_size=1, max_size=20))
def test_any_text_becomes_an_identifier(name: str) -> None:
    assert transliterate(name).isidentifier()
    assert transliterate(name).isascii()
