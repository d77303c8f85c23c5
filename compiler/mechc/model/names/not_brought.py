"""Names under the prefix of a used sheet or mechanism that this does not bring in."""

from collections.abc import Collection, Iterable, Mapping

from ...diagnostics.model import names as messages
from ...syntax import ast
from ..parts.targets import WITH_FRICTION
from .forms import COORDINATES, ReservedName, form_of, form_of_pose

OF_THE_POSE = frozenset({"phi", "len", *COORDINATES})
"""The quantities that a mechanism has without being asked."""


def of_a_use(name: str, brought: Mapping[str, ast.Brought]) -> ast.Brought | None:
    """Return the use whose prefix a name begins with, the longest such prefix; None without one."""
    prefixes = [prefix for prefix in brought if name.startswith(f"{prefix}_")]
    return brought[max(prefixes, key=len)] if prefixes else None


def without_friction(name: str) -> str:
    """Return the result that a name is of with friction, the name itself where it is of none.

    >>> without_friction("eta_k"), without_friction("k_hold"), without_friction("k")
    ('k', 'k', 'k')
    """
    ending = next((e for e in WITH_FRICTION if name.endswith(e)), "")
    return name.removesuffix(ending).removeprefix("eta_")


def reason(name: str, use: ast.Brought, known: Collection[str]) -> str:
    """Return why a use does not bring in a name, '' where that is not known."""
    own = name.removeprefix(f"{use.prefix}_")
    ending = next((e for e in WITH_FRICTION if own.endswith(e)), "")
    ideal = own.removesuffix(ending)
    if ideal in use.loads:
        given = next((load for load in use.loads if load != ideal), ideal)
        return messages.load_follows(use.used, use.prefix, given)
    if ending and f"{use.prefix}_{ideal}" in known:
        return messages.without_friction(use.used)
    begins = f"{use.prefix}_{ideal}_on_"
    at_links = [each for each in known if each.startswith(begins) and each.endswith(ending)]
    if at_links:
        return messages.meant(min(at_links, key=len))
    form = form_of_pose(ideal)
    strange = [point for point in form.points if point not in use.points] if form else []
    if strange:
        return messages.no_such_points(use.used, strange, use.points)
    if ideal in use.inner or (form and form.prefix in OF_THE_POSE):
        return messages.named_by_a_let(use.used, use.prefix, ideal)
    return messages.found_if_asked(use.used, ideal, _alike(form, use, known)) if form else ""


def _alike(form: ReservedName, use: ast.Brought, known: Iterable[str]) -> list[str]:
    """Return the names of one form under a prefix, as ``M_R_C`` of forces: one may be meant."""
    begins = f"{use.prefix}_"
    own = ((name, form_of(name.removeprefix(begins))) for name in known if name.startswith(begins))
    return sorted(name for name, other in own if other and other.prefix == form.prefix)
