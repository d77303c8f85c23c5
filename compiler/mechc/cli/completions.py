"""``mechc completions``: the shell's own script."""

import click
from click.shell_completion import get_completion_class

from .session import Command
from .terminal import give


@click.command("completions", cls=Command)
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
def command(shell: str) -> None:
    """Print shell completions.

    \b
    mechc completions bash > ~/.local/share/bash-completion/completions/mechc
    mechc completions zsh > ~/.zfunc/_mechc
    mechc completions fish > ~/.config/fish/completions/mechc.fish
    """
    script = get_completion_class(shell)
    assert script
    root = click.get_current_context().find_root().command
    give(script(root, {}, "mechc", "_MECHC_COMPLETE").source())
