"""The words of errors in the shape of a YAML description (E12x, E13x)."""

from collections.abc import Iterable

from ..source import Span
from .diagnostic import Message, Related, coded, near_miss
from .syntax import listed


@coded("E120")
def not_yaml(span: Span, problem: str, hint: str = "") -> Message:
    """The text is not well-formed YAML.

    Check the indentation and the brackets near the marked place. Two habits bite: a
    value may not begin with ``@`` or ``*``, and a colon inside a text needs quotes.

        geometry:
          BK: @ -90 deg          # wrong
          BK: {angle: -90 deg}   # right
    """
    hint = hint or "look for an indentation, a colon or a bracket that is wrong"
    return Message(span, f"not well-formed YAML: {problem}", hint)


@coded("E121")
def duplicate_key(span: Span, key: str, first: Span) -> Message:
    """A key stands twice in one mapping; which of the two is meant?"""
    related = (Related(first, "first used here"),)
    return Message(
        span, f"the key '{key}' stands twice", "remove or rename one of the two", related
    )


@coded("E122")
def alias_refused(span: Span, what: str) -> Message:
    """YAML's anchors and aliases are not part of the language.

    A small file of aliases can stand for an enormous one, and a reader cannot see what
    it says. Write the value where it is used, or name it as a parameter.

        a: &size 40 mm           # wrong
        b: *size
        a: 40 mm                 # right
        b: a
    """
    hint = "name the value as a parameter; a value that begins with * or & needs quotes"
    return Message(span, f"found {what}, which descriptions do not have", hint)


@coded("E123")
def tag_refused(span: Span, tag: str) -> Message:
    """YAML's tags are not part of the language: a description never constructs objects.

    a: !!float 40            # wrong
    a: 40                    # right
    """
    return Message(span, f"found the tag '{tag}', which descriptions do not have", "remove it")


@coded("E124")
def wrong_shape(span: Span, found: str, expected: str, hint: str = "") -> Message:
    """A mapping, a list or a plain value stands where another of them is expected.

    pivots: {x: [O]}         # wrong
    pivots: [O]              # right
    """
    return Message(span, f"found {found}, expected {expected}", hint or f"write {expected}")


@coded("E125")
def unknown_key(
    span: Span, key: str, place: str, allowed: Iterable[str], hint: str = ""
) -> Message:
    """A key that this place does not have.

    forces: {P: {on: A, along: 0 deg}}   # wrong
    forces: {P: {at: A, along: 0 deg}}   # right
    """
    allowed = list(allowed)
    hint = near_miss(key, allowed) or hint or f"allowed here: {', '.join(allowed)}"
    return Message(span, f"unknown key '{key}' in {place}", hint)


@coded("E126")
def missing_key(span: Span, keys: Iterable[str], place: str) -> Message:
    """A key without which the entry has no meaning is not there.

    forces: {P: {at: A}}                 # wrong: in which direction?
    forces: {P: {at: A, along: 0 deg}}   # right
    """
    missing = listed([f"'{key}'" for key in keys], "and")
    return Message(span, f"{place} lacks {missing}", f"add {missing}")


@coded("E127")
def round_brackets(span: Span) -> Message:
    """A pair of coordinates is written in round brackets inside YAML's braces.

    In flow style YAML cuts ``{O: (x, y)}`` at the comma into two keys. Coordinates are
    a list.

        pivots: {O: (0, 10 mm)}  # wrong
        pivots: {O: [0, 10 mm]}  # right
    """
    return Message(span, "a pair in round brackets is cut at its comma", "write [x, y]")


@coded("E140")
def colon_without_space(span: Span, text: str) -> Message:
    """A colon of YAML has no space behind it, so that key and value are one word.

    sliders: {K:90 deg}      # wrong
    sliders: {K: 90 deg}     # right
    """
    key, _, value = text.partition(":")
    return Message(span, f"the colon in '{text}' has no space behind it", f"write {key}: {value}")


@coded("W287")
def text_cut_short(span: Span, comment: str) -> Message:
    """A text of YAML ends at a ``#``, which begins a comment where a space stands before it.

    title: Jack #2       # warned of: the title is Jack
    title: "Jack #2"     # right
    """
    shown = comment if len(comment) < 30 else f"{comment[:30]}…"
    return Message(span, f"the text ends here: '{shown}' is a comment", "put the text in quotes")


@coded("E128")
def one_document(span: Span) -> Message:
    """A file holds one description, so ``---`` may stand only at its top."""
    return Message(span, "a second YAML document begins here", "put it into a file of its own")
