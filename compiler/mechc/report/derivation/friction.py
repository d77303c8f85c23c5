"""How friction comes into a result, body after body, as a teacher would write it."""

from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import assert_never

from ...algebra.from_formula import to_product
from ...algebra.sums import add
from ...base.frozen import replace
from ...formula.operations import count_operations
from ...formula.tree import ZERO, Call, Formula, Product, Sum, Symbol, is_call, product, total
from ...formula.walk import symbols, walk
from ...friction.solution import FrictionSolution, FrictionStep, SolvedWithFriction, StepKind
from ...model.mechanism import (
    Axial,
    LoadForm,
    LoadRatio,
    Rack,
    RopeFriction,
    WithFriction,
    tension_share,
)
from ...model.parts.targets import Sense, drives_from_below, drives_the_return, whole
from ...model.result import FrictionResult, Result
from ...pose.pose import Pose
from ...power.balance import AlgebraicResult
from ...study.analysis import Analysis
from ..kinds import SentenceKind
from ..sentences.order import geometry_first, positive_first
from ..steps import Equation, Explanation, Paragraph
from .earlier import EarlierSteps, driving, ending, renamed

_LINES: Mapping[str, SentenceKind] = {
    "internal": SentenceKind.INTERNAL_TANGENT,
    "external": SentenceKind.EXTERNAL_TANGENT,
    "parallel": SentenceKind.PARALLEL,
    "single": SentenceKind.SINGLE,
    "face": SentenceKind.FACE,
}

_OF_JOINTS: Mapping[tuple[StepKind, bool], SentenceKind] = {
    ("added", False): SentenceKind.ADDED_BY_FRICTION,
    ("added", True): SentenceKind.ADDED_BY_FRICTION,
    ("rod part", True): SentenceKind.PART_ALONG_ROD,
    ("rod part", False): SentenceKind.WHOLE_OF_ROD,
    ("normal part", False): SentenceKind.PART_ALONG_NORMAL,
    ("across", False): SentenceKind.ACROSS,
    ("balance", False): SentenceKind.BALANCE,
}

_AT_PINS = ("internal", "external", "parallel", "single")

_FORCE = Symbol("n")
_SIZES = {"sizes": _FORCE}
_RATIO = Call("exp", (product([(Symbol("mu"), 1), (Symbol("theta"), 1)]),))
_ROPE: Mapping[str, Formula] = {"ratio": _RATIO, "angle": Symbol("theta")}
_TENSIONS = Paragraph(SentenceKind.ROPE_FRICTION, formulas=_ROPE)
_SMALLER = Paragraph(SentenceKind.ROPE_SMALLER, formulas={"force": Symbol("S")})
_MEAN = Paragraph(SentenceKind.ROPE_MEAN, formulas={"part": tension_share(_RATIO)})
_SPEED = Symbol("v")
_STRAIGHT = {"force": _FORCE, "speed": _SPEED}


def of_friction(solution: FrictionSolution, results: Sequence[Analysis]) -> Iterator[Explanation]:
    """Yield an account of every result with friction that was found in steps.

    ``results`` are these in the form in which they are shown.
    """
    pose = solution.plan.graph.pose
    iterated = (d for r in results for d in r.where if d.name in r.inside)
    earlier = EarlierSteps(pose.mechanism, iterated)
    for place, group in groupby(solution.solved, _place):
        solved = tuple(s for s in group if isinstance(s, SolvedWithFriction))
        if place is not None and solved and solved[0].steps:
            yield _explanation(place, solved, results, pose, earlier)


