"""How fast surfaces slip, as a linear form of the speeds: the sign of it is that of friction.

Pins slip by the turn of one link relative to another, guides and faces by a speed along them,
wheels by that of their rims, threads and collars by that at a radius, ropes by how they overtake
a drum.
"""

from fractions import Fraction

from ..algebra.angle import QUARTER, Angle
from ..algebra.from_formula import to_product
from ..algebra.product import ONE, Product
from ..formula.tree import PI
from ..kinematics import contacts
from ..kinematics.forms import combined, projection, relative_speed, scaled, spin, subtract
from ..kinematics.graph import Graph, LinearForm
from ..kinematics.joint_refs import JointRef
from ..kinematics.release import SpeedReading
from ..model.mechanism import Feed, Rope, RopeFriction, Screw, WheelPair
from ..pose.pose import PointContact, Pose


def along_guide(point: str, guide: Angle) -> SpeedReading:
    """Return the speed of a point along its guide."""
    return lambda graph: projection(graph.velocities[point], guide)


def turning(link: str, carrier: str) -> SpeedReading:
    """Return the rotation of a link relative to what carries its pin."""
    return lambda graph: contacts.turning(graph, link, carrier)


def sliding(contact: PointContact) -> SpeedReading:
    """Return the speed along the face at a contact, as it is at the pose that a graph is of.

    Where the contact is released to find its force, that pose has none at the point.
    """

    def slip(graph: Graph) -> LinearForm:
        at_graph = (t for t in graph.pose.contacts if t.point == contact.point)
        return relative_speed(graph, next(at_graph, contact), contact.normal + QUARTER)

    return slip


def rim(joint: JointRef, pose: Pose) -> SpeedReading:
    """Return the speed of the first wheel's rim, or of a rack."""
    mesh = contacts.mesh_of(pose, joint.of)
    if isinstance(mesh, WheelPair):
        link, radius, arm = mesh.first_link, mesh.first_radius, mesh.arm
        return lambda graph: scaled(contacts.turning(graph, link, arm), pose.radii[radius])
    assert isinstance(mesh, Feed), "a rope has no rim"
    point = mesh.point
    return lambda graph: projection(graph.velocities[point], pose.moved_along(point))


def along_thread(joint: JointRef, diameter: Product, pose: Pose) -> SpeedReading:
    """Return v·p/(πd) + ω·d/2: what the axial force times μ does work with.

    With tan ψ = p/(πd) a nut slips at v·sin ψ + ω·(d/2)·cos ψ along the thread, and its axial
    force F presses with F/cos ψ.
    """
    screw = contacts.mesh_of(pose, joint.of)
    assert isinstance(screw, Screw), "a thread is on a screw"
    slope = lead_slope(screw, diameter, pose)

    def slip(graph: Graph) -> LinearForm:
        ahead = projection(graph.velocities[screw.point], pose.moved_along(screw.point))
        round_ = scaled(spin(graph, screw.link), -diameter.scaled(Fraction(1, 2)))
        return subtract(scaled(ahead, slope), round_)

    return slip


def lead_slope(screw: Screw, diameter: Product, pose: Pose) -> Product:
    """Return tan ψ = p/(πd) of a thread."""
    return pose.radii[screw.pitch] / (to_product(PI) * diameter)


def on_collar(joint: JointRef, radius: Product, pose: Pose) -> SpeedReading:
    """Return the speed at which a collar slides at its mean radius."""
    screw = contacts.mesh_of(pose, joint.of)
    assert isinstance(screw, Screw), "a collar is on a screw"
    return at_radius(screw.link, radius)


def at_radius(link: str, radius: Product) -> SpeedReading:
    """Return the speed at a radius of a link that turns."""
    return lambda graph: scaled(spin(graph, link), radius)


def along_rope(given: RopeFriction, pose: Pose) -> SpeedReading:
    """Return how fast a drum overtakes the rope around it, or the rope runs back.

    Friction in the rope adds half of itself behind the pulley and takes half in front of it:
    what presses then is the mean of both tensions.
    """
    rope = contacts.mesh_of(pose, given.joint)
    assert isinstance(rope, Rope), "friction of a rope is on a rope"
    half = Product(Fraction(1, 2))

    def slip(graph: Graph) -> LinearForm:
        each = enumerate(contacts.growths(rope, pose, graph.velocities))
        back = combined((half if i < given.place else -half, growth) for i, growth in each)
        if given.reach is None:
            return back
        return combined([(ONE, back), (pose.radii[given.reach], spin(graph, given.link))])

    return slip
