"""The first three stages of a check: the archive, the layout, the team's name and logo."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.checker.codes import ARCHIVE_SOUND
from rcj_challenges.checker.findings import Stage
from rcj_challenges.checker.identity import find_logo, name_findings
from rcj_challenges.checker.layout import layout_findings
from rcj_challenges.checker.others import others_that_fit, seats_of
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.models.robots import Entrant
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.archive import Contents
from rcj_challenges.submissions.team import Opening, Team, look_into


@dataclass(frozen=True)
class Inspection:
    """A submission before its programs are inspected.

    Attributes:
        stages: archive, layout, identity.
        team: the team, opened as a match opens it; None if it cannot play.
        logo: the logo as a PNG without anything that a picture does not need; None without one that may be shown.
        seats: the entrants whose robots it was checked for.
        opening: the result of opening it.
    """

    stages: list[Stage]
    team: Team | None
    logo: bytes | None
    seats: tuple[Entrant, ...]
    opening: Opening


def inspect(path: Path, scenario: Scenario) -> Inspection:
    """Inspect a submission: any bytes, or a folder.

    Args:
        path: a ZIP, a folder or a single program.
        scenario: says which programs are asked for.

    Raises:
        TeamError: there is nothing at this path that can be opened.
    """
    seats, opening = _opened(path, scenario)
    stages = [_archive(opening.contents), Stage("layout"), Stage("identity")]
    logo = None
    if opening.contents.complete:
        others = others_that_fit(opening.contents.files, scenario) if opening.missing else []
        stages[1].findings += layout_findings(opening, seats, others)
        found = find_logo(opening.files)
        stages[2].findings += [*name_findings(opening), *found.findings]
        logo = found.shown
    else:
        for stage in stages[1:]:
            stage.skipped = "the archive could not be read"
    return Inspection(stages, opening.team, logo, seats, opening)


def _opened(path: Path, scenario: Scenario) -> tuple[tuple[Entrant, ...], Opening]:
    wanted = seats_of(scenario)
    first = look_into(path, *wanted[0])
    for seats in wanted[1:] if first.missing else ():
        opening = look_into(path, *seats)
        if not opening.missing:
            return seats, opening
    return wanted[0], first


def _archive(contents: Contents) -> Stage:
    stage = Stage("archive", [*contents.problems])
    if not contents.refused:
        count, size = len(contents.files), sum(map(len, contents.files.values()))
        message = f"{counted(count, 'file')}, {size / 1000:.1f} kB unpacked"
        stage.findings.append(Diagnostic(ARCHIVE_SOUND, message))
    return stage
