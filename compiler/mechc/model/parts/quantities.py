"""Quantities of a description: those that are given, asked for, required and expected.

Formulas in here are in SI, as in :mod:`..mechanism`, which hands these classes on.
"""

from collections.abc import Container, Mapping
from fractions import Fraction
from typing import Literal

from ...base.frozen import frozen, replace
from ...base.named import NamedTuple
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...source import Span
from ...units import NUMBER, Dimension
from .targets import ResultTarget
from .written import WrittenFormula, WrittenSides


class Interval(NamedTuple):
    """A range of a parameter, both ends constant formulas in SI."""

    low: Formula
    high: Formula


@frozen
class Parameter:
    """A quantity of the description.

    ``value`` is None (declared by dimension only), a constant in SI, or a formula of
    other parameters (a *dependent* parameter). ``unit`` is what the user wrote, for
    output ('' when bare). ``low`` … ``high`` is the range of a free parameter, and
    ``tolerance`` how far its value may be off, a constant in SI. A formula is there as it was
    ``written``, too. ``setting`` is where the command line gives its value, if it does; the
    description then has the ``replaced`` one. With that it is drawn, until the pose moves it to
    the one from ``outside``.
    """

    name: str
    dimension: Dimension
    span: Span
    value: Formula | None = None
    range: Interval | None = None
    unit: str = ""
    label: str = ""
    about: str = ""
    dependent: bool = False
    tolerance: Formula | None = None
    written: WrittenFormula | None = None
    setting: Span | None = None
    replaced: Formula | None = None
    outside: Formula | None = None

    @property
    def moved(self) -> "Parameter":
        """Return it with the value that it has from outside, if it has one."""
        value = self.outside
        if value is None:
            return self
        return replace(self, value=value, dependent=bool(symbols(value)), outside=None)

    @property
    def given(self) -> Span:
        """Return where its value is given."""
        return self.setting or self.span


@frozen
class Find:
    """A result asked for. An unnamed one is called ``P_over_F``, ``V_D_over_V_A``, ``P``."""

    name: str
    target: ResultTarget
    span: Span


@frozen
class Let:
    """A formula of the user's own; it may mention parameters, loads, finds and other lets.

    ``unit`` is the one to give its value in ('' for that of the SI), ``label`` its text. It is
    there as it was ``written``, too.
    """

    name: str
    value: Formula
    dimension: Dimension
    span: Span
    unit: str = ""
    label: str = ""
    written: WrittenFormula | None = None


@frozen
class Taken:
    """A result of a mechanism that a sheet uses, the unit to give it in, and its text.

    Its ``span`` is that of the use, ``asked`` where the mechanism asks for it. So many of the
    sheet's formulas stand ``before`` it, among them what is given to the mechanism.
    """

    name: str
    dimension: Dimension
    span: Span
    asked: Span
    before: int = 0
    unit: str = ""
    label: str = ""


SubjectKind = Literal[
    "first row", "last row", "row", "list", "choice", "range", "pose", "ranges", "force"
]


class Subject(NamedTuple):
    """Of what a condition is that nobody wrote: an end or a row of a table, a list, a choice.

    The formula that has no value where it fails is that of the ``let``. A ``range`` is that of a
    parameter of a used sheet, and stands at a ``place`` of its own. A condition of a used
    mechanism on what its loops give, ``pose``, concerns all that its values decide, and so do
    ``ranges``: that a direction is as it is within the ranges given. A ``force`` that is zero has
    no direction.
    """

    kind: SubjectKind
    name: str
    let: str
    place: Span | None = None


@frozen
class Require:
    """A condition of use, ``left OP right``; a chain is split into its links.

    One with a ``subject`` follows from a formula, which has no value where it fails. Another one
    is there as it was ``written``, too; ``unit`` is the one to give both sides in.
    """

    left: Formula
    operator: Literal["<", "<=", ">", ">=", "=", "!="]
    right: Formula
    span: Span
    subject: Subject | None = None
    written: WrittenSides | None = None
    dimension: Dimension = NUMBER
    unit: str = ""

    def concerns(self, names: Container[str]) -> bool:
        """Return whether it is a condition of use, or one of a formula among these."""
        subject = self.subject
        return subject is None or subject.kind in ("pose", "ranges") or subject.let in names


@frozen
class Expect:
    """The expected value of a result, from a book: a formula, or a number ``at`` given values.

    ``tolerance`` is the one ``stated``, or half a unit of the last digit written, in SI
    (0 for a formula).
    """

    subject: str
    value: Formula
    at: Mapping[str, Formula]
    tolerance: Fraction
    span: Span
    stated: bool = False


class Reported(NamedTuple):
    """A part of a report: a picture or a result, or the plot of one ``over`` a parameter."""

    name: str
    over: str = ""
