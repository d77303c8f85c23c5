"""How forces at joints come about: a joint is released, and the powers are written down."""

from collections.abc import Iterator, Sequence, Set
from itertools import groupby

from ...algebra.angle import HALF_TURN
from ...algebra.product import Product
from ...algebra.sums import add, canonical
from ...algebra.trigonometry import cosine, sine
from ...base.frozen import replace
from ...formula.tree import ZERO, Call, Formula, Symbol, product, quotient, total
from ...friction.solution import FrictionSolution, SolvedWithFriction
from ...model.mechanism import Axial, Load, Normal, Reaction
from ...model.result import Definition
from ...pose.pose import Pose, Vector
from ...power.balance import AlgebraicResult, Release, Term
from ...power.definitions import resting_on
from ..kinds import SentenceKind
from ..sentences.order import positive_first
from ..steps import Equation, Explanation, Paragraph
from .notation import direction_formula

_BONDS = {
    "pin": SentenceKind.PIN,
    "slide": SentenceKind.GUIDE,
    "contact": SentenceKind.TOUCH,
    "mesh": SentenceKind.ROPE_RELEASED,
}


def of_forces(solution: FrictionSolution, met: Set[str] = frozenset()) -> Iterator[Explanation]:
    """Yield an account of every force at a joint; its components are explained together.

    Nothing is said of results that were ``met`` elsewhere.
    """
    pose = solution.plan.graph.pose
    opening: tuple[Paragraph, ...] = ()
    explained: set[str] = set()
    for place, group in groupby(solution.solved, _place):
        solved = tuple(s for s in group if isinstance(s, AlgebraicResult))
        if place is None or not solved or solved[0].result.name in met:
            continue
        writer = _ForceWriter(pose, solved, explained)
        if not explained and solved[0].releases:
            opening = (
                Paragraph(SentenceKind.RELEASED, names={"held": solved[0].releases[0].held}),
            )
        paragraphs = (*opening, *writer.paragraphs())
        opening = ()
        explained.update(writer.names)
        yield Explanation(writer.names, paragraphs, tuple(writer.definitions()))


def _place(solved: AlgebraicResult | SolvedWithFriction) -> tuple[str, ...] | None:
    """Return at which joint a force acts; None for any other result."""
    match solved.result.target:
        case Reaction(point, link):
            return ("R", point, link)
        case Axial(link):
            return ("N", link)
        case Normal(point):
            return ("N", point)
        case _:
            return None


