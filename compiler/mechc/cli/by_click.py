"""The command line as click has it: help, completion, and the words for slips."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from ..base.frozen import replace
from ..diagnostics import near_miss
from ..version import VERSION
from . import session
from .commands import COMMANDS, found
from .exit_status import MISUSED
from .usage import Argument, BadParameter, Command, Complete, Option, UsageError, WholeNumber, Word

if TYPE_CHECKING:
    Choice = click.Choice[str]
else:
    Choice = click.Choice  # not generic before click 8.2


DESCRIBED = (".mech", ".yaml", ".yml")
"""How the names of descriptions end."""


def run(arguments: Sequence[str] | None) -> int:
    """Run one command and return its exit status; what is wrong is shown."""
    try:
        status = mechc.main(arguments, prog_name="mechc", standalone_mode=False)
    except click.NoSuchOption as error:
        _with_hint(error).show()
        return MISUSED
    except click.ClickException as error:
        error.show()
        return MISUSED
    except click.Abort:
        raise KeyboardInterrupt from None
    return status if isinstance(status, int) else 0


def refuse(command: Command, error: UsageError) -> int:
    """Show what a command that had begun said of its command line; return the exit status."""
    root = click.Context(mechc, info_name="mechc")
    shown = _in_click(error, click.Context(_built(command), root, info_name=command.name))
    shown.show()
    return MISUSED


def _in_click(error: UsageError, ctx: click.Context | None = None) -> click.UsageError:
    if not isinstance(error, BadParameter):
        return click.UsageError(str(error), ctx)
    return click.BadParameter(str(error), ctx, param_hint=error.where or None)


def _with_hint(error: click.NoSuchOption) -> click.NoSuchOption:
    """Return the refusal of an unknown option, with the hint at the one there is."""
    near = error.possibilities or _like(error)
    message = error.message + _instead_of(error)
    return click.NoSuchOption(error.option_name, message, near, error.ctx)


def _like(error: click.NoSuchOption) -> list[str]:
    """Return the long flag of a command that is a short one here: ``--y`` for ``-y``."""
    params = error.ctx.command.params if error.ctx else []
    return [flag for param in params for flag in param.opts if flag == f"-{error.option_name}"]


def _instead_of(error: click.NoSuchOption) -> str:
    """Return the hint at the place of the answer, for a command without an `-o`."""
    if error.option_name not in ("-o", "--output") or not error.ctx:
        return ""
    name = error.ctx.info_name
    if name == "new":
        return " The file is called as the mechanism is: `mechc new arm` writes arm.mech."
    if name == "fmt":
        return " Files are laid out in place; with --to the result goes to standard output."
    return f" The answer goes to standard output: `mechc {name} … > FILE`."


# ------------------------------------------------------------------- commands of click


def _built(command: Command) -> click.Command:
    """Return a command with its arguments and options as click has them."""
    return click.Command(
        command.name,
        help=command.run.__doc__,
        params=[_parameter(one) for one in command.parameters],
        callback=lambda **values: _perform(command, values),
    )


def _perform(command: Command, values: dict[str, Any]) -> int:
    ctx = click.get_current_context()
    try:
        return session.perform(command, values, ctx.find_object(session.Session))
    except UsageError as error:
        raise _in_click(error, ctx) from None


def _parameter(one: Argument | Option) -> click.Parameter:
    if isinstance(one, Option):
        return _option(one)
    return click.Argument(
        [one.name],
        nargs=-1 if one.several else 1,
        required=one.required,
        type=_type(one.kind),
        metavar=one.metavar,
        shell_complete=_completing(one.complete),
    )


def _option(one: Option) -> click.Option:
    """Return an option as click's."""
    *others, last = one.flags
    flag = f"{last}/{one.against}" if one.against else last
    absent = {} if one.default is None and not one.of_session else {"default": one.default}
    kind: dict[str, Any] = {"type": _type(one.kind)} if one.takes_value else {"is_flag": True}
    if one.value is not None:
        kind = {"flag_value": one.value}
    return click.Option(
        [*others, flag, one.name],
        **kind,
        **absent,
        multiple=one.multiple,
        callback=_remember if one.of_session else _checking(one.check),
        expose_value=not one.of_session,
        metavar=one.metavar,
        help=one.help,
        show_default=one.show_default,
        shell_complete=_completing(one.complete),
    )


