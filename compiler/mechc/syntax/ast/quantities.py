"""Statements of parameters, formulas, conditions and results, and of what is used for them."""

from typing import Literal

from ...base.frozen import field, frozen
from ...source import Span
from ...units import Dimension
from .description import Statement
from .expressions import Cartesian, Expr, Name, Symbol


@frozen
class Param(Statement):
    """``param NAME = VALUE +- TOLERANCE in LOW .. HIGH as "label"``, ``param NAME: dimension``.

    ``replaced`` is the value of the line where one from outside stands in its place.
    """

    name: Name
    value: Expr | None = None
    low: Expr | None = None
    high: Expr | None = None
    dimension: Name | None = None
    label: str = ""
    about: str = ""
    tolerance: Expr | None = None
    replaced: Expr | None = None


@frozen
class Find(Statement):
    """``find k = P / F``, ``find P``, ``find R_B on AB``; ``name`` is None where none was given."""

    target: Expr
    name: Name | None = None
    on: Name | None = None


@frozen
class Condition:
    """``a < b < c``: ``operators[i]`` stands between ``operands[i]`` and ``operands[i + 1]``."""

    operands: tuple[Expr, ...]
    operators: tuple[Literal["<", "<=", ">", ">=", "=", "!="], ...]


@frozen
class Branch:
    """``2*a when a < b and c > 0``: a value, and the conditions that all hold where it is meant."""

    value: Expr
    conditions: tuple[Condition, ...]


@frozen
class Choice:
    """``1 when a < b, 2 when a > b else 3``: of the branches one at most is meant."""

    branches: tuple[Branch, ...]
    otherwise: "Expr | Choice | None"
    span: Span = field(compare=False)


@frozen
class Lookup:
    """``m49 at 2*r/d``: what a table has for a value, between two of its rows in proportion.

    ``pitches at exactly d`` takes the row of the value itself, and has none between rows.
    """

    table: Name
    at: Expr
    span: Span = field(compare=False)
    exactly: bool = False


@frozen
class NextSize:
    """``next d_min in pins``: the smallest size of a list that is no less."""

    least: Expr
    sizes: Name
    span: Span = field(compare=False)


LetValue = Expr | Choice | Lookup | NextSize
"""The value of a ``let``."""


@frozen
class Let(Statement):
    """``let p = 4*P/(pi*d^2) in MPa as "label"``."""

    name: Name
    value: LetValue
    unit: Name | None = None
    label: str = ""


@frozen
class Table(Statement):
    """``table m49 "Table 4.9" = 1: 0.388, 0.9: 0.400``: pairs of an argument and its value."""

    name: Name
    rows: tuple[tuple[Expr, Expr], ...]
    source: str = ""


@frozen
class Sizes(Statement):
    """``list bores "ISO 15552" = 32 mm, 40 mm``: sizes that there are, from the smallest."""

    name: Name
    sizes: tuple[Expr, ...]
    source: str = ""


@frozen
class Require(Statement):
    """``require 0 deg < alpha + theta < 90 deg``: a chain of comparisons.

    ``operators[i]`` stands between ``operands[i]`` and ``operands[i + 1]``.
    """

    operands: tuple[Expr, ...]
    operators: tuple[Literal["<", "<=", ">", ">=", "=", "!="], ...]


@frozen
class Expect(Statement):
    """``expect k = FORMULA`` or ``expect k = NUMBER +- TOLERANCE at alpha = 35 deg``."""

    subject: Expr
    value: Expr
    at: tuple[tuple[Name, Expr], ...] = ()
    tolerance: Expr | None = None


@frozen
class Use(Statement):
    """``use cylinder as cyl (P = 2*F)``: another sheet, what is ``given`` to its parameters.

    It is one of the library by its name, or a file by its path from this one's folder.
    ``use clamp as T at (x, y) turned θ joining T.C = B without F``: a mechanism that becomes
    a part of this one, where its origin lies and how it is turned.
    """

    used: Name
    prefix: Name
    given: tuple[tuple[Name, Expr], ...] = ()
    at: Cartesian | None = None
    turned: Expr | None = None
    joining: tuple[tuple[Name, Name], ...] = ()
    without: tuple[Name, ...] = ()


@frozen
class Given(Let):
    """The statement in place of a parameter of a used sheet, and the dimension of that.

    No line says so: it is made where the used sheet is put in.
    """

    parameter: Param = field(kw_only=True)
    measures: Dimension = field(kw_only=True)


@frozen
class Follows(Let):
    """The formula of a load that a ratio of a used mechanism gives, ``C_P = C_k*C_F``.

    No line says so: it is made where the used mechanism is put in.
    """


@frozen
class Taken(Statement):
    """A result of a used mechanism: what it measures, and the names of values that it rests on.

    No line says so: it is made where the mechanism is put in. ``asked`` is where the mechanism
    asks for it.
    """

    name: Name
    measures: Dimension
    rests_on: tuple[Symbol, ...]
    asked: Span


@frozen
class Brought(Statement):
    """A prefix under which something is used, what that is, and its loads that nothing gives.

    ``inner`` are its loads that it gives itself, such as weights, ``points`` the points of its
    bodies. No line says so: it stands where a sheet or a mechanism is put in.
    """

    prefix: str
    used: str
    loads: tuple[str, ...]
    inner: tuple[str, ...] = ()
    points: tuple[str, ...] = ()
