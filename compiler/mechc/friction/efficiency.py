"""Efficiencies, given or found, whichever load drives.

The load that is asked for drives where it moves along its force: with a positive ratio
while tightening, with a negative one while releasing. Elsewhere it follows, and what
arrives is the inverse quotient. At a dead centre nothing arrives.
"""

from functools import cached_property

from ..algebra.factors import Trig
from ..algebra.from_formula import to_product
from ..algebra.intervals import IntervalBox, sign
from ..algebra.product import ONE, Product
from ..algebra.sums import canonical
from ..algebra.trigonometry import cosine, sine
from ..base.frozen import on_demand, replace
from ..formula.operations import count_operations
from ..formula.tree import ZERO, Call, Formula, Power, Symbol, is_call, number, product, quotient
from ..formula.walk import symbols, walk
from ..kinematics.plan import Plan
from ..model.boxes import allowed_box
from ..model.mechanism import Mechanism, Require, Sense
from ..model.parts.targets import SIGNS
from ..model.result import Definition, FrictionResult, Result, SignCase
from ..power.numbers import default_values, value_of
from ..source import Span
from ..units import NUMBER
from .closed_form import DefinedFormula, PrintedFormula, readable
from .iterated import AS_SHORT_AS_NAME
from .signs.conditions import Operator
from .solution import FrictionStep


class Drives:
    """Whether the load that is asked for drives, here and at other poses."""

    def __init__(self, ideal: Result, sense: Sense, plan: Plan) -> None:
        self._ideal, self._k = ideal, Symbol(ideal.name)
        self._sense, self._plan = SIGNS[sense], plan
        self._mechanism = plan.graph.pose.mechanism

    @cached_property
    def _always(self) -> int | None:
        return _sign(self._ideal, _sizes(self._mechanism))

    @cached_property
    def _in_range(self) -> int | None:
        return _sign(self._ideal, allowed_box(self._mechanism))

    @cached_property
    def _known(self) -> int:
        """Return the sign of the ratio at the default pose, or in all; 0 where it is not known."""
        if default := self._ideal.default:
            return -1 if default < 0 else 1
        return 0 if default is not None else self._always or self._in_range or 0

    @property
    def _is_zero(self) -> bool:
        """Return whether the ratio is zero at the default pose, where the efficiency is, too."""
        return self._ideal.default == 0

    @property
    def _here(self) -> int:
        """Return the sign for which a result is printed; of a zero that of a load that drives."""
        return self._known or (self._sense if self._is_zero else 1)

    @property
    def is_driven(self) -> bool | None:
        """Return whether the others drive the load; None where that is not known."""
        return self._sense * self._known < 0 if self._known else None

    @property
    def is_printed_as_driven(self) -> bool:
        """Return whether they do in the case that is printed, with its condition."""
        return self._exponent < 0

    def with_constant(self, name: str, efficiency: Formula) -> DefinedFormula:
        """Return the ratio, which is called ``name``, with an efficiency that is given."""
        here = product([(self._ideal.formula, 1), (efficiency, -self._exponent)])
        share = product([(self._k, 1), (efficiency, -self._exponent)])
        steps = (FrictionStep("efficiency", equations=((Symbol(name), share),)),)
        if self._always is not None or here == ZERO:
            return DefinedFormula(here, steps=steps)
        whole = product([(self._k, 1), (Power(efficiency, self._turning(-1)), 1)])
        case = PrintedFormula(here, (), self._condition(self._ideal.formula), steps)
        return DefinedFormula(whole, (self._definition(),), case=case)

    def efficiency(self, real: FrictionResult, span: Span) -> FrictionResult:
        """Return the efficiency, from the ratio with friction."""
        k_f = Definition(f"{self._ideal.name}_f", real.formula)
        without = to_product(self._ideal.formula)
        here = ((without / Product.symbol(k_f.name)) ** self._exponent).formula()
        formula = _not_negative(here) if self._exponent < 0 else here
        where = (*real.where, k_f)
        if self._always is None:
            formula, where = self._anywhere(k_f.name), (*where, self._definition())
        return replace(
            real,
            formula=formula,
            where=where,
            dimension=NUMBER,
            case=self._case(here, real, k_f.name, span),
            elsewhere=on_demand(lambda: self._elsewhere(real, span)),
        )

    def _elsewhere(self, real: FrictionResult, span: Span) -> FrictionResult | None:
        other = real.elsewhere
        return self.efficiency(other, span) if isinstance(other, FrictionResult) else None

    def _case(self, here: Formula, real: FrictionResult, name: str, span: Span) -> SignCase | None:
        """Return the efficiency as it is printed; it has the conditions of the ratio, too."""
        case = real.case
        if case is None:
            return None
        where, holds = (*case.where, Definition(name, case.formula)), case.holds
        if count_operations(self._ideal.formula) > AS_SHORT_AS_NAME:
            above, below = (self._k, Symbol(name))[:: self._exponent]
            here, where = quotient(above, below), self._with_ideal(where)
        elif not _has_roots(case):
            put_in = self._put_in(case)
            allowed = count_operations(here) + self._spared(put_in, case)
            if count_operations(put_in) <= allowed:
                here, where = put_in, case.where
        if self._exponent < 0:
            value = value_of(real, default_values(self._plan))
            if value is not None and value * self._here < 0:
                here = _not_negative(here)
            else:
                holds += (Require(here, ">", ZERO, span),)
        if self._in_range is None:
            where = self._with_ideal(where)
            holds += tuple(Require(f, o, ZERO, span) for f, o in self._condition(self._k))
        return SignCase(here, where, holds, case.guards)

    def _spared(self, put_in: Formula, case: SignCase) -> int:
        """Return how many operations the efficiency with the printed ratio in it may have more."""
        ideal = symbols(self._ideal.formula)
        shows_more = not ideal or symbols(put_in) < ideal | symbols(case.formula)
        return LOOKED_UP + DROPPED * shows_more

    def _put_in(self, case: SignCase) -> Formula:
        """Return the efficiency with the printed ratio in it, not its name: tan β/tan(β + ρ)."""
        without, real = to_product(self._ideal.formula), to_product(case.formula)
        share = canonical((without / real) ** self._exponent)
        return min((_in_tangents(share), readable(share)), key=count_operations)

    def _with_ideal(self, where: tuple[Definition, ...]) -> tuple[Definition, ...]:
        """Return definitions with that of the ratio without friction."""
        ideal = self._definition()
        return where if ideal in where else (*where, ideal)

    def _anywhere(self, name: str) -> Formula:
        """Return |σ|·(k/k_f)^σ, σ the sign that depends on which side drives: 0 at a dead centre.

        It is 0 as well where the load drives and friction holds it, so that k_f has not its sign.
        """
        sigma = self._turning(1)
        share = _not_negative(Power(quotient(self._k, Symbol(name)), sigma))
        return product([(Call("abs", (Call("sign", (self._k,)),)), 1), (share, 1)])

    def _turning(self, exponent: int) -> Formula:
        """Return an exponent that changes its sign where the ratio does."""
        return product([(number(exponent * self._sense), 1), (Call("sign", (self._k,)), 1)])

    @property
    def _exponent(self) -> int:
        return self._sense * self._here

    def _condition(self, ratio: Formula) -> tuple[tuple[Formula, Operator], ...]:
        if self._in_range is not None:
            return ()
        operators: tuple[Operator, Operator] = ("<=", ">=") if self._is_zero else ("<", ">")
        return ((ratio, operators[self._here > 0]),)

    def _definition(self) -> Definition:
        return Definition(self._ideal.name, self._ideal.formula)


