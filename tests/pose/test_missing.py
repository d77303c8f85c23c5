"""Missing vectors: one that would follow from others that are missing is not reported as well."""

from mechc.pose.vectors import Missing


class Given:
    """Vectors that are given between some points: a path from A to B is one from B to A."""

    def __init__(self, *pairs: str) -> None:
        self._pairs = {frozenset(pair) for pair in pairs}

    def path(self, tail: str, head: str) -> tuple[()] | None:
        """Return a vector where one is given."""
        return () if frozenset((tail, head)) in self._pairs else None


def first_of(asked: str, *given: str) -> list[str]:
    """Return which vectors are reported, asked for in this order."""
    missing = Missing(Given(*given))  # type: ignore[arg-type]
    return [pair for pair in asked.split() if missing.add(*pair)]


def test_a_vector_is_missing_once_in_either_sense() -> None:
    assert first_of("AB AB BA CD") == ["AB", "CD"]


def test_what_missing_vectors_would_lead_to_is_not_missing_itself() -> None:
    assert first_of("AB BC AC CA") == ["AB", "BC"]


def test_vectors_that_are_given_lead_on_from_missing_ones() -> None:
    assert first_of("AB AC", "BC") == ["AB"]
    assert first_of("AB CD AD", "BC") == ["AB", "CD"]
    assert first_of("AB CD", "AC", "BD") == ["AB"]


def test_any_are_missing_once_one_was_reported() -> None:
    missing = Missing(Given())  # type: ignore[arg-type]
    assert not missing.are_any
    assert missing.add("A", "B")
    assert missing.are_any
