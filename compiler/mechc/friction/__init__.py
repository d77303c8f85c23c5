"""Friction: the surfaces that slide, the forces that press them, and k with both.

Promises: every pair of surfaces that has friction takes its power from the drive; a result
whose signs follow from the pose holds under its guards and is printed for the default pose.
In order: ``pairs``, ``normal_forces``, then a closed form body after body (``sequential``)
or for guides alone (``linear``), else the ``coupled`` equations (``iterated``).
"""
