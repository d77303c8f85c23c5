"""The notebook among the examples: its cells run in order, and each shows what its text says."""

import ast
import json
import math

import pytest
import sympy

from paths import EXAMPLES


def run(source, scope):
    """Run a cell; return what its last line is worth, as a notebook shows it."""
    tree = ast.parse(source)
    *before, last = tree.body
    exec(compile(ast.Module(before, []), "cell", "exec"), scope)
    if isinstance(last, ast.Expr):
        return eval(compile(ast.Expression(last.value), "cell", "eval"), scope)
    return exec(compile(ast.Module([last], []), "cell", "exec"), scope)


def test_every_cell_runs_and_shows_itself(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    notebook = json.loads((EXAMPLES / "clamp.ipynb").read_text("utf-8"))
    scope = {}
    shown = [run(c["source"], scope) for c in notebook["cells"] if c["cell_type"] == "code"]
    clamp, slope, derivation, scheme, plot, nothing, beyond, path = shown
    assert r"\frac" in clamp._repr_markdown_()
    assert r"\frac" in derivation._repr_markdown_()
    at = dict(zip(sympy.symbols("a b alpha beta"), (0.1, 0.25, 0.3, 0.1), strict=True))
    assert float(slope.subs(at)) == pytest.approx(0.2 / math.cos(0.3) ** 2)
    pictures = [shown._repr_svg_() for shown in (scheme, plot, beyond, path)]
    assert all(picture.startswith("<svg ") for picture in pictures)
    assert nothing is None
    assert "beta = 30°" in capsys.readouterr().out
    assert (tmp_path / "k.csv").read_text("utf-8").startswith("alpha [deg],k (beta = 10 deg)")
