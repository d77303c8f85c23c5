"""Forces at joints with friction: as they are without it, and what each friction adds."""

from collections.abc import Mapping, Sequence

from ...algebra.angle import Angle
from ...algebra.product import Product
from ...formula.tree import Call, Formula, Symbol, number, product, total
from ...kinematics.forms import QUARTER
from ...kinematics.plan import Plan
from ...model.mechanism import Axial, Normal, Reaction
from ..joint_forces import bond_of, line_of
from ..reactions import Reactions, Transmitted
from .closed import Named
from .exact import Sizes
from .pressing import Pressed, load_of, term_of


def force_with_friction(
    target: Reaction | Axial | Normal,
    plan: Plan,
    driving: str,
    pressed: Sequence[Pressed],
    sizes: Sizes,
) -> tuple[Named, Transmitted] | None:
    """Return a force at a joint, every friction as large as ``sizes`` says.

    None where equilibrium leaves it open.
    """
    pose, rubs = plan.graph.pose, [p.rub for p in pressed]
    reactions = Reactions(pose, (driving,), lambda loose: [term_of(rub, loose) for rub in rubs])
    transmitted = reactions.of(bond_of(target, pose))
    if transmitted is None:
        return None
    frictions = {load_of(p.rub): _resisting(p, sizes) for p in pressed}

    def along(direction: Angle) -> Formula:
        return _form(transmitted.along(direction), frictions)

    match target:
        case Reaction(part="size"):
            formula: Formula = Call("hypot", (along(Angle()), along(QUARTER)))
        case Reaction(part="direction"):
            formula = Call("atan2", (along(QUARTER), along(Angle())))
        case _:
            formula = along(line_of(target, pose))
    return Named(formula, sizes.definitions), transmitted


def _resisting(pressed: Pressed, sizes: Sizes) -> Formula:
    """Return a friction as a load on its slip: its size, against the sign of the slip."""
    factor, slip = pressed.rub.factor.formula(), Call("sign", (pressed.slip.formula(),))
    size = Symbol(sizes.names[pressed.rub.name])
    return product([(number(-sizes.sense), 1), (factor, 1), (size, 1), (slip, 1)])


def _form(amounts: Mapping[str, Product], frictions: Mapping[str, Formula]) -> Formula:
    kept = {load: amount for load, amount in amounts.items() if amount}
    loads = {load: frictions.get(load, Symbol(load)) for load in kept}
    return total(product([(kept[n].formula(), 1), (load, 1)]) for n, load in loads.items())