def _type(kind: Any) -> click.ParamType[Any] | None:
    match kind:
        case Word(choices):
            return _Word(choices)
        case WholeNumber(low, high):
            return click.IntRange(low, high)
        case None:
            return None
        case path:
            return click.Path(path_type=path)


class _Word(Choice):
    """One of a few words; the nearest one is proposed for a word that is none of them."""

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Return the word."""
        try:
            return super().convert(value, param, ctx)
        except click.BadParameter as error:
            hint = near_miss(value, map(str, self.choices))
            if value == "ua" and "uk" in self.choices:
                hint = "Ukrainian is 'uk'"
            if isinstance(param, click.Argument) and value.endswith(DESCRIBED):
                hint = f"it stands before the description: `mechc show pose {value}`"
            raise click.BadParameter(f"{error.message.rstrip('.')}{hint and f'; {hint}'}") from None


def _remember(ctx: click.Context, parameter: click.Parameter, value: Any) -> None:
    """Keep what an option says of messages; it may stand before or after a command."""
    if value is not None and parameter.name:
        known = ctx.find_object(session.Session) or session.Session()
        ctx.obj = replace(known, **{parameter.name: value})


def _checking(check: Callable[[Any], Any] | None) -> Callable[..., Any] | None:
    def callback(ctx: click.Context, parameter: click.Parameter, value: Any) -> Any:
        assert check
        try:
            return check(value)
        except UsageError as error:
            raise _in_click(error) from None

    return callback if check else None


def _completing(complete: Complete | None) -> Callable[..., list[CompletionItem]] | None:
    def items(ctx: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
        assert complete
        return [CompletionItem(p.value, p.kind, p.help or None) for p in complete(begun)]

    return items if complete else None


# --------------------------------------------------------------------- the root command


def _for_file(name: str) -> str:
    """Return the hint at a command that was left out before a description."""
    is_description = name.endswith(DESCRIBED)
    return f"a command comes first: `mechc check {name}`" if is_description else ""


class LazyGroup(click.Group):
    """A group whose commands' modules are imported when they are used."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names in the order of the table."""
        return list(COMMANDS)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command that is asked for, or propose the nearest one."""
        name = args[0]
        if name not in COMMANDS and not name.startswith("-"):
            hint = near_miss(name, COMMANDS) or _for_file(name)
            ctx.fail(f"there is no command {name!r}; {hint or '`mechc --help` lists them'}")
        return super().resolve_command(ctx, args)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import and return one command."""
        return _built(found(cmd_name)) if cmd_name in COMMANDS else None

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the table without importing the commands."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, entry.line) for name, entry in COMMANDS.items()])


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 96},
    epilog="`mechc COMMAND --help` says more, with an example. Exit status: 0 done, 1 the "
    "description is wrong, 2 the command line is, 3 a file, 4 a limit, 70 mechc itself.",
)
@click.version_option(VERSION, "-V", "--version", message="mechc %(version)s")
def mechc() -> None:
    """Compile a planar mechanism into its force transmission k = P/F.

    A description (pins, sliders, links, forces) becomes the formula for k, the derivation
    that proves it, and code in Python, C and LaTeX.

    \b
    mechc new clamp                        start a description
    mechc check clamp.mech                 find mistakes in it
    mechc compile clamp.mech -o clamp.tex  write the formula with its derivation
    mechc compile toggle_press --emit c    a mechanism of the library as C
    """


mechc.params.extend(map(_option, session.OPTIONS))