def _explanation(
    place: WithFriction,
    solved: Sequence[SolvedWithFriction],
    results: Sequence[Analysis],
    pose: Pose,
    earlier: EarlierSteps,
) -> Explanation:
    """Return the account of a quantity, and note what it says among the ``earlier`` steps."""
    names = tuple(s.result.name for s in solved)
    if any(exact_name(r, results) for r in results if r.name in names):
        return Explanation(names, (Paragraph(SentenceKind.FIRST_ORDER_SAME),))
    if solved[0].steps[0].kind == "iterated" and not _are_iterated(names, results):
        return Explanation(names, ())
    steps = earlier.enter_forces(_steps(solved), place, names[0])
    steps = [_with_result(step, place, names[0]) for step in steps]
    known = earlier.multiplied(steps) if driving(place) is None else None
    steps = [steps[-1]] if known else earlier.enter_equations(steps, place)
    paragraphs = [*_times_the_load(*known, earlier)] if known else []
    paragraphs += [p for step in steps for p in _paragraphs(step, earlier, place, names[0])]
    first = solved[0].result
    if steps[0].kind == "iterated" and driving(place):
        shown = next(r for r in results if r.name == names[0])
        powers = _powers(place, [d.name for d in shown.where], earlier)
        paragraphs += earlier.enter_sentences(powers)
    return Explanation(names, (*_opening(place, first, steps, pose, earlier), *paragraphs))


def _times_the_load(
    load: Symbol, forces: Iterable[Equation], earlier: EarlierSteps
) -> Iterator[Paragraph]:
    """Yield the forces that follow from those per unit of a load, those that are not stated yet."""
    if lines := tuple(earlier.enter_lines(forces)):
        yield Paragraph(SentenceKind.TIMES_THE_LOAD, lines, formulas={"load": load})


def _steps(solved: Sequence[SolvedWithFriction]) -> Sequence[FrictionStep]:
    """Return the steps to all parts of one force: the last one has an equation for each."""
    (*before, last), others = solved[0].steps, solved[1:]
    parts = [e for other in others for e in other.steps[-1].equations]
    return (*before, replace(last, equations=tuple(dict.fromkeys((*last.equations, *parts)))))


def _place(solved: AlgebraicResult | SolvedWithFriction) -> WithFriction | None:
    """Return the quantity of a result with friction, the same for all parts of one force."""
    target = solved.result.target and whole(solved.result.target)
    return target if isinstance(target, WithFriction) else None


def _are_iterated(names: Sequence[str], results: Iterable[Analysis]) -> bool:
    """Return whether results show anything of what is iterated: a force may rest on no friction."""
    for result in results:
        if result.name in names:
            formulas = (result.formula, *(d.formula for d in result.stated))
            if result.inside & symbols(*formulas):
                return True
    return False


MULTIPLIED = 24
"""Formulas of more operations are equal only as they are written."""


def exact_name(result: Result, results: Iterable[Result]) -> str:
    """Return the name of the exact result that a result of first order is equal to, or ''."""
    target = result.target
    if not isinstance(target, WithFriction) or target.order != "first":
        return ""
    exact = replace(target, order="exact")
    found = (r.name for r in results if r.target == exact and _are_equal(r.formula, result.formula))
    return next(found, "")


def _are_equal(one: Formula, other: Formula) -> bool:
    """Return whether two formulas are equal, multiplied out where they are short."""
    if one == other:
        return True
    if max(map(count_operations, (one, other))) > MULTIPLIED:
        return False
    return not add((to_product(one), -to_product(other)))


_BESIDE_THE_LOAD = ("first order", "iterated", "efficiency")
"""Steps in which a load has its own name for what it is without friction."""


def _with_result(step: FrictionStep, asked: WithFriction, result: str) -> FrictionStep:
    """Return a step in which a load that is asked for has the name that it has with friction."""
    drive = driving(asked)
    if drive is None or not isinstance(asked.of, LoadForm) or step.kind in _BESIDE_THE_LOAD:
        return step
    return renamed(step, {drive.name: Symbol(result)})


# ------------------------------------------------------------------------------- opening


_WAYS: Mapping[Sense, SentenceKind] = {
    "tightening": SentenceKind.TIGHTENING,
    "releasing": SentenceKind.RELEASING,
}
_HELD_BACK: Mapping[Sense, SentenceKind] = {
    "tightening": SentenceKind.TIGHTENING_HELD_BACK,
    "releasing": SentenceKind.RELEASING_HELD_BACK,
}
_NEGATIVE: Mapping[SentenceKind, SentenceKind] = {
    SentenceKind.TIGHTENING_HELD_BACK: SentenceKind.TIGHTENING_NEGATIVE,
    SentenceKind.RELEASING: SentenceKind.RELEASING_NEGATIVE,
}
"""What is said of a drive that acts against its arrow."""

