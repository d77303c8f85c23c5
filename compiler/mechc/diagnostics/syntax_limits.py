"""The words of errors about size: of the text (E811 … E816), and of the work it makes (E817)."""

from ..source import Span
from .diagnostic import Message, coded


@coded("E811")
def text_too_long(span: Span, length: int, limit: int) -> Message:
    """The file is longer than any description written by hand or by a sensible program."""
    message = f"the text has {length} characters, expected at most {limit}"
    return Message(span, message, "is this the right file? A mechanism is some lines long")


@coded("E812")
def nested_too_deep(span: Span, limit: int) -> Message:
    """Brackets, powers of powers or repeated signs are nested too deep.

    Name a part of the expression with ``let`` and use the name.
    """
    hint = "name a part of it with 'let'"
    return Message(span, f"nested deeper than {limit} levels", hint)


@coded("E813")
def number_too_long(span: Span, limit: int) -> Message:
    """A number has more digits than any measured value.

    Numbers are kept exactly as typed, so their length is limited.
    """
    return Message(span, f"a number of more than {limit} digits", "a double holds 17")


@coded("E814")
def exponent_too_large(span: Span, exponent: str, limit: int) -> Message:
    """A power or a decimal exponent is too large to compute with.

    let k = a^1000           # wrong
    param c = 1e400          # wrong
    """
    message = f"found the exponent {exponent}, expected at most {limit}"
    return Message(span, message, "is the exponent mistyped?")


@coded("E815")
def yaml_too_large(span: Span, what: str, limit: int) -> Message:
    """The YAML text nests deeper, or has more values, than a description needs."""
    return Message(span, f"the YAML text has more than {limit} {what}", "is this the right file?")


@coded("E816")
def too_many_errors(span: Span, limit: int) -> Message:
    """Reading stopped after so many errors; fix the first ones and try again."""
    message = f"more than {limit} errors: the rest of the text was not read"
    return Message(span, message, "correct the first ones and try again")


@coded("E817")
def too_much_work(span: Span, limit: int) -> Message:
    """The formulas of this mechanism grow beyond what can be computed, or be read.

    Steps of work are counted: in algebra terms of sums added, multiplied and divided, and
    factors compared; in numbers the operations by which formulas are evaluated and solved,
    over ranges and strokes, too. The count depends on the description alone, not on the
    machine. Every known mechanism takes less than a tenth of the limit. A great many bodies
    that are all coupled with one another take more, as the length of their formula doubles
    with each. Describe a part of it with a ``find`` of its own; for a formula that should not
    be so long, please report it.
    """
    return Message(
        span,
        f"algebra and evaluation took more than {limit} steps, expected less",
        "describe a part of the mechanism by itself, with the forces between the parts as loads",
    )
