"""What a language must say, and how its books write formulas."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ...base.named import NamedTuple
from ...statics import verdict

if TYPE_CHECKING:
    from ..kinds import PositionKind


Words = Mapping[str, str]
"""A sentence for each kind, with places for names and numbers."""


def with_reasons(own: Words, pictured: Words) -> Words:
    """Return the words of ``mechc check`` with those of free bodies that it needs, too."""
    return {**{reason: pictured[reason] for reason in verdict.WITHOUT_FORCES}, **own}


class Locale(NamedTuple):
    """All words of a report in one language."""

    babel: str
    functions: Mapping[str, str]
    """Functions that languages write differently, as LaTeX."""

    decimal: str
    """The sign between units and tenths."""

    cyrillic: bool
    """Whether the words take other fonts."""

    subjects: Mapping[str, str]
    source: str
    made_by: str

    given: str
    conventions: str
    plain_numbers: str
    atan2: str
    symbol: str
    quantity: str
    value: str
    range: str
    any_value: str
    driving: str
    """What the parameter of the drive is."""

    pivots: str
    directions: Mapping[str, str]
    """How a direction is said, by its angle to the x axis or relative to a vector."""

    slider: str
    through: str
    rods: str
    bodies: str
    force: str
    weight: str
    torque: str
    mirror: str
    copies: str
    joints: Mapping[str, str]
    """The words of a joint that is neither pin nor guide."""

    given_friction: Mapping[str, str]
    """The words of what is given of friction."""

    roles: Mapping[str, str]
    """What quantities without a text of their own are."""

    geometry: str
    vector: str
    length: str
    direction: str

    position: str
    loops: "Mapping[PositionKind, str]"
    """How a loop of each kind, or the sum of vectors, gives the position.

    A sentence has ``{loop}`` for the points of the loop, ``{all}`` for the same one by one, and
    ``{turn}`` for one of the ``turns``.
    """

    loops_again: "Mapping[PositionKind, str]"
    """Shorter sentences, from the second time on."""

    introduced: Mapping[str, str]
    """What the names are that a loop finds, and which of two places a point has on a guide."""

    turns: Mapping[str, str]
    velocities: str
    magnitudes: str
    signed: str
    rules: Mapping[str, str]
    """The sentence of each rule of the derivation, with places for names of its subject.

    ``{first}``, ``{second}``: the first name, the next one
    ``{point}``, ``{last}``: the last but one, the last
    ``{rest}``, ``{all}``: all but the first, all of them
    ``{joined}``: all written as one (the rod AB)
    """

    sentences: Mapping[str, str]
    """Sentences of a derivation about forces or friction, with places for names and formulas."""

    again: Mapping[str, str]
    """Shorter sentences for rules, from the second time on."""

    held: str
    hence: str

    power: str
    power_rule: str
    powers: Mapping[str, str]
    """What explains the factors of the power equation, and projections of velocities in it."""

    several: str

    results: str
    further: str
    force_ratio: str
    load: str
    speed_ratio: str
    transmission_ratio: str
    opposite_senses: str
    opposite_along_guides: str
    against: str
    against_load: str
    """What a minus says of loads: which one acts against its arrow."""

    at_joints: Mapping[str, str]
    """A force by its joint, rod or rope, its components, and what it is called with friction."""

    with_friction: Mapping[str, str]
    """Headings: where a load drives, else by the way it moves, or for the first order."""

    efficiency: str
    where: str
    solve: str
    proportional: str
    inverse: str
    independent: str
    swaps: str
    trends: Mapping[str, str]
    """The words for how a result moves with a parameter."""

    within: Mapping[str, str]
    zero: str
    pole: str
    infinite: str
    when: str
    and_every: str
    unmet: str
    absent: str
    but_where: str
    causes: Mapping[str, str]
    """The words for why a result is zero or infinite."""

    states: Mapping[str, str]
    all_loads: str
    as_given: str
    where_it_holds: str
    any_of: str
    in_range: str
    all_of_range: str
    out_of_range: str
    out_of_ranges: str
    efficiency_range: str
    steady: str
    still: str
    usual: str
    always_usual: str
    unusual: str
    why_usual: str
    sampled: str
    fails_here: str
    at_rest: Mapping[str, str]
    extents: Mapping[str, str]
    derivatives: str
    slope: str

    calculation: Mapping[str, str]
    """The words of a calculation sheet."""

    pictures: Mapping[str, str]
    """What is said below pictures and above the free bodies, with places for names."""

    checked: Mapping[str, str]
    """What ``mechc check`` says of a sound description, with places for names and numbers."""

    along_stroke: Mapping[str, str]
    """What ``mechc stroke`` says below its table and beside its rows."""

    comparison: Mapping[str, str]
    """The heads of a table of several mechanisms."""

    holds: str
    holds_as: str
    same_as: str
    inverse_of: Mapping[str, str]
    multiple_of: Mapping[str, str]
    requirements: str
    numbers: str
    at_default: str
    undetermined: str
    no_direction: str
    agrees: str
    agrees_once: str
    disagrees: str
    pending: str

    conjunction: str
    disjunction: str
    negation: str
    """What is between names behind "does not depend on"."""

    units: Mapping[str, str]
    """The language's letters of a unit, by the unit's own."""

    subscripts: Mapping[str, str]
    """What the subscripts of forces and results with friction are in formulas."""
