"""``mechc completions``: the shell's own script."""

from click.shell_completion import BashComplete, ShellComplete, get_completion_class

from ...data_folders import data
from .. import usage
from ..by_click import mechc
from ..terminal import give
from ..usage import Word


@usage.command("completions")
@usage.argument("shell", kind=Word(("bash", "zsh", "fish")))
def command(shell: str) -> None:
    """Print shell completions.

    \b
    mechc completions bash > ~/.local/share/bash-completion/completions/mechc
    mechc completions zsh > ~/.zfunc/_mechc
    mechc completions fish > ~/.config/fish/completions/mechc.fish
    """
    script = _script(shell)
    give(script.source_template % script(mechc, {}, "mechc", "_MECHC_COMPLETE").source_vars())


def _script(shell: str) -> type[ShellComplete]:
    if shell == "bash":
        return _Bash
    script = get_completion_class(shell)
    assert script
    return script


class _Bash(BashComplete):
    """Click's completion with a script of our own: click's forgets names where files may stand."""

    source_template = (data("cli") / "completions.bash").read_text("utf-8")
