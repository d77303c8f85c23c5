"""Messages for plots (E58x, E599)."""

from collections.abc import Iterable, Sequence

from .diagnostic import Message, coded
from .syntax import listed


def asked_for(name: str) -> str:
    """Return the hint on what a sheet brings in and does not use."""
    return f"nothing in the sheet uses it: `let x = {name}` asks for it"


@coded("E583")
def nothing_of_this_name(name: str, known: Sequence[str], near: str) -> Message:
    """A plot was asked for of what the description does not have.

    What can be plotted are its results, the angles and lengths that loops find, and, where there
    is a drive, coordinates of points, directions of links, and how fast both change.

    Wrong: ``mechc plot clamp.mech --y kk``
    Right: ``mechc plot clamp.mech --y k``
    """
    expected = listed(known[:8]) if known else "something that varies"
    hint = near or "name one of these with --y"
    return Message(None, f"{name} cannot be plotted, expected {expected}", hint)


@coded("E584")
def no_such_parameter(name: str, known: Sequence[str], near: str) -> Message:
    """What a plot runs over, or a family is made of, is no parameter that can be set.

    A parameter that follows from others cannot: what it follows from can, or another formula can
    be given to it along the curve.

    Wrong: ``mechc plot clamp.mech --x alhpa``
    Right: ``mechc plot clamp.mech --x alpha``
    """
    expected = listed(known) if known else "a parameter with a value"
    hint = near or "name one of these, or give a parameter a value"
    return Message(None, f"{name} is no parameter to vary, expected {expected}", hint)


@coded("E585")
def no_range(name: str, example: str) -> Message:
    """Nothing says from where to where a plot goes.

    The range of the parameter says it, or the stroke of the drive, or the command line.

    Wrong: ``mechc plot clamp.mech --x a`` where the description has ``param a = 100 mm``
    Right: ``mechc plot clamp.mech --x a --range "50 mm .. 200 mm"``
    """
    return Message(
        None,
        f"{name} has no range, expected two ends that differ",
        f'give it one, as in --range "{example}"',
    )


@coded("E586")
def no_value(name: str, lacking: Iterable[str]) -> Message:
    """A result rests on something whose size nobody gives.

    Wrong: ``let p = delta*k*F`` alone, and ``mechc plot FILE --y p``
    Right: ``let F = 2 kN`` besides
    """
    missing = list(lacking)
    return Message(
        None,
        f"{name} rests on {', '.join(missing)}, expected a value",
        f"add {' and '.join(f'`let {m} = …`' for m in missing)} to the description, "
        "or a value to its param",
    )


@coded("E587")
def nothing_to_vary(able: Sequence[str]) -> Message:
    """A plot was asked for without a word on what it runs over, and there is no drive.

    Wrong: ``mechc plot clamp.mech`` where the description has no drive
    Right: ``mechc plot clamp.mech --x alpha``
    """
    expected = listed(able) if able else "a parameter with a range"
    hint = f"name it, as in --x {able[0]}" if able else "give a parameter a range"
    return Message(None, f"nothing says what varies, expected {expected}", hint)


@coded("E588")
def no_curve(names: Sequence[str], parameter: str) -> Message:
    """What is asked for has no value anywhere on the range.

    A loop does not close there, or a condition of use excludes it. ``mechc check --verbose``
    lists the conditions.

    Wrong: ``mechc plot claw --x phi --range "10 rad .. 11 rad"`` beyond a ``require``
    Right: a range in which the mechanism can be assembled
    """
    return Message(
        None,
        f"{' and '.join(names)} has no value for any {parameter} of the range, expected one",
        "choose another range, or other values with -D",
    )


@coded("E589")
def too_many_curves(number: int, most: int) -> Message:
    """More curves than a person can tell apart.

    Wrong: ``mechc plot clamp.mech --x alpha --family beta=1,2,3,4,5,6,7,8,9,10,11,12,13deg``
    Right: ``mechc plot clamp.mech --x alpha --family beta=2,6,10deg``
    """
    return Message(
        None, f"{number} curves, expected at most {most}", "ask for fewer values or results"
    )


@coded("E598")
def zone_of_a_family() -> Message:
    """A zone is asked for of a family: each of its curves has a zone of its own.

    Wrong: ``mechc plot claw --family l=4,5m --where "gamma >= 1.5 rad"``
    Right: ``mechc plot claw --where "gamma >= 1.5 rad"``
    """
    return Message(
        None, "a zone of several settings, expected one", "leave out the family, or the zone"
    )


@coded("E599")
def no_point(name: str, known: Sequence[str], near: str) -> Message:
    """The path was asked for of what is no point, or of one that has no place along the drive.

    Wrong: ``mechc plot crank_rocker --path BC``, which is no point
    Right: ``mechc plot crank_rocker --path B``
    """
    expected = listed(known) if known else "a drive, and points in place"
    hint = near or "name a point that moves along the drive"
    return Message(None, f"{name} has no path, expected {expected}", hint)
