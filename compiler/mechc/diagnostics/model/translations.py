"""Messages for translations of a description's texts."""

from collections.abc import Sequence

from ...source import Span
from ..diagnostic import Message, Related, coded
from ..syntax import listed


@coded("E328")
def into_no_language(span: Span, text: str, languages: Sequence[str]) -> Message:
    """A text is translated into no language: name one.

    translate "handle"                  # wrong
    translate "handle" uk "рукоятка"    # right
    """
    hint = f"name a language: {listed(languages, 'or')}, and the text in it"
    return Message(span, f"'{text}' is translated into no language", hint)


@coded("E329")
def translated_twice(span: Span, text: str, language: str, before: Span) -> Message:
    """A text is translated twice into one language.

    translate "handle" uk "рукоятка"
    translate "handle" uk "ручка"       # wrong: which?
    """
    related = (Related(before, "it is translated here before"),)
    return Message(span, f"'{text}' has two translations ({language})", "remove one", related)


@coded("W224")
def of_no_text(span: Span, text: str, hint: str) -> Message:
    """A translation is of a text or name that the description does not have, or no longer.

    A word in names, ``far`` in ``P_far``, is translated in all of them.

    param a = 1 m as "arm"
    translate "arms" uk "плече"         # warned of: the text is "arm"
    """
    hint = hint or "a title, source, label, about, remark or name of the description is translated"
    return Message(span, f"no text of this description is '{text}'", hint)
