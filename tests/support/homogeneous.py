"""Results with all lengths twice as long: what measures no length must stay as it is.

Whether a formula balances in units is asked of its values, with nothing of the compiler but
what its names measure: a length that stands where a number belongs doubles it. Forces stay,
couples double with their arms.
"""

import math
from collections.abc import Iterator, Mapping
from itertools import count
from random import Random

from mechc.compilation import Compilation
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Constant, Formula, Implicit, Symbol
from mechc.formula.walk import substitute, walk
from mechc.model.result import Result
from mechc.units import ANGLE, Dimension

Values = Mapping[str, float]


def uneven(compilation: Compilation) -> Iterator[str]:
    """Yield results that do not scale as they should, where they have values at all.

    Formulas of the user's own may have numbers in them that are lengths; systems that are solved
    by Newton's method keep the numbers that they were made with.
    """
    mechanism, values = compilation.mechanism, dict[str, float]()
    dimensions = {load.name: load.dimension for load in mechanism.loads}
    for load, value in zip(mechanism.loads, count(3.7), strict=False):
        values[load.name] = value
    for known in (*mechanism.parameters, *mechanism.literals):
        dimensions[known.name] = known.dimension
        if known.value is not None:
            values[known.name] = evaluate(known.value, values)
    for result in filter(_is_scaled, compilation.results):
        once, twice = (_value(result, dimensions, values, scale) for scale in (1.0, 2.0))
        expected = once if result.dimension == ANGLE else once * 2.0 ** _metres(result.dimension)
        if math.isfinite(once) and not math.isclose(twice, expected, rel_tol=1e-6, abs_tol=1e-9):
            yield f"{result.name} is {once}, and {twice} where lengths are doubled"


def _is_scaled(result: Result) -> bool:
    formulas = (result.formula, *(d.formula for d in result.where))
    iterated = any(isinstance(part, Implicit) for f in formulas for part in walk(f))
    return result.target is not None and not iterated


def _metres(dimension: Dimension) -> float:
    """Return the power of a length that is left once newtons are taken out."""
    return float(dimension.length - dimension.mass)


def _value(
    result: Result, dimensions: Mapping[str, Dimension], values: Values, scale: float
) -> float:
    scaled = {n: v * scale ** _metres(dimensions[n]) for n, v in values.items()}
    for name, formula in result.where:
        if name not in scaled:
            scaled[name] = evaluate(_open(formula), scaled)
    return evaluate(_open(result.formula), scaled)


def _open(formula: Formula) -> Formula:
    """Return a formula whose named numbers are symbols like all others."""
    names = {part.name for part in walk(formula) if isinstance(part, Constant)}
    return substitute(formula, {name: Symbol(name) for name in names})


def on_grid(seed: int) -> str:
    """Return a mechanism drawn on a grid of metres, so that lengths are equal to numbers."""
    dice = Random(seed)
    points = [(x, y) for x in range(5) for y in range(-2, 4)]
    places = dict(zip("OACBD", dice.sample(points, 5), strict=True))
    fixed, moving, lines, finds = dice.choice((_four_bar, _crank, _hoist))(dice)
    drawn = [f"pivot {p} at {_place(places[p])}" for p in fixed]
    drawn += [f"{p} at {_place(places[p])}" for p in moving]
    ratio = dice.choice(("M/F", "F/M"))
    asked = ", ".join((f"k = {ratio}", *dice.sample(finds, 2)))
    return "\n".join((*drawn, *lines, f"find {asked}", ""))


def _place(place: tuple[int, int]) -> str:
    return f"({place[0]} m, {place[1]} m)"


Part = tuple[str, str, list[str], list[str]]
"""Points of the ground and moving ones, lines of the description, and forces to ask for."""


def _four_bar(dice: Random) -> Part:
    load = dice.choice(("force F at D along x", "force F at D along -y", "torque F on CBD"))
    lines = ["link OA", "link AB", "link CBD", "torque M on OA", load]
    if dice.random() < 0.3:
        lines.append("friction pins 0.1 diameter 500 mm")
    return "OC", "ABD", lines, ["R_O", "R_C", "N_AB", "R_B on CBD"]


def _crank(dice: Random) -> Part:
    along = dice.choice("xy")
    lines = [f"slider B along {along}", "link OA", "link AB", "torque M on OA"]
    return "O", "AB", [*lines, f"force F at B along {along}"], ["R_O", "N_AB", "N_B"]


def _hoist(dice: Random) -> Part:
    lines = ["link OAB", "slider D along y", "rope A, C, D along -y", "torque M on OAB"]
    load = f"force F at D along {dice.choice(('y', '-y'))}"
    return "OC", "ABD", [*lines, load], ["R_O", "R_C", "N_AC"]
