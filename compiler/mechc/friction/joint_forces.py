"""Forces at joints with friction: as they are without it, and what each friction adds."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial

from ..algebra.angle import QUARTER, Angle
from ..algebra.product import ONE, Product
from ..formula.tree import Call, Formula, Symbol, number, product, total
from ..kinematics.plan import Plan
from ..model.mechanism import ForceAtJoint, Reaction
from ..model.result import Definition
from ..pose.pose import Arm
from ..power.balance import Term
from ..power.definitions import bound_sums
from ..power.joint_forces import component, joint_of, line_of, size_of_two
from ..power.reactions import Reactions
from .closed_form import DefinedFormula, PrintedFormula
from .friction_pairs import FrictionPair, LoadedPair, radii
from .iterated import named_factor, step_of
from .naming import ForceSizes
from .normal_forces import load_of, term_of
from .signs.at_one_pose import SignsAtOnePose
from .signs.conditions import conditions
from .signs.senses import sense_of


class ForceWithFriction:
    """A force at a joint, every friction as large as ``sizes`` says."""

    def __init__(
        self,
        target: ForceAtJoint,
        plan: Plan,
        driving: str,
        loaded: Sequence[LoadedPair],
        sizes: ForceSizes,
    ) -> None:
        self._target, self._pose = target, plan.graph.pose
        self._loaded, self._sizes = loaded, sizes
        pairs = [p.pair for p in loaded]
        known = (plan, *(other for p in loaded for other in p.plans))
        reactions = Reactions(self._pose, (driving,), partial(_terms, pairs), known)
        self.transmitted = reactions.of(joint_of(target, self._pose))

    def at_any_pose(self) -> DefinedFormula:
        """Return the force with signs that follow from the pose."""
        formula = self._formula(lambda pair: pair.factor, sense_of)
        sizes = self._sizes
        return DefinedFormula(formula, sizes.definitions, sizes.positive, inside=sizes.inside)

    def at_one_pose(self, signs: SignsAtOnePose) -> PrintedFormula:
        """Return the force as it is printed, for the signs of one pose."""
        labels = radii(p.pair for p in self._loaded)
        formula = self._formula(
            lambda pair: named_factor(pair, labels, signs),
            lambda slip: signs.note_sign("", slip).formula(),
        )
        where = (*signs.definitions, *self._sizes.definitions)
        steps = (step_of(self._loaded),)
        return PrintedFormula(formula, where, conditions(signs), steps, self._sizes.positive)

    def sums(self) -> Iterator[Definition]:
        """Yield the named sums that the force rests on."""
        assert self.transmitted is not None
        for plan, push in zip(self.transmitted.plans, self.transmitted.force_terms, strict=True):
            yield from bound_sums(plan, list(push.amounts.values()))

    def _formula(
        self, factor: Callable[[FrictionPair], Product], sign: Callable[[Product], Formula]
    ) -> Formula:
        """Return the force asked for, with the factor and the sign that each friction has."""
        frictions = {
            load_of(p.pair): self._resisting(p, factor(p.pair), sign(p.slip)) for p in self._loaded
        }

        def along(*line: Arm) -> Formula:
            assert self.transmitted is not None
            return _form(component(self.transmitted, line), frictions)

        x, y = Arm(ONE, Angle()), Arm(ONE, QUARTER)

        match self._target:
            case Reaction(part="size"):
                return size_of_two(along(x), along(y))
            case Reaction(part="direction"):
                return Call("atan2", (along(y), along(x)))
            case _:
                return along(*line_of(self._target, self._pose))

    def _resisting(self, loaded: LoadedPair, factor: Product, sign: Formula) -> Formula:
        """Return a friction as a load on its slip: its size, against the sign of the slip."""
        size = Symbol(self._sizes.names[loaded.pair.name])
        return product(
            [(number(-self._sizes.sense), 1), (factor.formula(), 1), (size, 1), (sign, 1)]
        )


def _terms(pairs: Sequence[FrictionPair], loose: Plan) -> list[Term]:
    return [term_of(pair, loose) for pair in pairs]


def _form(amounts: Mapping[str, Product], frictions: Mapping[str, Formula]) -> Formula:
    kept = {load: amount for load, amount in amounts.items() if amount}
    loads = {load: frictions.get(load, Symbol(load)) for load in kept}
    return total(product([(kept[n].formula(), 1), (load, 1)]) for n, load in loads.items())
