"""The command line itself; `commands` lists what it has."""

from __future__ import annotations

from typing import Annotated

import typer

from rcj_challenges import __version__
from rcj_challenges.cli.help import Group

app = typer.Typer(
    name="rcj-challenge",
    cls=Group,
    help="Play robot-soccer matches and challenges that are declared in YAML.",
    epilog="rcj-challenge run match --duration 1:00 --open\nrcj-challenge check my_team.zip",
    no_args_is_help=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
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
