"""What the sequential solver notes of its way, so that a derivation can show it step by step."""

from collections.abc import Iterable, Mapping, Sequence
from typing import assert_never

from ..algebra.product import Product
from ..algebra.sums import canonical
from ..formula.tree import ZERO, Formula, Symbol, is_call, number, product, total
from ..formula.walk import substitute, symbols
from ..model.mechanism import Link
from ..power.joint_forces import size_of_two
from .chain_bodies import Bodies, BodyForce, BodyKind
from .signs.names import SignSymbols, exact_sign
from .solution import FrictionStep, StepKind

FormulaPair = tuple[Formula, Formula]


class Notes:
    """Notes steps in order, each with the names that it is the first to use."""

    def __init__(self, bodies: Bodies, signs: SignSymbols) -> None:
        self._bodies, self._signs = bodies, signs
        self.steps: list[FrictionStep] = []
        self._named: dict[str, Formula] = {}
        self._noted = 0

    def rod(
        self, rod: Link, sense: Product, resistances: Mapping[str, Product], turn: Product
    ) -> None:
        """Note the line of a rod's force, by the friction at the pins on which it turns."""
        senses = {exact_sign(r.coefficient) for r in resistances.values()}
        kind: StepKind = "internal" if len(senses) == 1 else "external"
        pivot = ""
        if len(resistances) == 1:
            kind, (pivot,) = "single", resistances
        elif not turn:
            kind = "parallel"
        self._note(kind, rod.name, pivot, exact_sign(sense.coefficient))

    def face(self, point: str) -> None:
        """Note the line of a force on a face."""
        self._note("face", point)

    def balance(
        self,
        kind: BodyKind,
        body: str,
        forces: Sequence[BodyForce],
        friction: Product,
        found: Mapping[str, Product],
        squared: FormulaPair | None = None,
    ) -> None:
        """Note a body in balance under forces of unknown size, and what that gives.

        ``squared`` is the equation of a lever behind that of its moments, where these have a root.
        """
        match kind:
            case "lever":
                equations = [self._moments(body, forces, friction), *([squared] if squared else [])]
                pivot, sense = self._bodies.pivot(body), exact_sign(friction.coefficient)
                self._note(kind, body, pivot, sense, self._in_names(equations, found))
            case "slider":
                equations = [self._along(body, forces, friction)]
                self._note(kind, body, equations=self._in_names(equations, found))
            case "pin":
                equations = _across(forces, found)
                self._note(kind, body, equations=self._in_names(equations, found))
            case _:
                assert_never(kind)

    def _in_names(
        self, equations: Iterable[FormulaPair], found: Mapping[str, Product]
    ) -> list[FormulaPair]:
        """Return equations and what they give; sizes that have definitions under their names."""
        defined = {Symbol(d.name) for d in self._signs.definitions}
        self._named |= {n: s.formula() for n, s in found.items() if s.formula() in defined}
        named = self._named
        return [
            *((substitute(a, named), substitute(b, named)) for a, b in equations),
            *((Symbol(n), s.formula()) for n, s in found.items() if n not in named),
        ]

    def symbol(self, name: str) -> Formula:
        """Return the name of a force in the steps, with an ending where another has it."""
        return self._named.get(name, Symbol(name))

    def _note(
        self,
        kind: StepKind,
        body: str,
        pivot: str = "",
        sense: int = 0,
        equations: Sequence[FormulaPair] = (),
    ) -> None:
        """Note a step, with the definitions that were made since the last one."""
        fresh = self._signs.definitions[self._noted :]
        self._noted = len(self._signs.definitions)
        self.steps.append(FrictionStep(kind, body, pivot, sense, tuple(equations), tuple(fresh)))

    def _moments(self, lever: str, forces: Sequence[BodyForce], friction: Product) -> FormulaPair:
        """Return the moments about the pivot, and the couple of its friction."""
        arms = self._bodies.arms(lever)
        moments = _sum(force.moment(arms) for force in forces)
        if not friction:
            return moments, ZERO
        line = next(force.line for force in forces if force.line is not None)
        along, across = (_sum(p.along(line) for p in forces), _sum(p.across(line) for p in forces))
        return moments, product([(friction.formula(), 1), (_size(along, across), 1)])

    def _along(self, body: str, forces: Sequence[BodyForce], friction: Product) -> FormulaPair:
        """Return the forces along a guide, and the friction of what presses on it."""
        guide = self._bodies.guide(body)
        across = _sum(force.across(guide) for force in forces)
        along = _sum(force.along(guide) for force in forces)
        return along, product([(friction.formula(), 1), (across, 1)])


def _size(x: Formula, y: Formula) -> Formula:
    """Return the size of a force from its parts; that of the force in a rod is one by itself.

    >>> from ..formula.to_text import text
    >>> backwards = product([(number(-1), 1), (Symbol("S_AB"), 1)])
    >>> text(_size(backwards, ZERO)), text(_size(ZERO, Symbol("Q")))
    ('S_AB', 'abs(Q)')
    """
    size = size_of_two(x, y)
    if not is_call(size, "abs"):
        return size
    (part,) = size.arguments
    in_rods = [Symbol(name) for name in symbols(part) if name.startswith("S_")]
    of_rod = next((s for s in in_rods if part in (s, product([(number(-1), 1), (s, 1)]))), None)
    return of_rod or size


def _across(forces: Sequence[BodyForce], found: Mapping[str, Product]) -> list[FormulaPair]:
    """Return the forces on a pin across each of those that are found."""
    lines = [force.line for force in forces if force.name in found]
    return [(_sum(p.across(line) for p in forces), ZERO) for line in lines if line is not None]


def _sum(terms: Iterable[Product]) -> Formula:
    return total(canonical(term).formula() for term in terms if term)
