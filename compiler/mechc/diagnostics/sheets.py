"""Messages about calculation sheets (E21x, E55x, E704, W265, W290)."""

from ..source import Span
from .diagnostic import Message, coded


@coded("E550")
def requirement_fails(span: Span, left: str, operator: str, right: str) -> Message:
    """A ``require`` of a calculation sheet fails at the values that the sheet gives.

    The message has the values of both sides. Nothing is emitted: change what is given, or the
    condition::

        param d = 8 mm                             # 10 mm hold
        let tau = 4*F/(pi*d^2) in MPa
        require tau <= tau_allowed
    """
    wanted = held_against(left, operator, right)
    return Message(span, f"the requirement fails: {wanted}", "change what is given")


def held_against(left: str, operator: str, right: str) -> str:
    """Return the words for what is found and for what is expected of it.

    >>> held_against("d = 8 mm", ">=", "10 mm")
    'd = 8 mm, expected at least 10 mm'
    """
    return f"{left}, expected {_WORDS[operator]} {right}"


_WORDS = {
    "<": "less than",
    "<=": "at most",
    ">": "more than",
    ">=": "at least",
    "=": "the same as",
    "!=": "something else than",
}


@coded("E552")
def beyond_the_table(span: Span, table: str, end: str, asked: str) -> Message:
    """A table is asked for a value outside its rows.

    Between two rows a table is taken in proportion; beyond its ends nothing is known::

        table m49 "Table 4.9" = 1: 0.388, 0.5: 0.541, 0.1: 1.180
        let m = m49 at r/R                         # r/R from 0.1 to 1
    """
    message = f"table '{table}' has no such row: it {end}, and {asked} is asked"
    return Message(span, message, "change what is given")


@coded("E556")
def between_rows(span: Span, table: str, asked: str, nearest: str) -> Message:
    """A row of a table is asked for that the table does not have.

    ``at exactly`` takes the row of the value itself: a thread has its pitch, and between two
    threads there is none. What lies between rows in proportion is asked for with ``at`` alone::

        table pitches "ISO 261" = 6 mm: 1 mm, 8 mm: 1.25 mm, 10 mm: 1.5 mm
        let p = pitches at exactly d               # d is 9 mm
    """
    message = f"table '{table}' has no row at {asked}, the nearest is at {nearest}"
    hint = f"add the row, change what is given, or interpolate: '{table} at …'"
    return Message(span, message, hint)


@coded("E553")
def no_single_case(span: Span, name: str, count: int) -> Message:
    """Of the cases of a choice none holds at what the sheet gives, or more than one does.

    Cases with commas between them exclude one another. ``else`` says what is meant where none
    holds; what stands behind it may be a choice again, asked only then::

        let K = 1.1 when v < 1 m/s, 1.3 when v >= 1 m/s
        let K = 1.1 when v < 1 m/s else 1.3
        let K = 1.1 when v < 1 m/s else 1.2 when v < 2 m/s else 1.3
    """
    found = f"{count} cases hold at once" if count else "no case holds"
    hint = "cases that may hold together are parted by `else`" if count else "add a case, or `else`"
    return Message(span, f"in the choice of {name} {found}, expected one", hint)


@coded("E554")
def beyond_the_list(span: Span, listed: str, least: str, largest: str) -> Message:
    """No size of a list is as large as the one that is asked for::

    list bores = 32 mm, 40 mm, 50 mm
    let D = next D_min in bores                # D_min is 62 mm
    """
    message = f"list '{listed}' has no such size: {least}, and it ends at {largest}"
    return Message(span, message, "change what is given, or add sizes to the list")


@coded("E551")
def without_value(span: Span, name: str) -> Message:
    """A formula of a calculation sheet has no value at what the sheet gives.

    It divides by zero there, takes the root of a negative number, or the like::

        let s = sqrt(a - b)                        # b = 30 mm, a = 20 mm
    """
    return Message(span, f"{name} has no value at what is given", "look at what it is made of")


@coded("W265")
def bound_on_a_negative(span: Span, side: str, value: str, force: str) -> Message:
    """An upper bound holds because the force held against it counts as negative.

    The force along a rod is negative in compression, a component against its axis. However
    large it becomes, it stays below a positive bound, and nothing was checked::

        let sigma = C_N_AB/A in MPa                # -120 MPa
        require sigma <= sigma_a                   # holds for any compression
        require abs(sigma) <= sigma_a              # right

    Where both signs are meant, bound it on both sides: `require -F_cr < C_N_AB < F_max`.
    """
    said = f"{side} is {value}, which is below any positive bound: {force} counts with its sign"
    hint = f"for its size write abs({side}); with both signs bound it from below, too"
    return Message(span, said, hint)


@coded("W290")
def negative_size(span: Span, name: str, value: str) -> Message:
    """A length, an area or a mass of a calculation sheet is negative at the values given.

    Its square is positive all the same, and a bound from above holds: nothing else would show
    that the values do not fit one another::

        param D = 40 mm
        param t = 25 mm
        let d = D - 2*t in mm                      # -10 mm
        let A = pi*d^2/4 in mm^2                   # 78.5398 mm^2
        require d > 0 mm                           # says what is meant

    Of coordinates (`x_A`), projections, and what is made of a negative length nothing is said,
    and of a size that a condition names.
    """
    hint = f"look at what it is made of, or state its bound: require {name} > ..."
    return Message(span, f"{name} is {value}, below zero", hint)


@coded("E704")
def sheet_has_no_links(span: Span, name: str) -> Message:
    """A calculation sheet has no links, so that there is nothing to draw and nothing moves.

    A description without pins, links and loads is a sheet: it has parameters, formulas and
    conditions. ``mechc check``, ``derive`` and ``compile`` take it like any other; ``draw``,
    ``stroke`` and the stages that look at links do not.
    """
    message = f"{name} is a calculation sheet: it has no links that could move or be drawn"
    return Message(span, message, "`mechc derive` shows the calculation")
