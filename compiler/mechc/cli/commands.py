"""The root command and the table of its commands."""

from importlib import import_module
from typing import NamedTuple, cast

import click

from ..diagnostics import near_miss
from ..version import VERSION
from .session import session_options


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


def _for_file(name: str) -> str:
    """Return the hint at a command that was left out before a description."""
    described = name.endswith((".mech", ".yaml", ".yml"))
    return f"a command comes first: `mechc check {name}`" if described else ""


class LazyGroup(click.Group):
    """A group whose commands' modules are imported when they are used."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names in the order of the table."""
        return list(COMMANDS)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command that is asked for, or propose the nearest one."""
        name = args[0]
        if name not in COMMANDS and not name.startswith("-"):
            hint = near_miss(name, COMMANDS) or _for_file(name)
            ctx.fail(f"there is no command {name!r}; {hint or '`mechc --help` lists them'}")
        return super().resolve_command(ctx, args)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import and return one command."""
        if cmd_name not in COMMANDS:
            return None
        module = import_module(f".{COMMANDS[cmd_name].module}", __package__)
        return cast(click.Command, module.command)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the table without importing the commands."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, entry.line) for name, entry in COMMANDS.items()])


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 96},
    epilog="`mechc COMMAND --help` says more, with an example. Exit status: 0 done, 1 the "
    "description is wrong, 2 the command line is, 3 a file, 4 a limit, 70 mechc itself.",
)
@click.version_option(VERSION, "-V", "--version", message="mechc %(version)s")
@session_options
def mechc() -> None:
    """Compile a planar mechanism into its force transmission k = P/F.

    A description (pins, sliders, links, forces) becomes the formula for k, the derivation
    that proves it, and code in Python, C and LaTeX.

    \b
    mechc new clamp                        start a description
    mechc check clamp.mech                 find mistakes in it
    mechc compile clamp.mech -o clamp.tex  write the formula with its derivation
    mechc compile toggle_press --emit c    a mechanism of the library as C
    """
