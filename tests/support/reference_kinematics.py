"""A second way from a description to its results, for tests only.

Every rigid body has three velocity unknowns; pins, guides and the ground are rows of
one matrix; its null space by singular values is the motion. The loads are those for
which no motion has power. Nothing here is algebra, and nothing is taken in an order.
"""

import math
from collections.abc import Iterator
from random import Random

import numpy as np
import numpy.typing as npt

from mechc.compilation import Compilation
from mechc.routine.evaluate import evaluate as run
from mechc.syntax import ast
from reference_geometry import (
    Action,
    Arms,
    Assembly,
    Values,
    arms_of,
    assemble,
    defaults,
    defined,
    evaluate,
    every,
    known_spread,
    points_of,
)

Array = npt.NDArray[np.float64]

GRAVITY = 9.80665
TOLERANCE = 1e-9
LOAD = 1.3
"""What loads without a value are taken to be."""


class Motion:
    """All motions of an assembly: a basis of velocities that its joints allow."""

    def __init__(self, assembly: Assembly) -> None:
        self.assembly = assembly
        self.column = {name: 3 * i for i, name in enumerate(assembly.links)}
        self.size = 3 * len(self.column)
        self.basis = null_space(np.array(list(self._rows())))

    def velocity(self, point: str, link: str | None = None) -> Array:
        """Return the 2-row matrix that gives a point's velocity from the unknowns."""
        links = self.assembly.links
        name = link or next(n for n, points in links.items() if point in points)
        return self._velocity_at(name, links[name][point])

    def _velocity_at(self, name: str, arm: complex) -> Array:
        matrix = np.zeros((2, self.size))
        if not name:
            return matrix
        at = self.column[name]
        matrix[0, at], matrix[0, at + 2] = 1, -arm.imag
        matrix[1, at + 1], matrix[1, at + 2] = 1, arm.real
        return matrix

    def turning(self, link: str) -> Array:
        """Return the row that gives a link's angular velocity."""
        row = np.zeros(self.size)
        row[self.column[link] + 2] = 1
        return row

    def _rows(self) -> Iterator[Array]:
        first: dict[str, str] = {}
        for name, points in self.assembly.links.items():
            for point in points:
                home = first.setdefault(point, name)
                if home != name:
                    yield from self.velocity(point, name) - self.velocity(point, home)
        for point in self.assembly.pivots & first.keys():
            yield from self.velocity(point)
        for point, along in self.assembly.guides.items():
            yield np.array([-along.imag, along.real]) @ self.velocity(point)

        for name, along in self.assembly.slides.items():
            yield self.turning(name)
            first = next(iter(self.assembly.links[name]))
            yield np.array([-along.imag, along.real]) @ self.velocity(first, name)
        for pin, body, normal, place in self.assembly.contacts:
            own = self.velocity(pin) - self._velocity_at(body, place)
            yield np.array([normal.real, normal.imag]) @ own
        for first, at, second, there, along in (pair[:5] for pair in self.assembly.rollings):
            gap = self._velocity_at(first, at) - self._velocity_at(second, there)
            yield np.array([along.real, along.imag]) @ gap
        for pulls in self.assembly.ropes:
            moved = pulls.keys() - self.assembly.pivots
            yield sum(
                np.array([pulls[p].real, pulls[p].imag]) @ self.velocity(p) for p in sorted(moved)
            )

    def power(self, load: Action) -> Array:
        """Return the power of one unit of a load in each basic motion."""
        if load.direction is None:
            return load.times * self.turning(load.at) @ self.basis
        line = np.array([load.direction.real, load.direction.imag])
        return load.times * line @ self.velocity(load.at) @ self.basis


def null_space(matrix: Array) -> Array:
    """Return an orthonormal basis of the null space, one column each."""
    _, sizes, rows = np.linalg.svd(matrix)
    rank = int((sizes > TOLERANCE * sizes[0]).sum())
    return np.asarray(rows[rank:].T)


# ------------------------------------------------------------------------- results


def results(
    file: ast.File, at: Values | None = None, seed: int = 1, arms: Arms | None = None
) -> Values:
    """Return every ``find`` and ``let`` of a description but forces at joints, by name, in SI.

    ``at`` replaces default values; ``seed`` chooses the lengths that are not given.
    An unnamed ``find`` goes by the name of the load it asks for. ``arms`` are the vectors
    between points where not the description has them.
    """
    values = defined(file, at) if at else defaults(file)
    motion = Motion(assemble(file, values, seed, arms))
    known = _known_loads(file, values)
    for item in file.statements:
        if isinstance(item, ast.Find) and not _is_joint_force(item):
            name, value = _found(file, item, motion, values | known)
            values[name] = value
        elif isinstance(item, ast.Let) and _computable(item.value, values | known):
            values[item.name.text] = evaluate(item.value, values | known)
    return values


def refuted(file: ast.File, compilation: Compilation, seed: int) -> Iterator[str]:
    """Yield where code has another result without friction, at the values given and nearby."""
    dice = Random(seed)
    given = {p.name.text: defaults(file)[p.name.text] for p in every(file, ast.Param)}
    loads = (*every(file, ast.Force), *every(file, ast.Torque))
    given |= {load.name.text: LOAD for load in loads if load.tie is None}
    open_ = {r.name for r in compilation.results if r.default is None}
    for part in (0.01, 0.05) if open_ else (0.0, 0.01, 0.05):
        values = defined(file, {n: v * (1 + dice.uniform(-part, part)) for n, v in given.items()})
        expected = results(file, values)
        for function in compilation.routine.functions:
            known = {i.name: values.get(i.name) for i in function.inputs}
            is_known = not math.isnan(expected.get(function.name, math.nan))
            if is_known and None not in known.values():
                found, there = float(run(function, known)), expected[function.name]
                if not math.isclose(found, there, rel_tol=1e-7, abs_tol=1e-10):
                    yield f"{function.name} is {found}, by the motion {there}, at {values}"