class _ForceWriter:
    """Writes the explanation of one force."""

    def __init__(self, pose: Pose, solved: Sequence[AlgebraicResult], explained: Set[str]) -> None:
        mechanism = pose.mechanism
        self._pose, self._mechanism, self._explained = pose, mechanism, explained
        self.names = tuple(s.result.name for s in solved)
        self._target = solved[0].result.target
        self._releases = solved[0].releases
        taken = {p.name for p in mechanism.parameters} | {k.name for k in mechanism.loads}
        self._parting = next(n for n in ("u", "u_r", "u_rel") if n not in taken)
        self._said: list[tuple[Release, list[Product]]] = []

    def paragraphs(self) -> Iterator[Paragraph]:
        """Yield one paragraph for each direction in which the joint is released."""
        releases = self._releases
        if isinstance(self._target, Axial) and self._is_slanting():
            paragraphs = [self._paragraph(release) for release in releases]
            yield from paragraphs[:-1]
            yield replace(paragraphs[-1], equations=(*paragraphs[-1].equations, self._projected()))
            return
        if isinstance(self._target, Axial):
            releases = releases[:1]
        elif self._is_rod():
            yield Paragraph(SentenceKind.ROD, names={"link": (releases[0].of,)})
            releases = releases[:1] if f"N_{releases[0].of}" not in self._explained else ()
        elif isinstance(self._target, Reaction) and len(releases) < 2:
            yield self._one_sided()
        yield from map(self._paragraph, releases)

    def definitions(self) -> Iterator[Definition]:
        """Yield the definitions that the ratios of speeds rest on."""
        found: dict[Definition, None] = {}
        for release, values in self._said:
            formula = total(v.formula() for v in values)
            found.update(dict.fromkeys(resting_on(release.plan, formula, values)))
        yield from found

    def _is_rod(self) -> bool:
        """Return whether all forces on a link act at its two pins."""
        of = self._releases[0].of if self._releases else ""
        link = next((k for k in self._mechanism.links if k.name == of), None)
        return (
            link is not None
            and len(link.points) == 2
            and not any(self._releases[1].amounts.values())
        )

    def _is_slanting(self) -> bool:
        """Return whether a rod's vector is a sum, so that no release is along the rod itself."""
        return len(self._releases) > 1 and len(self._rod(self._releases[0])) > 1

    def _rod(self, release: Release) -> Vector:
        """Return the vector of a rod from its other end to the point of a release."""
        link = self._mechanism.link(release.of)
        other = next(p for p in link.points if p != release.point)
        return self._pose.vector(link.name, other, release.point)

    def _projected(self) -> Equation:
        """Return the force along a slanting rod as what its components have along the rod."""
        ahead = self._releases[0].direction
        arms = self._rod(self._releases[0])
        sides = [
            add(arm.length * turn(arm.angle - ahead) for arm in arms).formula()
            for turn in (cosine, sine)
        ]
        parts = zip(self._releases, sides, strict=True)
        whole = total(product([(side, 1), (self._component(r)[0], 1)]) for r, side in parts)
        return Equation(Symbol(self.names[0]), quotient(whole, Call("hypot", tuple(sides))))

    def _one_sided(self) -> Paragraph:
        """Return the paragraph that says why a force has one component."""
        guided = self._releases and self._releases[0].kind in ("ground", "slide")
        point = self._target.point if isinstance(self._target, Reaction) else ""
        return Paragraph(
            SentenceKind.SMOOTH if guided else SentenceKind.SHARED, names={"point": (point,)}
        )

    # ------------------------------------------------------------------------ releases

    def _paragraph(self, release: Release) -> Paragraph:
        """Return the speeds of the loads that do work once a joint is released, and its force."""
        symbol, way = self._component(release)
        ahead = release.direction if way > 0 else release.direction + HALF_TURN
        direction = {"direction": direction_formula(ahead)}
        here = release.terms[-1]
        motion = next(i for i, speed in enumerate(here.speed) if speed)
        working = [t for t in release.terms[:-1] if t.speed[motion]]
        found = () if symbol.name in self.names else (Equation(symbol, _force(release, way)),)
        names = {"point": (release.point,), "link": (release.of,)}
        if not working:
            return Paragraph(SentenceKind.IDLE, found, names, direction)
        parting = self._parting_of(release)
        ratios = [canonical(t.speed[motion].scaled(way) / here.speed[motion]) for t in working]
        self._said.append((release, ratios))
        speeds = (
            Equation(quotient(_speed(t.load), parting), ratio.formula())
            for t, ratio in zip(working, ratios, strict=True)
        )
        powers = [_power(here, symbol, parting)]
        powers += [_power(t, Symbol(t.load.name), _speed(t.load)) for t in working]
        power = Equation(total(positive_first(powers)), ZERO)
        kind = _BONDS.get(release.kind) or self._on_ground(release.point)
        if arc := self._mechanism.arc_of(release.of):
            kind, names = SentenceKind.CIRCULAR_SLOT_RELEASED, {**names, "link": (arc.link,)}
        formulas = {**direction, "speed": parting, "force": symbol}
        return Paragraph(kind, (*speeds, power, *found), names, formulas)

    def _on_ground(self, point: str) -> SentenceKind:
        fixed = point in self._mechanism.fixed
        return SentenceKind.PIVOT if fixed else SentenceKind.GUIDE

    def _parting_of(self, release: Release) -> Symbol:
        relative = release.kind in ("pin", "contact", "mesh")
        return Symbol(self._parting if relative else f"V_{release.point}")

    def _component(self, release: Release) -> tuple[Symbol, int]:
        """Return the symbol of a component, and -1 if it counts against the release."""
        slanting = isinstance(self._target, Axial) and self._is_slanting()
        if not isinstance(self._target, Reaction) and not slanting:
            name = self.names[0]
            return Symbol(name), self._outwards(release) if isinstance(self._target, Axial) else 1
        if self._is_rod() and not slanting:
            return Symbol(f"N_{release.of}"), self._outwards(release)
        base = f"R_{release.point}"
        if not slanting:
            base = next(n for n in self.names if n + "_x" in self.names)
        if not release.direction.terms and release.direction.degrees % 90 == 0:
            turn = release.direction.degrees % 360
            return Symbol(f"{base}_{'y' if turn % 180 else 'x'}"), 1 if turn < 180 else -1
        return Symbol(f"{base}_{'n' if release is self._releases[-1] else 't'}"), 1

    def _outwards(self, release: Release) -> int:
        """Return 1 if a push at the point of a rod pulls it: away from its other end.

        A rope that is released pulls back as it grows.
        """
        if release.kind == "mesh":
            return -1
        link = self._mechanism.link(release.of)
        return 1 if release.point == link.points[-1] else -1


def _speed(load: Load) -> Symbol:
    """Return the symbol of the speed with which a load does its work."""
    speed = load.against
    return Symbol(f"{speed.name}_{load.name}" if speed.kind == "load" else speed.name)


def _force(release: Release, way: int) -> Formula:
    """Return the force that each load has a share in, turned where ``way`` is -1."""
    return total(
        product([(canonical(share.scaled(way)).formula(), 1), (Symbol(load), 1)])
        for load, share in release.amounts.items()
        if share
    )


def _power(term: Term, load: Formula, speed: Formula) -> Formula:
    return product([(term.count.formula(), 1), (load, 1), (speed, 1)])
