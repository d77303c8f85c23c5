"""Powers whose exponent is a sign, as a choice between a number and its inverse.

``(k/k_f)^sign(k)`` is an efficiency, whoever drives. Machines take long for a power, and no
loop over one becomes vector code.
"""

from ..formula.sharing import each_part
from ..formula.tree import ONE, ZERO, Call, Formula, Power, is_call, negative, power
from ..formula.walk import children, rebuild
from .lengths import signed, unsigned

MINUS_ONE = negative(ONE)


def in_choices(formula: Formula) -> Formula:
    """Return a formula in which no exponent is a sign.

    >>> from ..formula.to_text import text
    >>> from ..formula.tree import Symbol
    >>> text(in_choices(Power(Symbol("q"), Call("sign", (Symbol("k"),)))))
    'q when k > 0 else (1/q when k < 0 else 1)'
    """
    return _in_choices(formula) if any(map(_is_decided, each_part([formula]))) else formula


def _is_decided(formula: Formula) -> bool:
    """Return whether a sign is the exponent of a power."""
    if not isinstance(formula, Power):
        return False
    return is_call(unsigned(formula.exponent), "sign")


def _in_choices(formula: Formula) -> Formula:
    parts = tuple(map(_in_choices, children(formula)))
    match formula:
        case Power(_, exponent):
            sign, inner = signed(exponent)
            if is_call(inner, "sign"):
                return _chosen(parts[0], sign, _in_choices(inner.arguments[0]))
    return rebuild(formula, parts) if parts else formula


def _chosen(base: Formula, sign: int, decides: Formula) -> Formula:
    ahead, behind = (
        power(base, ONE if sign > 0 else MINUS_ONE),
        power(base, MINUS_ONE if sign > 0 else ONE),
    )
    more, less = (Call(name, (decides, ZERO)) for name in ("more", "less"))
    return Call("choose", (more, ahead, Call("choose", (less, behind, ONE))))
