"""What is said of a description as a whole, and what every statement has."""

from ...base.frozen import field, frozen
from ...source import Span
from .expressions import Name


@frozen
class Statement:
    """One line of a description. ``comments`` stand above it, ``remark`` behind it."""

    span: Span = field(compare=False)
    comments: tuple[str, ...] = field(default=(), kw_only=True)
    remark: str = field(default="", kw_only=True)


@frozen
class Version(Statement):
    """``mechc 1``."""

    number: str


@frozen
class Heading(Statement):
    """``mechanism NAME "Title"``; the title is '' where there is none."""

    name: Name
    title: str = ""


@frozen
class SheetHeading(Heading):
    """``sheet NAME "Title"``: the heading of a calculation sheet."""


@frozen
class SourceNote(Statement):
    """``source "where it comes from"``."""

    text: str


@frozen
class Translate(Statement):
    """``translate "arm" uk "плече" ru "плечо"``: what a text is in other languages, '' in none."""

    text: str
    en: str = ""
    uk: str = ""
    ru: str = ""


@frozen
class Reported(Statement):
    """``report scheme``, ``report k``, ``report plot k over alpha``: one thing that a report holds.

    ``over`` is what a plot is against, None for what is no plot.
    """

    name: Name
    over: Name | None = None


@frozen
class File:
    """A whole description: its statements in order, and the comments after the last one."""

    statements: tuple[Statement, ...]
    trailing: tuple[str, ...] = ()
