"""Lines ``assembly`` that decide nothing, that the pose refutes, or another line contradicts."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from ..diagnostics import Diagnostic
from ..diagnostics import assembly_lines as messages
from ..model.mechanism import Assembly
from .pose import evaluate_vector
from .tolerances import FLAT_TRIANGLE
from .vectors import Vectors


def remarks(
    assembly: Assembly, vectors: Vectors, values: Mapping[str, float]
) -> Iterator[Diagnostic]:
    """Yield the error of a line that is false at the default pose, or that it decides nothing."""
    points = "".join(assembly.points)
    area = _area(assembly, vectors, values)
    if area is not None and (area > 0) != (assembly.mode == "ccw"):
        yield messages.assembly_refuted(assembly.span, points, "ccw" if area > 0 else "cw")
    else:
        yield messages.assembly_idle(assembly.span, points)


def _area(assembly: Assembly, vectors: Vectors, values: Mapping[str, float]) -> float | None:
    """Return twice the area that three points turn about; None where it is flat, or open."""
    if len(assembly.points) != 3:
        return None
    first, *others = assembly.points
    paths = [vectors.path(first, point) for point in others]
    try:
        (bx, by), (cx, cy) = (evaluate_vector(path or (), values) for path in paths)
    except (KeyError, ZeroDivisionError):
        return None
    area = bx * cy - by * cx
    longest = max(bx * bx + by * by, cx * cx + cy * cy)
    return area if abs(area) > FLAT_TRIANGLE * longest else None


def contradictions(assemblies: Sequence[Assembly]) -> Iterator[Diagnostic]:
    """Yield the assemblies that ask for the opposite of an earlier one."""
    first: dict[tuple[str, ...], Assembly] = {}
    for assembly in assemblies:
        points, mode = _in_order(assembly)
        other = first.setdefault(points, assembly)
        if _in_order(other)[1] != mode:
            named = "".join(assembly.points), "".join(other.points)
            yield messages.assemblies_contradict(assembly.span, *named, other.span)


def _in_order(assembly: Assembly) -> tuple[tuple[str, ...], bool]:
    """Return the points in alphabetical order, and whether they then turn ccw, or are ahead."""
    points = assembly.points
    swaps = sum(a > b for a, b in combinations(points, 2))
    return tuple(sorted(points)), (assembly.mode in ("ccw", "forward")) == (swaps % 2 == 0)
