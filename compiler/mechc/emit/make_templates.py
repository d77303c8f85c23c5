"""Templates as functions: ``python -m mechc.emit.make_templates`` writes them anew.

Jinja reads the templates; each becomes a plain function here, so that no compilation spends a
quarter of its time on reading them and on importing Jinja.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import cache

from jinja2 import Environment, FileSystemLoader, nodes

from ..data_folders import PACKAGE

EMIT = PACKAGE / "emit"
TARGETS = tuple(sorted({path.parent.name for path in EMIT.glob("*/*.jinja")}))
"""The folders that have templates."""

MADE = "made_templates.py"

MARKS = {
    "block_start_string": "<%",
    "block_end_string": "%>",
    "variable_start_string": "<<",
    "variable_end_string": ">>",
    "comment_start_string": "<#",
    "comment_end_string": "#>",
}
"""The marks of templates for LaTeX, where braces mean something else."""

HEAD = '''"""The templates of this folder as functions, made by ``mechc.emit.make_templates``."""

from collections.abc import Mapping
from typing import Any

from ..render import turns
'''

KNOWN, PARTS = "_known", "_parts"
"""Variables of each function that no template may name: what it is given, what it has written."""

OPERATORS = {
    "eq": "==",
    "ne": "!=",
    "gt": ">",
    "gteq": ">=",
    "lt": "<",
    "lteq": "<=",
    "in": "in",
    "notin": "not in",
}

FILTERS = {
    "join": "{1}.join(map(str, {0}))",
    "length": "len({0})",
    "list": "list({0})",
    "reverse": "reversed({0})",
}

Local = frozenset[str]
"""The names that are variables where a line stands; all others were given."""


@cache
def environment(target: str) -> Environment:
    """Return the reader of a target's templates."""
    return Environment(
        loader=FileSystemLoader(EMIT),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        **(MARKS if target == "latex" else {}),  # type: ignore[arg-type]
    )


def written(target: str) -> str:
    """Return the text of a target's module of templates."""
    paths = sorted((EMIT / target).glob("*.jinja"))
    functions = (line for path in paths for line in _template(target, path.stem))
    table = (f'    "{target}/{path.name}": _{path.stem},\n' for path in paths)
    return "".join([HEAD, *functions, "\n\nTEMPLATES = {\n", *table, "}\n"])


def _template(target: str, stem: str) -> Iterator[str]:
    """Yield the lines of a template's function, those of its macros first."""
    source = (EMIT / target / f"{stem}.jinja").read_text("utf-8")
    tree = environment(target).parse(source)
    for macro in tree.find_all(nodes.Macro):
        names = [argument.name for argument in macro.args]
        arguments = "".join(f"{name}: Any, " for name in names).rstrip(", ")
        yield from _function(f"macro_{macro.name}({arguments})", macro.body, frozenset(names))
    yield from _function(f"_{stem}({KNOWN}: Mapping[str, Any])", tree.body, frozenset())


def _function(head: str, body: Sequence[nodes.Node], local: Local) -> Iterator[str]:
    yield f"\n\ndef {head} -> str:\n    {PARTS}: list[str] = []\n"
    for line in _lines(body, local):
        yield f"    {line}\n"
    yield f'    return "".join({PARTS})\n'


# ---------------------------------------------------------------------- statements


def _lines(body: Iterable[nodes.Node], local: Local) -> Iterator[str]:
    """Yield the lines that write a template's statements; a variable holds to their end."""
    for node in body:
        yield from _statement(node, local)
        if isinstance(node, nodes.Assign):
            local |= {_bound(node.target)}


