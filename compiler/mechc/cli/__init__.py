"""The command line. A command's module is imported when the command is used.

Data goes to standard output, messages to standard error. Exit status: 0 done, 1 the
description is wrong, 2 the command line is, 3 a file or the environment, 4 a limit,
70 mechc itself.
"""

from .main import console, main

__all__ = ["console", "main"]

TYPE_CHECKING = False
if not TYPE_CHECKING:
    from ..later import waiting

    __getattr__ = waiting(__name__, {"by_click", "opening", "store_answers"})