def _computable(node: ast.Expr, values: Values) -> bool:
    try:
        evaluate(node, values)
    except KeyError:
        return False
    return True


def _known_loads(file: ast.File, values: Values) -> Values:
    g = values.get("g", GRAVITY)
    weights = {w.name.text: evaluate(w.mass, values) * g for w in every(file, ast.Weight)}
    return weights | known_spread(file, values, arms_of(file, values))


def _found(file: ast.File, find: ast.Find, motion: Motion, values: Values) -> tuple[str, float]:
    columns = _power_columns(file, motion, values)
    match find.target:
        case ast.Symbol(load):
            return load, _balancing(load, columns, values, _asked(file))
        case ast.Product(((1, ast.Symbol(above)), (-1, ast.Symbol(below)))):
            name = find.name.text if find.name else f"{above}/{below}"
            if above in columns:
                return name, _load_ratio(above, below, columns)
            ratio = _speed(above, motion) / _speed(below, motion)
            return name, ratio if _has_sense(above, motion) and _has_sense(below, motion) else abs(
                ratio
            )
        case _:
            raise AssertionError("a find of the library is a load or a ratio")


def _power_columns(file: ast.File, motion: Motion, values: Values) -> dict[str, Array]:
    """Return the power of each free load in each motion, tied loads with their masters."""
    loads = (*every(file, ast.Force), *every(file, ast.Torque))
    ties = {f.name.text: f.tie for f in loads if f.tie is not None}
    columns: dict[str, Array] = {}
    for load in motion.assembly.actions:
        name, factor = load.name, 1.0
        while name in ties:
            name, part = _master(ties[name], {a.name for a in motion.assembly.actions}, values)
            factor *= part
        empty = np.zeros(motion.basis.shape[1])
        columns[name] = columns.get(name, empty) + factor * motion.power(load)
    return columns


def _master(tie: ast.Expr, loads: set[str], values: Values) -> tuple[str, float]:
    for name in loads:
        at_one, at_two = ({**values, name: value} for value in (1.0, 2.0))
        if _computable(tie, at_one) and evaluate(tie, at_one) != evaluate(tie, at_two):
            return name, evaluate(tie, at_one)
    raise AssertionError("a tie names one load")


IDLE = 1e-12
"""A power of nothing but rounding, where the whole motion is 1."""


def _load_ratio(above: str, below: str, columns: dict[str, Array]) -> float:
    """Return the ratio of two loads that balance; NaN where neither does any work.

    A load on the pin of a pivot has no part in it.
    """
    names = [n for n in columns if n in (above, below) or np.abs(columns[n]).max() > IDLE]
    if max(np.abs(columns[name]).max() for name in (above, below)) < IDLE:
        return math.nan
    balanced = null_space(np.column_stack([columns[name] for name in names]))
    top, bottom = balanced[names.index(above)], balanced[names.index(below)]
    ratios = top / bottom
    assert np.allclose(ratios, ratios[0], rtol=1e-7), "the ratio depends on other loads"
    return float(ratios[0])


def _asked(file: ast.File) -> list[str]:
    """Return the loads that are asked for as linear forms of the others."""
    return [
        f.target.name
        for f in every(file, ast.Find)
        if isinstance(f.target, ast.Symbol) and not _is_joint_force(f)
    ]


def _is_joint_force(find: ast.Find) -> bool:
    return isinstance(find.target, ast.Symbol) and find.target.name[:2] in ("R_", "N_")


def _balancing(load: str, columns: dict[str, Array], values: Values, asked: list[str]) -> float:
    matrix = np.column_stack([columns[name] for name in asked])
    known = (columns[name] * values[name] for name in columns if name not in asked)
    others = sum(known, np.zeros(len(matrix)))
    solution, *_ = np.linalg.lstsq(matrix, -others, rcond=None)
    return float(solution[asked.index(load)])


def _speed(name: str, motion: Motion) -> float:
    """Return ``V_A`` or ``omega_AB``, signed as the language says, in the only motion."""
    assert motion.basis.shape[1] == 1, "speeds are asked of one motion"
    kind, points = name.split("_", 1)
    if kind == "omega":
        wanted = set(points_of(points))
        link = next(n for n, at in motion.assembly.links.items() if wanted <= set(at))
        return float((motion.turning(link) @ motion.basis)[0])
    vx, vy = (motion.velocity(points) @ motion.basis)[:, 0]
    if points in motion.assembly.guides:
        along = motion.assembly.guides[points]
        return float(vx * along.real + vy * along.imag)
    return float(np.hypot(vx, vy)) * _sense(points, motion)


def _sense(point: str, motion: Motion) -> float:
    """Return the sign of the rotation that carries a point about a pivot; +1 without one."""
    link = _about_pivot(point, motion)
    return float(np.sign((motion.turning(link) @ motion.basis)[0])) if link else 1.0


def _about_pivot(point: str, motion: Motion) -> str | None:
    links, pivots = motion.assembly.links, motion.assembly.pivots
    return next((n for n, at in links.items() if point in at and pivots & at.keys()), None)


def _has_sense(name: str, motion: Motion) -> bool:
    kind, points = name.split("_", 1)
    return (
        kind == "omega"
        or points in motion.assembly.guides
        or _about_pivot(points, motion) is not None
    )
