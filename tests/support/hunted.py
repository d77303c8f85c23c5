"""Random mechanisms of every kind that the tests can make, by the seed of each."""

import re
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from random import Random
from typing import NamedTuple

from branchings import Flat, folding, toggle
from equal_lengths import four_bar
from force_mechanisms import given
from force_samples import pushing, tree_of
from friction_chains import chain, squared
from friction_mechanisms import closed, opened, small_closed
from grown import Grown, drawn, swept, wide, without_drive
from homogeneous import on_grid
from mechanisms import sample
from mechc.api import SolvedMechanism
from mechc.compilation import Compilation, complete
from mechc.source import Source
from mechc.study.stroke.stroke import Stroke
from mechc.syntax import ast
from open_chains import Chain
from other_kinds import KINDS as OTHER_KINDS
from other_kinds import other, put_toggle
from shared_lengths import shared
from special_drives import driven
from special_trains import special


class Made(NamedTuple):
    """A description, with its places, or with where its loops lie flat, if these are known."""

    text: str
    grown: Grown | None = None
    flat: Flat | None = None


class Hunted:
    """A mechanism in the compiler, with all that checks ask of it."""

    def __init__(self, made: Made, seed: int, folder: Path) -> None:
        self.text, self.grown, self.flat = made
        self.seed, self.folder = seed, folder
        self.tree: ast.File = tree_of(made.text)

    @cached_property
    def compilation(self) -> Compilation:
        put_toggle(self.folder)
        found = complete(Compilation(Source("hunted.mech", self.text, folder=self.folder)))
        found.run(["derivation"])
        return found

    @property
    def is_compiled(self) -> bool:
        """Return whether the compiler was asked, and took the description."""
        return "compilation" in vars(self)

    @property
    def is_closed(self) -> bool:
        """Return whether loops or a drive give directions that a reader of the text cannot see."""
        pose = self.compilation.pose
        return bool(pose.definitions or pose.solved or pose.mechanism.drive)

    @cached_property
    def mechanism(self) -> SolvedMechanism:
        return SolvedMechanism(self.compilation)

    @cached_property
    def stroke(self) -> Stroke | None:
        return self.compilation.stroke(3) if self.compilation.pose.mechanism.drive else None


# ------------------------------------------------------------------------------- kinds


def forces(seed: int) -> str | None:
    """Return a mechanism of a given pose of which the forces at all joints are asked."""
    found = pushing(given(seed, ratio=bool(seed % 2)))
    return found and found.finding()


def grown(seed: int, change: Callable[[Grown], str]) -> Made:
    """Return a closed mechanism, put in words that keep its parameters."""
    return Made(change(Grown(seed)), Grown(seed))


def in_other_words(seed: int, change: Callable[[Grown], str]) -> str | None:
    """Return a closed mechanism whose drive is given otherwise: an angle, and no triads."""
    found = Grown(seed)
    return change(found) if found.drive == "phi" and "triad" not in found.kinds else None


def right_angled(seed: int) -> str:
    """Return a chain with friction whose directions are multiples of a round angle."""
    return squared(chain(seed), Random(seed).choice((15, 30, 45, 90)))


def flat(seed: int) -> Made:
    found = folding(seed)
    return Made(found.text, flat=found)


def joined(seed: int) -> Made:
    text = other("joined", seed)
    return Made(text, flat=toggle(text))


def loaded_pivot(seed: int) -> str | None:
    """Return a mechanism with friction that has a load on the pin of a pivot, whose force is asked.

    The ground alone carries that load: the pin rubs under what the link presses it with.
    """
    found = (opened, small_closed, chain)[seed % 3](seed)
    text = found.text if isinstance(found, Made) else found
    pivots = re.findall(r"^pivot (\w+)", text or "", re.MULTILINE)
    if not text or not pivots:
        return None
    rng = Random(seed)
    pivot, angle, size = rng.choice(pivots), rng.uniform(-3, 3), rng.choice((0.3, 2, 90))
    return f"{text}\nforce W99 at {pivot} along {angle} rad\nlet W99 = {size} N\nfind R_{pivot}\n"


KINDS: dict[str, Callable[[int], Made | str | None]] = {
    "chain": lambda seed: Chain(seed).text,
    "chain of equal links": lambda seed: Chain(seed, equal=True).text,
    "linkage": lambda seed: sample(seed).text,
    "forces at joints": forces,
    "with friction": opened,
    "chain with friction": chain,
    "right-angled with friction": right_angled,
    "closed": lambda seed: grown(seed, wide),
    "closed in a range": lambda seed: grown(seed, swept),
    "without a drive": lambda seed: in_other_words(seed, lambda one: without_drive(wide(one))),
    "drawn": lambda seed: in_other_words(seed, drawn),
    "drawn on a grid": on_grid,
    "closed with friction": closed,
    "small with friction": small_closed,
    "flat": flat,
    "equal lengths": four_bar,
    "shared lengths": shared,
    "special": special,
    "special driven": driven,
    **{kind: (lambda seed, kind=kind: other(kind, seed)) for kind in OTHER_KINDS},
    "joined": joined,
    "loaded pivots": loaded_pivot,
}
"""How a mechanism of each kind is made; some seeds have none."""


def made(kind: str, seed: int) -> Made | None:
    """Return the mechanism that a kind has for a seed."""
    found = KINDS[kind](seed)
    return Made(found) if isinstance(found, str) else found
