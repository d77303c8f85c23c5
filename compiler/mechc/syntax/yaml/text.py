"""Scalars as YAML text: plain where every YAML reader takes them for the same text."""

from ...base.later import pattern

# Nothing that YAML gives a meaning: no indicator in front, no ': ', no ' #'.
PLAIN = pattern(r"(?![-?:](?:\s|$))[^\s,\[\]{}#&*!|>'\"%@`?:][^\n]*(?<![\s:])")
MEANT = pattern(r":\s|\s#")
IN_FLOW = pattern(r"[,?\[\]{}]")  # some readers end a plain scalar at any '?' there
OTHER_TYPE = pattern(
    r"(?i)~|null|true|false|yes|no|on|off|y|n|[-+.\d][\d_.,:eE+-]*|\.(?:inf|nan)|0[xo][\da-f]+|---.*|\.\.\..*"
)
NO_NAME = pattern(r"(?i)null|true|false|yes|no|on|off")
PRINTABLE = pattern(
    r"[\x20-\x7e\xa0-\u2027\u202a-\ud7ff\ue000-\ufefe\uff00-\ufffd\U00010000-\U0010ffff]*"
)


def scalar(value: str, flow: bool = False) -> str:
    """Return an expression or a name as a scalar, inside ``[…]`` or ``{…}`` if ``flow``.

    A name that some YAML reader takes for nothing or for a truth value is in quotes.

    >>> scalar("a @ alpha - 90 deg"), scalar("atan2(y, x)", flow=True), scalar("null")
    ('a @ alpha - 90 deg', "'atan2(y, x)'", "'null'")
    """
    return value if is_plain(value, flow) and not NO_NAME.fullmatch(value) else quoted(value)


def text(value: str, flow: bool = False) -> str:
    """Return a text as a scalar; in quotes too where YAML would see a number or a truth value.

    >>> text("2023"), text("fig. 9")
    ("'2023'", 'fig. 9')
    """
    return value if is_plain(value, flow) and not OTHER_TYPE.fullmatch(value) else quoted(value)


def is_plain(value: str, flow: bool) -> bool:
    """Return whether a text can stand without quotes."""
    return bool(
        PLAIN.fullmatch(value)
        and PRINTABLE.fullmatch(value)
        and not MEANT.search(value)
        and not (flow and IN_FLOW.search(value))
    )


def quoted(value: str) -> str:
    r"""Return a text in quotes, double ones where it has characters that must be escaped.

    >>> quoted("it's"), quoted("a\nb")
    ("'it''s'", '"a\\nb"')
    """
    if PRINTABLE.fullmatch(value):
        return "'" + value.replace("'", "''") + "'"
    return '"' + "".join(escaped(character) for character in value) + '"'


def escaped(character: str) -> str:
    """Return one character as it stands in double quotes."""
    match character:
        case '"' | "\\":
            return "\\" + character
        case "\n":
            return "\\n"
        case _ if PRINTABLE.fullmatch(character):
            return character
        case _:
            return f"\\U{ord(character):08X}"
