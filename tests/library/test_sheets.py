"""Every calculation sheet of the library: its text, its references, its checks, its code."""

from functools import cache

import pytest

from mechc.compilation import Compilation, compile_source, emit
from mechc.diagnostics import Report
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.files import library, mechanisms, read
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.notation import read as parse
from mechc.syntax.to_dsl import to_dsl
from mechc.syntax.to_yaml import to_yaml

NAMES = sorted(library().keys() - mechanisms().keys())

every_sheet = pytest.mark.parametrize("name", NAMES)


@cache
def compiled(name: str) -> Compilation:
    return compile_source(read(library()[name]))


def tree_of(source: Source) -> ast.File:
    return parse(source, Report(source))


@every_sheet
def test_heading_and_source(name: str) -> None:
    sheet = compiled(name).mechanism
    assert sheet.name == name
    assert sheet.title
    assert sheet.source


@every_sheet
def test_every_line_has_its_text(name: str) -> None:
    """A person reads in the note what each parameter and formula is."""
    lines = library()[name].read_text("utf-8").splitlines()
    said = [line for line in lines if line.startswith(("param ", "let "))]
    assert [line for line in said if "  # " not in line and ' as "' not in line] == []


@every_sheet
def test_is_laid_out_as_fmt_does_and_reads_as_yaml(name: str) -> None:
    source = compiled(name).source
    tree = tree_of(source)
    assert to_dsl(tree) == source.text
    yaml = to_yaml(tree)
    assert to_dsl(tree_of(Source("a.yaml", yaml))) == source.text


@every_sheet
def test_references_hold_and_checks_pass(name: str) -> None:
    compilation = compiled(name)
    outcomes = {finding.outcome for finding in compilation.findings}
    assert outcomes
    assert outcomes <= {"proved", "agrees"}
    assert not compilation.report.diagnostics


@every_sheet
def test_every_target_takes_it(name: str) -> None:
    for target in ("python", "c", "latex", "json"):
        assert emit(compiled(name), registry.load(target), Options(name))
