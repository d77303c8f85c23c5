"""What people write for a unit: one hint for each of the usual spellings."""

import re
from typing import TYPE_CHECKING

from ...units import UNITS

if TYPE_CHECKING:
    import difflib
else:
    from ...base.later import Later

    difflib = Later("difflib")

SPELLED: dict[str, str] = {
    "millimeter": "mm", "millimetre": "mm", "centimeter": "cm", "centimetre": "cm",
    "meter": "m", "metre": "m", "kilometer": "km", "micrometer": "um", "micrometre": "um",
    "micron": "um", "mkm": "um", "degree": "deg", "dg": "deg", "grad": "deg",
    "radian": "rad", "newton": "N", "kilonewton": "kN", "kilogram": "kg", "kilogramme": "kg",
    "kilo": "kg", "kilopond": "kgf", "kp": "kgf", "kilogramforce": "kgf", "gram": "g",
    "gramme": "g", "tonne": "t", "ton": "t", "pascal": "Pa", "megapascal": "MPa",
    "second": "s", "sec": "s", "minute": "min", "watt": "W",
    "kilowatt": "kW", "joule": "J", "hertz": "Hz",
    "nm": "N*m", "nmm": "N*mm", "ncm": "N*cm", "knm": "kN*m", "kgfm": "kgf*m", "kgm": "kgf*m",
    "revolution": "rev", "turn": "rev", "mps": "m/s", "kmh": "km/h", "kph": "km/h",
    "inche": "in", "zoll": "in", "foot": "ft", "feet": "ft", "yard": "yd", "pound": "lb",
    "lbm": "lb", "ounce": "oz", "poundforce": "lbf", "kipf": "kip", "ftlb": "lbf*ft",
    "lbft": "lbf*ft", "ftlbf": "lbf*ft", "lbfft": "lbf*ft", "inlb": "lbf*in", "lbin": "lbf*in",
    "inlbf": "lbf*in", "lbfin": "lbf*in", "lbsft": "lbf*ft", "fps": "ft/s", "ips": "in/s",
    "mm2": "mm^2", "cm2": "cm^2", "m2": "m^2", "mm3": "mm^3", "cm3": "cm^3", "m3": "m^3",
    "sqin": "in^2", "cc": "cm^3",
    "mnm": "N*mm", "kh": "kN", "mh": "MN", "dah": "daN", "hm": "N*m", "khm": "kN*m", "hmm": "N*mm",
}  # fmt: skip
"""What people write for a unit, in small letters and the singular.

A Latin H stands for the newton of Cyrillic letters, where these were put into Latin by eye.
"""


NEWTONS = "did you mean 'MN', 10^6 N? A millinewton is 0.001 N"

THOUSANDTHS: dict[str, str] = {
    "mN": NEWTONS,
    "mn": NEWTONS,
    "mPa": "did you mean 'MPa', 10^6 Pa? A millipascal is 0.001 Pa",
}
"""Hints at thousandths, which are no units here: the capital letter makes a million of them."""


def hint_of(word: str) -> str:
    """Return a hint at the unit that a word behind a number most likely means, '' for none.

    >>> hint_of("MM")
    "did you mean 'mm'?"
    >>> hint_of("mn")
    "did you mean 'MN', 10^6 N? A millinewton is 0.001 N"
    """
    if word in THOUSANDTHS:
        return THOUSANDTHS[word]
    meant = unit_meant(word)
    return f"did you mean {meant!r}?" if meant else ""


def unit_meant(word: str) -> str:
    """Return the unit that a word behind a number most likely means, '' where none is near.

    >>> unit_meant("degrees"), unit_meant("MM"), unit_meant("Nm"), unit_meant("milimeter")
    ('deg', 'mm', 'N*m', 'mm')
    >>> unit_meant("N/mm2"), unit_meant("cm4")
    ('N/mm^2', 'cm^4')
    """
    if (powers := re.sub(r"(?<=[A-Za-z])(?=\d)", "^", word)) in UNITS and powers != word:
        return powers
    small = word.lower().replace("_", "")
    known = {unit.lower(): unit for unit in UNITS if unit.isalpha()} | SPELLED
    for spelled in (small, small.removesuffix("s")):
        if spelled in known:
            return known[spelled]
    near = difflib.get_close_matches(small.removesuffix("s"), SPELLED, n=1, cutoff=0.85)
    return SPELLED[near[0]] if near and len(small) > 3 else ""
