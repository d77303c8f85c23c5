"""Messages for what a report is said to hold."""

from collections.abc import Sequence

from ...source import Span
from ..diagnostic import Message, coded


@coded("E336")
def no_part_of_a_report(span: Span, name: str, known: Sequence[str], hint: str) -> Message:
    """A report holds what is no picture and no result.

    Beside results by their names it holds ``scheme``, ``bodies``, ``plans``, ``stroke``, and
    plots of results over parameters.

    find k = P/F
    report scheme, ratio                # wrong
    report scheme, k, plot k over alpha # right
    """
    expected = f"expected {', '.join(known)}" if known else "no result is asked for"
    hint = hint or "name one of these, or ask for it with 'find'"
    return Message(span, f"a report holds no '{name}': {expected}", hint)


@coded("E337")
def plot_over_no_range(span: Span, name: str, ranged: Sequence[str], hint: str) -> Message:
    """A plot is over a parameter that has no range: give it one.

    param alpha = 20 deg                         # wrong
    param alpha = 20 deg in 5 deg .. 40 deg      # right
    report plot k over alpha
    """
    expected = f"expected {', '.join(ranged)}" if ranged else "no parameter has one"
    return Message(
        span,
        f"{name} has no range to plot over: {expected}",
        hint or f"give it one: param {name} = … in LOW .. HIGH",
    )


@coded("E338")
def stroke_without_drive(span: Span) -> Message:
    """The table along the stroke is asked of a mechanism without a drive.

    report stroke                       # wrong by itself
    drive phi from 10 deg to 80 deg     # right: this is the stroke
    """
    return Message(
        span,
        "there is no stroke: expected a drive, found none",
        "name what moves, as in drive phi from 10 deg to 80 deg",
    )


@coded("E339")
def parts_of_a_sheet(span: Span) -> Message:
    """Parts of a report are asked of a calculation sheet, which is reported line by line.

    sheet pin
    let tau = 4*F/(pi*d^2)
    report tau                          # wrong: leave it out
    """
    return Message(
        span,
        "a calculation sheet is reported line by line: there are no parts to choose",
        "leave this out",
    )
