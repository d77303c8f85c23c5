"""The library's front: a description in, formulas, numbers and code out.

All quantities that go in or come out as numbers are SI and radians; what goes in may be text
with a unit, ``"20 deg"``, as well.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .compilation import Compilation, checked, compile_source, emit, warnings
from .diagnostics import Diagnostic, near_miss
from .emit import registry
from .emit.target import Emitted, Options
from .evaluation import Evaluation
from .files import SUFFIXES, find, read
from .formula.to_sympy import to_sympy
from .formula.walk import constants
from .plotting import Plotting
from .source import Source

if TYPE_CHECKING:
    import sympy

    from .emit.picture import Picture
    from .figure.figure import Figure
    from .routine.evaluate import OnArrays
    from .shown import ShownDerivation, ShownResult, ShownStroke
    from .statics.diagrams.diagram import Diagram


class SolvedMechanism(Plotting):
    """A mechanism whose power equation has been solved.

    ``k = P/F`` is the ratio for which the loads *as directed in the description*, all
    acting on the mechanism, balance: a positive k says that the arrows are right. The
    solution has been compared with the equilibrium of every free body before it is
    handed out.

    >>> import mechc
    >>> clamp = mechc.load("karpenko_fig9_packet_clamp")
    >>> clamp.k
    a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))
    >>> round(clamp.evaluate()["k"], 6)
    0.067068
    """

    def __init__(
        self, compilation: Compilation, on_arrays: "Mapping[str, OnArrays] | None" = None
    ) -> None:
        self._compilation = compilation
        self._evaluation = Evaluation(compilation, on_arrays)

    @property
    def name(self) -> str:
        """The mechanism's name, an identifier."""
        return self._compilation.mechanism.name

    @property
    def title(self) -> str:
        """The title given in the description, '' where there is none."""
        return self._compilation.mechanism.title

    @cached_property
    def results(self) -> "Mapping[str, ShownResult]":
        """Every ``find`` and ``let`` by name, in order, with what follows from it.

        A result has its formula, where it vanishes and where it is infinite, how it
        moves with each parameter, its partial derivatives and its value at the default
        pose.
        """
        from .shown import ShownResult, shown

        compilation = self._compilation
        return {r.name: shown(ShownResult, r, of=compilation) for r in compilation.results}

    @property
    def k(self) -> "sympy.Expr":
        """The result named ``k``, or the only one, as a sympy expression.

        Raises AttributeError where there are several and none is called k.
        """
        if "k" in self.results:
            return self["k"]
        if len(self.results) == 1:
            return self[next(iter(self.results))]
        raise AttributeError(f"no result is called k; there are {', '.join(self.results)}")

    def __getitem__(self, name: str) -> "sympy.Expr":
        """Return a result by name as a sympy expression, in SI and radians."""
        return to_sympy(self._result(name).formula)

    @property
    def where(self) -> dict[str, "sympy.Expr"]:
        """The named numbers and intermediates that results mention, in order of definition."""
        where = [d for r in self.results.values() for d in r.where]
        formulas = [*(r.formula for r in self.results.values()), *(d.formula for d in where)]
        numbers = {c.name: to_sympy(c.value) for c in constants(formulas)}
        return numbers | {d.name: to_sympy(d.formula) for d in where}

    def _result(self, name: str) -> "ShownResult":
        if name in self.results:
            return self.results[name]
        hint = near_miss(name, self.results) or f"there are {', '.join(self.results)}"
        raise KeyError(f"no result is called {name!r}; {hint}")

    @property
    def derivation(self) -> "ShownDerivation":
        """The derivation as data: velocity steps, the power equation, the results."""
        from .shown import ShownDerivation, shown

        return shown(ShownDerivation, self._compilation.derivation, of=self._compilation)

    @property
    def defaults(self) -> Mapping[str, float]:
        """The parameters' values from the description, in SI and radians."""
        return self._evaluation.defaults

    @property
    def warnings(self) -> list[Diagnostic]:
        """What was remarked upon, in the order of the text."""
        return warnings(self._compilation)

    def evaluate(self, **values: Any) -> dict[str, Any]:
        """Return every result at given values: floats, or arrays that broadcast together.

        What is not given is taken from the description, and what is given goes before it: a
        load that a ``let`` or a mass gives its size, too. A result that depends on a load
        without a value is left out. SI and radians, or text with its unit; NaN at poses that a
        ``require`` excludes. TypeError for a name that follows from others, or that no result
        depends on, MechcError for text that is no such quantity.

        >>> import mechc
        >>> clamp = mechc.load("karpenko_fig9_packet_clamp")
        >>> [round(float(k), 4) for k in clamp.evaluate(alpha=[0.1, 0.2])["k"]]
        [0.0446, 0.0651]
        >>> round(clamp.evaluate(alpha="10 deg", a="120 mm")["k"], 4)
        0.0718
        """
        return self._evaluation.results(values)

    def __reduce__(self) -> "tuple[Callable[..., SolvedMechanism], tuple[Compilation, bool]]":
        """Return the way a copy is made: functions, which no file can hold, are made anew."""
        return _copied, (self._compilation, self._evaluation.has_machine_code)

    def compile(self) -> "SolvedMechanism":
        """Return the same mechanism, whose ``evaluate`` has machine code for arrays.

        The emitted C is built once, in the folder of caches (``~/.cache/mechc``, or
        ``$MECHC_CACHE``). Where that is not possible, the emitted NumPy module takes its place.

        >>> import mechc
        >>> clamp = mechc.load("karpenko_fig9_packet_clamp").compile()
        >>> [round(float(k), 4) for k in clamp.evaluate(alpha=[0.1, 0.2])["k"]]
        [0.0446, 0.0651]
        """
        from .emit.loaded_code import on_arrays

        return SolvedMechanism(self._compilation, on_arrays(self._compilation))

    def figure(self, **values: float | str) -> "Figure":
        """Return the drawing at given values: its points in metres, and its parts.

        What is not given is taken from the description; SI and radians, or text with its unit.
        TypeError for a name that is no parameter, ValueError where the mechanism cannot be
        assembled.

        >>> import mechc
        >>> rocker = mechc.load("crank_rocker").figure(phi=0)
        >>> rocker.points["A"]
        Plane(x=..., y=0.0)
        """
        given = self._evaluation.in_si(values)
        parameters = [p.name for p in self._compilation.mechanism.parameters]
        for unknown in (name for name in given if name not in parameters):
            hint = near_miss(unknown, parameters) or f"there are {', '.join(parameters) or 'none'}"
            raise TypeError(f"{unknown!r} is no parameter; {hint}")
        drawn = self._compilation.drawn(given)
        if drawn is None:
            raise ValueError("no pose of the mechanism is found at these values")
        return drawn

    def draw(self, language: str = "en", **values: float | str) -> "Picture":
        """Return the kinematic scheme at given values, as for :meth:`figure`.

        ``language`` is that of its title and of its text alternative: en, uk or ru. In a notebook
        it shows itself; ``save("clamp.svg")`` writes it, also .tex, .pdf and .png.
        """
        from .drawing.language_letters import in_letters
        from .emit.picture import Picture
        from .formula.letters import letters
        from .report.languages.registry import locale

        drawing = self._compilation.drawn_scheme(language, figure=self.figure(**values))
        assert drawing is not None, "a figure has a scheme"
        texts = self._compilation.mechanism.texts(language)
        return Picture(in_letters(drawing, letters(locale(language), texts)))

    def free_bodies(self, **values: float | str) -> "tuple[Diagram, ...]":
        """Return each body with the forces on it, at given values of parameters and loads.

        SI and radians, as for :meth:`figure`. A load to which nothing gives a size counts as 1.

        >>> import mechc
        >>> (lever,) = mechc.load("lever_first_class").free_bodies(F=100)[0].bodies
        >>> [(acting.by, round(acting.force.y, 6)) for acting in lever.forces]
        [('P', -25.0), ('ground', 125.0), ('F', -100.0)]
        """
        given = self._evaluation.in_si(values)
        loads = {load.name for load in self._compilation.mechanism.loads}
        sizes = {name: size for name, size in given.items() if name in loads}
        pose = {name: value for name, value in given.items() if name not in loads}
        self.figure(**pose)
        return self._compilation.cut_free(pose, sizes)

    def points(self, **values: Any) -> tuple[dict[str, Any], Any]:
        """Return where points are and how links point, and a status, at given values.

        By name: ``x_B``, ``y_B``, the direction ``phi_AB`` of a link, and their slopes along the
        drive, ``dx_B_dphi``; where its speed is given, velocities ``V_B_x``, ``omega_AB`` and
        accelerations ``a_B_x``, ``epsilon_AB`` instead. Floats or arrays as for
        :meth:`evaluate`, in SI and radians. The status is 0 where there is a pose, 1 where the
        loops do not close, 2 where iteration finds none; what is not there is NaN. ValueError
        where no drive is named, TypeError for a name that follows from others, or that nothing
        depends on.

        >>> import mechc
        >>> found, status = mechc.load("crank_rocker").points(phi=[0, 1.5707963267948966])
        >>> [round(float(x), 4) for x in found["x_A"]], [round(float(y), 4) for y in found["y_B"]]
        ([0.04, 0.0], [0.0711, 0.0788])
        """
        return self._evaluation.points(values)

    def stroke(self, points: int = 19, paths: Sequence[str] = ()) -> "ShownStroke":
        """Return the results along the stroke of the drive; singular poses, branch points, extrema.

        ``paths`` are points and links whose coordinates, directions and rates are columns, too.
        SI and radians. Raises :class:`mechc.MechcError` where no drive is named.

        >>> import mechc
        >>> claw = mechc.load("claw_closed").stroke()
        >>> [(e.kind, round(e.drive, 7), round(e.value, 7)) for e in claw.extrema][-1]
        ('minimum', 1.3805578, 1.3727737)
        """
        from .shown import ShownStroke, shown

        return shown(ShownStroke, self._compilation.stroke(points, paths))

    def emit(self, target: str, **options: Any) -> str:
        """Return one self-contained file as text: ``python``, ``c``, ``latex`` or ``json``.

        Of LaTeX, ``fragment=True`` leaves out the preamble, and ``language`` is ``"en"``,
        ``"uk"`` or ``"ru"``.
        """
        return self.emit_files(target, single=True, **options)[0].text

    def emit_files(self, target: str, **options: Any) -> tuple[Emitted, ...]:
        """Return the files of a target by name, the main one first (``clamp.c``, ``clamp.h``)."""
        for unknown in (name for name in options if name not in Options._fields):
            hint = near_miss(unknown, Options._fields) or f"there are {', '.join(Options._fields)}"
            raise TypeError(f"there is no option {unknown!r}; {hint}")
        asked = Options(**{"stem": self.name, "named": "stem" in options, **options})
        return emit(self._compilation, registry.load(target), asked)

    def _repr_markdown_(self) -> str:
        from .emit.latex import notebook

        return notebook.results(checked(self._compilation), self._compilation.results)

    def _repr_latex_(self) -> str:
        from .emit.latex import notebook

        return notebook.results_in_latex(checked(self._compilation), self._compilation.results)

    def __repr__(self) -> str:
        """Return name and results in one line."""
        return f"<{self.name}: {', '.join(self.results)}>"


