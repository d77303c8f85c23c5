"""Messages for what can go wrong when files are written, and for derivations (E7xx, W7xx)."""

from ..source import Span
from .diagnostic import Message, coded


@coded("E701")
def unspeakable_file_name(stem: str) -> Message:
    r"""A name that a C source cannot include.

    The source names its header in ``#include "NAME.h"``, where C has no way to write a
    quotation mark, a backslash or a line break.

    Wrong: ``mechc compile clamp.mech -o 'my"clamp.c'``
    Right: ``mechc compile clamp.mech -o my_clamp.c``
    """
    return Message(
        None,
        f"the file name {stem!r} cannot stand in a C #include: expected no quotation mark,"
        " backslash or line break",
        "choose another name for the output",
    )


@coded("E702")
def broken_target(name: str, origin: str, reason: str) -> Message:
    """A target of another package that was asked for and does not load.

    Packages add targets through the entry-point group ``mechc.targets``; each entry
    must name an object with ``name``, ``suffixes`` and ``emit``.

    Wrong: ``[project.entry-points."mechc.targets"]  excel = "gone.module:TARGET"``
    Right: ``[project.entry-points."mechc.targets"]  excel = "mechc_excel:TARGET"``
    """
    return Message(
        None,
        f"the target {name!r} ({origin}) does not load: expected an emitter, found {reason}",
        "update or remove the package that provides it",
    )


@coded("E703")
def file_hides_another(name: str, hidden: str, free: str) -> Message:
    """A name of a file that the language's own library has, too.

    A compiler that looks for headers in the folder of ``math.h`` finds that one and not the
    header of the library; a ``string.py`` is imported in place of Python's module, which NumPy
    needs. Where mechc chooses the names, in a folder, it appends ``_``.

    Wrong: ``mechc compile clamp.mech -o math.c``
    Right: ``mechc compile clamp.mech -o clamp.c``
    """
    return Message(
        None,
        f"the file {name} would hide {hidden}: expected a name that is free",
        f"write -o {free}",
    )


@coded("E705")
def beyond_single_precision(number: str) -> Message:
    """A number that ``float`` does not hold, in C with ``--c-real float``.

    Single precision goes from 1.2e-38 to 3.4e38, in SI units.

    Wrong: ``param c = 1e45`` with ``mechc compile sheet.mech --emit c --c-real float``
    Right: ``mechc compile sheet.mech --emit c``
    """
    return Message(
        None,
        f"the number {number} is beyond single precision: expected 1.2e-38 to 3.4e38",
        "leave out --c-real float",
    )


@coded("E730")
def no_equilibrium_by_hand(span: Span, load: str) -> Message:
    """A load that sums of forces and moments do not give step by step.

    ``--by equilibrium`` takes one sum after another, each with one force that is not known
    yet, or up to three together. Where bodies hang together more closely (two beams and two
    pans in a parallelogram), where a bar is redundant, or where a length that is not given
    would be needed, virtual power gives the load all the same: the derivation without
    ``--by equilibrium`` has it.
    """
    return Message(
        span,
        f"no three sums of forces and moments at a time lead to {load}: expected bodies whose"
        " forces follow one after another",
        "leave out --by equilibrium: virtual power finds it",
    )


@coded("E731")
def no_load_to_find(span: Span, name: str) -> Message:
    """Equilibrium was asked for where no load is: a ratio of velocities does not follow from it.

    Wrong: ``find V_D/V_A``
    Right: ``find k = P/F``
    """
    return Message(
        span,
        f"{name} asks for no load: expected one for equilibrium to give",
        "add `find k = P/F` with two loads of yours, or leave out --by equilibrium",
    )


@coded("W701")
def left_out_target(name: str, origin: str, reason: str) -> Message:
    """A target of another package that does not load, though it was not asked for.

    It is left out and all others work; see E702 for what an entry must name.

    Wrong: ``[project.entry-points."mechc.targets"]  excel = "gone.module:TARGET"``
    Right: ``[project.entry-points."mechc.targets"]  excel = "mechc_excel:TARGET"``
    """
    return Message(
        None,
        f"the target {name!r} ({origin}) is left out: expected an emitter, found {reason}",
        "update or remove the package that provides it",
    )
