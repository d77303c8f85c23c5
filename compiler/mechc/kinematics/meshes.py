"""What meshes: the rims of wheels, a rack and its wheel, a thread; how fast they slip."""

from typing import assert_never

from ..algebra.angle import Angle
from ..algebra.from_formula import to_product
from ..algebra.product import Product
from ..formula.tree import PI
from ..model.mechanism import Mesh, Rack, Screw, WheelPair
from ..pose.pose import Pose
from .forms import combined, projection, scaled, spin, subtract
from .graph import Form, Graph


def mesh_of(pose: Pose, id: str) -> Mesh:
    """Return the wheels, the rack or the screw of an id."""
    mesh = pose.mechanism.joint(id)
    assert isinstance(mesh, WheelPair | Rack | Screw), "a mesh is of wheels, a rack or a screw"
    return mesh


def rims(mesh: WheelPair, pose: Pose) -> tuple[Product, Product]:
    """Return the radii of two wheels, the second one negative where both turn alike."""
    first, second = pose.radii[mesh.first_radius], pose.radii[mesh.second_radius]
    return first, -second if mesh.same else second


def turning(graph: Graph, link: str, carrier: str) -> Form:
    """Return the rotation of a link relative to what carries it; '' is the ground."""
    own, under = (spin(graph, name) if name else {} for name in (link, carrier))
    return subtract(own, under)


def slipping(graph: Graph, pose: Pose, mesh: Mesh) -> Form:
    """Return the speed at which rims, a rack and its wheel, or nut and thread, part."""
    match mesh:
        case WheelPair():
            first, second = rims(mesh, pose)
            return combined(
                [
                    (first, turning(graph, mesh.first_link, mesh.arm)),
                    (second, turning(graph, mesh.second_link, mesh.arm)),
                ]
            )
        case Rack(point, pivot, link):
            guide = pose.guide_of(point) or Angle()
            ahead = projection(graph.velocities[point], guide)
            rim = scaled(spin(graph, link), pose.radii[mesh.radius])
            return subtract(subtract(ahead, rim), projection(graph.velocities[pivot], guide))
        case Screw(point, pitch, link):
            ahead = projection(graph.velocities[point], pose.guide_of(point) or Angle())
            lead = pose.radii[pitch] / to_product(PI).scaled(2)
            return subtract(ahead, scaled(spin(graph, link), lead))
        case _:
            assert_never(mesh)
