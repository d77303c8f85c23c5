"""Statements in hints, which are written as lines, in the notation of YAML."""

import yaml

from ..base.later import pattern
from ..diagnostics import MechcError, Report
from ..source import Source
from .from_dsl import parse
from .to_yaml import to_yaml

QUOTED = pattern(r"([`'])((?:(?!\1).)+)\1")

LEFT_OPEN = "left_open"
"""A name that stands for what a hint leaves to the reader, …, while the statement is read."""


def in_yaml(hint: str) -> str:
    """Return a hint with the statements in it as they stand in YAML.

    What is no whole statement stays as it is: a name, a part of a line.

    >>> in_yaml("add a line such as `AB = @ 30 deg`, or write `sharing K`")
    'add a line such as `geometry: {AB: {angle: 30 deg}}`, or write `sharing K`'
    >>> in_yaml("declare it, 'param psi = …'; a unit stands behind its number: '1 psi'")
    "declare it, 'params: {psi: …}'; a unit stands behind its number: '1 psi'"
    """
    return QUOTED.sub(lambda found: f"{found[1]}{_statement(found[2])}{found[1]}", hint)


def _statement(line: str) -> str:
    """Return a statement in YAML on one line; what is none as it is."""
    source = Source("hint.mech", line.replace("…", LEFT_OPEN) + "\n")
    report = Report(source)
    try:
        tree = parse(source, report)
        report.stop_on_errors()
    except MechcError:
        return line
    return _on_one_line(to_yaml(tree)).replace(LEFT_OPEN, "…") if tree.statements else line


def _on_one_line(text: str) -> str:
    """Return YAML with all below its first keys in brackets."""
    node = yaml.compose(text, yaml.SafeLoader)
    assert isinstance(node, yaml.MappingNode), "a description begins with its sections"
    for _, value in node.value:
        if not isinstance(value, yaml.ScalarNode):
            value.flow_style = True
    return yaml.serialize(node, Dumper=yaml.SafeDumper, width=10**6, allow_unicode=True).strip()
