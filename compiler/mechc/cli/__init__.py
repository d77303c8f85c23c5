"""The command line: ``main`` is the way in, and each of the ``commands`` has a module.

A line is read by ``usage``: by ``plain`` where it is right, else, and for help, ``by_click``.

Data goes to standard output, messages to standard error. Exit status: 0 done, 1 the
description is wrong, 2 the command line is, 3 a file or the environment, 4 a limit,
70 mechc itself.
"""

from .main import console, main

__all__ = ["console", "main"]

TYPE_CHECKING = False
if not TYPE_CHECKING:
    from ..base.later import waiting

    __getattr__ = waiting(__name__, {"by_click", "opening", "store_answers"})