_RETURNS: Mapping[Sense, SentenceKind] = {
    "tightening": SentenceKind.TIGHTENING_THE_RETURN,
    "releasing": SentenceKind.RELEASING_THE_RETURN,
}


def _opening(
    target: WithFriction,
    result: FrictionResult,
    steps: Sequence[FrictionStep],
    pose: Pose,
    earlier: EarlierSteps,
) -> Iterator[Paragraph]:
    """Yield which way friction acts, how, and what forces are measured by."""
    kind = steps[0].kind
    if kind in ("efficiency", "unloaded"):
        return
    drive = driving(target)
    if drive is not None and kind != "first order":
        yield _way(target, result, drive)
    if kind not in ("first order", "straight", "ropes", "iterated"):
        yield from earlier.enter_sentences(_how(steps, pose))
    elif any(isinstance(joint, RopeFriction) for joint in pose.mechanism.friction.joints):
        is_mean = kind in ("first order", "iterated")
        yield from earlier.enter_sentences([_TENSIONS, _MEAN if is_mean else _SMALLER])
    if isinstance(target.of, LoadRatio):
        yield _unit_of_forces(target.of, steps, result.name)
    elif drive is None:
        yield from earlier.enter_sentences(_loads(target, steps, pose))


def _way(target: WithFriction, result: FrictionResult, drive: Formula) -> Paragraph:
    """Return which way the mechanism moves, and which load drives it at the values given."""
    is_by_other = drives_from_below(target, result.name, result.driven)
    ways = _HELD_BACK if result.driven else _WAYS
    if drives_the_return(target, result.driven, result.default):
        ways = _WAYS if is_by_other else _RETURNS
    elif is_by_other and isinstance(target.of, LoadRatio):
        named = {"drive": Symbol(target.of.below), "load": drive}
        return Paragraph(SentenceKind.RELEASING_BY_LOAD, formulas=named)
    way = ways[target.sense]
    if result.default is not None and result.default < 0:
        way = _NEGATIVE.get(way, way)
    return Paragraph(way, formulas={"drive": drive})


def _loads(target: WithFriction, steps: Sequence[FrictionStep], pose: Pose) -> Iterator[Paragraph]:
    """Yield what the loads are that have a name of their own with friction, and no result."""
    met = _met(steps) - {find.name for find in pose.mechanism.finds}
    for load in pose.mechanism.loads:
        whole = load.name + ending(target)
        if whole in met:
            formulas = {"load": Symbol(load.name), "whole": Symbol(whole)}
            yield Paragraph(SentenceKind.LOAD_WITH_FRICTION, formulas=formulas)


def _unit_of_forces(asked: LoadRatio, steps: Sequence[FrictionStep], result: str) -> Paragraph:
    """Return the paragraph on the unit of forces, and on the driving load if it is met then."""
    names, drive = {"load": (asked.below,)}, Symbol(asked.above)
    if drive.name not in _met(steps):
        return Paragraph(SentenceKind.UNIT, names=names)
    formulas = {"drive": drive, "ratio": Symbol(result)}
    return Paragraph(SentenceKind.UNIT_AND_DRIVE, names=names, formulas=formulas)


def _how(steps: Sequence[FrictionStep], pose: Pose) -> Iterator[Paragraph]:
    """Yield how each kind of friction resists, which forces have names, and which part is meant."""
    mechanism = pose.mechanism
    radii = [d.name for step in steps for d in step.defined if d.name.startswith("rho")]
    if any(step.kind in _AT_PINS or (step.kind == "lever" and step.sense) for step in steps):
        circle = Symbol(radii[0] if len(radii) == 1 else "rho")
        yield Paragraph(SentenceKind.PIN_FRICTION, formulas={"radius": circle})
    if any(map(_has_friction_along, steps)):
        yield Paragraph(SentenceKind.GUIDE_FRICTION)
    used = _met(steps)
    if any(f"S_{link.name}" in used for link in mechanism.links):
        yield Paragraph(SentenceKind.ROD_FORCES, formulas={"force": Symbol("S")})
    turned = {step.body for step in steps if step.kind == "face"}
    for touch in pose.contacts:
        force = Symbol(f"R_{touch.point}")
        if force.name in used and touch.point not in turned:
            names = {"point": (touch.point,), "link": (touch.body,)}
            yield Paragraph(SentenceKind.FORCE_OF_TOUCH, names=names, formulas={"force": force})
    for rack in mechanism.each(Rack):
        force, joint = Symbol(f"S_{rack.point}"), {"pivot": (rack.pivot,), "point": (rack.point,)}
        if force.name in used:
            yield Paragraph(SentenceKind.FORCE_OF_RACK, names=joint, formulas={"force": force})
    if mechanism.symmetries:
        yield Paragraph(SentenceKind.PART)


