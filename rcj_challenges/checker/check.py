"""The check of one submission, stage by stage, each doing what the tournament does."""

from __future__ import annotations

import hashlib
import re
import shutil
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from rcj_challenges.checker.archives import Inspection, TeamError, inspect
from rcj_challenges.checker.findings import STAGES, Finding, Stage, StageName
from rcj_challenges.checker.report import FileReport, MatchReport, gravest, match_report, stage_report
from rcj_challenges.checker.sources import check_sources
from rcj_challenges.controllers.private_folders import PrivateFolders
from rcj_challenges.controllers.team import Team
from rcj_challenges.facts.errors import RcjError
from rcj_challenges.facts.shown import shown, shown_block
from rcj_challenges.records.errors import RecordError
from rcj_challenges.scenario.load import Loaded

if TYPE_CHECKING:
    from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed

_NEEDS: dict[StageName, tuple[StageName, ...]] = {
    "archive": (),
    "layout": ("archive",),
    "identity": ("archive",),
    "sources": ("archive", "layout"),
    "start": ("archive", "layout", "sources"),
    "play": ("archive", "layout", "sources", "start"),
}
PLAY_S = 10.0
"""As long as the web checker of the original played (reference, section 7)."""

_MOST_OUTPUT_LINES = 200
_MOST_LOGO_BYTES = 500_000
_PNG = b"\x89PNG\r\n\x1a\n"


@dataclass(frozen=True)
class CheckOptions:
    """What a check is to do.

    Attributes:
        sandbox: ``auto``, ``strict`` or ``off``.
        play: whether programs are run at all.
        play_s: how long each short match is, in simulated s.
        replays: folder for replay pages; None: none are written.
        show_output: whether what programs print is part of the report.
    """

    sandbox: str = "auto"
    play: bool = True
    play_s: float = PLAY_S
    replays: Path | None = None
    show_output: bool = False


@dataclass
class _Findings:
    """What is known so far."""

    stages: dict[StageName, Stage] = field(default_factory=dict)
    matches: list[MatchReport] = field(default_factory=list)

    def obstacle(self, name: StageName) -> str:
        """Return why a stage makes no sense, if it does not."""
        failed = next((need for need in _NEEDS[name] if need in self.stages and self.stages[need].failed), None)
        return "" if failed is None else f'"{STAGES[failed]}" has to be put right first'


def check_file(path: Path, loaded: Loaded, options: CheckOptions, repaired: list[str] | None = None) -> FileReport:
    """Check one submission. Whatever its bytes are, this ends with a verdict.

    Args:
        path: a ZIP, a folder or a ``.py`` file that exists.
        loaded: the scenario that it is for.
        options: what to do.
        repaired: what was put right in it before, safe to show.

    Raises:
        TeamError: there is nothing at this path that can be opened.
    """
    began = time.perf_counter()
    found = _Findings()
    inspection = _inspected(path, loaded, found)
    team = inspection.team if inspection is not None else None
    try:
        if inspection is not None and team is not None:
            name = inspection.display_name or team.name
            _carried_out(found, "sources", lambda: check_sources(team))
            _run(found, options, path, lambda scratch: _rehearsal(loaded, team, name, options.sandbox, scratch))
    finally:
        if team is not None:
            team.close()
    for left in STAGES:
        if left not in found.stages:
            found.stages[left] = Stage(left, skipped=found.obstacle(left) or "the submission could not be opened")
    stages = [stage_report(found.stages[name]) for name in STAGES]
    return FileReport(
        file=shown(path.resolve().name or str(path)),
        level=gravest(stage.level for stage in stages),
        team=shown(inspection.display_name) if inspection is not None else "",
        digest=inspection.digest if inspection is not None else "",
        repaired=repaired or [],
        stages=stages,
        matches=found.matches,
        wall_s=round(time.perf_counter() - began, 3),
        logo=_logo(inspection),
    )


def crashed_report(path: Path, message: str, details: str = "") -> FileReport:
    """Return the report on a submission whose check itself came to a bad end."""
    told = shown_block(details) if details else ""
    return _verdict_only(path, Finding("check.broken", "failure", message, _OUR_REMEDY, details=told))


def unreadable_report(path: Path, message: str) -> FileReport:
    """Return the report on a submission that cannot be opened any more when its turn comes."""
    remedy = "is the file still there, and may it be read?"
    return _verdict_only(path, Finding("archive.cannot_open", "failure", shown(message, 400), remedy))


def _verdict_only(path: Path, finding: Finding) -> FileReport:
    stages = [Stage(name, skipped="the submission could not be checked") for name in STAGES]
    stages[0] = Stage("archive", [finding])
    return FileReport(
        file=shown(path.resolve().name or str(path)),
        level="failure",
        team="",
        digest="",
        repaired=[],
        stages=[stage_report(stage) for stage in stages],
        matches=[],
        wall_s=0.0,
    )


