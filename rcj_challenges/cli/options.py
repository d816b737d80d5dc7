"""Options that several commands share."""

from __future__ import annotations

from typing import Annotated

import typer

from rcj_challenges.cli.completion import complete_scenarios, complete_teams

Overrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="PATH=VALUE", help="Change a param or any value: --set match.half_s=60. Repeatable."),
]
Sandbox = Annotated[
    str,
    typer.Option("--sandbox", metavar="auto|strict|off", help="How programs are isolated (docs/isolation.md)."),
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
ScenarioFiles = Annotated[
    list[str],
    typer.Argument(
        metavar="FILE...", autocompletion=complete_scenarios, help="Scenario files, or names of shipped ones."
    ),
]


def all_teams(given: list[str] | None, blue: list[str] | None, yellow: list[str] | None) -> list[str]:
    """Return the teams as ``ENTRANT=PATH``, the short options ``--blue`` and ``--yellow`` included."""
    short = (f"{seat}={path}" for seat, paths in (("blue", blue), ("yellow", yellow)) for path in paths or ())
    return [*(given or ()), *short]


def all_overrides(given: list[str] | None, duration: str | None, halves: int | None) -> list[str]:
    """Return the overrides of the scenario as ``PATH=VALUE``, the short options included."""
    from rcj_challenges.cli.durations import parse_duration

    short = (("half_s", None if duration is None else parse_duration("--duration", duration)), ("halves", halves))
    return [*(given or ()), *(f"match.{name}={value}" for name, value in short if value is not None)]
