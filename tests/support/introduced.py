"""Which names on a page stand in an equation before anything has introduced them.

A name is introduced by the words above it, by an equation of which it is the left side, or by the
lines after "where". A letter in the words introduces all names that are that letter with an index
(S is the size of the force in a rod: S_AB).
"""

import re
from collections.abc import Iterable, Iterator
from itertools import pairwise

SHOWN = re.compile(
    r"\\\[\s*(.*?)\s*\\\]|\\begin\{(align\*|multline\*)\}\s+(.*?)\s+\\end\{\2\}", re.DOTALL
)
MATHS = re.compile(r"(?<!\\)\$(.*?)(?<!\\)\$", re.DOTALL)
GREEK = (
    "alpha|beta|gamma|delta|(?:var)?epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|rho|sigma"
    "|tau|upsilon|(?:var)?phi|chi|psi|omega|[A-Z][a-z]+"
)
INDEX = r"_(?:\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\w)"
POINT = r"[A-Z]'*(?:_(?:\d|\{[\d']+\}))?"
TOKEN = re.compile(
    r"\\(?:text|operatorname|begin|end)\{[^{}]*\}|\\mathrm\{\w\}|\\\[2pt\]"
    rf"|{POINT}(?:{POINT})+(?!_)"
    rf"|(?P<name>(?:\\(?:{GREEK})(?![A-Za-z])|\\mathrm\{{\w\w+\}}|[A-Za-z]'*)(?:{INDEX})?)"
    r"|\\[A-Za-z]+"
)
"""A name, or what is none: words, functions, and lengths by their points, OA."""

KNOWN = {"V", r"\omega", "v"}
"""Letters of velocities, each of the point, link or surface of its index."""

PARTS_OF_A_POSE = {r"\varphi", r"\phi", r"\delta", r"\mu", "x", "y"}
"""Letters of directions, angles and coordinates, each with an index of its own."""

Block = tuple[str, list[str]]
"""The words above, and equations that stand together."""


def blocks(tex: str) -> Iterator[Block]:
    """Yield the equations of a page with the words above them."""
    body = tex.partition(r"\begin{document}")[2] or tex
    ends = [0]
    above, together = "", list[str]()
    for found in SHOWN.finditer(body):
        words = body[ends[-1] : found.start()]
        ends.append(found.end())
        if together and words.strip().removeprefix(r"\noindent").strip() not in ("", "where"):
            yield above, together
            together = []
        if not together:
            above = words
        together.extend(re.split(r"\\\\\*?(?:\[2pt\])?\s|&\s|\\qquad", found[1] or found[3]))
    yield above, together


def names(tex: str) -> set[str]:
    """Return the names that stand in a formula."""
    return {found["name"] for found in TOKEN.finditer(tex)} - {None}


def not_introduced(tex: str) -> Iterator[tuple[str, str]]:
    """Yield the names that nothing introduces, each with the first equation that it stands in."""
    met = set(KNOWN)
    for words, equations in blocks(tex):
        for formula in MATHS.findall(words):
            met |= names(formula)
        found = [_plain(equation) for equation in equations]
        met |= set(_left_sides(found))
        for equation in found:
            for name in sorted(names(equation)):
                if name not in met and name.partition("_")[0] not in met:
                    yield name, equation
                    met.add(name)


def _plain(equation: str) -> str:
    line = equation.strip()
    if line.startswith(r"\boxed{"):
        line = line.removeprefix(r"\boxed{").removesuffix("}")
    return line.replace("&=", "=").strip(" &")


def _left_sides(equations: Iterable[str]) -> Iterator[str]:
    """Yield the names that equations define; a sum may go on in the next line."""
    for line, after in pairwise([*equations, ""]):
        left, is_equal, _ = line.partition("=")
        if left.strip() in names(left) and (is_equal or after.startswith("=")):
            yield left.strip()


def never_introduced(tex: str) -> set[str]:
    """Return directions, lengths and angles in formulas among words that nothing introduces.

    What introduces a name may be a sentence that has it alone, or an equation anywhere.
    """
    formulas = MATHS.findall(tex)
    alone = {f.strip() for f in formulas}
    equations = [_plain(e) for _, found in blocks(tex) for e in found]
    met = KNOWN | alone | set(_left_sides([*equations, *formulas]))
    used = {name for formula in formulas for name in names(formula)}
    made = {n for n in used - met if n.partition("_")[0] in PARTS_OF_A_POSE}
    return {n for n in made if "_" in n}
