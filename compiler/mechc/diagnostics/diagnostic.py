"""What an error or a warning is, and the register of all of them.

An error is a value with a code and a name. Its words are made in one place: a
function in one of this folder's modules (``syntax``, ``model``, …), decorated with
:func:`coded`. The function's docstring is what ``mechc explain CODE`` prints, so it
says what is wrong, why it matters, and shows how to fix it.
"""

from collections.abc import Callable, Iterable
from functools import wraps
from typing import TYPE_CHECKING, ParamSpec

from ..base.frozen import frozen, replace
from ..base.named import NamedTuple
from ..base.string_enum import Word
from ..source import Source, Span

if TYPE_CHECKING:
    import difflib
    import inspect
else:
    from ..base.later import Later

    difflib, inspect = Later("difflib"), Later("inspect")


class Severity(Word):
    """Whether output is withheld (``error``) or only remarked upon (``warning``)."""

    ERROR = "error"
    WARNING = "warning"


class Related(NamedTuple):
    """A second place that a diagnostic speaks of, and what stands there."""

    span: Span
    message: str


def used_at(use: Span, cause: Span) -> tuple[Related, ...]:
    """Return the place of a wrong value's use, and the place that it comes from."""
    return () if use == cause else (Related(use, "it is used here"),)


class Message(NamedTuple):
    """What a wording function returns: where, what was found and expected, one hint."""

    span: Span | None
    message: str
    hint: str
    related: tuple[Related, ...] = ()


@frozen
class Diagnostic:
    """One error or warning.

    ``code`` is ``E`` or ``W`` and three digits, whose first is the stage's:
    1 syntax, 2 model, 3 pose, 4 kinematics, 5 power, 6 statics, 7 emission,
    8 limits, 9 files. ``span`` is None only where no place in the file is meant.
    """

    code: str
    name: str
    span: Span | None
    message: str
    hint: str = ""
    related: tuple[Related, ...] = ()

    @property
    def severity(self) -> Severity:
        """Return the severity, which is the code's letter."""
        return Severity.ERROR if self.code.startswith("E") else Severity.WARNING


class CatalogueEntry(NamedTuple):
    """A kind of diagnostic in the catalogue: its name, and the docstring that explains it."""

    code: str
    name: str
    docstring: str

    @property
    def explanation(self) -> str:
        """Return the docstring without its indent."""
        return inspect.cleandoc(self.docstring)


CATALOGUE: dict[str, CatalogueEntry] = {}
"""Every kind of diagnostic by its code, filled by :func:`coded` as modules load."""

P = ParamSpec("P")


def coded(code: str) -> Callable[[Callable[P, Message]], Callable[P, Diagnostic]]:
    """Register a wording function under a code; its name and docstring come along."""

    def decorate(words: Callable[P, Message]) -> Callable[P, Diagnostic]:
        name = words.__name__.replace("_", "-")
        assert code not in CATALOGUE, f"{code} is taken"
        assert words.__doc__, f"{code} has no explanation"
        CATALOGUE[code] = CatalogueEntry(code, name, words.__doc__)

        @wraps(words)
        def make(*args: P.args, **kwargs: P.kwargs) -> Diagnostic:
            span, message, hint, related = words(*args, **kwargs)
            return Diagnostic(code, name, span, message, hint, related)

        return make

    return decorate


class MechcError(Exception):
    """The one exception of the library: a description that cannot be compiled.

    It carries every diagnostic found before the compiler had to stop, in the order
    of the text, and the source they point into.
    """

    def __init__(self, diagnostics: Iterable[Diagnostic], source: Source | None = None) -> None:
        self.diagnostics = tuple(diagnostics)
        self.source = source
        super().__init__("\n".join(f"{d.code}: {d.message}" for d in self.diagnostics))

    def __reduce__(self) -> tuple[type["MechcError"], tuple[object, ...]]:
        """Return the arguments to make it anew: copied or sent away, it keeps them all."""
        return type(self), (self.diagnostics, self.source)


