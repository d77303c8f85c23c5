"""Descriptions spoiled at random: lines and words dropped, swapped and taken from elsewhere."""

import random
import re
from collections.abc import Callable
from pathlib import Path

from paths import CORPUS, LIBRARY

FOLDERS = (LIBRARY, CORPUS / "good", CORPUS / "bad")
WORD = re.compile(r"[A-Za-z_]\w*'?|\d+(?:\.\d+)?|\s+|.", re.DOTALL)
UNITS = ("mm", "m", "deg", "rad", "N", "kN", "N*m", "kg", "Pa", "m/s^2", "")
NUMBERS = ("0", "1", "-1", "90", "180", "360", "45", "1e-30", "1e300", "0.1", "12.3456789012345")
POINTS = ("A", "B", "C", "D", "O", "K", "O1", "E", "A'")

Words = list[str]
Mutation = Callable[[random.Random, Words, Words], None]


def texts() -> dict[str, str]:
    """Return every description of the library and of the corpus, without expected messages."""
    paths = sorted(p for f in FOLDERS for p in f.glob("*.*") if p.suffix in (".mech", ".yaml"))
    return {p.name: _without_messages(p.read_text(encoding="utf-8")) for p in paths}


def _without_messages(text: str) -> str:
    return "".join(line for line in text.splitlines(True) if not line.startswith("#!"))


def _at(rng: random.Random, items: Words) -> int:
    return rng.randrange(len(items))


def drop(rng: random.Random, items: Words, _: Words) -> None:
    del items[_at(rng, items)]


def double(rng: random.Random, items: Words, _: Words) -> None:
    at = _at(rng, items)
    items.insert(at, items[at])


def swap(rng: random.Random, items: Words, _: Words) -> None:
    i, j = _at(rng, items), _at(rng, items)
    items[i], items[j] = items[j], items[i]


def take(rng: random.Random, items: Words, others: Words) -> None:
    items.insert(_at(rng, items), others[_at(rng, others)])


def _replace(pattern: str, choices: tuple[str, ...]) -> Mutation:
    def mutate(rng: random.Random, items: Words, _: Words) -> None:
        places = [i for i, word in enumerate(items) if re.fullmatch(pattern, word)]
        if places:
            items[rng.choice(places)] = rng.choice(choices)

    return mutate


def turn_sign(rng: random.Random, items: Words, _: Words) -> None:
    places = [i for i, word in enumerate(items) if word in "+-*/^"]
    if places:
        items[rng.choice(places)] = rng.choice("+-*/^")


def rename(rng: random.Random, items: Words, _: Words) -> None:
    """Write one name of the file in the place of another of the same case."""
    names = [i for i, word in enumerate(items) if word[0].isalpha()]
    if names:
        at = rng.choice(names)
        alike = [i for i in names if items[i][0].isupper() == items[at][0].isupper()]
        items[at] = items[rng.choice(alike)]


def reverse_vector(rng: random.Random, items: Words, _: Words) -> None:
    places = [i for i, word in enumerate(items) if re.fullmatch("[A-Z]{2,}", word)]
    if places:
        at = rng.choice(places)
        items[at] = items[at][::-1]


OF_LINES = (drop, double, swap, take)
OF_WORDS = (
    drop,
    double,
    swap,
    take,
    rename,
    rename,
    reverse_vector,
    turn_sign,
    _replace(r"\d+(\.\d+)?", NUMBERS),
    _replace("|".join(u for u in UNITS if u.isalpha()), UNITS),
    _replace("[A-Z]['0-9]*", POINTS),
    _replace("deg|mm|x|y", ("x", "y", "-x", "OA", "perp AB", "alpha", "alpha/7", "0", "deg")),
)


def mutant(seed: int, given: dict[str, str]) -> tuple[str, str]:
    """Return the name and the text of one spoiled description."""
    rng = random.Random(seed)
    names = list(given)
    library = [n for n in names if not n.startswith(("E", "W"))]
    name = rng.choice(library if rng.random() < 0.85 else names)
    alike = [n for n in names if Path(n).suffix == Path(name).suffix]
    text, other = given[name], given[rng.choice(alike)]
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        by_line = rng.random() < 0.4
        items, others = (_split(t, by_line) for t in (text, other))
        if items and others:
            rng.choice(OF_LINES if by_line else OF_WORDS)(rng, items, others)
        text = "".join(items)
    return name, text


def _split(text: str, by_line: bool) -> Words:
    return text.splitlines(True) if by_line else WORD.findall(text)