def _met(steps: Iterable[FrictionStep]) -> frozenset[str]:
    """Return the names in the equations of steps."""
    sides = (side for step in steps for pair in step.equations for side in pair)
    return symbols(*sides)


def _has_friction_along(step: FrictionStep) -> bool:
    return step.kind == "slider" and step.equations[0][1] != ZERO


def _sentence_along(step: FrictionStep) -> SentenceKind:
    """Return the sentence of the forces along a guide."""
    has_friction = _has_friction_along(step)
    return SentenceKind.ALONG_WITH_FRICTION if has_friction else SentenceKind.ALONG


# ----------------------------------------------------------------------------- paragraphs


def _paragraphs(
    step: FrictionStep, earlier: EarlierSteps, asked: WithFriction, result: str
) -> Iterator[Paragraph]:
    """Yield the paragraphs of a step; the load that is asked for is left to the result."""
    new = earlier.enter(step)
    sides = ([geometry_first(side, earlier.turns) for side in pair] for pair in step.equations)
    equations = [Equation(_ordered(left), right) for left, right in sides]
    if new is None:
        if step.kind == "iterated":
            again = (SentenceKind.ITERATED_AGAIN, SentenceKind.ITERATED_ALONE_AGAIN)
            yield Paragraph(again[bool(step.body)], tuple(equations), formulas=_SIZES)
        return
    solved = {driving(asked)} if step.kind in _BESIDE_THE_LOAD else {driving(asked), Symbol(result)}
    found = [e for e in equations if e.left not in solved] or equations[:1]
    if step.kind == "first order":
        yield from _first_order((*new, *found), asked, earlier)
    elif step.kind == "straight" or step.kind == "ropes":
        sentence = SentenceKind.ROPES if step.kind == "ropes" else _of_frictions(equations)
        lines = tuple(earlier.enter_lines(_by_name([*new, *equations])))
        yield from earlier.enter_sentences(_of_meshes(lines, _STRAIGHT, earlier))
        yield Paragraph(sentence, lines, formulas=_STRAIGHT)
    elif step.kind == "pressing":
        pressing = {"force": _FORCE}
        yield from _of_meshes(equations, pressing, earlier)
        yield Paragraph(SentenceKind.PRESSING, tuple(equations), formulas=pressing)
    elif step.kind == "iterated":
        yield _iterated(equations, bool(step.body), earlier.named)
    else:
        yield from _of_step(step, new, equations, found, isinstance(asked.of, Axial))


def _of_step(
    step: FrictionStep,
    new: Sequence[Equation],
    equations: Sequence[Equation],
    found: Sequence[Equation],
    of_rod: bool,
) -> Iterator[Paragraph]:
    """Yield the paragraphs of a step that says nothing of earlier ones.

    ``new`` are its definitions, ``found`` what it gives; ``of_rod``: a force in a rod is asked for.
    """
    match step.kind:
        case "internal" | "external" | "parallel" | "single":
            names = {"link": (step.body,), "point": (step.pivot,)}
            rod = SentenceKind.IN_COMPRESSION if step.sense > 0 else SentenceKind.IN_TENSION
            yield Paragraph(rod, names=names)
            yield Paragraph(_LINES[step.kind], tuple(new), names)
        case "face":
            force = {"force": Symbol(f"R_{step.body}")}
            yield Paragraph(SentenceKind.FACE, tuple(new), {"point": (step.body,)}, force)
        case "lever":
            yield from _moments(step, new, found)
        case "slider":
            balanced = (*found[:1], *new, *found[1:])
            yield Paragraph(_sentence_along(step), balanced, {"point": (step.body,)})
        case "pin":
            yield Paragraph(SentenceKind.PIN_OF_RODS, (*found, *new), {"point": (step.body,)})
        case "efficiency":
            yield Paragraph(SentenceKind.EFFICIENT, tuple(equations))
        case "first order" | "straight" | "ropes" | "pressing" | "iterated":
            raise AssertionError("what earlier steps have said counts there")
        case "unloaded":
            yield Paragraph(SentenceKind.UNLOADED)
        case "added" | "rod part" | "normal part" | "across" | "balance":
            yield _of_joint(step, equations, of_rod)
        case _:
            assert_never(step.kind)


