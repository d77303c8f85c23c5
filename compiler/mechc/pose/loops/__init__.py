"""Loops closed: sought directions and places found from lengths and the drive.

``closing`` does it where anything is sought, loop after loop; ``state`` is what was found so far.
``guide_lines`` makes vectors of guides and slots, ``redundant`` takes what joins points that are
placed already. ``dyads`` takes groups of two links apart: ``dyad_closures`` has their formulas
(sides and angles by Heron and atan2; the laws of sines and cosines are for reports),
``dyad_sides`` names the sides and angles of the triangle that these need, ``choosing`` decides
which of two closures is meant, ``drawn`` by a drawing, ``recognition`` writes closures as people
do. ``groups`` are groups of higher class as systems of equations, ``by_groups`` closes one after
another, ``branches`` finds where in the stroke they close. ``rated`` is how fast all of it moves,
``reach`` where in the stroke it can be assembled, ``assembly_hints`` what would set closures
apart.

Promises: what is found is a definition of the pose, or a sum of named angles put in for it; each
uses only parameters and earlier definitions.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"branches", "by_groups", "state"}
    __getattr__ = waiting(__name__, SELDOM)
