"""The commands: a module for each, which is imported when the command is used, and their table."""

from importlib import import_module

from ...base.named import NamedTuple
from ..usage import Command


class CommandEntry(NamedTuple):
    """Where a command is defined, and its line in ``mechc --help``."""

    module: str
    line: str


COMMANDS = {
    "compile": CommandEntry("compile", "Write the formula, its derivation or code."),
    "check": CommandEntry("check", "Find mistakes; prove or refute expectations."),
    "derive": CommandEntry("derive", "Print the derivation of k step by step."),
    "stroke": CommandEntry("stroke", "Print k along the stroke, dead centres and extrema."),
    "draw": CommandEntry("draw", "Draw the kinematic scheme: SVG, LaTeX or PNG."),
    "plot": CommandEntry("plot", "Plot results against a parameter: a picture or a table."),
    "report": CommandEntry("report", "Set several mechanisms in one table, as LaTeX."),
    "show": CommandEntry("show", "Print what a stage of the compiler made of a description."),
    "list": CommandEntry("list", "List the mechanisms of the library."),
    "new": CommandEntry("new", "Start a description from a commented example."),
    "fmt": CommandEntry("fmt", "Lay out descriptions; turn one notation into the other."),
    "explain": CommandEntry("explain", "Explain an error or a warning by its code."),
    "completions": CommandEntry("completions", "Print shell completions for bash, zsh or fish."),
}
"""Every command: its module in this folder, whose ``command`` it is."""


def found(name: str) -> Command:
    """Import and return one command of the table."""
    module = import_module(f".{COMMANDS[name].module}", __package__)
    assert isinstance(module.command, Command)
    return module.command
