"""Messages for what can go wrong when files are written (E70x, W70x)."""

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
