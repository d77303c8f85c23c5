"""The language-neutral straight-line program and its interpreter, the oracle of every target.

Promises, which ``promises.broken_promises`` looks after: a function's steps mention its
inputs and earlier steps only; no name means two things; every input is used; no part
is computed twice; powers with small whole exponents are products.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"angle_offsets", "common_steps"}
    __getattr__ = waiting(__name__, SELDOM)
