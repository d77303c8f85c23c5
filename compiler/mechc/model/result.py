"""Results, each as a readable formula.

It answers what was asked for (``mechanism.Find``): power and friction fill it, statics
checks it, and neither needs to know of the other.

All formulas are in SI and radians and mention free parameters and the names in
``where`` only.
"""

from collections.abc import Mapping

from ..base.frozen import field, frozen
from ..base.named import NamedTuple
from ..formula.tree import Formula
from ..units import Dimension
from .mechanism import Parameter, Require, ResultTarget


class Definition(NamedTuple):
    """``name = formula``: an intermediate that a result mentions."""

    name: str
    formula: Formula


@frozen
class Result:
    """One ``find`` (or ``let``), solved, as code takes it.

    ``formula`` is the whole result; for a load found as a linear form (``find P``)
    ``coefficients`` gives the factor of every other load and ``formula`` their sum; a result
    with friction is none.
    ``target`` is None for a let. At the default pose it has the value ``default``, if any; it
    is ``undetermined`` where it is 0/0 there, and has ``sides``
    where a slip is 0 for once: it jumps between two of them, NaN where nothing balances, and has
    the value of one. ``guards`` are conditions without which the
    formula has no meaning; ``elsewhere`` is the result that takes its place where one of them
    fails, if there is one: being long, it is made when it is read. The ``label`` is the text that
    the description gives a let.
    """

    name: str
    target: ResultTarget | None
    dimension: Dimension
    formula: Formula
    where: tuple[Definition, ...] = ()
    coefficients: Mapping[str, Formula] | None = None
    default: float | None = None
    undetermined: bool = False
    sides: tuple[float, ...] = ()
    guards: tuple[Require, ...] = ()
    elsewhere: "Result | None" = field(default=None, on_demand=True)
    label: str = ""


@frozen
class SignCase:
    """A result with friction as it is printed: for one case of the signs of slips and forces.

    ``holds`` are the conditions, each of a formula that is positive, negative or zero.
    """

    formula: Formula
    where: tuple[Definition, ...]
    holds: tuple[Require, ...]
    guards: tuple[Require, ...] = ()


class DrivingLoad(NamedTuple):
    """The load of the drive under which a force at a joint is so large.

    Without friction it is ``ideal``, with it ``load``; both rest on the force's definitions.
    """

    ideal: Formula
    load: Formula


@frozen
class FrictionResult(Result):
    """A result with friction.

    ``case`` is what is printed instead of a formula that takes its signs from the pose.
    Names of ``where`` that are ``inside`` a system are its many coefficients, of which people
    read the structure only. Whether a force at a joint is one of a mechanism that moves, its
    ``drive`` states.
    A load is ``driven`` where the others drive the motion at the default pose, or would without
    friction, and it holds them back; None where that is not known, and at a dead centre.
    ``is_idle`` says that the load that drives has friction alone to overcome, as in a brake.
    """

    case: SignCase | None = None
    inside: frozenset[str] = frozenset()
    drive: DrivingLoad | None = None
    driven: bool | None = None
    is_idle: bool = False


class ClosedLoop(NamedTuple):
    """A loop that closes at some values of its symbols only.

    ``names`` are the definitions that have no value where it does not; ``margin`` is not
    negative where it closes, and negative or NaN elsewhere. ``of`` is the prefix of the used
    mechanism that has the loop, '' of a mechanism's own.
    """

    loop: str
    names: frozenset[str]
    margin: Formula
    of: str = ""


@frozen
class UsedSolution:
    """The solution of a mechanism that a sheet uses, by its names there.

    ``definitions`` are those that results and loops may rest on, ``requires`` the conditions
    on what the loops give, ``literals`` the numbers that have names.
    """

    results: tuple[Result, ...] = ()
    definitions: tuple[Definition, ...] = ()
    loops: tuple[ClosedLoop, ...] = ()
    requires: tuple[Require, ...] = ()
    literals: tuple[Parameter, ...] = ()

    def __add__(self, other: "UsedSolution") -> "UsedSolution":
        """Return both solutions as one."""
        return UsedSolution(
            (*self.results, *other.results),
            (*self.definitions, *other.definitions),
            (*self.loops, *other.loops),
            (*self.requires, *other.requires),
            (*self.literals, *other.literals),
        )
