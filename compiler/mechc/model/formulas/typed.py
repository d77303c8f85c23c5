"""Values given as text, ``20 deg``, as the value of a ``param`` line is given."""

from ...diagnostics import Report
from ...formula.evaluate import evaluate
from ...syntax.settings import parse
from ...units import Dimension
from ..names.points import Points
from ..names.scope import DESCRIPTION, Scope
from .expressions import Reader
from .parameters import constant

ORIGIN = "value"
"""What messages call the text of a value, which stands in no file."""


def in_si(name: str, text: str, dimension: Dimension) -> float:
    """Return a value for a name in SI and radians.

    Raises :class:`MechcError` where the text is no constant that measures ``dimension``.

    >>> from ...units import LENGTH
    >>> in_si("a", "2.5 in", LENGTH), in_si("a", "30mm", LENGTH)
    (0.0635, 0.03)
    """
    _, (value, source) = parse(f"{name}={text}", ORIGIN)
    report = Report(source)
    scope = Scope(report, Points(report))
    found = constant(value, scope, "a value")
    if found is not None:
        Reader(scope, DESCRIPTION).fits(found, dimension, f"the value of {name}")
    report.stop_on_errors()
    assert found is not None
    return evaluate(found.formula, {})
