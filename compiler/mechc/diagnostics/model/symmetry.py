"""Messages for halves and branches that have nothing in common (W203, W242)."""

from ...source import Span
from ..diagnostic import Message, coded


@coded("W203")
def halves_apart(at: Span, along: str) -> Message:
    """The halves of a mirror share no point that moves, and nothing acts between them.

    Then each half is a mechanism of its own, and a load on both counts twice. A pivot alone may
    be meant, as in a pair of tongs, but hardly where a point slides along the mirror line.

        slider K along 90 deg
        mirror across 90 deg               # warned of
        mirror across 90 deg sharing O     # warned of where O is a pivot: there are two K
        mirror across 90 deg sharing K     # right: K belongs to both halves
    """
    message = "the halves share no point that moves, so each stands alone"
    return Message(at, message, f"add `sharing {along or 'K'}`")


@coded("W242")
def copies_apart(at: Span) -> Message:
    """Equal branches share no point that moves, so that each is a mechanism of its own.

    copies 3               # warned of: k is that of one branch alone
    copies 3 sharing O     # warned of where O is a pivot
    copies 3 sharing K     # right: K belongs to all three
    """
    message = "the copies share no point that moves, so each stands alone"
    return Message(at, message, "add `sharing K`")
