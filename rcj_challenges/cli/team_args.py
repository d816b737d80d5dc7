"""The teams of a match: from ``--team ENTRANT=PATH`` to opened teams."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rcj_challenges.cli.codes import NO_SAMPLE_TEAM, OPTION_GIVEN_TWICE, UNKNOWN_ENTRANT
from rcj_challenges.core.code import Code
from rcj_challenges.core.codes import BAD_OPTION
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.scenario.errors import choice_of, did_you_mean
from rcj_challenges.scenario.resources import shipped_teams
from rcj_challenges.tournament.codes import UNKNOWN_TEAM

if TYPE_CHECKING:
    from rcj_challenges.scenario.load import Loaded
    from rcj_challenges.scenario.models.robots import Entrant
    from rcj_challenges.scenario.models.scenario import Scenario
    from rcj_challenges.submissions.team import Team


def open_teams(loaded: Loaded, given_teams: list[str]) -> dict[str, Team]:
    """Open each seat's team: the one given as ``ENTRANT=PATH`` or ``ENTRANT=NAME``, else a sample team.

    Raises:
        RcjError: a seat that is none, a team that cannot be opened, or a seat for which there is no sample team.
    """
    entrants = loaded.scenario.entrants
    given = assignments(given_teams, entrants, "--team")
    opened: dict[str, Team] = {}
    for seat, entrant in entrants.items():
        path = locate_team(given[seat]) if seat in given else _sample_team(loaded, seat)
        seats = entrants.values() if loaded.scenario.match.swap_sides else (entrant,)
        opened[seat] = _opened(path, tuple(seats), loaded.scenario)
    return opened


def _opened(path: Path, seats: tuple[Entrant, ...], scenario: Scenario) -> Team:
    """Open a team that plays for some seats.

    Raises:
        TeamError: it cannot be; for missing programs with the code and help of ``check``.
    """
    from rcj_challenges.submissions.team import TeamError, look_into, open_team

    try:
        return open_team(path, *seats)
    except TeamError as error:
        opening = look_into(path, *seats)
        if not opening.missing or opening.contents.refused:
            raise
        from rcj_challenges.checker.layout import layout_findings
        from rcj_challenges.checker.others import others_that_fit
        from rcj_challenges.submissions.problems import MAX_PATH_SHOWN, safe_text

        others = others_that_fit(opening.contents.files, scenario)
        found = next(one for one in layout_findings(opening, seats, others) if one.level == "error")
        copy = "; rcj-challenge check … --fix NEW.zip makes such a copy" if found.repair else ""
        message = f"{safe_text(path, MAX_PATH_SHOWN)}: {found.message}"
        raise TeamError(message, f"{found.help}{copy}", code=found.code) from error


def _sample_team(loaded: Loaded, seat: str) -> Path:
    """The sample team for a seat; see `rcj_challenges.match.samples.sample_team`.

    Raises:
        RcjError: there is none.
    """
    from rcj_challenges.match.samples import sample_team
    from rcj_challenges.scenario.load import load

    scenario = loaded.scenario
    bases = [load(path).scenario for path in loaded.bases]
    found = sample_team(scenario, seat, bases)
    if found is not None:
        return found
    raise RcjError(
        f"who plays for {seat!r}? {_why_no_sample_team(scenario, seat, bases)}",
        f"give --team {seat}=PATH, a team with {_programs_of(scenario, seat)}",
        code=NO_SAMPLE_TEAM,
    )


def _why_no_sample_team(scenario: Scenario, seat: str, bases: Sequence[Scenario]) -> str:
    from rcj_challenges.match.samples import has_sample_team, other_kits

    for base in bases:
        if has_sample_team(base) and (kits := other_kits(scenario, base, seat)):
            kits_text = ", ".join(f"{robot}: {kit}" for robot, kit in kits.items())
            return f"The sample team of {base.id} was written for other kits or packets ({kits_text})"
    return "There is no sample team for it"


def _programs_of(scenario: Scenario, seat: str) -> str:
    """Programs that a team must have, each with its robots and their kits."""
    wanted = scenario.entrants[seat].robots.items()
    driven = grouped((entry if isinstance(entry, str) else entry[0], robot) for robot, entry in wanted)
    return " and ".join(
        f"{program} for {', '.join(f'{robot} (kit {scenario.robots[robot].kit})' for robot in robots)}"
        for program, robots in driven.items()
    )


def assignments(given: list[str], seats: Mapping[str, Any], option: str) -> dict[str, str]:
    """``ENTRANT=VALUE`` options by entrant.

    Raises:
        RcjError: no such form, no such entrant, or one that is given twice.
    """
    found: dict[str, str] = {}
    for entry in given:
        seat, equals, value = entry.partition("=")
        if not equals or not value:
            example = f"write ENTRANT=VALUE, such as {option} {next(iter(seats))}=…"
            raise RcjError(f"{option} {entry}: no entrant or no value", example, code=BAD_OPTION)
        refuse_unknown(seat, seats, UNKNOWN_ENTRANT)
        if seat in found:
            raise RcjError(f"{option}: {seat!r} is given twice", "leave one out", code=OPTION_GIVEN_TWICE)
        found[seat] = value
    return found


def refuse_unknown(name: str, names: Mapping[str, Any] | frozenset[str], code: Code) -> None:
    """Raise a `RcjError` with the names that there are, if this is none of them."""
    if name not in names:
        raise RcjError(f"{code.replace('-', ' ')} {name!r}", choice_of(name, sorted(names)), code=code)


def locate_team(given: str) -> Path:
    """The folder of a team: the path that was typed if it exists, else that of the sample team of that name.

    Raises:
        RcjError: it looks like a name, and there is no such file, folder or sample team.
    """
    path = path_or_sample_team(Path(given))
    if os.path.exists(path) or path.name != given or path.suffix:  # noqa: PTH110 - pathlib's raises for long names
        return path
    help_ = did_you_mean(given, shipped_teams(), "'rcj-challenge teams' lists the sample teams")
    raise RcjError(f"no file, folder or sample team '{sanitize(given)}'", help_, code=UNKNOWN_TEAM)


def path_or_sample_team(given: Path) -> Path:
    """The folder of the sample team of that name if nothing else is there, else what was given."""
    if os.path.exists(given):  # noqa: PTH110 - pathlib's raises for long names
        return given
    return shipped_teams().get(str(given), given)