def _iterated(equations: Sequence[Equation], is_alone: bool, named: Container[str]) -> Paragraph:
    """Return the equations of forces that are iterated, in words where they are long.

    Their parts have letters by which the description has ``named`` nothing, such as a radius r.
    """
    if equations:
        kinds = (SentenceKind.ITERATED_EQUATIONS, SentenceKind.ITERATED_EQUATION)
        return Paragraph(kinds[is_alone], tuple(equations), formulas=_SIZES)
    kinds = (SentenceKind.ITERATED, SentenceKind.ITERATED_ALONE)
    parts, matrix = (
        Symbol(next(letter for letter in letters if letter not in named))
        for letters in (_COMPONENTS, _MATRICES)
    )
    changes = product([(matrix, 1), (_FORCE, 1)])
    whole = Call("abs", (total([parts, changes]),))
    formulas = {**_SIZES, "parts": parts, "changes": changes, "whole": whole}
    return Paragraph(kinds[is_alone], formulas=formulas)


_COMPONENTS, _MATRICES = ("r", "q", "n_0"), ("D", "C", "K", "Delta")
"""Letters of the forces without friction, and of what friction changes in them; others if taken."""


def _by_name(equations: Sequence[Equation]) -> tuple[Equation, ...]:
    """Return equations in which what is equal to an earlier quantity is so by the name of that."""
    named: dict[Formula, Formula] = {}
    found: list[Equation] = []
    for left, right in equations:
        is_named = isinstance(left, Symbol) and isinstance(right, Sum | Product)
        known = named.setdefault(right, left) if is_named else left
        found.append(Equation(left, right if known == left else known))
    return tuple(found)


def _of_joint(step: FrictionStep, equations: Sequence[Equation], of_rod: bool) -> Paragraph:
    """Return how a force at a joint follows from what is solved."""
    names = {"link": (step.body,), "point": (step.pivot,)} if step.body else {}
    whole = {"rod part": "S_", "normal part": "R_"}.get(step.kind, "")
    met = (n for e in equations for n in symbols(e.right) if n.startswith(whole))
    formulas = {}
    if whole and equations:
        formulas = {"whole": Symbol(next(met, whole)), "force": equations[0].left}
    sentence = _OF_JOINTS[step.kind, of_rod]
    return Paragraph(sentence, tuple(equations), names, formulas)


def _powers(
    asked: WithFriction, names: Sequence[str], earlier: EarlierSteps
) -> Iterator[Paragraph]:
    """Yield how the frictions that are iterated add up, and what their slips are."""
    if asked.sense == "tightening":
        yield Paragraph(SentenceKind.POWERS, formulas={"force": _FORCE})
    yield from _slips(names, _FORCE, earlier)


def _first_order(
    equations: Sequence[Equation], asked: WithFriction, earlier: EarlierSteps
) -> Iterator[Paragraph]:
    """Yield how the frictions of first order add up, and what their slips are."""
    less = asked.sense == "releasing"
    sentence = SentenceKind.FIRST_ORDER_LESS if less else SentenceKind.FIRST_ORDER
    names, force = (e.left.name for e in equations if isinstance(e.left, Symbol)), Symbol("r")
    slips = earlier.enter_sentences(_slips([*names], force, earlier))
    paragraphs = (Paragraph(sentence, formulas={"force": force}), *slips)
    yield from paragraphs[:-1]
    yield replace(paragraphs[-1], equations=tuple(equations))


