"""What the templates of reports print, piece by piece."""

from collections.abc import Mapping

from ...base.named import NamedTuple
from ...report.languages.locale import Locale
from ...report.latex.given import ParameterRow, VectorRow
from ...report.latex.results import SectionBlock
from .note import TableBlock


class StepBlock(NamedTuple):
    """One step of the derivation, ready for LaTeX."""

    sentence: str
    relations: str
    results: str


class PositionBlock(NamedTuple):
    """The directions and lengths that one loop gives, ready for LaTeX."""

    sentence: str
    displays: tuple[str, ...]


class Pictures(NamedTuple):
    """The pictures of a report as lines of LaTeX; none where there is no such picture."""

    scheme: tuple[str, ...] = ()
    bodies: tuple[str, ...] = ()
    plans: tuple[str, ...] = ()
    plot: tuple[str, ...] = ()
    table: tuple[str, ...] = ()


NO_PICTURES = Pictures()


class ReportContext(NamedTuple):
    """All that the body's template prints."""

    locale: Locale
    made_by: str
    section: str
    kind: str
    conventions: str
    convention_of_speeds: str
    title: str
    source: str
    parameters: tuple[ParameterRow, ...]
    words: Mapping[str, str]
    tables: tuple[TableBlock, ...]
    scheme: tuple[str, ...]
    vectors: tuple[VectorRow, ...]
    position: tuple[PositionBlock, ...]
    steps: tuple[StepBlock, ...]
    explained: str
    balances: str
    last: str
    results: tuple[SectionBlock, ...]
    conditions: str
    of_position: tuple[str, ...]
    values: str
    numbers: tuple[str, ...]
    check: str
    remarks: tuple[str, ...]
    pictures: Pictures


class Brief(NamedTuple):
    """All that the template of a report in brief prints."""

    locale: Locale
    made_by: str
    section: str
    kind: str
    title: str
    source: str
    displays: tuple[str, ...]
    numbers: tuple[str, ...]
    values: str


class UsedMechanismContext(NamedTuple):
    """All that the template of a mechanism in the report of a sheet prints."""

    section: str
    heading: str
    sentence: str
    body: str


class Document(NamedTuple):
    """All that the template of a whole document prints."""

    body: str
    babel: str
    eastern: bool
    cyrillic: bool
    pictures: tuple[str, ...]