_OUR_REMEDY = "this is our fault, not yours: please send the submission to the people of this project"


def _inspected(path: Path, loaded: Loaded, found: _Findings) -> Inspection | None:
    try:
        inspection = inspect(path, loaded.scenario)
    except TeamError:
        raise
    except Exception as error:  # noqa: BLE001 - whatever an archive does to us, its team gets a verdict
        found.stages["archive"] = Stage("archive", [_stumbled("archive", error)])
        return None
    found.stages |= {stage.name: stage for stage in inspection.stages}
    return inspection


def _rehearsal(loaded: Loaded, team: Team, name: str, sandbox: str, scratch: Path) -> Rehearsal:
    from rcj_challenges.checker.rehearsal import Rehearsal  # noqa: PLC0415 - see `_run`

    return Rehearsal(loaded, team, name, sandbox, scratch)


def _run(found: _Findings, options: CheckOptions, path: Path, rehearsal_in: Callable[[Path], Rehearsal]) -> None:
    """Carry out the stages that run programs. The physics is imported only if there is something to run."""
    for name in ("start", "play"):
        obstacle = found.obstacle(name) if options.play else "not asked for (--no-play)"
        if obstacle:
            found.stages[name] = Stage(name, skipped=obstacle)
    if "start" in found.stages:
        return

    from rcj_challenges.checker.playing import check_play  # noqa: PLC0415
    from rcj_challenges.checker.starting import check_start  # noqa: PLC0415

    with PrivateFolders() as folders:
        rehearsal = rehearsal_in(folders.place)

        def play() -> Stage:
            played = check_play(rehearsal, options.play_s)
            found.matches = [_match(match, path, options, played.stage) for match in played.matches]
            return played.stage

        _carried_out(found, "start", lambda: check_start(rehearsal))
        _carried_out(found, "play", play)


def _carried_out(found: _Findings, name: StageName, stage: Callable[[], Stage]) -> None:
    """Carry out a stage, unless one that it needs failed; what goes wrong on our side becomes a finding."""
    obstacle = found.obstacle(name)
    if obstacle:
        found.stages[name] = Stage(name, skipped=obstacle)
        return
    try:
        found.stages[name] = stage()
    except RcjError as error:
        found.stages[name] = Stage(name, [Finding(f"{name}.impossible", "failure", shown(error), _OUR_REMEDY)])
    except Exception as error:  # noqa: BLE001 - whatever a program does to us, its team gets a verdict
        found.stages[name] = Stage(name, [_stumbled(name, error)])


def _stumbled(name: StageName, error: Exception) -> Finding:
    message = f"the check itself stumbled here ({type(error).__name__}: {shown(error, 120)})"
    return Finding(f"{name}.stumbled", "failure", message, _OUR_REMEDY)


def _match(match: Rehearsed, path: Path, options: CheckOptions, stage: Stage) -> MatchReport:
    """Report a match, keep its replay, and quote what programs printed."""
    replay = ""
    if options.replays is not None:
        try:
            replay = str(_keep_replay(match, path, options.replays))
        except (OSError, RecordError) as error:
            message = f"the replay could not be written: {shown(error)}"
            stage.findings.append(Finding("play.no_replay", "warning", message, "is there room on the disk?"))
    outputs = {}
    if options.show_output:
        outputs = {robot: shown_block(match.log(robot), _MOST_OUTPUT_LINES) for robot in match.motions}
    return match_report(match, replay, outputs)


def _keep_replay(match: Rehearsed, path: Path, folder: Path) -> Path:
    """Write the replay page of a match into a folder; return where.

    Raises:
        OSError, RecordError: it cannot be written.
    """
    from rcj_challenges.views.replay import write_replay  # noqa: PLC0415 - few ask for it

    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"{file_slug(path)}-{'-'.join(match.seats)}.html"
    shutil.move(write_replay(match.folder), target)
    return target


def file_slug(path: Path) -> str:
    """Return a name made from a file's name that is legal everywhere and differs where the file's does."""
    name = path.resolve().name
    slug = re.sub(r"[^A-Za-z0-9_-]+", "_", name.removesuffix(".zip")).strip("_")[:60]
    if slug and slug == name.removesuffix(".zip"):
        return slug
    return f"{slug or 'team'}-{hashlib.sha256(name.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}"


def _logo(inspection: Inspection | None) -> bytes | None:
    """Return a logo that a page can show."""
    logo = inspection.logo if inspection is not None else None
    return logo if logo is not None and logo.startswith(_PNG) and len(logo) <= _MOST_LOGO_BYTES else None
