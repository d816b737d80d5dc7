"""The group ``rcj-challenge tournament``, and what its commands share."""

from __future__ import annotations

from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli.app import App

if TYPE_CHECKING:
    from rcj_challenges.tournament.opened import OpenTournament

tournament_app = App(
    "tournament",
    "Plan, play and publish a tournament that is declared in YAML.",
    "rcj-challenge tournament plan cup",
    "rcj-challenge tournament run cup",
)

File = Annotated[str, typer.Argument(metavar="FILE", help="A tournament file, or the name of a shipped one: cup.")]
Data = Annotated[
    Path | None,
    typer.Option("--data", metavar="DIR", help="Folder of its data; default: NAME_data in the current folder."),
]
Cascade = Annotated[
    bool, typer.Option("--cascade", help="Play again what depends on a change, also in stages that have begun.")
]


def opened(file: str, data: Path | None, *, writing: bool = False) -> AbstractContextManager[OpenTournament]:
    """Open a tournament with its store.

    Raises:
        RcjError: the file or the store cannot be used.
    """
    from rcj_challenges.tournament.opened import open_tournament

    return open_tournament(file, data, writing=writing)
