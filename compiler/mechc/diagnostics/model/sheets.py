"""Messages about what calculation sheets are made of (E21x)."""

from collections.abc import Collection, Sequence

from ...source import Span
from ...units import Dimension, described
from ..diagnostic import Message, Related, coded, near_miss
from .quantities import lost_factor


@coded("E210")
def links_in_a_sheet(span: Span, heading: Span) -> Message:
    """A description that calls itself a sheet has statements of a mechanism.

    A calculation sheet has parameters, tables, formulas and conditions. What has pins, links
    or loads is a mechanism, in which formulas may stand just as well::

        mechanism clamp "Toggle clamp"             # not: sheet clamp
        pivot O
    """
    message = "this belongs to a mechanism, and the description is headed as a sheet"
    related = (Related(heading, "it is headed so here"),)
    return Message(span, message, "head it `mechanism NAME`, or leave this out", related)


@coded("E211")
def no_such_table(span: Span, name: str, kind: str, known: Collection[str]) -> Message:
    """A value is looked up in a table, or a size in a list, that is not there.

    ``NAME at X`` looks X up in a table, ``next X in NAME`` takes the next size of a list::

        table m49 "Table 4.9" = 1: 0.388, 0.5: 0.541
        list  bores           = 32 mm, 40 mm, 50 mm
        let m = m49 at r/R
        let D = next D_min in bores
    """
    there = f"there are {', '.join(known)}" if known else f"declare one: {kind} {name} = …"
    return Message(span, f"no {kind} is called '{name}'", near_miss(name, known) or there)


@coded("E212")
def not_in_order(span: Span, name: str, before: Span, is_again: bool) -> Message:
    """The arguments of a table, or the sizes of a list, do not rise (or fall) throughout.

    One of them stands twice, or at a wrong place::

        list bores = 32 mm, 50 mm, 40 mm           # wrong
        list bores = 32 mm, 40 mm, 50 mm           # right

    A list begins with its smallest size; a table may run either way.
    """
    related = (Related(before, "this stands before it"),)
    if is_again:
        return Message(span, f"'{name}' has this value twice", "leave one out", related)
    return Message(span, f"'{name}' is not in order here", "put it in order", related)


@coded("W292")
def decimal_comma(span: Span, whole: str, part: str) -> Message:
    """Two sizes of a list stand like one number with a comma for its decimals.

    list bores = 0,5 mm, 0,8 mm     # warned of: the sizes are 0, 5 mm, 0 and 8 mm
    list bores = 0.5 mm, 0.8 mm     # right
    list counts = 1, 2, 5, 6        # right, and counts = 1,2,5,6 as well
    """
    message = f"'{whole},{part}' are two sizes, {whole} and {part}"
    return Message(span, message, f"decimals are written with a point: {whole}.{part}")


@coded("W283")
def range_without_value(span: Span, name: str, value: str, why: str, ranged: Span) -> Message:
    """The range of a parameter reaches to where a table, a list or a choice has no value.

    Code gives NaN there. The ranges are sampled, each by itself, at a dozen places::

        param v = 1 m/s in 0 m/s .. 5 m/s
        table impact = 0 m/s: 1.0, 2 m/s: 1.5
        let K = impact at v                    # warned of: the table ends at 2 m/s

    A condition of one's own, `require v <= 2 m/s`, says the same to those who use the sheet.
    """
    related = (Related(ranged, f"the range of {name}"),)
    message = f"within the range of {name}, at {value}: {why}"
    return Message(span, message, "narrow the range, or complete what has no value there", related)


@coded("E332")
def size_not_positive(span: Span, name: str) -> Message:
    """A list has a length that is zero or negative: no part has such a size.

    list pins = -5 mm, 6 mm, 8 mm     # wrong
    list pins = 5 mm, 6 mm, 8 mm      # right
    """
    return Message(span, f"a size of list '{name}' is not positive", "look at its sign")


@coded("W289")
def size_in_another_unit(span: Span, what: str, usual: str) -> Message:
    """One size of a list, or number of a table, has another unit than all others, far from them.

    list pins = 5 mm, 6 mm, 8 mm, 10 cm     # warned of
    list pins = 5 mm, 6 mm, 8 mm, 10 mm     # right
    """
    message = f"this {what} is far from the others, which are in {usual}"
    return Message(span, message, "is its unit right?")


@coded("E213")
def other_unit(
    span: Span, name: str, unit: str, found: Dimension, wanted: Dimension, bare: str
) -> Message:
    """A formula is to be shown in a unit of something else than it measures::

    let sigma = M/W in MPa                     # right where M is a moment
    let sigma = M/W in N                       # wrong: it is a pressure

    A number has its unit behind it, without ``in``: ``let t = 5 mm``.
    """
    message = f"'{name}' is asked for in {unit}, and its formula gives {described(found)}"
    return Message(span, message, f"write {bare} {unit}" if bare else lost_factor(found, wanted))


