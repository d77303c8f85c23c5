"""``mechc check``: mistakes found, expectations proved or refuted, the second opinion."""

from collections.abc import Iterator

import click

from ..algebra.formula import text
from ..check.expectations import Finding
from ..diagnostics import MechcError
from ..driver import Compilation, complete, warnings
from ..power.result import Result
from ..statics.to_text import to_text
from ..statics.verdict import Verdict
from ..syntax.settings import Settings
from .begin import begin
from .inputs import settings_option, stdin_option
from .session import Command, session, session_options, status


@click.command("check", cls=Command)
@click.argument("files", nargs=-1, required=True, metavar="FILE|NAME|-...")
@click.option("-v", "--verbose", is_flag=True, help="Show every pose of the second opinion.")
@click.option("-q", "--quiet", is_flag=True, help="Print errors and warnings only.")
@settings_option
@stdin_option
@session_options
def command(
    files: tuple[str, ...], verbose: bool, quiet: bool, settings: Settings, stdin_name: str
) -> None:
    """Find mistakes; prove or refute expectations.

    Every `expect` is proved by algebra, or refuted by a pose with both numbers. Every
    result is compared with the equilibrium of the free bodies at several poses.

    \b
    mechc check clamp.mech
    mechc check --verbose toggle_press
    mechc check --format concise *.mech
    """
    worst = 0
    for file in files:
        try:
            compilation = complete(begin(file, stdin_name, settings))
        except MechcError as error:
            session().show(error.diagnostics, error.source)
            worst = max(worst, status(error.diagnostics))
            continue
        session().show(warnings(compilation), compilation.source)
        if session().werror and warnings(compilation):
            worst = max(worst, 1)
        for line in () if quiet else report(compilation, verbose):
            click.echo(line)
    click.get_current_context().exit(worst)


def report(compilation: Compilation, verbose: bool) -> Iterator[str]:
    """Yield what is known of a sound description, line by line."""
    results = compilation.results
    yield f"{compilation.source.name}: {compilation.mechanism.name}"
    for result in results:
        yield from _of_result(result)
    for finding in compilation.findings:
        yield f"  {_of_finding(finding)}"
    yield from _of_verdict(compilation.verdict, verbose)


def _of_result(result: Result) -> Iterator[str]:
    yield f"  {result.name} = {text(result.formula)}"
    for name, formula in result.where:
        yield f"    where {name} = {text(formula)}"
    if result.default is not None:
        yield f"    = {result.default:.9g} at the default pose"
    if result.independent:
        yield f"    does not depend on {', '.join(result.independent)}"


def _of_finding(finding: Finding) -> str:
    expect, outcome = finding.expect, finding.outcome
    if outcome == "proved":
        return f"expect {expect.subject} = {text(expect.value)}: proved"
    at = ", ".join(f"{name} = {value:.9g}" for name, value in finding.at.items())
    return f"expect {expect.subject} = {finding.expected:.9g} at {at}: agrees ({finding.found:.9g})"


def _of_verdict(verdict: Verdict, verbose: bool) -> Iterator[str]:
    if verbose:
        yield from (f"  {line}" for line in to_text(verdict).splitlines())
        return
    number = len(verdict.trials)
    yield f"  equilibrium of the free bodies agrees in {number} trials"
    yield from (f"    {remark}" for remark in verdict.remarks)
