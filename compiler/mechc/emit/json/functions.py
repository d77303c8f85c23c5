"""The functions of the emitted code, as the document lists them."""

from ...routine.steps import STATUSES, Function
from ..describe import condition_lines, numbered
from .kinds import TEXT, Kind, list_of, member, optional, record

FUNCTION: Kind[Function] = record(
    "function",
    "A function of the emitted code.",
    member("name", "The result's.", TEXT, lambda f: f.name),
    member("inputs", "In order.", list_of(TEXT), lambda f: tuple(i.name for i in f.inputs)),
    member(
        "conditions",
        "Where one is broken, the function gives NaN.",
        list_of(TEXT),
        lambda f: tuple(condition_lines(f)),
    ),
    member(
        "otherwise",
        "The function that is called where this one has no value.",
        optional(TEXT),
        lambda f: f.otherwise.name if f.otherwise else None,
    ),
    member(
        "status",
        f"The function that tells what its numbers and NaN mean: {'; '.join(numbered(STATUSES))}.",
        optional(TEXT),
        lambda f: f.status.name if f.status else None,
    ),
    member(
        "operations",
        "With shared parts computed once.",
        Kind({"type": "integer"}, int),
        lambda f: f.operations,
    ),
)
