"""What the status of a result says, as a number in every target: whether it moves, else why not."""

MOVES, NO_POSE, NOT_FOUND, LOCKED, JAMMED = range(5)

STATUSES = (
    "it moves: the result is a number",
    "there is no pose",
    "iteration has found no balance, and has not shown that there is none",
    "it is locked: the load alone does not move it",
    "it is jammed: no force of the drive moves it",
)
"""What each status means; the first three are those of a pose as well."""
