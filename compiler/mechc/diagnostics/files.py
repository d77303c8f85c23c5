"""Messages for what goes wrong with files (E9xx): exit status 3."""

from ..source import Span
from .diagnostic import Message, coded


@coded("E901")
def file_not_found(name: str, hint: str) -> Message:
    """No file and no mechanism of the library has this name.

    A command takes a path (``clamp.mech``, ``clamp.yaml``), ``-`` for standard input, or
    the name of a mechanism of the library. A path is tried first::

        mechc compile clamp.mech --emit latex      # a file here
        mechc compile packet_clamp --emit latex    # from the library

    ``mechc list`` prints the names of the library.
    """
    message = f"no file and no mechanism of the library is called {name!r}"
    return Message(None, message, hint or "`mechc list` prints the mechanisms of the library")


@coded("E902")
def file_unreadable(name: str, reason: str) -> Message:
    """A file is there but cannot be read.

    It is a folder, or belongs to someone else, or the disk failed. The operating
    system's own reason is given in the message.
    """
    return Message(None, f"cannot read {name!r}: {reason}", "is it a text file that you may read?")


@coded("E903")
def file_not_text(name: str, offset: int) -> Message:
    """A description is UTF-8 text, and this file is not.

    Older editors save Cyrillic text in windows-1251 or koi8-u. Convert it once::

        iconv -f windows-1251 -t utf-8 old.mech > new.mech
    """
    message = f"{name!r} is not UTF-8 text: byte {offset} begins no character"
    return Message(None, message, "save it as UTF-8, or convert it with iconv")


@coded("E904")
def file_unwritable(name: str, reason: str, lacking: str = "") -> Message:
    """An output file cannot be written.

    Its folder does not exist or may not be written to. Output files are written whole
    or not at all: when one of several cannot be written, none is, and files of an
    earlier run are left as they were.
    """
    hint = f"make the folder {lacking!r} first; " if lacking else ""
    return Message(None, f"cannot write {name!r}: {reason}", f"{hint}nothing was written")


@coded("E905")
def file_exists(name: str) -> Message:
    """``mechc new`` does not overwrite a file.

    A starter file is for a new mechanism; an existing description is worth more. Choose
    another name, or remove the old file first.
    """
    return Message(None, f"{name!r} exists already", "choose another name")


@coded("E906")
def no_descriptions(name: str) -> Message:
    """A folder holds no description.

    ``mechc check FOLDER`` and ``mechc fmt FOLDER`` look for files that end in .mech, .yaml or
    .yml in the folder and below it; hidden folders are left out.
    """
    message = f"no file in {name!r} ends in .mech, .yaml or .yml"
    return Message(None, message, "`mechc new NAME` starts a description")


@coded("E907")
def used_not_found(span: Span, name: str, hint: str) -> Message:
    """A sheet that is used is not there.

    A name is one of the library, whatever files lie beside this one; a path, in quotes and with
    its suffix, leads to a file in this file's folder or below it::

        use cylinder as cyl (P = 2 kN)             # of the library
        use "jaws.mech" as jaw                     # a file beside this one

    ``mechc list`` prints the names of the library.
    """
    is_path = name.endswith((".mech", ".yaml", ".yml"))
    message = f"there is no file {name!r} in this folder" if is_path else _not_listed(name)
    return Message(span, message, hint or "`mechc list` prints the names of the library")


def _not_listed(name: str) -> str:
    return f"nothing in the library is called {name!r}"


@coded("E908")
def used_elsewhere(span: Span, name: str, nowhere: bool) -> Message:
    """A path of what is used leads out of the folder of the file that uses it.

    A description reads files in its own folder and below it, and the library; paths with ``..``,
    from the root of the disk, or through links that lead elsewhere are refused, so that a
    description from somebody else reads nothing of yours. A text that is no file, from standard
    input or in a program, has no folder: it uses the library only::

        use "../jaws.mech" as jaw                  # wrong
        use "parts/jaws.mech" as jaw               # right
    """
    if nowhere:
        message = f"{name!r} cannot be used: this text is no file, so that it has no folder"
        return Message(span, message, "write it to a file, or use a sheet of the library")
    message = f"{name!r} leads out of the folder of this file"
    return Message(span, message, "put the file into this folder, or below it")
