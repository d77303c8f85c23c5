"""What the names of a stroke's columns mean, in words."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import assert_never

from ...study.stroke.stroke import AngleAt, Column, SpeedOf

Spelled = Callable[[str], str]


def legend(
    columns: Iterable[Column],
    words: Mapping[str, str],
    symbol: Callable[[SpeedOf | AngleAt], str],
    spell: Spelled,
) -> Iterator[str]:
    """Yield a sentence without its stop on each speed and each transmission angle.

    ``symbol`` writes what it is called, ``spell`` points, links, loads and parameters.
    """
    for about in dict.fromkeys(about for column in columns for about in column.about):
        yield _meaning(about, words, symbol(about), spell)


def _meaning(
    about: SpeedOf | AngleAt, words: Mapping[str, str], symbol: str, spell: Spelled
) -> str:
    match about:
        case SpeedOf(_, kind, of, load):
            said = words[f"means {kind}"]
            return said.format(name=symbol, of=spell(of), load=spell(load) if load else "")
        case AngleAt(_, pin, rod, link):
            said = words["means angle" if link else "means at guide"]
            other = spell(link) if link else ""
            return said.format(name=symbol, of=spell(pin), rod=spell(rod), link=other)
        case _:
            assert_never(about)
