"""Links and joints, where they are, what drives them, and of what they are copies.

Promises: every point of a joint or guide stands on a body, a pivot or a slider.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"held"}
    __getattr__ = waiting(__name__, SELDOM)