class Report:
    """Collects diagnostics while one description goes through the stages.

    A stage adds all it finds and calls :meth:`stop_on_errors` where the next step
    would need what is missing. Hints are written in lines; ``in_notation`` puts them into the
    notation of the text.
    """

    def __init__(self, source: Source, in_notation: Callable[[str], str] | None = None) -> None:
        self.source, self._in_notation = source, in_notation
        self.diagnostics: list[Diagnostic] = []
        self._known: set[Diagnostic] = set()
        self._uses: list[tuple[Span, Span]] = []

    def add(self, diagnostic: Diagnostic) -> None:
        """Note a diagnostic, once; of one in an attached text also where that is used."""
        if self._in_notation and diagnostic.hint:
            diagnostic = replace(diagnostic, hint=self._in_notation(diagnostic.hint))
        diagnostic = self._with_use(diagnostic)
        if diagnostic not in self._known:
            self._known.add(diagnostic)
            self.diagnostics.append(diagnostic)

    def add_first(self, diagnostic: Diagnostic) -> None:
        """Note a diagnostic unless one of its code is noted at its place."""
        at = diagnostic.code, diagnostic.span
        if all((known.code, known.span) != at for known in self.diagnostics):
            self.add(diagnostic)

    def withdraw(self, code: str, span: Span) -> Diagnostic | None:
        """Take back the diagnostic of a code at a place and return it; None where there is none."""
        found = next((d for d in self.diagnostics if (d.code, d.span) == (code, span)), None)
        if found:
            self.diagnostics.remove(found)
        return found

    def has(self, code: str, within: Span | None) -> bool:
        """Return whether a diagnostic of a code is noted within a place."""
        found = (known.span for known in self.diagnostics if known.code == code)
        return any(
            span and within and within.start <= span.start and span.end <= within.end
            for span in found
        )

    def _with_use(self, diagnostic: Diagnostic) -> Diagnostic:
        at = diagnostic.span.start if diagnostic.span else -1
        uses = (use for text, use in self._uses if text.start <= at < text.end)
        here = tuple(Related(use, "it is used here") for use in uses)
        return replace(diagnostic, related=(*diagnostic.related, *here)) if here else diagnostic

    def attach(self, source: Source, use: Span) -> int:
        """Attach a text that is used, in which places may lie, and return where it begins."""
        self.source, start = self.source.with_attached(source)
        end, last = max(self.source.parts(), key=lambda part: part[0])
        self._uses.append((Span(start, end + len(last.text) + 1), use))
        return start

    def fail(self, diagnostic: Diagnostic) -> MechcError:
        """Note an error and return the exception to raise, with all that was found."""
        self.add(diagnostic)
        return MechcError(self.sorted(), self.source)

    def stop_on_errors(self) -> None:
        """Raise :class:`MechcError` if an error has been found."""
        if any(d.severity is Severity.ERROR for d in self.diagnostics):
            raise MechcError(self.sorted(), self.source)

    def sorted(self) -> list[Diagnostic]:
        """Return the diagnostics in the order of the text, those without a span last."""
        far = len(self.source.text)
        return sorted(self.diagnostics, key=lambda d: d.span.start if d.span else far)


def near_miss(name: str, known: Iterable[str]) -> str:
    """Return ``did you mean 'x'?`` for the nearest known name, or nothing when none is near.

    >>> near_miss("alhpa", ["alpha", "beta"])
    "did you mean 'alpha'?"
    >>> near_miss("q", ["alpha", "beta"])
    ''
    >>> near_miss("R_A", ["R_A_on_AB_x", "R_A_on_AB", "R_Q"])
    "did you mean 'R_A_on_AB'?"
    >>> near_miss("R_A_f_y", ["R_A_y", "R_A_y_f"])
    "did you mean 'R_A_y_f'?"
    """
    known = list(known)
    twin = [k for k in known if k.lower() == name.lower()]
    longer = sorted((k for k in known if k.startswith(f"{name}_")), key=len)
    ordered = sorted(name.split("_"))
    shuffled = [k for k in known if sorted(k.split("_")) == ordered]
    close = twin or longer or shuffled or difflib.get_close_matches(name, known, n=1, cutoff=0.7)
    return f"did you mean {close[0]!r}?" if close else ""
