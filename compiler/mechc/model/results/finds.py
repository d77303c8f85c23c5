"""Results asked for with ``find``: ratios of loads or velocities, and single loads."""

from collections.abc import Iterator

from ...base.named import NamedTuple
from ...diagnostics.model import reactions as reaction_words
from ...diagnostics.model import results as messages
from ...syntax import ast
from ...units import FREQUENCY, NUMBER, VELOCITY, Dimension
from ..mechanism import (
    Efficiency,
    Find,
    ForceAtJoint,
    LoadForm,
    LoadRatio,
    ResultTarget,
    Sense,
    Speed,
    SpeedRatio,
    WithFriction,
)
from ..names.forms import COORDINATES, ReservedName, form_of, form_of_pose
from ..names.scope import NameScope, ScopeEntry
from ..parts.linkage import PRIME
from ..parts.targets import HOLDING, WITH_FRICTION
from ..statements import every, only
from .reactions import read_reaction


class Operand(NamedTuple):
    """A load (by its name) or a velocity in a target, and what it measures."""

    quantity: str | Speed
    dimension: Dimension
    name: str


class AskedTarget(NamedTuple):
    """A target, what it measures, and the name it gets where the user gave none."""

    target: ResultTarget
    dimension: Dimension
    name: str


def read_finds(file: ast.File, scope: NameScope) -> list[Find]:
    """Return every find and enter its name; points and loads are known by now.

    Behind them stand those that friction adds.
    """
    scope.lets = {statement.name.text for statement in every(file, ast.Let)}
    finds = [find for statement in every(file, ast.Find) for find in _read(statement, scope)]
    motion = only(file, ast.Motion)
    sense: Sense = motion.sense if motion else "tightening"
    overridden = bool(every(file, ast.Efficiency))
    has_friction = any(isinstance(s, ast.Friction) for s in file.statements) and not overridden
    if has_friction:
        _remark_on_names(file, scope)
    if has_friction or overridden:
        finds += [
            more for find in finds for more in _with_friction(find, sense, has_friction, scope)
        ]
    return finds


def _remark_on_names(file: ast.File, scope: NameScope) -> None:
    """Say which results have a name as those with friction have, and are the ideal ones."""
    for statement in every(file, ast.Find):
        name = statement.name
        if name is None or not isinstance(statement.target, ast.Product):
            continue
        stems = (name.text.removesuffix(end) for end in WITH_FRICTION if name.text.endswith(end))
        if stem := next(stems, ""):
            scope.report.add(messages.named_as_with_friction(name.span, name.text, stem))


def _with_friction(
    find: Find, sense: Sense, has_friction: bool, scope: NameScope
) -> Iterator[Find]:
    """Yield the load or ratio with friction, to first order, when holding, its efficiency."""
    of = find.target
    if not isinstance(of, LoadRatio | LoadForm | ForceAtJoint):
        return
    dimension = scope.entries[find.name].dimension
    more: list[tuple[str, ResultTarget, Dimension | None]] = [
        (f"{find.name}_f", WithFriction(of, sense), dimension)
    ]
    if isinstance(of, ForceAtJoint):
        more = more if has_friction else []
    elif has_friction:
        more.append((f"{find.name}_f1", WithFriction(of, sense, "first"), dimension))
        if sense == "tightening":
            more.append((f"{find.name}{HOLDING}", WithFriction(of, "releasing"), dimension))
        more.append((f"eta_{find.name}", Efficiency(of, sense), NUMBER))
    for name, target, measure in more:
        if scope.enter(name, ScopeEntry("result", find.span, measure)):
            yield Find(name, target, find.span)


def _read(statement: ast.Find, scope: NameScope) -> Iterator[Find]:
    """Yield the results that one line asks for."""
    target = statement.target
    if isinstance(target, ast.Symbol) and (form := _joint_force(target)):
        yield from _reactions(statement, target, form, scope)
        return
    asked = read_target(target, scope, statement.on)
    if asked is None:
        if statement.name:
            scope.declare(statement.name, "result")
    elif name := _entered(statement, asked, scope):
        yield Find(name, asked.target, target.span)


def _joint_force(symbol: ast.Symbol) -> ReservedName | None:
    form = form_of(symbol.name)
    return form if form and form.prefix in "RN" else None


def _reactions(
    statement: ast.Find, symbol: ast.Symbol, form: ReservedName, scope: NameScope
) -> Iterator[Find]:
    """Enter a force at a joint: ``R_B``, or ``R_B_on_AB`` where the link is named."""
    on = f"_on_{statement.on.text}" if statement.on else ""
    name = statement.name.text if statement.name else symbol.name.replace(PRIME, "p") + on
    for suffix, target, dimension in read_reaction(symbol, form, statement.on, scope):
        entry = ScopeEntry("result", symbol.span, dimension)
        if scope.enter(name + suffix, entry):
            yield Find(name + suffix, target, symbol.span)


