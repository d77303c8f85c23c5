"""What shared parts of formulas are called: by what they are, as ``sin_alpha_plus_beta``.

A label is made of those of its parts. Where one of them has none, or where it would be long,
there is none either, and a part gets a letter and a number.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction

from ..formula.tree import Number, Pi, Symbol
from .table import Apply, Entry, Leaf, Ratio, Scaled, Terms

LONGEST_LABEL = 24
"""Characters of a step's name beyond which it is numbered instead."""

Labels = Mapping[int, str]
"""The labels of entries, '' of those without one."""


def shortened(label: str) -> str:
    """Return a label, '' where it is too long."""
    return label if len(label) <= LONGEST_LABEL else ""


def words(entry: Entry, labels: Labels, entries: Sequence[Entry]) -> str:
    """Return an entry in words, '' where there are none for it."""
    match entry:
        case Leaf(Symbol(name)):
            return name
        case Leaf(Number(value)) if value.denominator == 1 and value >= 0:
            return str(value)
        case Apply(function, (argument,)) if labels[argument]:
            return f"{function}_{labels[argument]}"
        case Scaled(coefficient, part):
            return _scaled(coefficient, labels[part], is_pi=entries[part] == Leaf(Pi()))
        case Ratio((one, other), ()) if labels[one] and labels[other]:
            return f"{labels[one]}_{'squared' if one == other else labels[other]}"
        case Terms(terms) if all(labels[t] and not isinstance(entries[t], Ratio) for t in terms):
            return "_plus_".join(labels[t] for t in terms).replace("plus_minus", "minus")
        case _:
            return ""


def _scaled(coefficient: Fraction, label: str, *, is_pi: bool) -> str:
    """Return so many times what has a label; parts of π are degrees."""
    sign, size = "minus_" if coefficient < 0 else "", abs(coefficient)
    if is_pi:
        size, label = 180 * size, "deg"
    if not label or size.denominator != 1:
        return ""
    return f"{sign}{'' if size == 1 else size}{label}"
