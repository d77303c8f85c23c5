"""``mechc explain``: the long explanation of an error or a warning."""

from importlib import import_module
from pkgutil import walk_packages
from textwrap import indent

from ... import diagnostics
from ...diagnostics import CATALOGUE, near_miss
from .. import usage
from ..terminal import say
from ..usage import beginning


def _codes(begun: str) -> list[usage.Proposal]:
    """Return the codes that begin so, with their names, or else the names."""
    load_all()
    known = (e for e in CATALOGUE.values() if e.code.startswith(begun.upper()))
    codes = [usage.Proposal(entry.code, entry.name) for entry in known]
    return codes or [*beginning(begun, (entry.name for entry in CATALOGUE.values()))]


@usage.command("explain")
@usage.argument("code", required=False, complete=_codes)
def command(code: str | None) -> None:
    """Explain an error or a warning by its code or its name.

    Without a code all are listed.

    \b
    mechc explain E203
    mechc explain
    """
    load_all()
    if code is None:
        for known in sorted(CATALOGUE):
            say(f"{known}  {CATALOGUE[known].name}")
    else:
        say(explanation(code))


def explanation(code: str) -> str:
    """Return heading and explanation of a code, in either case, or of a name."""
    for entry in CATALOGUE.values():
        if code.upper() == entry.code or code.lower() == entry.name:
            return f"{entry.code}: {entry.name}\n\n{_with_examples(entry.explanation)}"
    names = [entry.name for entry in CATALOGUE.values()]
    both = [f"{kind}{code}" for kind in "EW" if f"{kind}{code}" in CATALOGUE]
    meant = " or ".join(map(repr, both))
    hint = (
        f"did you mean {meant}?"
        if both
        else near_miss(code.upper(), CATALOGUE) or near_miss(code.lower(), names)
    )
    raise usage.BadParameter(
        f"no error or warning is called {code!r}; {hint or '`mechc explain` lists them'}",
        where="CODE",
    )


def _with_examples(text: str) -> str:
    r"""Return an explanation with its examples indented, where nothing else stands in their lines.

    >>> print(_with_examples("It is wrong.\n\npivott O  # wrong"))
    It is wrong.
    <BLANKLINE>
        pivott O  # wrong
    """
    return "\n\n".join(
        indent(part, "    ") if "  # " in part and not part.startswith(" ") else part
        for part in text.split("\n\n")
    )


def load_all() -> None:
    """Import every wording module, which fills the catalogue."""
    for module in walk_packages(diagnostics.__path__, f"{diagnostics.__name__}."):
        import_module(module.name)
