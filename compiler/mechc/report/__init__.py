"""What people read: the derivation in steps, sentences in three languages, text and LaTeX.

``steps`` is the derivation as data, ``derivation`` makes it, ``kinds`` names its steps and
sentences; ``languages`` have the words, ``sentences`` say conclusions in them, ``text`` and
``latex`` typeset. ``put_in``, ``by_parts`` and ``evaluated`` put numbers into formulas, ``note``
and ``checks`` are the calculation note of a sheet, ``brief`` is a row of a table. ``book_forms``,
``proportional_results``, ``directions`` and ``made_names`` choose how formulas read; ``sections``,
``definitions``, ``columns``, ``roles`` and ``dimensions`` order and explain what stands in them.

Promises: nothing is computed here that an earlier stage has not found; every name is explained
once, before or where it is first met.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"book_forms", "directions", "proportional_results", "steps"}
    __getattr__ = waiting(__name__, SELDOM)
