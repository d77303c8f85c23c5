"""Names that a target allows: one pass, from vetted identifiers, without collisions.

A name goes verbatim into code, so this pass is the only way there. It writes Greek
and Cyrillic in Latin letters and primes as words, appends ``_`` to what the language
reserves (where that is not enough, ``x_`` goes before it), and never lets two names become one.
"""

import re
from collections.abc import Container, Iterable, Mapping
from unicodedata import normalize

_GREEK = """
alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma_end
sigma tau upsilon phi chi psi omega
"""
_CYRILLIC = """
а a б b в v г g д d е e ж zh з z и i й j к k л l м m н n о o п p р r с s т t у u ф f х h ц c ч ch
ш sh щ shch ъ _ ы y ь _ э e ю ju я ja і i ї ji є je ґ g ё jo
"""
_PAIRS = dict(zip(_CYRILLIC.split()[::2], _CYRILLIC.split()[1::2], strict=True))
_LETTERS: Mapping[str, str] = {
    **{chr(ord("α") + i): name for i, name in enumerate(_GREEK.split())},
    **{chr(ord("Α") + i): name.capitalize() for i, name in enumerate(_GREEK.split())},
    **_PAIRS,
    **{letter.upper(): latin.capitalize() for letter, latin in _PAIRS.items()},
    "ς": "sigma",
    "ϑ": "theta",
    "ϕ": "phi",
    "ϵ": "epsilon",
    "'": "_prime",
    "′": "_prime",
    "’": "_prime",
}


def transliterate(name: str) -> str:
    """Return a name in ASCII letters, digits and single underscores.

    >>> transliterate("β1"), transliterate("V_A'"), transliterate("кут")
    ('beta1', 'V_A_prime', 'kut')
    >>> transliterate("Länge"), transliterate("a-b"), transliterate("力"), transliterate("2")
    ('Lange', 'a_b', 'u529b', 'x_2')
    """
    plain = "".join(_LETTERS.get(c) or _ascii(c) for c in name)
    plain = re.sub(r"_{2,}", "_", plain).lstrip("_") or "x"
    return f"x_{plain}" if plain[0].isdigit() else plain


def _ascii(character: str) -> str:
    found = normalize("NFKD", character).encode("ascii", "ignore").decode()
    letters = re.sub(r"\W", "", found, flags=re.ASCII)
    return letters or ("_" if character.isascii() else f"u{ord(character):x}")


class Reserved:
    """What a language keeps for itself: words, beginnings and endings of words.

    None begins with ``x_``, or ends with ``_``.

    >>> kept = Reserved(["int"], beginnings=["str_"])
    >>> [name in kept for name in ("int", "str_a", "x_str_a")], "n" in kept.besides(["n"])
    ([True, True, False], True)
    """

    def __init__(
        self, words: Iterable[str], beginnings: Iterable[str] = (), endings: Iterable[str] = ()
    ) -> None:
        self._words, self._ends = frozenset(words), (tuple(beginnings), tuple(endings))

    def __contains__(self, name: object) -> bool:
        beginnings, endings = self._ends
        return isinstance(name, str) and (
            name in self._words or name.startswith(beginnings) or name.endswith(endings)
        )

    def besides(self, words: Iterable[str], beginnings: Iterable[str] = ()) -> "Reserved":
        """Return this with more words and beginnings."""
        return Reserved(self._words.union(words), (*self._ends[0], *beginnings), self._ends[1])


class TargetNames:
    """The names given out in one space of names of one target.

    >>> names = TargetNames(reserved={"int"})
    >>> [names.claim(n) for n in ("int", "int_", "α", "alpha")]
    ['int_', 'int_2', 'alpha', 'alpha_2']
    """

    def __init__(self, reserved: Container[str], taken: Iterable[str] = ()) -> None:
        self.reserved = reserved
        self.taken = set(taken)

    def claim(self, name: str) -> str:
        """Return a legal name near this one that was never given out, and take it."""
        plain = transliterate(name)
        near = (plain, f"{plain}_", f"x_{plain}", f"x_{plain}_")
        plain = next(n for n in near if n not in self.reserved)
        found, number = plain, 1
        while found in self.taken or found in self.reserved:
            number += 1
            found = f"{plain.rstrip('_')}_{number}"
        self.taken.add(found)
        return found


def file_stem(stem: str, named: bool, taken: Container[str]) -> str | None:
    """Return the files' name without suffix, None where a user named one that is taken.

    Names that differ in case are one name in some file systems.

    >>> file_stem("Math", True, {"math"}), file_stem("Math", False, {"math"})
    (None, 'Math_')
    """
    if stem.lower() not in taken:
        return stem
    return None if named else f"{stem}_"


def mangle(names: Iterable[str], space: TargetNames) -> dict[str, str]:
    """Return the target's name of each name; those that need no change keep theirs.

    >>> mangle(["lambda", "lambda_", "b"], TargetNames(reserved={"lambda"}))
    {'lambda': 'lambda_2', 'lambda_': 'lambda_', 'b': 'b'}
    """
    listed = list(dict.fromkeys(names))
    first = [n for n in listed if transliterate(n) == n and n not in space.reserved]
    chosen = {n: space.claim(n) for n in [*first, *(n for n in listed if n not in first)]}
    return {n: chosen[n] for n in listed}
