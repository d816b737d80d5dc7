"""The command line, and how it formats ``--help``: commands in groups, options without useless types, and examples.

Plain text: the library's own frames load a Markdown parser and a syntax highlighter, which takes longer than all else.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, TypeVar

import typer
from typer.core import TyperCommand, TyperGroup

from rcj_challenges import __version__
from rcj_challenges.cli import CommandInterruptedError
from rcj_challenges.cli.codes import OPTION_GIVEN_TWICE
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError

PLAY = "Play"
WATCH = "Watch"
WRITE = "Write a challenge"
SUBMIT = "Submit"
ORGANIZE = "Organize"

_Work = TypeVar("_Work", bound=Callable[..., Any])


class Command(TyperCommand):
    """A command whose help ends with examples: its ``epilog``, one to a line."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse them; an option that takes one value is not given twice.

        Raises:
            DiagnosticError: one is.
        """
        given: Any = self.make_parser(ctx).parse_args(list(args))[2]
        for option in () if ctx.resilient_parsing else given:
            takes_one = option.param_type_name == "option" and not (option.multiple or option.is_flag or option.count)
            if takes_one and given.count(option) > 1:
                message = f"{option.opts[0]} is given more than once"
                raise DiagnosticError(Diagnostic(OPTION_GIVEN_TWICE, message, "give it once"))
        parsed: list[str] = super().parse_args(ctx, args)
        return parsed

    def invoke(self, ctx: Any) -> Any:
        """Run it; what it returns is the exit code.

        Raises:
            CommandInterruptedError: Ctrl-C.
        """
        if ctx.obj is not None:
            ctx.obj.append(self)
        try:
            code = super().invoke(ctx)
        except KeyboardInterrupt as error:
            raise CommandInterruptedError from error
        ctx.exit(code or 0)

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write arguments and options; of arguments only the names, whose types say no more than these."""
        arguments, options = [], []
        for parameter in self.get_params(ctx):
            record = parameter.get_help_record(ctx)
            if record is not None and parameter.param_type_name == "argument":
                arguments.append((record[0].partition(" <")[0], record[1]))
            elif record is not None:
                options.append(record)
        for heading, rows in (("Arguments", arguments), ("Options", options)):
            if rows:
                with formatter.section(heading):
                    formatter.write_dl(rows)

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        """Write the examples as they are typed."""
        _write_examples(self.epilog, formatter)


class Group(TyperGroup):
    """Commands, listed below the heading of each one's ``rich_help_panel`` in the order of the first of each."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the commands by group, each with the first sentence of its help."""
        names = self.list_commands(ctx)
        groups: dict[str, list[tuple[str, str]]] = {PLAY: [], WATCH: [], WRITE: [], SUBMIT: [], ORGANIZE: []}
        for name in names:
            command: Any = self.get_command(ctx, name)
            if command is not None and not command.hidden:
                panel = command.rich_help_panel
                heading = panel if isinstance(panel, str) else "Commands"
                groups.setdefault(heading, []).append((name, command.get_short_help_str(limit=200)))
        widest = max(map(len, names), default=0)
        for heading, rows in groups.items():
            if rows:
                with formatter.section(heading):
                    formatter.write_dl([(name.ljust(widest), text) for name, text in rows])

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        """Write the examples as they are typed."""
        _write_examples(self.epilog, formatter)


def _write_examples(epilog: str | None, formatter: Any) -> None:
    lines = [f"  {line}\n" for line in (epilog or "").splitlines()]
    if lines:
        formatter.write_paragraph()
        formatter.write_heading("Example" if len(lines) == 1 else "Examples")
        for line in lines:
            formatter.write(line)


class App(typer.Typer):
    """Commands in groups, with our help.

    Args:
        name: of the command line, or of a group of commands in it.
        summary: for ``--help``.
        examples: a line each.
    """

    def __init__(self, name: str, summary: str, *examples: str) -> None:
        super().__init__(
            name=name,
            cls=Group,
            help=summary,
            epilog="\n".join(examples),
            no_args_is_help=True,
            rich_markup_mode=None,
            pretty_exceptions_enable=False,
            context_settings={"help_option_names": ["-h", "--help"]},
        )

    def register(
        self, panel: str, *examples: str, name: str | None = None, cls: type[Command] = Command
    ) -> Callable[[_Work], _Work]:
        """Make a command of a function: its parameters are those of the command, and it may return the exit code."""
        return self.command(name, cls=cls, rich_help_panel=panel, epilog="\n".join(examples))


app = App(
    "rcj-challenge",
    "Play robot-soccer matches and challenges that are declared in YAML.",
    "rcj-challenge run match --duration 1:00 --open",
    "rcj-challenge check my_team.zip",
)


def _show_version(asked: bool) -> None:
    if asked:
        typer.echo(f"rcj-challenge {__version__}")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Play robot-soccer matches and challenges that are declared in YAML."""
