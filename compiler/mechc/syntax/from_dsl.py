"""The line notation (``.mech``) to the syntax tree."""

from ..base.frozen import replace
from ..diagnostics import Report
from ..source import Source
from . import ast
from .fault import Fault, check_characters, check_length, check_once, note
from .parser.grammar import keywords, statement_words
from .parser.lalr import span_of
from .parser.lines import SourceLine, lines
from .parser.parse import parse as parse_line
from .parser.tokens import tokens

ON_ONE_LINE = "a statement stands on one line, however long"


def parse(source: Source, report: Report) -> ast.File:
    """Return the tree of a ``.mech`` text.

    Errors go to the report, as many as there are statements with one; a statement with
    an error is not in the tree. Raises :class:`MechcError` only for a text that is too
    long or has too many errors.

    >>> source = Source("a.mech", "pivot O  # left pin")
    >>> parse(source, Report(source)).statements
    (Pivot(span=Span(start=0, end=7), point=Name(text='O', ...remark='left pin'),)
    """
    check_length(source, report)
    check_characters(source.text, None, report)
    statements: list[ast.Statement] = []
    *found, last = lines(tokens(source.text))
    found += [last] if last.tokens else []
    trailing = () if last.tokens else last.comments
    is_cut = False
    for line, following in zip(found, [*found[1:], None], strict=False):
        try:
            statements += [] if is_cut and goes_on(line) else statements_of(line)
            is_cut = False
        except Fault as fault:
            is_cut = following is not None and goes_on(following)
            hint = ON_ONE_LINE if is_cut else fault.diagnostic.hint
            note(replace(fault.diagnostic, hint=hint), report)
    check_once(statements, report)
    return ast.File(tuple(statements), trailing)


def goes_on(line: SourceLine) -> bool:
    """Return whether a line begins with a word from within a statement: ``along 0 deg``."""
    word = str(line.tokens[0])
    return word in keywords() and word not in statement_words()


def statements_of(line: SourceLine) -> list[ast.Statement]:
    """Return the statements of a line: one, or several behind one ``find``."""
    span = span_of(line.tokens[0]).to(span_of(line.tokens[-1]))
    made = parse_line(line.tokens, "statement", span.end)
    several = made if isinstance(made, tuple) else (made,)
    found = [replace(node, span=span) for node in several]
    found[0] = replace(found[0], comments=line.comments)
    found[-1] = replace(found[-1], remark=line.remark)
    return found
