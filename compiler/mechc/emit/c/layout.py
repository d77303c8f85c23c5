"""How C's function heads and comments are laid out."""

LONGEST_LINE = 100


def wrapped(head: str, arguments: list[str], indent: str = "    ") -> str:
    """Return a function's head, or a call, on one line or with one argument on each."""
    line = f"{head}{', '.join(arguments)})"
    if len(indent) - 4 + len(line) <= LONGEST_LINE:
        return line
    return f"{head}\n{indent}" + f",\n{indent}".join(arguments) + ")"


def harmless(words: str) -> str:
    """Return text that neither ends a comment nor starts one, a trigraph or a spliced line.

    >>> harmless("a */ b ??/")
    'a * / b ? ?/'
    """
    words = words.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
    return f"{words} ." if words.endswith("\\") else words


def broken(sign: str, parts: list[str]) -> str:
    """Return parts joined by a sign on one line, or with one part on each."""
    line = sign.join(parts)
    return line if len(line) <= LONGEST_LINE - 14 else f"\n        {sign.lstrip()}".join(parts)