@coded("W293")
def unit_of_divisor(span: Span, name: str, divisor: str, unit: str, rest: str) -> Message:
    """A unit at the end of a formula belongs to the number before it, which is divided by.

    The result is then a plain number. The unit in which it is shown stands behind ``in``::

        let A = pi*d^2/4 mm^2            # warned of: pi*d^2/(4 mm^2)
        let A = pi*d^2/4 in mm^2         # an area
        let n = F/(5 kN)                 # a number of 5 kN each, and no warning
    """
    message = f"the unit belongs to the divisor, {divisor}, so that '{name}' is a plain number"
    return Message(span, message, f"for a result in {unit} write `{rest}`, else `/({divisor})`")


@coded("W294")
def unit_twice(span: Span, name: str, factor: str, unit: str, plain: str) -> Message:
    """The unit of a number in a formula is that of the rest of the formula as well.

    So that it counts twice. The unit in which a formula is shown stands behind ``in``::

        let A = pi*d^2*0.25 mm^2         # warned of: an area by an area, in mm^4
        let A = pi*d^2*0.25 in mm^2      # an area
        let A = b*10 mm                  # an area, too, and no warning
    """
    message = (
        f"what {factor} multiplies is measured in {unit} itself, so that '{name}' has it twice"
    )
    return Message(span, message, f"for a result in {unit} write `{plain}`")


@coded("W267")
def turns_as_radians(span: Span, unit: str) -> Message:
    """A speed of turning is shown in a unit in which people count turns.

    An angle counts radians: 60 rpm are 6.28 rad/s, and 6.28 of what is counted in a second::

        param n = 1450 rpm
        let f = n in Hz                            # 151.8, radians in a second
        let f = n/(1 rev) in Hz                    # 24.17, turns in a second
        let omega = n in rad/s                     # right, too
    """
    message = f"an angle counts radians, so that a speed in rpm is 2*pi times as large in {unit}"
    return Message(span, message, f"turns are 'n/(1 rev) in {unit}'; or show it in rpm, or rad/s")


@coded("W296")
def speed_in_radians(span: Span, unit: str) -> Message:
    """The speed of a drive that turns is in a unit in which people count turns.

    An angle counts radians, so that 60 1/min are one radian in a second, and not one turn::

        drive phi from 0 deg to 360 deg speed 60 1/min    # warned of: 9.55 rpm
        drive phi from 0 deg to 360 deg speed 60 rpm      # right
        drive phi from 0 deg to 360 deg speed 1 rad/s     # right, too
    """
    message = f"the speed in {unit} counts radians, not turns"
    return Message(span, message, "turns are counted in rpm, as in 60 rpm, radians in rad/s")


@coded("W268")
def volume_of_a_radian(span: Span, volume: str) -> Message:
    """A volume is multiplied by a speed of turning, as if it were that for each radian.

    Catalogues of pumps and motors give the volume for a turn::

        param V_g = 10 cm^3                        # for each turn
        param n = 1450 rpm
        let Q = V_g*n in l/min                     # 91.1
        let Q = V_g/(1 rev)*n in l/min             # 14.5
    """
    message = f"an angle counts radians: '{volume}' is taken as the volume for a radian"
    hint = f"the volume for a turn is '{volume}/(1 rev)', that for a radian '{volume}/(1 rad)'"
    return Message(span, message, hint)


@coded("W269")
def size_between_rows(span: Span, table: str, listed: str, sizes: Sequence[Span]) -> Message:
    """What is looked up for a size of a list may lie between two rows of the table.

    It is taken in proportion there. What belongs to a size, as a pitch does to a thread, has a
    row of its own or does not exist::

        list threads = 8 mm, 10 mm, 12 mm
        table pitches = 8 mm: 1.25 mm, 12 mm: 1.75 mm
        let d = next d_min in threads
        let p = pitches at d                       # 1.5 mm for 10 mm: in proportion
        let p = pitches at exactly d               # an error for 10 mm
    """
    those = "a size" if len(sizes) == 1 else f"{len(sizes)} sizes"
    message = f"list '{listed}' has {those} for which table '{table}' has no row: it interpolates"
    related = tuple(Related(size, "there is no row for this size") for size in sizes[:3])
    hint = f"add the rows, or take rows alone: '{table} at exactly …'"
    return Message(span, message, hint, related)


@coded("E215")
def table_of_one_row(span: Span, name: str) -> Message:
    """A table has one row, so that there is nothing between two rows.

    table E = 20 deg: 2                        # write: let E = 2
    """
    return Message(span, f"table '{name}' has one row, at least two are expected", "add a row")


@coded("E216")
def too_long(span: Span, name: str, most: int) -> Message:
    """A table or a list of sizes is longer than what a sheet is written with.

    Its values go into the formulas of the code, one by one. A large table is data of a program
    of one's own::

        table m = 1: 0.388, 0.5: 0.541, ...        # 200 rows at most
    """
    return Message(span, f"'{name}' is too long, expected {most} values at most", "thin it out")