def _has_roots(case: SignCase) -> bool:
    """Return whether a ratio, or what it rests on, is a root of a quadratic equation."""
    used = symbols(case.formula)
    rests_on = (d.formula for d in case.where if d.name in used)
    return any(
        is_call(f, "sqrt", "hypot") for whole in (case.formula, *rests_on) for f in walk(whole)
    )


def _in_tangents(share: Product) -> Formula:
    """Return a share of sines and cosines alone with tangents below its line: tan β/tan(β + ρ)."""
    trigs = {f: e for f, e in share.factors.items() if isinstance(f, Trig)}
    below = ONE
    if len(trigs) == len(share.factors):
        for angle in (f.angle for f, e in trigs.items() if f.function == "sin" and e < 0):
            if trigs.get(Trig("cos", angle), 0) > 0:
                below *= sine(angle) / cosine(angle)
    return quotient((share * below).formula(), below.formula())


LOOKED_UP = 2
"""Operations that a ratio counts for which the reader has to look up by its name."""

DROPPED = 8
"""Operations that a formula may have more which shows on what an efficiency does not depend."""


def _not_negative(share: Formula) -> Formula:
    """Return a share of the power, 0 where all of it is friction's."""
    return Call("max", (share, ZERO))


def _sign(result: Result, box: IntervalBox) -> int | None:
    """Return the sign of a result all over a box, None where it is not proved."""
    value = to_product(result.formula)
    return sign(value, box) if value else None


def _sizes(mechanism: Mechanism) -> IntervalBox:
    """Return the box of all that is no angle."""
    return {name: i for name, i in allowed_box(mechanism).items() if name not in mechanism.angles}
