"""A derivation put into words, whatever the language and whoever prints."""

from collections.abc import Callable, Iterable

from ..algebra.formula import Formula, Power, Product, Symbol, product, quotient
from ..words.table import Words
from .steps import Equation, Step


def sentence(step: Step, words: Words, spell: Callable[[str], str]) -> str:
    """Return the rule of a step in words; ``spell`` writes a name of the drawing."""
    first, *rest = step.subject or ("",)
    together = first if len(first.rstrip("'0123456789")) > 1 else "".join(step.subject)
    return words.rules[step.rule].format(
        first=spell(first),
        rest=enumeration((spell(s) for s in rest or (first,)), words),
        all=enumeration((spell(s) for s in step.subject), words),
        joined=spell(together),
    )


def enumeration(items: Iterable[str], words: Words) -> str:
    """Return ``A, B and C`` in the table's language."""
    *most, last = items
    return f"{', '.join(most)} {words.conjunction} {last}" if most else last


def as_ratio(equation: Equation) -> Equation:
    """Return ``V_B/V_A = …`` for ``V_B = V_A·…``, as textbooks print it; others unchanged.

    >>> from ..algebra.formula import Call, text
    >>> left, right = as_ratio(
    ...     Equation(
    ...         Symbol("V_B"),
    ...         product([(Symbol("V_A"), 1), (Call("cot", (Symbol("alpha"),)), 1)]),
    ...     )
    ... )
    >>> f"{text(left)} = {text(right)}"
    'V_B/V_A = cot(alpha)'
    """
    match equation:
        case Equation(Symbol(name), Product(factors)) if is_speed(name):
            speeds = [f for f in factors if isinstance(f, Symbol) and is_speed(f.name)]
            others = [f for f in factors if f not in speeds]
            if len(speeds) == 1 and not any(_mentions_speed(f) for f in others):
                ratio = quotient(equation.left, speeds[0])
                return Equation(ratio, product((f, 1) for f in others))
    return equation


def is_speed(name: str) -> bool:
    """Return whether a name is a velocity ``V_A`` or an angular velocity ``omega_OA``."""
    return name.startswith(("V_", "omega_"))


def _mentions_speed(factor: Formula) -> bool:
    base = factor.base if isinstance(factor, Power) else factor
    return isinstance(base, Symbol) and is_speed(base.name)


def solved(step: Step) -> tuple[Equation, ...]:
    """Return what a step gives beyond what its rule already says, as ratios."""
    said = {as_ratio(e) for e in step.relations}
    ratios = dict.fromkeys(as_ratio(e) for e in step.results)
    return tuple(e for e in ratios if e not in said)
