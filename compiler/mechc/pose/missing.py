"""Vectors that nothing gives: each is reported once, not with all that rests on it."""

from .vectors import Vectors

MOST = 20
"""Missing vectors among which it is looked whether they give another one."""


class Missing:
    """The vectors that were found missing."""

    def __init__(self, vectors: Vectors) -> None:
        self._vectors = vectors
        self._asked: list[tuple[str, str]] = []

    @property
    def are_any(self) -> bool:
        """Return whether a vector is missing, without which loops stay open."""
        return bool(self._asked)

    def is_first(self, tail: str, head: str) -> bool:
        """Return whether a missing vector would not follow from those missing before; note it."""
        if len(self._asked) < MOST and self._follows(tail, head):
            return False
        self._asked.append((tail, head))
        return True

    def _follows(self, tail: str, head: str) -> bool:
        reached, waiting = {tail}, [tail]
        both_ways = [*self._asked, *((b, a) for a, b in self._asked)]
        while waiting:
            here = waiting.pop()
            for start, end in both_ways:
                if end not in reached and self._joined(here, start):
                    reached.add(end)
                    waiting.append(end)
        return any(self._joined(point, head) for point in reached)

    def _joined(self, first: str, second: str) -> bool:
        return first == second or self._vectors.path(first, second) is not None
