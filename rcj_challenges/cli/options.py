"""Options that several commands share, their completion by the shell, and what their values mean."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges.cli.codes import BAD_DURATION
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError

_DURATION = re.compile(r"(?:(?P<minutes>[0-9]+):(?=[0-5]?[0-9](?:\.|$)))?(?P<seconds>[0-9]+(?:\.[0-9]+)?|\.[0-9]+)s?")


def complete_scenarios(incomplete: str) -> list[str]:
    """Names of shipped scenarios; if none fits, the shell offers files."""
    from rcj_challenges.scenario.resources import shipped_scenarios

    return [name for name in shipped_scenarios() if name.startswith(incomplete)]


def complete_teams(incomplete: str) -> list[str]:
    """Names of sample teams."""
    from rcj_challenges.scenario.resources import shipped_teams

    return [name for name in shipped_teams() if name.startswith(incomplete)]


def complete_seats(incomplete: str) -> list[str]:
    """``ENTRANT=TEAM`` for the sample teams, once the entrant is typed."""
    seat, equals, name = incomplete.partition("=")
    return [f"{seat}={team}" for team in complete_teams(name)] if equals else []


Overrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="PATH=VALUE", help="Change a param or any value: --set match.half_s=60. Repeatable."),
]
Sandbox = Annotated[
    str, typer.Option("--sandbox", metavar="auto|strict|off", help="How programs are isolated (docs/isolation.md).")
]

Json = Annotated[bool, typer.Option("--json", help="Print JSON and nothing else.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Print no progress.")]
AtOnce = Annotated[int | None, typer.Option("--at-once", metavar="N", min=1, help="Matches at a time; default: cores.")]
Seeds = Annotated[str, typer.Option("--seeds", metavar="1..N", help="Which seeds: 1..10, 3 or 1,4,7..9.")]
Runs = Annotated[
    list[Path] | None,
    typer.Argument(metavar="RUN...", help="Folders of records, or beginnings of their names; default: the newest."),
]
Run = Annotated[
    Path | None,
    typer.Argument(metavar="RUN", help="A record's folder or the beginning of its name; default: the newest."),
]
RunsFolder = Annotated[Path, typer.Option("--runs", "--out", metavar="DIR", help="Where the records are.")]
OutFolder = Annotated[Path, typer.Option("--out", metavar="DIR", help="Where the folders of the records are created.")]
Teams = Annotated[
    list[str] | None,
    typer.Option(
        "--team",
        metavar="ENTRANT=TEAM",
        autocompletion=complete_seats,
        help="Who plays: a folder, a ZIP, a .py file or the name of a sample team. Repeatable.",
    ),
]
Blue = Annotated[
    list[str] | None,
    typer.Option("--blue", metavar="TEAM", autocompletion=complete_teams, help="Short for --team blue=TEAM."),
]
Yellow = Annotated[
    list[str] | None,
    typer.Option("--yellow", metavar="TEAM", autocompletion=complete_teams, help="Short for --team yellow=TEAM."),
]
Duration = Annotated[
    str | None, typer.Option("--duration", metavar="TIME", help="Length of a half in simulated time: 90, 90s or 1:30.")
]
Halves = Annotated[int | None, typer.Option("--halves", metavar="N", help="How many halves.")]
ScenarioName = Annotated[
    str,
    typer.Argument(
        metavar="SCENARIO",
        autocompletion=complete_scenarios,
        help="A scenario file, or the name of one that comes with this: match.",
    ),
]


def all_teams(given: list[str] | None, blue: list[str] | None, yellow: list[str] | None) -> list[str]:
    """Teams as ``ENTRANT=PATH``, the short options ``--blue`` and ``--yellow`` included."""
    short = (f"{seat}={path}" for seat, paths in (("blue", blue), ("yellow", yellow)) for path in paths or ())
    return [*(given or ()), *short]


def all_overrides(given: list[str] | None, duration: str | None, halves: int | None) -> list[str]:
    """Overrides of the scenario as ``PATH=VALUE``, the short options included.

    Raises:
        DiagnosticError: ``duration`` is no time.
    """
    half_s = None if duration is None else parse_duration(duration)
    short = (("half_s", half_s), ("halves", halves))
    return [*(given or ()), *(f"match.{name}={value}" for name, value in short if value is not None)]


def parse_duration(text: str) -> float:
    """The seconds of ``90``, ``90s`` or ``1:30``.

    Raises:
        DiagnosticError: it is no time.
    """
    found = _DURATION.fullmatch(text.strip())
    if found is None:
        raise DiagnosticError(Diagnostic(BAD_DURATION, f"--duration {text}: not a time", "write 90, 90s or 1:30"))
    return int(found["minutes"] or 0) * 60 + float(found["seconds"])