def _entered(statement: ast.Find, asked: AskedTarget, scope: NameScope) -> str | None:
    """Enter the name of a find; a load asked for may go by its own."""
    if statement.name and statement.name.text != asked.name:
        entered = scope.declare(statement.name, "result", asked.dimension)
        return statement.name.text if entered else None
    if isinstance(asked.target, LoadForm):
        return asked.name
    entry = ScopeEntry("result", statement.target.span, asked.dimension)
    return asked.name if scope.enter(asked.name, entry) else None


def read_target(
    target: ast.Expr, scope: NameScope, on: ast.Name | None = None
) -> AskedTarget | None:
    """Read what is asked for; None where an error in it was reported."""
    match target:
        case ast.Symbol() as symbol:
            asked = _single(symbol, scope)
        case ast.Product(factors=((1, ast.Symbol() as above), (-1, ast.Symbol() as below))):
            asked = _ratio(above, below, scope)
        case _:
            scope.report.add(messages.not_findable(target.span))
            return None
    if on:
        scope.report.add(reaction_words.link_named_for_nothing(on.span))
    return asked


def _single(symbol: ast.Symbol, scope: NameScope) -> AskedTarget | None:
    """Return a load that is asked for by itself; report a quantity of the pose."""
    form = form_of_pose(symbol.name) if symbol.name not in scope.entries else None
    if form and (form.prefix not in COORDINATES or form.points[0] in scope.points.places):
        is_speed = form.prefix in ("V", "omega")
        ratio = "velocities are asked for as a ratio, as in V_D / V_A"
        hint = ratio if is_speed else f"where things are is a formula: `let place = {symbol.name}`"
        scope.report.add(messages.not_findable(symbol.span, hint))
        return None
    part = _load(symbol, scope, alone=True)
    return AskedTarget(LoadForm(symbol.name), part.dimension, symbol.name) if part else None


def _ratio(above: ast.Symbol, below: ast.Symbol, scope: NameScope) -> AskedTarget | None:
    """Return a ratio of two loads, or of two speeds; report any other."""
    first, second = _part(above, scope), _part(below, scope)
    if first is None or second is None:
        return None
    target: ResultTarget
    match first.quantity, second.quantity:
        case str(p), str(q) if p != q:
            target = LoadRatio(p, q)
        case Speed() as v, Speed() as w if v != w:
            target = SpeedRatio(v, w)
        case _:
            same = first.quantity == second.quantity
            hint = "this ratio is 1" if same else "a load and a velocity have no ratio here"
            scope.report.add(messages.not_findable(above.span.to(below.span), hint))
            return None
    dimension = first.dimension.joined(second.dimension.scaled(-1))
    return AskedTarget(target, dimension, f"{first.name}_over_{second.name}")


def _part(symbol: ast.Symbol, scope: NameScope) -> Operand | None:
    form = form_of(symbol.name)
    return _velocity(symbol, form, scope) if form else _load(symbol, scope)


def _load(symbol: ast.Symbol, scope: NameScope, alone: bool = False) -> Operand | None:
    """Return a load of a target; None where the name is that of something else, reported."""
    entry = scope.entries.get(symbol.name)
    if entry is None and symbol.name in scope.lets:
        scope.report.add(messages.let_asked_for(symbol.span, symbol.name, alone))
        return None
    if entry is None:
        is_speed = symbol.name.startswith(("V_", "omega_"))
        loads = scope.names({"load"})
        points = scope.points.places
        scope.report.add(messages.unknown_load(symbol.span, symbol.name, loads, points, is_speed))
        return None
    if entry.kind != "load" or entry.dimension is None:
        scope.report.add(messages.not_findable(symbol.span, f"'{symbol.name}' is a {entry.kind}"))
        return None
    return Operand(symbol.name, entry.dimension, symbol.name)


def _velocity(symbol: ast.Symbol, form: ReservedName, scope: NameScope) -> Operand | None:
    """Read ``V_D``, ``V_D_x`` or ``omega_OB``."""
    points = ast.Name("".join(form.points), symbol.span)
    identifier = symbol.name.replace(PRIME, "p")
    match form.prefix:
        case "omega":
            link = scope.points.link(points)
            return Operand(Speed("link", link.name), FREQUENCY, identifier) if link else None
        case "V":
            return _point_velocity(points, form, identifier, scope)
        case _:
            scope.report.add(messages.not_findable(symbol.span))
            return None


def _point_velocity(
    point: ast.Name, form: ReservedName, identifier: str, scope: NameScope
) -> Operand | None:
    if not scope.points.acting(point):
        return None
    if point.text in scope.points.fixed:
        scope.report.add(messages.still_point(point.span, point.text))
        return None
    return Operand(Speed("point", point.text, form.axis), VELOCITY, identifier)