def _slips(names: Sequence[str], force: Symbol, earlier: EarlierSteps) -> Iterator[Paragraph]:
    """Yield what the slips are that have names, and what the ``force`` of a mesh is."""
    meshed = [n for n in names if earlier.is_of_thread(n) or earlier.is_of_rim(n)]
    slips = [(n.partition("_")[0], n.endswith("_face")) for n in names if n not in meshed]
    kinds = {kind for kind, _ in slips}
    if ("Omega", False) in slips:
        yield Paragraph(SentenceKind.SLIP_OF_PIN, formulas={"turn": Symbol("Omega")})
    if ("Omega", True) in slips:
        yield Paragraph(SentenceKind.SLIP_OF_CIRCULAR_SLOT, formulas={"turn": Symbol("Omega")})
    if "v" in kinds:
        yield Paragraph(SentenceKind.SLIP_OF_FACE, formulas={"speed": Symbol("v")})
    yield from _meshes(meshed, {"force": force, "speed": _SPEED}, earlier)


def _of_meshes(
    equations: Iterable[Equation], formulas: Mapping[str, Formula], earlier: EarlierSteps
) -> Iterator[Paragraph]:
    """Yield what the forces of threads and rims are, and their slips where these have names."""
    names = {name for equation in equations for side in equation for name in symbols(side)}
    yield from _meshes(names, formulas, earlier)


def _meshes(
    names: Collection[str], formulas: Mapping[str, Formula], earlier: EarlierSteps
) -> Iterator[Paragraph]:
    """Yield what the forces of threads and rims by these names are."""
    has_slip = "speed" in formulas
    if any(map(earlier.is_of_thread, names)):
        kind = SentenceKind.SLIP_OF_THREAD if has_slip else SentenceKind.PRESSING_OF_THREAD
        yield Paragraph(kind, formulas=formulas)
    if any(map(earlier.is_of_rim, names)):
        kind = SentenceKind.SLIP_OF_RIM if has_slip else SentenceKind.PRESSING_OF_RIM
        yield Paragraph(kind, formulas=formulas)


def _of_frictions(equations: Iterable[Equation]) -> SentenceKind:
    """Return the sentence of frictions along one line each, where each is known by itself or not.

    ``n = W`` is known; ``n - f*n = W`` and ``n = f*n_B + W`` depend on frictions.
    """
    forces = [e for e in equations if any(map(_is_pressing, symbols(e.left)))]
    known = all(isinstance(e.left, Symbol) for e in forces)
    own = any(map(_is_pressing, symbols(*(e.right for e in forces))))
    return SentenceKind.STRAIGHT_KNOWN if known and not own else SentenceKind.STRAIGHT


def _is_pressing(name: str) -> bool:
    return name.startswith("n_")


def _moments(
    step: FrictionStep, new: Sequence[Equation], found: Sequence[Equation]
) -> Iterator[Paragraph]:
    """Yield the moments about a pivot, and what they give where they had to be squared."""
    turns = {1: SentenceKind.TURNS_LEFT, -1: SentenceKind.TURNS_RIGHT}
    names = {"link": (step.body,), "point": (step.pivot,)}
    sentence = turns.get(step.sense, SentenceKind.MOMENTS)
    moments, rest = found[0], [e for e in found[1:] if isinstance(e.left, Symbol)]
    squared = [e for e in found[1:] if e not in rest]
    if not any(is_call(f, "hypot") for f in walk(moments.right)):
        yield Paragraph(sentence, (moments, *new, *rest), names)
        return
    met = _mentioned(moments).union(*map(_mentioned, squared))
    given = [e for e in new if e.left in met and not _is_root(e.right)]
    yield Paragraph(sentence, (moments, *given), names)
    solved = [e for e in new if e not in given]
    if squared:
        yield Paragraph(SentenceKind.SQUARED, (*squared, *solved, *rest))


def _mentioned(equation: Equation) -> set[Formula]:
    return {Symbol(name) for side in equation for name in symbols(side)}


def _is_root(formula: Formula) -> bool:
    """Return whether something is, or is defined by, the root of a quadratic equation."""
    return any(is_call(part, "sqrt") for part in walk(formula))


def _ordered(side: Formula) -> Formula:
    return total(positive_first(side.terms)) if isinstance(side, Sum) else side
