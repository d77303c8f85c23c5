"""The friction between free bodies: at the ends of rods, on pivots, on faces and along guides."""

from ..algebra.angle import HALF_TURN
from ..algebra.product import ZERO, Product
from ..algebra.sums import add
from ..base.named import NamedTuple
from ..kinematics.joint_refs import JointRef, held_end
from ..model.mechanism import Link, Rack
from ..pose.pose import PointContact
from ..power.definitions import bound_names
from .chain_bodies import Bodies, EquationsCoupled
from .friction_pairs import LoadedPair


class Surface(NamedTuple):
    """Friction of a body at a joint: its factor, its slip, and 1, or -1 for a slip turned round.

    ``across`` is, of a face or of teeth, the ideal force that presses there.
    """

    name: str
    factor: Product
    slip: Product
    turn: int = 1
    across: Product = ZERO


def of_rod(bodies: Bodies, rod: Link, point: str) -> Surface | None:
    """Return the friction of a rod at one of its ends: in what carries the pin, or about it."""
    own = bodies.loaded.get(JointRef("pin", point, rod.name))
    if own:
        return _surface(own)
    others = [p for b, p in bodies.loaded.items() if b.kind == "pin" and b.point == point]
    if bodies.carriers.get(point) != rod.name or not others:
        return None
    if len(others) > 1 or _is_loaded_otherwise(bodies, point):
        raise EquationsCoupled
    return _surface(others[0])._replace(turn=-1)


def _is_loaded_otherwise(bodies: Bodies, point: str) -> bool:
    """Return whether a pin has a guide, or is on a lever and in a slot or contact.

    Then two links press one another at the pin with other forces than it has from them.
    """
    slides = bool(bodies.mechanism.slides_at(point))
    turning = any(point in k.points for k in bodies.levers.values())
    touching = any(contact.point == point for contact in bodies.pose.contacts)
    return point in bodies.guides or slides or (turning and touching)


def of_face(bodies: Bodies, contact: PointContact) -> Surface | None:
    """Return the friction of a pin on the body under it, with the ideal force on the pin."""
    found = bodies.loaded.get(JointRef("contact", contact.point))
    if found is None:
        return None
    (component,) = found.components
    return _surface(found)._replace(across=component.ideal)


def of_rack(bodies: Bodies, rack: Rack) -> Surface | None:
    """Return the friction of a rack's teeth, with the ideal force of the gear on the rack."""
    found = bodies.loaded.get(JointRef("mesh", rack.point, rack.id))
    if found is None:
        return None
    (component,) = found.components
    return _surface(found)._replace(across=component.ideal)


def at_pin(bodies: Bodies, point: str) -> bool:
    """Return whether any pair of surfaces with friction is at the pin of a point."""
    return any(b.kind == "pin" and b.point == point for b in bodies.loaded)


def of_pivot(bodies: Bodies, lever: str) -> Surface | None:
    """Return the friction of a lever on its pivot."""
    found = bodies.loaded.get(JointRef("pin", bodies.pivot(lever), lever))
    return _surface(found) if found else None


def of_guide(bodies: Bodies, body: str) -> Surface | None:
    """Return the friction on the guide of a slider or slide."""
    joint_refs = [
        JointRef("ground", body),
        *(JointRef("slide", p, body) for p in bodies.points(body)),
    ]
    found = next((bodies.loaded[b] for b in joint_refs if b in bodies.loaded), None)
    return _surface(found) if found else None


def compression(bodies: Bodies, rod: Link) -> Product:
    """Return the ideal force by which a rod is pressed.

    Raises :class:`EquationsCoupled` where that is not known, or is a long sum.
    """
    end = held_end(bodies.mechanism, rod)
    found = bodies.task.reactions.of(JointRef("pin", end, rod.name))
    if found is None:
        raise EquationsCoupled
    outwards = bodies.vector(rod)[0]
    along = found.along(outwards if end == rod.points[1] else outwards + HALF_TURN)
    force = -add(along[n] * size for n, size in bodies.task.given.items() if n in along)
    if any(bound_names(force)):
        raise EquationsCoupled
    return force


def _surface(loaded: LoadedPair) -> Surface:
    return Surface(loaded.pair.name, loaded.pair.factor, loaded.slip)
