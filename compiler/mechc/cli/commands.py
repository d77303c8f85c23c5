"""The table of the commands."""

from importlib import import_module

from ..named import NamedTuple
from .usage import Command


class Entry(NamedTuple):
    """Where a command is defined, and its line in ``mechc --help``."""

    module: str
    line: str


COMMANDS = {
    "compile": Entry("compile", "Write the formula, its derivation or code."),
    "check": Entry("check", "Find mistakes; prove or refute expectations."),
    "derive": Entry("derive", "Print the derivation of k step by step."),
    "stroke": Entry("stroke", "Print k along the stroke, dead centres and extrema."),
    "draw": Entry("draw", "Draw the kinematic scheme: SVG, LaTeX or PNG."),
    "plot": Entry("plot", "Plot results against a parameter: a picture or a table."),
    "report": Entry("report", "Set several mechanisms in one table, as LaTeX."),
    "show": Entry("show", "Print what a stage of the compiler made of a description."),
    "list": Entry("list", "List the mechanisms of the library."),
    "new": Entry("new", "Start a description from a commented example."),
    "fmt": Entry("fmt", "Lay out descriptions; turn one notation into the other."),
    "explain": Entry("explain", "Explain an error or a warning by its code."),
    "completions": Entry("completions", "Print shell completions for bash, zsh or fish."),
}
"""Every command: its module in this folder, whose ``command`` it is."""


def found(name: str) -> Command:
    """Import and return one command of the table."""
    module = import_module(f".{COMMANDS[name].module}", __package__)
    assert isinstance(module.command, Command)
    return module.command
