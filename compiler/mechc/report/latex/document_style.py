"""How one document writes names: which are angles, and no two of them alike."""

from collections.abc import Iterable, Sequence

from ...base.frozen import replace
from ...model.mechanism import Mechanism, WithFriction
from ...study.analysis import Analysis
from ..made_names import names_of, points_of
from ..sentences.remarks import called, reaction
from ..sentences.speller import angles_of, couples_of, guided_of, own_names
from .notation import LatexNotation, of_first_order, of_force, spellings


def style_of(
    mechanism: Mechanism, results: Sequence[Analysis], style: LatexNotation
) -> LatexNotation:
    """Return a notation with this mechanism's angles, and its names set apart from each other."""
    texts = mechanism.translations.get(style.language, style.texts)
    known = replace(
        style,
        angles=angles_of(mechanism, results),
        couples=couples_of(mechanism),
        guided=guided_of(mechanism),
        texts=texts,
        own=own_names(mechanism),
        pictured=frozenset((*points_of(mechanism), *own_names(mechanism))),
    )
    known.made.take(names_of(mechanism, results))
    known.made.take_points(points_of(mechanism))
    known = replace(known, spellings=spellings(names_of(mechanism, results), known))
    forces = {
        name: of_force(r.name, force, known)
        for r in results
        if (force := reaction(r))
        for name in (r.name, called(r))
    }
    return replace(known, spellings={**known.spellings, **forces, **first_orders(results, known)})


def first_orders(results: Iterable[Analysis], style: LatexNotation) -> dict[str, str]:
    """Return how results of first order in friction are spelled."""
    return {
        r.name: of_first_order(r.name, style)
        for r in results
        if isinstance(r.target, WithFriction) and r.target.order == "first"
    }
