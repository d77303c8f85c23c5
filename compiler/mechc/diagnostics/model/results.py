"""Messages for what is asked for: find, let, expect (E28x)."""

import re
from collections.abc import Collection, Sequence
from typing import Final

from ...source import Span
from ..diagnostic import Message, coded
from ..syntax import WITH_FRICTION
from .names import offered


@coded("E280")
def nothing_asked(span: Span, is_empty: bool = False) -> Message:
    """A description to compile has no ``find`` and no ``let``.

    find k = P / F
    """
    if is_empty:
        return Message(span, "the description is empty", "`mechc new NAME` starts one")
    return Message(span, "nothing is asked for", "add a line such as 'find k = P / F'")


@coded("E281")
def not_findable(span: Span, hint: str = "") -> Message:
    """A ``find`` asks for something that is no ratio and no load.

    ``find`` takes the ratio of two loads (``P / F``), one load (``P``, as a linear form
    of all others), or the ratio of two velocities (``V_D / V_A``, ``omega_OB / V_A``).
    Formulas of these are written with ``let``.

        find q = 2*P/F     # wrong
        find k = P/F       # right
        let  q = 2*k
    """
    message = "'find' takes a ratio of two loads, one load, or a ratio of two velocities"
    return Message(span, message, hint or "a formula of results is written with 'let'")


@coded("E282")
def unknown_load(
    span: Span, name: str, loads: Collection[str], points: Collection[str], is_speed: bool
) -> Message:
    """A ``find`` names a load that is not there.

    force P at A along x
    force F at B along x
    find k = P / G     # wrong
    find k = P / F     # right
    """
    if is_speed:
        message = f"'{name}' is no velocity: what stands behind the '_' is no point or link"
        return Message(span, message, "write V_A for a point A, omega_OA for a link OA")
    message = f"there is no load '{name}'"
    for pattern, hint in _FORCES.items():
        if (found := re.fullmatch(pattern, name)) and (
            named := re.findall(r"[A-Z][\d']*", found[1])
        ):
            strange = next((point for point in named if point not in points), "")
            fallback = f"no point is called {strange}: {offered(strange, points, 'points')}"
            at, first = found[1], named[0]
            return Message(span, message, fallback if strange else hint.format(at=at, first=first))
    if with_friction := re.fullmatch(r"eta_(\w+)|(\w+?)_(?:f1|f|hold)", name):
        ideal = with_friction[1] or with_friction[2]
        hint = f"with friction a line 'find {ideal} = …' brings {name} along: it is not asked for"
        return Message(span, message, hint)
    if name.startswith("mu_"):
        hint = "transmission angles stand in the table of `mechc stroke`"
        return Message(span, message, hint)
    if re.fullmatch(r"(?:a|epsilon)_[A-Z].*", name):
        hint = "accelerations are those of points(…) in code, where the drive has a speed"
        return Message(span, message, hint)
    if name.lower() in ("omega", "w", "v"):
        hint = "a velocity is that of a point, V_A, or of a link, omega_OA"
        return Message(span, message, hint)
    if name.lower() in ("eta", "efficiency"):
        return Message(span, message, WITH_FRICTION)
    return Message(span, message, offered(name, loads, "loads"))


_FORCES: Final = {
    r"R_([A-Z][\d']*(?:_on_\w+)?)_(?:x|y|direction)": (
        "write 'find R_{at}', which gives R_{at}_x, R_{at}_y and R_{at}_direction, too"
    ),
    r"R_((?:[A-Z][\d']*){2})": (
        "along a rod it is 'find N_{at}', at one of its pins 'find R_{first} on {at}'"
    ),
    r"R([A-Z][\d']*)": "a force at a joint is asked for by 'find R_{at}'",
    r"F_?((?:[A-Z][\d']*){2})": "a force at a joint is asked for by 'find N_{at}'",
    r"S_((?:[A-Z][\d']*){2})": "S_{at} is the force of a spring; along a rod it is 'find N_{at}'",
    r"M_?([A-Z][\d']*)": "a pin takes no moment; the force there is asked for by 'find R_{at}'",
    r"R_?([A-Z][\d']*)_?[xy]": "write 'find R_{at}', which gives R_{at}_x and R_{at}_y, too",
}
"""By how forces at joints are often called, how they are asked for."""


@coded("E265")
def let_asked_for(span: Span, name: str, alone: bool) -> Message:
    """A ``find`` names a formula of a ``let``.

    ``find`` asks for loads and velocities; a ``let`` is computed and printed by itself, and
    what is made of it is a ``let``, too.

        let p = P/(pi*d^2/4)
        find p               # wrong: p is there without it
        find q = p/F         # wrong
        let q = p/F          # right
    """
    hint = "leave it out here" if alone else "write the ratio as a let: let k = …"
    return Message(span, f"'{name}' is a let, which is computed without a find", hint)


@coded("E283")
def still_point(span: Span, point: str) -> Message:
    """A velocity of a pivot is asked for; pivots stand still.

    pivot O
    find V_O / V_A     # wrong
    """
    message = f"point {point} is a pivot, so its velocity is always 0"
    return Message(span, message, "name a point that moves")


