"""The same k by sympy.physics.mechanics: Kane's method, then ``simplify``.

Written to be as quick as the peer allows: only velocities are constrained, only the
active forces are formed (no inertia), and simplification comes once, at the end.
"""

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, dynamicsymbols

Frame = Any
Dot = Any


def four_bar() -> sp.Expr:
    """Return k of the library's ``four_bar``, in its parameters' names."""
    ground, links, speeds = _links("phi psi theta")
    crank, coupler, rocker = links
    a, b, c, d = sp.symbols("a b c d")
    o1, o2 = _fixed(ground), _fixed(ground)
    end = _along(_along(o1, crank, a, ground), coupler, b, ground)
    gap = end.vel(ground) - _along(o2, rocker, c, ground).vel(ground)
    load = _along(o2, rocker, d, ground)
    return _ratio(ground, speeds, [gap], crank, load, -rocker.y)


def stephenson() -> sp.Expr:
    """Return k of the library's ``stephenson_six_bar``, in its parameters' names.

    The coupler's second arm is at ``sigma``, which turns with ``psi``.
    """
    ground, links, speeds = _links("phi psi theta chi delta")
    crank, coupler, rocker, rod, output = links
    a, b, p, l_2, l_4, l_5, sigma = sp.symbols("a b p l_2 l_4 l_5 sigma")
    arm = ground.orientnew("arm", "Axis", (sigma, ground.z))
    arm.set_ang_vel(ground, coupler.ang_vel_in(ground))
    o1, o2, o3 = (_fixed(ground) for _ in range(3))
    pin = _along(o1, crank, a, ground)
    first = _along(pin, coupler, b, ground).vel(ground) - _along(o2, rocker, l_2, ground).vel(
        ground
    )
    tracer = _along(pin, arm, p, ground)
    load = _along(o3, output, l_5, ground)
    second = _along(tracer, rod, l_4, ground).vel(ground) - load.vel(ground)
    return _ratio(ground, speeds, [first, second], crank, load, -output.y)


def _links(names: str) -> tuple[Frame, list[Frame], list[Any]]:
    ground = ReferenceFrame("N")
    angles = sp.symbols(names)
    speeds = dynamicsymbols(f"u1:{len(angles) + 1}")
    links = [ground.orientnew(f"L{q}", "Axis", (q, ground.z)) for q in angles]
    for link, speed in zip(links, speeds, strict=True):
        link.set_ang_vel(ground, speed * ground.z)
    return ground, links, list(speeds)


def _fixed(ground: Frame) -> Dot:
    point = Point("O")
    point.set_vel(ground, 0)
    return point


def _along(start: Dot, link: Frame, length: sp.Expr, ground: Frame) -> Dot:
    point = start.locatenew("P", length * link.x)
    point.v2pt_theory(start, ground, link)
    return point


def _ratio(
    ground: Frame, speeds: Sequence[Any], gaps: Sequence[Any], crank: Frame, load: Dot, line: Any
) -> sp.Expr:
    coordinates = dynamicsymbols(f"q1:{len(speeds) + 1}")
    method = KanesMethod(
        ground,
        q_ind=list(coordinates),
        u_ind=[speeds[0]],
        u_dependent=list(speeds[1:]),
        kd_eqs=[q.diff() - u for q, u in zip(coordinates, speeds, strict=True)],
        velocity_constraints=[gap.dot(axis) for gap in gaps for axis in (ground.x, ground.y)],
    )
    torque, force = sp.symbols("M F")
    active = method._form_fr([(crank, torque * ground.z), (load, force * line)])[0]
    return sp.simplify(sp.solve(active, torque)[0] / force)
