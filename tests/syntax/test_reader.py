"""Reading by tables gives what Lark itself reads."""

from functools import cache

from hypothesis import given
from hypothesis import strategies as st
from lark import Lark, Transformer
from lark import Token as LarkToken

from mechc.data_folders import data
from mechc.syntax.parser import grammar, make_tables
from mechc.syntax.parser.lalr import END, Parser, ParserState, Token
from mechc.syntax.parser.lines import lines
from mechc.syntax.parser.tokens import tokens
from notations import CONSTRUCTS, WHOLE_MECH


def test_the_shipped_tables_are_of_this_grammar():
    assert make_tables.MADE.read_text("utf-8") == make_tables.written()


def test_tables_are_made_anew_where_the_file_is_of_another_grammar(monkeypatch):
    shipped = grammar.tables()
    monkeypatch.setattr(grammar, "checksum", lambda text: 0)
    anew = grammar.tables()
    assert anew.terminals == [tuple(terminal) for terminal in shipped.terminals]
    assert (anew.words, anew.rules, anew.states) == (shipped.words, shipped.rules, shipped.states)


class Plain(Transformer):
    """Every rule of Lark's tree as its name and its parts."""

    def __default__(self, data, children, meta):
        return (str(data), *children)


class PlainRules(dict):
    def __missing__(self, name):
        return lambda *children: (name, *children)


@cache
def by_lark():
    return Lark(grammar.grammar(), parser="lalr", lexer="basic", start=grammar.STARTS)


def all_lines():
    texts = [path.read_text("utf-8") for path in sorted(data("library").glob("*.mech"))[::4]]
    for text in [WHOLE_MECH, *(construct[0] for construct in CONSTRUCTS), *texts]:
        yield from (line.tokens for line in lines(tokens(text)) if line.tokens)


def test_the_reader_builds_the_tree_that_lark_builds():
    plain = Parser(grammar.tables(), PlainRules())
    for line in all_lines():
        theirs, ours = (
            by_lark().parse_interactive(start="statement"),
            ParserState(plain, "statement"),
        )
        for token in line:
            assert ours.accepted() == theirs.accepts()
            theirs.feed_token(LarkToken(token.type, str(token)))
            ours.feed(token)
        assert ours.accepted() == theirs.accepts()
        tree = theirs.feed_token(LarkToken("$END", ""))
        assert ours.feed(Token(END, "")) == Plain().transform(tree)


@given(st.text(alphabet="ab1.e+-*/<>=!@(),:#\"'\\ \t\n_é", max_size=40) | st.text(max_size=20))
def test_the_lexer_cuts_as_lark_does(text):
    theirs = [(t.type, str(t), t.start_pos, t.end_pos) for t in by_lark().lex(text)]
    ours = [(t.type, str(t), t.start_pos, t.end_pos) for t in grammar.lexed(text)]
    assert ours == theirs