def _copied(compilation: Compilation, is_compiled: bool) -> SolvedMechanism:
    copy = SolvedMechanism(compilation)
    return copy.compile() if is_compiled else copy


def load(path: str | Path) -> SolvedMechanism:
    """Compile a file (``.mech``, ``.yaml``), or a mechanism of the library by its name.

    Raises :class:`mechc.MechcError` with every diagnostic where the description is
    wrong or there is no such file.

    >>> import mechc
    >>> mechc.load("karpenko_fig9_packet_clamp")
    <karpenko_fig9_packet_clamp: k, delta, p>
    """
    return SolvedMechanism(compile_source(read(find(str(path)))))


def loads(text: str, name: str = "<text>") -> SolvedMechanism:
    """Compile a description given as text in either notation; ``name`` is for messages.

    >>> import mechc
    >>> lever = mechc.loads('''
    ... mechanism lever
    ... param a = 1 m
    ... param b = 2 m
    ... pivot O
    ... link AOB
    ... OA = a @ 180 deg
    ... OB = b @ 0 deg
    ... force P at B along -y
    ... force F at A along -y
    ... find k = P/F
    ... ''')
    >>> lever.k
    a/b
    """
    if text.endswith(SUFFIXES) and "\n" not in text:
        raise ValueError(f"{text!r} is a path, which mechc.load reads; mechc.loads takes the text")
    return SolvedMechanism(compile_source(Source(name, text)))
