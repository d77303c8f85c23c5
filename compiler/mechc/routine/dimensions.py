"""What the angles and lengths that loops find measure."""

from ..model.mechanism import Mechanism
from ..units import ANGLE, LENGTH, Dimension
from .steps import Pose


def closed_dimensions(pose: Pose, mechanism: Mechanism) -> dict[str, Dimension]:
    """Return the dimension of each output: a parameter's own, else a length or an angle."""
    own = {p.name: p.dimension for p in mechanism.parameters}
    return {n: own.get(n, LENGTH if n.startswith("len_") else ANGLE) for n in pose.outputs}
