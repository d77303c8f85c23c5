"""Names under the prefix of a used sheet or mechanism that this does not bring in."""

from collections.abc import Container, Mapping

from ...diagnostics.model import names as messages
from ...syntax import ast
from .forms import form_of

ENDINGS = ("_f1", "_hold", "_f")
"""What the names of loads and results with friction end with."""


def of_a_use(name: str, brought: Mapping[str, ast.Brought]) -> ast.Brought | None:
    """Return the use whose prefix a name begins with, the longest such prefix; None without one."""
    prefixes = [prefix for prefix in brought if name.startswith(f"{prefix}_")]
    return brought[max(prefixes, key=len)] if prefixes else None


def reason(name: str, use: ast.Brought, known: Container[str]) -> str:
    """Return why a use does not bring in a name, '' where that is not known."""
    own = name.removeprefix(f"{use.prefix}_")
    ending = next((e for e in ENDINGS if own.endswith(e)), "")
    ideal = own.removesuffix(ending)
    if ideal in use.loads:
        given = next((load for load in use.loads if load != ideal), ideal)
        return messages.load_follows(use.used, use.prefix, given)
    if ending and f"{use.prefix}_{ideal}" in known:
        return messages.without_friction(use.used)
    return messages.found_if_asked(use.used, ideal) if form_of(ideal) else ""
