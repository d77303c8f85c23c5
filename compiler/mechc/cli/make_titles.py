"""The titles of the library, noted for ``mechc list``: ``python -m mechc.cli.make_titles``."""

from ..data import data
from .list import NOTED, noted

if __name__ == "__main__":
    (data("library") / NOTED).write_text(noted(), "utf-8")
