"""What a target is: one object that turns a compiled mechanism into files.

Targets are found by name; third parties add theirs through the entry-point group
``mechc.targets``, whose values are :class:`Target` objects.
"""

from typing import TYPE_CHECKING, Protocol

from ..base.named import NamedTuple
from ..model.mechanism import Mechanism
from ..statics.verdict import Verdict

if TYPE_CHECKING:
    from ..drawing.drawing import Drawing
    from ..figure.figure import Figure
    from ..plot.plot import Plot
    from ..plot.query import Query
    from ..pose.motion import Motion
    from ..report.steps import Derivation
    from ..routine.steps import Routine
    from ..statics.diagrams.diagram import Diagram
    from ..study.stroke.stroke import Stroke


class Compiled(Protocol):
    """Everything known of a mechanism after the last stage but emission.

    Each is made when a target first asks for it: code needs no derivation.
    """

    @property
    def mechanism(self) -> Mechanism:
        """Return the names, the quantities in SI, the geometry."""
        ...

    @property
    def derivation(self) -> "Derivation":
        """Return the derivation in steps, with all that follows from the results."""
        ...

    @property
    def reported(self) -> "Derivation":
        """Return the derivation with the extents of ratios along the stroke, for people."""
        ...

    @property
    def by_equilibrium(self) -> "Derivation":
        """Return the derivation for people, loads by the equilibrium of free bodies."""
        ...

    @property
    def routine(self) -> "Routine":
        """Return the straight-line program."""
        ...

    @property
    def motion(self) -> "Motion | None":
        """Return where points are along the drive; None without one."""
        ...

    @property
    def verdict(self) -> Verdict:
        """Return the second opinion, which agrees."""
        ...

    @property
    def figure(self) -> "Figure | None":
        """Return the drawing data at the default pose; None where it cannot be assembled."""
        ...

    def drawn_scheme(self, language: str) -> "Drawing | None":
        """Return the kinematic scheme at the default pose; None where it cannot be assembled."""
        ...

    def drawn_bodies(self, language: str) -> "Drawing | None":
        """Return the free bodies drawn, in the words of a language; None where there are none."""
        ...

    def drawn_plans(self, language: str) -> "Drawing | None":
        """Return the plans of velocities and forces, in the words of a language, if any."""
        ...

    def stroke(self, points: int) -> "Stroke":
        """Return the results along the stroke of the drive, in so many rows."""
        ...

    def plot(self, query: "Query") -> "Plot":
        """Return results against a parameter."""
        ...

    @property
    def free_bodies(self) -> "tuple[Diagram, ...]":
        """Return each body with the forces on it, at the default pose."""
        ...

    @property
    def used_mechanisms(self) -> "tuple[tuple[str, Compiled], ...]":
        """Return the mechanisms that a sheet uses, by their prefixes, at the values it gives."""
        ...

    @property
    def version(self) -> str:
        """Return the version of mechc, for the header of what is emitted."""
        ...


class Options(NamedTuple):
    """What a user may ask of a target; a target ignores what it has no use for."""

    stem: str
    """Name of the files without suffix (``clamp`` for ``clamp.c``, ``clamp.h``)."""
    fragment: bool = False
    language: str = "en"
    """One of :data:`~mechc.report.languages.registry.LANGUAGES`."""
    numbers: bool = True
    """Whether reports put the given values into their formulas."""
    brief: bool = False
    """Whether reports are formulas without the words between."""
    pictures: bool = False
    """Whether reports have the scheme, the free bodies and a plot."""
    gradient: bool = False
    """Whether code has functions of results with their slopes by each input."""
    c_real: str = "double"
    """The type of C's real numbers, of :data:`~mechc.emit.c.real.REALS`."""
    c_openmp: bool = False
    """Whether C's forms for many poses work on all processors where it is built with OpenMP."""
    by: str = "power"
    """How reports find loads, one of :data:`~mechc.syntax.vocabulary.METHODS`."""
    single: bool = False
    """One self-contained file (for standard output)."""
    named: bool = True
    """Whether a user named the files; otherwise a target may rename them."""


class Emitted(NamedTuple):
    """One file's name (no folder) and its text."""

    name: str
    text: str


class Target(Protocol):
    """A printer for formulas and a template for the file's shape, under one name."""

    @property
    def name(self) -> str:
        """Return the name given to ``--emit``."""
        ...

    @property
    def suffixes(self) -> tuple[str, ...]:
        """Return the file suffixes that choose this target, the main one first."""
        ...

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return the files; the first is the main one."""
        ...
