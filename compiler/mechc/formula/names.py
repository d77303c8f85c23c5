"""Names as they are set: head, index, primes.

``alpha_1`` is the letter alpha with index 1, ``V_O1`` the speed of the point O1,
``omega_O1B`` the angular velocity of the link through O1 and B.
"""

import re
from functools import lru_cache

from ..base.later import pattern
from ..base.named import NamedTuple

_SMALL = """
alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho
sigma tau upsilon phi chi psi omega
"""
_CAPITAL = "Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"

GREEK = {
    **dict(zip(_SMALL.split(), "αβγδεζηθικλμνξοπρστυφχψω", strict=True)),
    **dict(zip(_CAPITAL.split(), "ΓΔΘΛΞΠΣΥΦΨΩ", strict=True)),
}
"""Greek letters by the names they are typed with; capitals where they are not Latin ones."""

_SHORT = {"lam": "lambda", "eps": "epsilon"}
"""What those write who write code, where ``lambda`` is a word of the language."""

_POINTS = pattern(r"(?:[A-Z][0-9]*'*)+")
_POINT = pattern(r"([A-Z])([0-9]*)('*)")
_FORCE = pattern(r"(R_[A-Z][0-9]*'*)(?:_on_((?:[A-Z][0-9]*'*)+))?(_direction)?((?:_.+)?)")
_HEAD = pattern(r"(.*?)([0-9]*)('*)", re.DOTALL)


class PointName(NamedTuple):
    """A point's letter, number and primes: ``("O", "1", "")``."""

    letter: str
    number: str
    primes: str


class ParsedName(NamedTuple):
    """A name's head (a letter, a Greek name or a word), primes and indices."""

    head: str
    primes: str
    indices: tuple[str, ...]


class JointForceName(NamedTuple):
    """A force at a joint by its name: what stands without the link, the link, what it measures."""

    name: str
    link: str
    is_direction: bool


class MadeRatio(NamedTuple):
    """A ratio asked for without a name: of what, with which friction, or its efficiency."""

    above: str
    below: str
    ending: str
    is_efficiency: bool


@lru_cache(maxsize=4096)
def split_name(name: str) -> ParsedName:
    """Split a name at underscores and at the digits that end its head.

    >>> split_name("alpha1")
    ParsedName(head='alpha', primes='', indices=('1',))
    >>> split_name("l_max").indices
    ('max',)
    >>> split_name("lam_1").head
    'lambda'
    """
    head, *indices = name.split("_")
    match = _HEAD.fullmatch(head)
    assert match is not None
    stem, number, primes = match.groups()
    if not stem:
        return ParsedName(name, "", ())
    return ParsedName(_SHORT.get(stem, stem), primes, tuple(i for i in (number, *indices) if i))


def words_in(name: str) -> tuple[str, ...]:
    """Return the words that a name is made of, neither letters nor points.

    >>> words_in("dP_far"), words_in("bores"), words_in("alpha_1"), words_in("omega_O1B")
    (('dP', 'far'), ('bores',), (), ())
    """
    head, _, indices = split_name(name)
    return tuple(word for word in (head, *indices) if is_word(word))


def is_word(part: str) -> bool:
    """Return whether a part of a name is a word: no letter, Greek or Latin, no point, no number."""
    return len(part) > 1 and part.isalpha() and part not in GREEK and not split_points(part)


def another(name: str) -> str:
    """Return the name to try where one is taken; it differs on paper, too.

    >>> another("q_Q"), another("q_Q_2"), another("d_1")
    ('q_Q_2', 'q_Q_3', 'd_2')
    """
    stem, _, last = name.rpartition("_")
    return f"{stem}_{int(last) + 1}" if stem and last.isdecimal() else f"{name}_2"


def split_ratio(name: str) -> tuple[str, ...]:
    """Split the name of a result that was asked for without one into what it is the ratio of.

    >>> split_ratio("V_D_over_V_A"), split_ratio("alpha_1")
    (('V_D', 'V_A'), ('alpha_1',))
    """
    return tuple(name.split("_over_"))


def split_made_ratio(name: str) -> MadeRatio | None:
    """Split the name of what a ratio without a name comes to; None for other names.

    >>> split_made_ratio("M_over_F_f1")
    MadeRatio(above='M', below='F', ending='f1', is_efficiency=False)
    >>> split_made_ratio("eta_M_over_F").is_efficiency, split_made_ratio("k_f")
    (True, None)
    """
    above, *others = split_ratio(name)
    if len(others) != 1:
        return None
    below, _, last = others[0].rpartition("_")
    ending = last if below and last in RATIO_ENDINGS else ""
    is_efficiency = above.startswith("eta_")
    return MadeRatio(
        above.removeprefix("eta_"), below if ending else others[0], ending, is_efficiency
    )


RATIO_ENDINGS = frozenset({"f", "f1", "hold"})
"""What stands behind the name of a ratio with friction."""


def direction_of(name: str) -> str:
    """Return the vector of whose direction this is the name, '' of another name.

    >>> direction_of("phi_AB"), direction_of("phi_O1B_"), direction_of("phi_max")
    ('AB', 'O1B', '')
    """
    head, _, vector = name.rstrip("_").partition("_")
    return vector if head == "phi" and len(split_points(vector)) == VECTOR_POINTS else ""


VECTOR_POINTS = 2
"""A vector leads from one point to another."""

ANGLE_POINTS = 3
"""An angle of a link is that at the second of three points."""


def corner_of(name: str) -> str:
    """Return the three points of the angle of a link that a name stands for, '' of another name.

    >>> corner_of("turn_CAB"), corner_of("turn_O1AB"), corner_of("turn_rate"), corner_of("len_AB")
    ('CAB', 'O1AB', '', '')
    """
    head, _, points = name.partition("_")
    return points if head == "turn" and len(split_points(points)) == ANGLE_POINTS else ""


def split_points(name: str) -> tuple[PointName, ...]:
    """Split a point, vector or link into its points; ``()`` when it is none of these.

    >>> [p.letter + p.number for p in split_points("OB12C")]
    ['O', 'B12', 'C']
    """
    if not _POINTS.fullmatch(name):
        return ()
    return tuple(PointName(*groups) for groups in _POINT.findall(name))


def split_force(name: str) -> JointForceName | None:
    """Split the name of a force at a joint that has a link or is a direction; None for others.

    >>> split_force("R_B_on_BC_x")
    JointForceName(name='R_B_x', link='BC', is_direction=False)
    >>> split_force("R_O_direction_f")
    JointForceName(name='R_O_f', link='', is_direction=True)
    >>> split_force("R_max")
    """
    match = _FORCE.fullmatch(name)
    if match is None or not (match[2] or match[3]):
        return None
    return JointForceName(match[1] + match[4], match[2] or "", bool(match[3]))
