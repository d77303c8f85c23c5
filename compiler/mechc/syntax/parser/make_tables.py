"""The parser's tables, made by Lark.

``python -m mechc.syntax.parser.make_tables`` ships them anew.
"""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from lark import Lark
from lark.grammar import Rule as LarkRule
from lark.lexer import PatternStr, TerminalDef

from .grammar import STARTS, checksum, grammar
from .lalr import ParserTables, Reduction

MADE = Path(__file__).with_name("made_tables.py")

HEAD = '''"""The parser's tables, made by ``mechc.syntax.parser.make_tables``."""

from .lalr import ParserTables, Reduction
'''


def make(grammar: str, starts: list[str]) -> ParserTables:
    """Return the tables of a grammar in Lark's notation."""
    lark = Lark(grammar, parser="lalr", lexer="basic", start=starts)
    terminals = sorted(lark.terminals, key=_precedence)
    words = {t.name: _words(t, terminals) for t in terminals}
    several = {name for found in words.values() for name in found.values()}
    frontend: Any = lark.parser
    table = frontend.parser._parse_table
    order = _order(table, starts)
    numbers = {rule: ~number for number, rule in enumerate(lark.rules)} | order
    return ParserTables(
        terminals=[(t.name, t.pattern.to_regexp()) for t in terminals if t.name not in several],
        words={name: found for name, found in words.items() if found},
        texts={t.name: t.pattern.value for t in terminals if isinstance(t.pattern, PatternStr)},
        ignored=list(lark.ignore_tokens),
        rules=[_rule(rule) for rule in lark.rules],
        states=[_state(table.states[state], numbers) for state in order],
        starts={s: (order[table.start_states[s]], order[table.end_states[s]]) for s in starts},
    )


def written() -> str:
    """Return the tables as the text of their module."""
    text = grammar()
    return "\n".join([HEAD, f"MADE_FROM = {checksum(text)}", *_literal(make(text, STARTS)), ""])


def _literal(tables: ParserTables) -> Iterator[str]:
    """Yield the lines of the tables as Python, a line for each entry of a list."""
    yield "TABLES = ParserTables("
    for name, value in tables._asdict().items():
        if isinstance(value, list):
            yield from (f"{name}=[", *(f"{entry!r}," for entry in value), "],")
        else:
            yield f"{name}={value!r},"
    yield ")"


def _precedence(terminal: TerminalDef) -> tuple[object, ...]:
    """Order terminals as Lark's own lexer tries them."""
    pattern = terminal.pattern
    return -terminal.priority, -pattern.max_width, -len(pattern.value), terminal.name


def _words(terminal: TerminalDef, others: list[TerminalDef]) -> dict[str, str]:
    """Return the terminals, by their texts, that a pattern would swallow."""
    if isinstance(terminal.pattern, PatternStr):
        return {}
    whole = re.compile(terminal.pattern.to_regexp())
    return {
        t.pattern.value: t.name
        for t in others
        if isinstance(t.pattern, PatternStr)
        and t.priority == terminal.priority
        and whole.fullmatch(t.pattern.value)
    }


def _order(table: Any, starts: list[str]) -> dict[Any, int]:
    """Number the states as they are reached, since Lark's own numbers change with each run."""
    reached = [table.start_states[start] for start in starts]
    for state in reached:  # grows while it is read
        following = [to for _, (_, to) in sorted(table.states[state].items(), key=_name)]
        reached += [to for to in following if isinstance(to, int) and to not in reached]
    return {state: number for number, state in enumerate(reached)}


def _state(actions: dict[str, tuple[Any, Any]], numbers: dict[Any, int]) -> dict[str, int]:
    """Return the actions in a state: go on to another, or reduce by a rule, written ``~rule``."""
    return {name: numbers[to] for name, (_, to) in sorted(actions.items(), key=_name)}


def _name(action: tuple[str, Any]) -> str:
    return action[0]


def _rule(rule: LarkRule) -> Reduction:
    options: Any = rule.options
    name = str(rule.alias or rule.origin.name)
    collapses = bool(options.expand1 and not rule.alias)
    return Reduction(str(rule.origin.name), len(rule.expansion), name, _children(rule), collapses)


def _children(rule: LarkRule) -> list[int | None]:
    """Return the places of a rule's parts, without the words that only mark it.

    None stands for a part that may be missing and is, ``~place`` for one that has the parts of a
    rule of its own, which take its place.
    """
    symbols: Any = rule.expansion
    options: Any = rule.options
    places = iter(range(len(symbols)))
    children: list[int | None] = []
    for left_out in options.empty_indices or [False] * len(symbols):
        if left_out:
            children.append(None)
            continue
        place = next(places)
        if not symbols[place].is_term:
            children.append(~place if _inlined(symbols[place]) else place)
        elif not symbols[place].filter_out:
            children.append(place)
    return children


def _inlined(symbol: Any) -> bool:
    return bool(symbol.name.startswith("_"))


if __name__ == "__main__":
    MADE.write_text(written(), "utf-8")