def _statement(node: nodes.Node, local: Local) -> Iterator[str]:
    """Yield the lines of code that a statement of a template becomes."""
    match node:
        case nodes.Output(nodes=parts):
            yield f"{PARTS} += [{', '.join(_printed(part, local) for part in parts)}]"
        case nodes.If():
            yield from _if(node, local)
        case nodes.For():
            yield from _for(node, local)
        case nodes.Assign(target=target, node=value):
            yield f"{_bound(target)} = {_code(value, local)}"
        case nodes.Include(template=name):
            known = "".join(f', "{name}": {name}' for name in sorted(local))
            given = f"{{**{KNOWN}{known}}}" if local else KNOWN
            yield f"{PARTS} += [TEMPLATES[{_code(name, local)}]({given})]"
        case nodes.Macro() | nodes.FromImport():
            return
        case _:
            raise NotImplementedError(f"{type(node).__name__}, line {node.lineno}")


def _if(node: nodes.If, local: Local) -> Iterator[str]:
    word = "if"
    for branch in (node, *node.elif_):
        yield f"{word} {_code(branch.test, local)}:"
        yield from _indented(branch.body, local)
        word = "elif"
    if node.else_:
        yield "else:"
        yield from _indented(node.else_, local)


def _for(node: nodes.For, local: Local) -> Iterator[str]:
    """Yield a loop; where its body asks how far it is, ``loop`` counts."""
    name, values = _bound(node.target), _code(node.iter, local)
    within = local | {name}
    if node.test:
        values = f"[{name} for {name} in {values} if {_code(node.test, within)}]"
    if any(used.name == "loop" for used in node.find_all(nodes.Name)):
        yield f"for loop, {name} in turns({values}):"
        within |= {"loop"}
    else:
        yield f"for {name} in {values}:"
    yield from _indented(node.body, within)


def _indented(body: Sequence[nodes.Node], local: Local) -> Iterator[str]:
    lines = list(_lines(body, local))
    return (f"    {line}" for line in lines or ["pass"])


def _bound(target: nodes.Node) -> str:
    assert isinstance(target, nodes.Name), target
    return target.name


# --------------------------------------------------------------------- expressions


def _printed(node: nodes.Node, local: Local) -> str:
    """Return the code of what an expression prints."""
    match node:
        case nodes.TemplateData(data=text):
            return repr(text)
        case nodes.Call():
            return _code(node, local)
        case _:
            return f"str({_code(node, local)})"


def _code(node: nodes.Node | None, local: Local) -> str:
    """Return the code of an expression."""

    def code(part: nodes.Node | None) -> str:
        return "" if part is None else _code(part, local)

    match node:
        case nodes.Name(name=name):
            return name if name in local else f'{KNOWN}["{name}"]'
        case nodes.Const(value=value):
            return repr(value)
        case nodes.Getattr(node=of, attr=name):
            return f"{code(of)}.{name}"
        case nodes.Getitem(node=of, arg=place):
            return f"{code(of)}[{code(place)}]"
        case nodes.Slice(start=start, stop=stop):
            return f"{code(start)}:{code(stop)}"
        case nodes.List(items=items):
            return f"[{', '.join(map(code, items))}]"
        case nodes.Call(node=nodes.Name(name=name), args=given):
            return f"macro_{name}({', '.join(map(code, given))})"
        case nodes.Filter(name="selectattr", node=values, args=[nodes.Const(value=name)]):
            return f"[_one for _one in {code(values)} if _one.{name}]"
        case nodes.Filter(name=name, node=value, args=given):
            return FILTERS[name].format(code(value), *map(code, given))
        case nodes.CondExpr(test=test, expr1=then, expr2=otherwise):
            return f"({code(then)} if {code(test)} else {code(otherwise) or repr('')})"
        case nodes.Compare(expr=left, ops=[nodes.Operand(op=name, expr=right)]):
            return f"({code(left)} {OPERATORS[name]} {code(right)})"
        case nodes.Not(node=part):
            return f"(not {code(part)})"
        case nodes.And() | nodes.Or() | nodes.Add() | nodes.Mul() | nodes.FloorDiv():
            return f"({code(node.left)} {node.operator} {code(node.right)})"
        case _:
            raise NotImplementedError(f"{node}")


if __name__ == "__main__":
    for each in TARGETS:
        (EMIT / each / MADE).write_text(written(each), "utf-8")
