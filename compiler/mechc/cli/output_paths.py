"""Where output goes: which target for which path, and which file under which name."""

from collections.abc import Iterable, Mapping
from pathlib import Path

from ..base.later import pattern
from ..base.named import NamedTuple
from ..emit import registry
from ..emit.target import Emitted
from . import usage

SPECIAL = pattern(r"(\\*)([ #:])")
"""What make reads as itself behind a backslash, for which backslashes in front are doubled."""

UNSPEAKABLE = pattern(r"[=;|*?\[\t-\r]|^~|\\$|\(.*\)$")
"""What has a meaning in rules that nothing takes from it."""

PICTURES = (".pdf", ".png", ".svg", ".ps", ".eps", ".dvi", ".docx", ".html")
"""Suffixes of what other programs make of LaTeX, or `mechc draw` of a mechanism."""


class OutputPath(NamedTuple):
    """One ``-o``: the target, and a file, a folder, or None for standard output."""

    target: str
    path: Path | None
    folder: bool = False

    def stem(self, mechanism: str) -> str:
        """Return the name of the files without suffix: the path's, or the mechanism's."""
        return mechanism if self.path is None or self.folder else self.path.stem


def outputs(paths: tuple[str, ...], target: str | None) -> list[OutputPath]:
    """Return the outputs asked for; a usage error where a format is missing or unknown."""
    return [_output(path, target) for path in paths or ("-",)]


def _output(path: str, target: str | None) -> OutputPath:
    """Return where a text goes, and its format: the one asked for, or that of the suffix."""
    if path == "-":
        return OutputPath(target or _choose("standard output has no suffix"), None)
    if path.endswith("/") or Path(path).is_dir():
        return OutputPath(target or _choose(f"the folder {path!r} has no suffix"), Path(path), True)
    refuse_pictures(Path(path))
    suffix = Path(path).suffix
    ours = registry.own_by_suffix(suffix)
    if target in registry.BUILT_IN and ours not in (None, target):
        raise usage.UsageError(
            f"{path!r} is a file of {ours} by its suffix, and --emit asks for {target}"
        )
    chosen = target or registry.by_suffix(suffix) or _choose(f"no format has the suffix {suffix!r}")
    return OutputPath(chosen, Path(path))


def refuse_pictures(path: Path) -> None:
    """Raise a usage error where a text would be written to what is to be a page or a picture."""
    if path.suffix.lower() in PICTURES:
        latex = path.with_suffix(".tex").name
        raise usage.UsageError(
            f"{str(path)!r} would hold no {path.suffix}: write LaTeX to {latex!r}"
            " and set it with pdflatex, or draw the scheme with `mechc draw`"
        )


def refuse_other_texts(path: Path) -> None:
    """Raise a usage error where LaTeX would be written to what the suffix calls another text."""
    refuse_pictures(path)
    if path.suffix.lower() not in ("", ".tex", ".ltx", ".latex"):
        latex = path.with_suffix(".tex").name
        raise usage.UsageError(f"{str(path)!r} would hold LaTeX: write it to {latex!r}")


OF_TARGETS: Mapping[str, frozenset[str]] = {
    "--gradient": frozenset({"c", "python"}),
    "--c-real": frozenset({"c"}),
    "--c-openmp": frozenset({"c"}),
    "--fragment": frozenset({"latex"}),
    "--brief": frozenset({"latex"}),
    "--pictures": frozenset({"latex"}),
}
"""The formats that options are about; any other one is the same without them."""


def refuse_idle(given: Mapping[str, bool], wanted: Iterable[OutputPath]) -> None:
    """Raise a usage error for an option that is about none of the formats that are written."""
    targets = {output.target for output in wanted}
    if not targets <= registry.BUILT_IN.keys():
        return
    for option, is_given in given.items():
        if is_given and not targets & OF_TARGETS[option]:
            formats = " and ".join(sorted(OF_TARGETS[option]))
            written = ", ".join(sorted(targets))
            raise usage.UsageError(f"{option} is about {formats}, and {written} is asked for")


def _choose(reason: str) -> str:
    formats = ", ".join(registry.names())
    raise usage.UsageError(f"{reason}: choose a format with --emit, one of {formats}")


def placed(output: OutputPath, emitted: tuple[Emitted, ...]) -> dict[Path, str]:
    """Return texts by path: the first at the path asked for, the others beside it."""
    if output.path is None:
        return {}
    if output.folder:
        return {output.path / name: text for name, text in emitted}
    main, *others = emitted
    if output.path.suffix in [Path(name).suffix for name, _ in others]:
        return {output.path.with_name(name): text for name, text in emitted}
    return {output.path: main.text} | {output.path.with_name(n): text for n, text in others}


def makefile_rule(made: Iterable[Path], read: Iterable[Path]) -> str:
    r"""Return a rule for make; standard input without a name has no place in it.

    >>> makefile_rule([Path("k.c"), Path("k.h")], [Path("my clamp.mech")])
    'k.c k.h: my\\ clamp.mech\n'
    """
    targets = " ".join(_escaped(path).replace("%", "\\%") for path in made)
    if not targets:
        raise usage.UsageError("a rule for make needs files: write the output to one with -o")
    return " ".join([f"{targets}:", *map(_escaped, read)]) + "\n"


def _escaped(path: Path) -> str:
    """Return a path as make reads it; a usage error where no rule can name it."""
    name = str(path)
    if UNSPEAKABLE.search(name):
        raise usage.UsageError(
            f"no rule for make can name {name!r}; rename it, or leave out --deps"
        )
    return SPECIAL.sub(r"\1\1\\\2", name).replace("$", "$$")
