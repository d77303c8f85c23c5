"""Messages for halves and branches that have nothing in common (W203, W242)."""

from ...source import Span
from ..diagnostic import Message, coded


@coded("W203")
def halves_apart(at: Span) -> Message:
    """The halves of a mirror share no point and nothing acts between them.

    Then each half is a mechanism of its own, and a load on both counts twice.

        mirror across 90 deg               # warned of
        mirror across 90 deg sharing K     # right: K belongs to both halves
    """
    return Message(at, "the halves share no point, so each stands alone", "add `sharing K`")


@coded("W242")
def copies_apart(at: Span) -> Message:
    """Equal branches share no point, so that each is a mechanism of its own.

    copies 3               # warned of: k is that of one branch alone
    copies 3 sharing K     # right: K belongs to all three
    """
    return Message(at, "the copies share no point, so each stands alone", "add `sharing K`")
