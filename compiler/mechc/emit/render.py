"""Templates: the shape of a file, beside its target, filled from a frozen context."""

from functools import cache
from typing import NamedTuple, Protocol

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from ..data import data

TEMPLATES = data("emit")


class Context(Protocol):
    """A NamedTuple: its fields are what the template may mention."""

    def _asdict(self) -> dict[str, object]: ...


@cache
def environment() -> Environment:
    """Return the templates' environment; a name that the context lacks is an error."""
    return Environment(
        loader=FileSystemLoader(TEMPLATES),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )


def render(template: str, context: Context) -> str:
    """Return a file's text from a template (``c/header.jinja``) and its context."""
    return environment().get_template(template).render(context._asdict())


class Line(NamedTuple):
    """One statement of a function: ``name = code``."""

    name: str
    code: str
