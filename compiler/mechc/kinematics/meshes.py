"""What meshes: the rims of wheels, a rack and its wheel, a thread, a rope; how fast they slip."""

from collections.abc import Mapping
from itertools import pairwise

from ..algebra.from_formula import to_product
from ..algebra.product import Product
from ..formula.tree import PI
from ..model.mechanism import Feed, Mesh, Meshing, Rope, WheelPair
from ..pose.pose import Pose
from .forms import projection, scaled, spin, subtract
from .graph import Form, Graph, Velocity


def mesh_of(pose: Pose, id: str) -> Mesh | Rope:
    """Return the wheels, the rack, the screw or the rope of an id."""
    mesh = pose.mechanism.joint(id)
    assert isinstance(mesh, Meshing | Rope), "no other joint meshes"
    return mesh


def rims(mesh: WheelPair, pose: Pose) -> tuple[Product, Product]:
    """Return the radii of two wheels, the second one negative where both turn alike."""
    first, second = pose.radii[mesh.first_radius], pose.radii[mesh.second_radius]
    return first, -second if mesh.same else second


def lead(feed: Feed, pose: Pose) -> Product:
    """Return how far a link moves a point while it turns by a radian, as the guide points."""
    way = pose.radii[feed.way]
    return way / to_product(PI).scaled(2) if feed.is_per_turn else way


def travel(feed: Feed, pose: Pose, velocities: Mapping[str, Velocity], turn: Form) -> Form:
    """Return V of the point along its guide, less ω · lead, less that of what it is seen from."""
    along = pose.moved_along(feed.point)
    ahead = subtract(projection(velocities[feed.point], along), scaled(turn, lead(feed, pose)))
    base = velocities[feed.base] if feed.base else ()
    return subtract(ahead, projection(base, along))


def turning(graph: Graph, link: str, carrier: str) -> Form:
    """Return the rotation of a link relative to what carries it; '' is the ground."""
    own, under = (spin(graph, name) if name else {} for name in (link, carrier))
    return subtract(own, under)


def growths(rope: Rope, pose: Pose, velocities: Mapping[str, Velocity]) -> list[Form]:
    """Return the speed at which each fall of a rope grows."""
    ends = zip(pairwise(rope.route), pose.falls[rope.id], strict=True)
    return [
        subtract(projection(velocities[head], way), projection(velocities[tail], way))
        for (tail, head), way in ends
    ]