@coded("E284")
def unknown_subject(span: Span, known: Collection[str], load: str = "") -> Message:
    """An ``expect`` speaks of something that nothing asks for.

    Its left side is the name of a ``find`` or ``let``, the same ratio as a ``find``, or in a
    sheet what a used mechanism finds, ``C_k``.

        find k = P / F
        expect q = 2     # wrong
        expect k = 2     # right
    """
    message = "an 'expect' is about the name of a 'find' or 'let'"
    if load:
        return Message(span, message, f"a load is asked for as well: 'find {load}'")
    return Message(span, message, offered("", known, "results"))


@coded("E285")
def not_a_setting(span: Span, name: str, kind: str) -> Message:
    """The values behind ``at`` set parameters and loads, not what follows from them.

    expect k = 7.14 at b = 2 mm     # wrong where b = 2*a
    """
    message = f"'{name}' is {kind}; 'at' sets free parameters and loads"
    return Message(span, message, f"set the parameters that '{name}' follows from")


@coded("E330")
def set_twice(span: Span, name: str) -> Message:
    """The values behind ``at`` set one parameter twice.

    expect k = 0.35 at alpha = 10 deg, alpha = 12 deg     # wrong
    expect k = 0.35 at alpha = 10 deg, beta = 12 deg      # right
    """
    return Message(span, f"'{name}' is set twice", "leave one out, or write an `expect` for each")


@coded("W263")
def named_as_with_friction(span: Span, name: str, stem: str) -> Message:
    """A ratio has a name such as results with friction have, and is the ideal one.

    With friction every ratio comes out twice, under names of its own: of ``find k = P/F`` the
    ideal one is ``k``, that with friction ``k_f``::

        find k_f = P/F     # warned of: k_f is ideal, and k_f_f has the friction
        find k = P/F       # right: k and k_f
    """
    message = f"'{name}' is the ideal ratio here; that with friction is called '{name}_f'"
    return Message(span, message, f"call it {stem}: then {stem}_f is that with friction")


@coded("E287")
def let_too_long(span: Span, name: str) -> Message:
    """A condition or expectation uses a ``let`` that would be very long in parameters.

    Lets of lets of lets can double in length each time. A condition is checked by itself
    wherever a result is evaluated, so it must stay short.

        let u = ...            # hundreds of operations when written out
        require u > 0          # wrong
    """
    message = f"'{name}' is too long to stand here, written out in parameters"
    return Message(span, message, "state the condition in parameters")


@coded("E234")
def tolerance_of_formula(span: Span) -> Message:
    """The formula that a result is expected to be has a tolerance.

    A formula is proved equal, or refuted; a figure holds within bounds.

        expect k = 2*tan(alpha) +- 0.01              # wrong
        expect k = 2*tan(alpha)                      # right
        expect k = 0.35 +- 0.01 at alpha = 10 deg    # right
    """
    message = "a tolerance belongs to a figure, found it behind a formula"
    return Message(span, message, "leave it out, or write the figure and `at …`")


@coded("E336")
def no_part_of_a_report(span: Span, name: str, known: Sequence[str], hint: str) -> Message:
    """A report holds what is no picture and no result.

    Beside results by their names it holds ``scheme``, ``bodies``, ``plans``, ``stroke``, and
    plots of results over parameters.

    find k = P/F
    report scheme, ratio                # wrong
    report scheme, k, plot k over alpha # right
    """
    expected = f"expected {', '.join(known)}" if known else "no result is asked for"
    hint = hint or "name one of these, or ask for it with 'find'"
    return Message(span, f"a report holds no '{name}': {expected}", hint)


@coded("E337")
def plot_over_no_range(span: Span, name: str, ranged: Sequence[str], hint: str) -> Message:
    """A plot is over a parameter that has no range: give it one.

    param alpha = 20 deg                         # wrong
    param alpha = 20 deg in 5 deg .. 40 deg      # right
    report plot k over alpha
    """
    expected = f"expected {', '.join(ranged)}" if ranged else "no parameter has one"
    return Message(
        span,
        f"{name} has no range to plot over: {expected}",
        hint or f"give it one: param {name} = … in LOW .. HIGH",
    )


@coded("E338")
def stroke_without_drive(span: Span) -> Message:
    """The table along the stroke is asked of a mechanism without a drive.

    report stroke                       # wrong by itself
    drive phi from 10 deg to 80 deg     # right: this is the stroke
    """
    return Message(
        span,
        "there is no stroke: expected a drive, found none",
        "name what moves, as in drive phi from 10 deg to 80 deg",
    )


@coded("E339")
def parts_of_a_sheet(span: Span) -> Message:
    """Parts of a report are asked of a calculation sheet, which is reported line by line.

    sheet pin
    let tau = 4*F/(pi*d^2)
    report tau                          # wrong: leave it out
    """
    return Message(
        span,
        "a calculation sheet is reported line by line: there are no parts to choose",
        "leave this out",
    )
