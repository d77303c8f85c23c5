"""What counts as zero or as holding where the free bodies are solved: each with its reason.

Forces differ in size without a limit (200 gears pass on 1e-60 of a load), so that every one is
compared with what it was computed from, never with a number of newtons.
"""

EPSILON = 2.0**-52
"""The distance from 1 to the next number: what a sum may be off, per largest part.

A force at a joint that is zero by two reasons is off by the rounding of a rounding.
"""

VANISHED = 1e-13
"""A number below this part of its like is a zero that was rounded: cos 90° is 6e-17."""

ELIMINATED = 1e-11
"""What elimination leaves below this part of the terms that it came from is a rounded zero."""

DETERMINED = 1e3 * ELIMINATED
"""An unknown that moves by less than this part of the others does not move with them."""

SAME_TERM = 64 * EPSILON
"""Two terms nearer to each other than this part cancel: each was rounded some dozens of times."""

INCONSISTENT = 1e-9
"""A residual above this, relative to the heaviest row, is an equation that does not hold."""

LOOP_GAP = 1e-6
"""A gap below this part of the largest length is rounding: arc cosines lose half the digits."""

NO_TENSION = 1e-9
"""A tension below this part of the load is rounding."""

FORCE_CHANGE = 1e-9
"""A change of a force below this part of the largest one is rounding."""

NO_SLIP = 1e-13
"""A slip below this, per unit of the driving load's speed, is none."""

AGREEMENT = 1e-12
"""An error of the power below this is rounding at any pose, relative to the answer."""

CONDITION_SLACK = 1e4
"""How many roundings, each made larger by the condition of the equations, an error may have.

It covers the number of equations and what the directions themselves have lost.
"""

SINGULAR_CONDITION = 1e9
"""A pose whose condition is worse is within a hair of singular: another one is drawn.

Of the sixteen digits of a number seven are left there.
"""

SMALLEST = 1e-300
"""What an error is relative to where both answers are zero."""
