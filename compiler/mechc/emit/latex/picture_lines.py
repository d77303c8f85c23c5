"""The pictures of a report as lines of LaTeX, for reports that have none, too."""

from ...named import NamedTuple


class Pictures(NamedTuple):
    """Lines of LaTeX; none where there is no such picture."""

    scheme: tuple[str, ...] = ()
    bodies: tuple[str, ...] = ()
    plans: tuple[str, ...] = ()
    plot: tuple[str, ...] = ()
    table: tuple[str, ...] = ()


NONE = Pictures()
