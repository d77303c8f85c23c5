"""Templates: the shape of a file, beside its target, filled from a frozen context."""

from importlib import import_module
from typing import Protocol

from ..named import NamedTuple


class Context(Protocol):
    """A NamedTuple: its fields are what the template may mention."""

    def _asdict(self) -> dict[str, object]: ...


class Nothing(NamedTuple):
    """The context of a template that mentions nothing."""


def render(template: str, context: Context) -> str:
    """Return a file's text from a template (``c/header.jinja``) and its context.

    What the template mentions and the context lacks is an error.
    """
    folder = template.partition("/")[0]
    made = import_module(f".{folder}.templates", __package__)
    text: str = made.TEMPLATES[template](context._asdict())
    return text


class Line(NamedTuple):
    """One statement of a function: ``name = code``."""

    name: str
    code: str
