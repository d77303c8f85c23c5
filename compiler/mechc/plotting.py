"""Plots of a mechanism from Python."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING

from .base.frozen import replace
from .compilation import Compilation
from .plot.query import USUAL_ROWS, GivenSetting, Query, condition
from .syntax.settings import parse

if TYPE_CHECKING:
    from .emit.picture import Picture, PlotPicture


class Plotting:
    """What has a compilation can be plotted."""

    _compilation: Compilation

    def plot(
        self,
        x: str = "",
        y: str | Sequence[str] = (),
        *,
        family: Mapping[str, Sequence[GivenSetting]] = MappingProxyType({}),
        along: Mapping[str, str] = MappingProxyType({}),
        range: tuple[GivenSetting, GivenSetting] | None = None,
        path: str | Sequence[str] = (),
        where: str | Sequence[str] = (),
        points: int = USUAL_ROWS,
        language: str = "en",
    ) -> "PlotPicture":
        """Return results ``y`` against ``x``, or the ``path`` of points while the drive moves.

        Without ``x`` the drive varies, without ``y`` the first result is shown. A ``family`` is
        a curve for each value of a parameter, ``along`` gives parameters formulas, and ``range``
        is another one than that of the description: numbers in SI and radians, or text with
        units. ``where="gamma >= 1.5 rad"`` shades where that holds, ``language`` is that of words,
        units and decimals: en, uk or ru. In a notebook the plot shows
        itself; ``save("k.svg")`` writes it, also .tex, .pdf, .png, and the table of its values
        as .csv or .xlsx. Raises :class:`mechc.MechcError` where there is no such thing to plot.

        >>> import mechc
        >>> clamp = mechc.load("karpenko_fig9_packet_clamp")
        >>> clamp.plot("alpha", family={"beta": ["10 deg", "20 deg"]}).alt
        'k against alpha from 2° to 40°. k, beta = 10°: 0.04225 at the start, ...'
        """
        from .drawing.plots.from_plot import picture
        from .emit.picture import PlotPicture
        from .formula.letters import letters
        from .report.languages.registry import locale

        settings = dict(parse(f"{name}={formula}") for name, formula in along.items())
        query = Query(
            x,
            _listed(y),
            tuple((name, tuple(values)) for name, values in family.items()),
            range,
            _listed(path),
            tuple(map(condition, _listed(where))),
            points,
        )
        plotted, words = self._compilation.along(settings).plot(query), locale(language)
        found = replace(plotted, title=self._compilation.titled(language))
        known = letters(words, self._compilation.mechanism.texts(language))
        return PlotPicture(found, picture(found, words.pictures), words.pictures, known)

    def plans(self, language: str = "en") -> "Picture | None":
        """Return the plans of velocities and of forces at the pose of the description.

        In a notebook they show themselves; ``save("plans.svg")`` writes them, also .tex, .png and
        .pdf. None where nothing moves, and no result speaks of a load.

        >>> import mechc
        >>> mechc.load("crank_rocker").plans().drawing.description
        'velocities: VA ∠ 150°; VB = 0.915\u2009VA ∠ 155°. k, without friction, ...'
        """
        from .drawing.language_letters import in_letters
        from .emit.picture import Picture
        from .formula.letters import letters
        from .report.languages.registry import locale

        words = locale(language)
        drawing = self._compilation.drawn_plans(language)
        known = letters(words, self._compilation.mechanism.texts(language))
        return Picture(in_letters(drawing, known)) if drawing else None


def _listed(names: str | Sequence[str]) -> tuple[str, ...]:
    """Return one name, or several, as several."""
    return (names,) if isinstance(names, str) else tuple(names)
