"""Statements of other descriptions that are used, and what stands in their place."""

from ...frozen import field, frozen
from ...source import Span
from ...units import Dimension
from .description import Statement
from .expressions import Cartesian, Expr, Name, Symbol
from .quantities import Let, Param


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
