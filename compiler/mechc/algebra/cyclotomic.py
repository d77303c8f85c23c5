"""Sums of constant directions: Σ c·exp(i·j·part), with ``parts`` of them in a quarter turn.

The n directions 360°/n apart add up to zero. For a prime n these are all the relations
that there are (de Bruijn 1953), so leaving out one direction of each such star makes the
form of a sum unique; putting it back where that takes fewer terms makes it short. With
``parts = 3``, in steps of 30°, exp(i·60°) = 1 + i·exp(i·30°):

>>> unique({2: (1, 0)}, 3)
{0: (1, 0), 1: (0, 1)}
>>> short({0: (1, 0), 1: (0, 1)}, 3)
{2: (1, 0)}
"""

from collections import Counter
from collections.abc import Iterable
from functools import lru_cache

Gaussian = tuple[int, int]
"""A Gaussian integer (real part, imaginary part)."""

GaussianDirections = dict[int, Gaussian]
"""Direction, 0 … parts - 1, → coefficient, without zero coefficients."""

_PRIMES = (3, 5, 7, 11, 13)
"""The odd primes of :data:`~.modular.PARTS`: angles finer than that do not occur."""


def rotated(value: Gaussian, power: int) -> Gaussian:
    """Return a Gaussian integer times a power of i."""
    re, im = value
    match power & 3:
        case 0:
            return value
        case 1:
            return (-im, re)
        case 2:
            return (-re, -im)
    return (im, -re)


def accumulate(terms: dict[int, Gaussian], key: int, value: Gaussian) -> None:
    """Add a term to a sum, where it may cancel."""
    old = terms.get(key)
    if old is not None:
        value = (old[0] + value[0], old[1] + value[1])
    if value != (0, 0):
        terms[key] = value
    elif old is not None:
        del terms[key]


@lru_cache(maxsize=256)
def stars(parts: int) -> tuple[tuple[int, int], ...]:
    """Return each odd prime that divides ``parts``, with its highest power that does."""
    found = []
    for prime in _PRIMES:
        power = 1
        while parts % (power * prime) == 0:
            power *= prime
        if power > 1:
            found.append((prime, power))
    return tuple(found)


def unique(terms: GaussianDirections, parts: int) -> GaussianDirections:
    """Return the one form of a sum in which no star's last direction occurs."""
    for prime, power in stars(parts):
        last = power - power // prime
        for direction in [j for j in terms if j % power >= last]:
            re, im = terms.pop(direction)
            for step in range(1, prime):
                turns, to = divmod(direction + 4 * (parts // prime) * step, parts)
                accumulate(terms, to, rotated((-re, -im), turns))
    return terms


def short(terms: GaussianDirections, parts: int) -> GaussianDirections:
    """Return a form of a sum in its unique form that has few sines and cosines.

    With parts of 15° twice sin 15° is -i·exp(i·15°) + exp(i·75°), one sine and not three:

    >>> short({1: (1, -1), 3: (0, 1)}, 6)
    {1: (0, -1), 5: (1, 0)}
    """
    for prime, _ in reversed(stars(parts)):
        terms = _shortened(terms, parts, prime)
    return terms


def _shortened(terms: GaussianDirections, parts: int, prime: int) -> GaussianDirections:
    """Subtract from each star the real part that occurs in it most often, the imaginary one too."""
    span = parts // prime
    result: GaussianDirections = {}
    for first in sorted({direction % span for direction in terms}):
        star = [divmod(first + 4 * span * step, parts) for step in range(prime)]
        values = [rotated(terms.get(to, (0, 0)), -turns) for turns, to in star]
        common = _most_often(re for re, _ in values), _most_often(im for _, im in values)
        for (turns, to), (re, im) in zip(star, values, strict=True):
            accumulate(result, to, rotated((re - common[0], im - common[1]), turns))
    return result


def _most_often(parts: Iterable[int]) -> int:
    """Return the number that occurs most often, of several 0 or else the greatest."""
    counts = Counter(parts)
    return max(counts, key=lambda part: (counts[part], part == 0, part))
