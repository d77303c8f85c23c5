"""Command lines that are read without click mean what click makes of them."""

import click
import pytest

from mechc.cli import by_click
from mechc.cli.commands import COMMANDS, found
from mechc.cli.plain import read

LINES = [
    "check clamp.mech",
    "check clamp.mech toggle.mech -q -v --lang uk",
    "check - --stdin-filename in.mech --werror",
    "check --format json clamp.mech --color never",
    "check clamp.mech -D alpha=30deg --define a=2mm -D b=-3mm",
    "check clamp.mech --define=alpha=30deg --lang=ru --lang en",
    "compile clamp.mech --emit c",
    "compile clamp.mech -o k.c -o - --no-numbers --numbers --no-numbers --gradient",
    "compile --deps - clamp.mech --by equilibrium --c-real float --no-cache",
    "derive clamp.mech --brief --by power",
    "draw clamp.mech -o a.svg -o - --friction-circles",
    "explain",
    "explain E203",
    "fmt a.mech b.mech --to yaml --diff",
    "list --json -l",
    "list --lang uk",
    "new clamp",
    "new clamp --gripper",
    "new clamp --gripper --toggle",
    "plot clamp.mech --y a,b --y c --family beta=10,20deg --range 1..2 -n 50 -o k.svg",
    "report a b -o t.tex --no-schemes",
    "show pose clamp.mech",
    "stroke clamp.mech --points 2",
    "stroke clamp.mech --points 5 --csv-dialect comma --path B --path C",
]
"""Plain ones, as the shell hands them over."""

NOT_PLAIN = [
    "check",
    "check --lang xx clamp.mech",
    "check --quit clamp.mech",
    "check clamp.mech -D",
    "check clamp.mech -D alpha",
    "check -qv clamp.mech",
    "check -- clamp.mech",
    "check --help",
    "check --quiet=yes clamp.mech",
    "compile a.mech b.mech",
    "stroke clamp.mech -n 1",
    "stroke clamp.mech -n many",
    "stroke clamp.mech -n5",
    "show poses clamp.mech",
    "plot clamp.mech --range 1",
]


def by_the_book(line):
    """Return the values that click reads off a line, by name, and the settings of messages."""
    name, *words = line.split()
    with click.Context(by_click.mechc, info_name="mechc") as root:
        command = by_click.mechc.get_command(root, name)
        ctx = command.make_context(name, words, parent=root)
        return ctx.params, ctx.find_object(by_click.session.Session)


def of_messages(values):
    """Return the settings of messages, as a session has them."""
    kept = {n: v for n, v in values.items() if n in by_click.session.NAMES and v is not None}
    return by_click.session.Session(**kept)


@pytest.mark.parametrize("line", LINES)
def test_a_plain_line_has_the_values_that_click_finds(line):
    name, *words = line.split()
    values = read(found(name), words)
    params, said = by_the_book(line)
    assert {n: v for n, v in values.items() if n not in by_click.session.NAMES} == params
    assert of_messages(values) == (said or by_click.session.Session())


@pytest.mark.parametrize("line", NOT_PLAIN)
def test_what_is_not_plain_is_left_to_click(line):
    name, *words = line.split()
    assert read(found(name), words) is None


def test_lines_of_every_command_are_read():
    assert {line.split()[0] for line in LINES} | {"completions"} == COMMANDS.keys()
