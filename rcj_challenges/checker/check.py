"""The check of one submission, stage by stage, each doing what the tournament does."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from rcj_challenges.checker.archives import Inspection, TeamError, inspect
from rcj_challenges.checker.findings import STAGES, Finding, Level, Stage, StageName, gravest
from rcj_challenges.checker.many_given import Called, called
from rcj_challenges.checker.report import FileReport, MatchReport, first_cause, match_report, stage_report
from rcj_challenges.checker.report_files import copy_page
from rcj_challenges.checker.sources import check_sources
from rcj_challenges.controllers.disk_names import from_disk
from rcj_challenges.controllers.private_folders import PrivateFolders, temporary_folder_error
from rcj_challenges.controllers.scratch import ensure_room
from rcj_challenges.controllers.team import Team
from rcj_challenges.core.diagnostics import one_line
from rcj_challenges.core.errors import (
    HostError,
    RcjError,
    error_hint,
    format_error,
    interruption_behind,
    is_no_room,
    is_of_the_host,
)
from rcj_challenges.core.sanitize import sanitize, sanitize_block
from rcj_challenges.records.errors import RecordError, UnwritableError
from rcj_challenges.records.logos import PNG_SIGNATURE
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

_MAX_OUTPUT_LINES = 200
_MAX_LOGO_BYTES = 500_000


@dataclass(frozen=True)
class CheckOptions:
    """The options of a check.

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
    """The results so far."""

    stages: dict[StageName, Stage] = field(default_factory=dict)
    started: dict[str, str] = field(default_factory=dict)
    matches: list[MatchReport] = field(default_factory=list)
    hindrance: str = ""
    hindrance_code: str = ""
    our_fault: bool = False

    def obstacle(self, name: StageName) -> str:
        """Return why a stage must be skipped; empty if it need not."""
        failed = next((need for need in _NEEDS[name] if need in self.stages and self.stages[need].failed), None)
        if failed is None:
            return ""
        known = self.stages[failed].level == "failure"
        return f'"{STAGES[failed]}" {"has to be put right first" if known else "could not be checked"}'


def check_file(
    path: Path,
    loaded: Loaded,
    options: CheckOptions,
    repaired: list[str] | None = None,
    named: Called | None = None,
) -> FileReport:
    """Check one submission. Whatever its bytes are, this ends with a report.

    Args:
        path: a ZIP, a folder or a ``.py`` file that exists.
        loaded: the scenario that it is for.
        options: what to do.
        repaired: earlier repairs of it, safe to show.
        named: its name among several; None: that of its file.

    Raises:
        TeamError: there is nothing at this path that can be opened.
    """
    began = time.perf_counter()
    named = named or called([path])[0]
    found = _Findings()
    inspection = None
    try:
        inspection = _inspected(path, loaded, found)
        if inspection is not None and inspection.team is not None:
            _examined(inspection, inspection.team, loaded, options, found, named)
    except HostError as error:
        found.hindrance, found.hindrance_code = sanitize(one_line(error)), error.code
    missing = "this computer could not go on" if found.hindrance else "the submission could not be opened"
    for left in STAGES:
        if left not in found.stages:
            found.stages[left] = Stage(left, skipped=found.obstacle(left) or missing)
    stages = [stage_report(found.stages[name]) for name in STAGES]
    level: Level = "unchecked" if found.hindrance else gravest(stage.level for stage in stages)
    return FileReport(
        file=named.name,
        level=level,
        cause=first_cause([found.stages[name] for name in STAGES], level),
        code=found.hindrance_code,
        hindrance=found.hindrance or (_unknown(found) if level == "unchecked" else ""),
        our_fault=found.our_fault and not found.hindrance,
        team=sanitize(inspection.display_name) if inspection is not None else "",
        digest=inspection.digest if inspection is not None else "",
        repaired=repaired or [],
        stages=stages,
        started=found.started,
        matches=found.matches,
        wall_s=round(time.perf_counter() - began, 3),
        logo=_logo(inspection),
    )


def _unknown(found: _Findings) -> str:
    """Return why the first stage of which nothing is known could not be carried out."""
    unknown = (one for stage in found.stages.values() for one in stage.findings if one.level == "unchecked")
    return next(unknown).message


def crashed_report(named: Called, message: str, details: str = "") -> FileReport:
    """Return the report on a submission whose check itself failed: nothing is known about it."""
    block = sanitize_block(details) if details else ""
    finding = Finding("check.broken", "unchecked", sanitize(message, 400), _OUR_REMEDY, details=block)
    return _report_without_check(named, finding, finding.message)


def unchecked_report(named: Called, hindrance: str) -> FileReport:
    """Return the report on a submission that this computer could not check: nothing is known about it.

    Args:
        named: what it is called.
        hindrance: what could not be done.
    """
    return _report_without_check(named, None, sanitize(hindrance, 400))


def _report_without_check(named: Called, finding: Finding | None, hindrance: str) -> FileReport:
    stages = [Stage(name, skipped="the submission could not be checked") for name in STAGES]
    if finding is not None:
        stages[0] = Stage("archive", [finding])
    return FileReport(
        file=named.name,
        level="unchecked",
        hindrance=hindrance,
        our_fault=finding is not None,
        team="",
        digest="",
        repaired=[],
        stages=[stage_report(stage) for stage in stages],
        matches=[],
        wall_s=0.0,
    )


_OUR_REMEDY = "this is the fault of the check, not the team's: please send the submission to the people of this project"
_OUR_EXIT_CODE = 3
_IMPOSSIBLE_REMEDY = "this says nothing about the team: look whether the scenario can be played here at all"


def _inspected(path: Path, loaded: Loaded, found: _Findings) -> Inspection | None:
    try:
        inspection = inspect(path, loaded.scenario)
    except TeamError as error:
        _raise_if_of_the_host(error)
        raise
    except Exception as error:  # noqa: BLE001 - whatever an archive does to us, the others are checked
        _raise_if_of_the_host(error)
        found.our_fault = True
        found.stages["archive"] = Stage("archive", [_stumbled("archive", error)])
        return None
    found.stages |= {stage.name: stage for stage in inspection.stages}
    return inspection


def _examined(
    inspection: Inspection, team: Team, loaded: Loaded, options: CheckOptions, found: _Findings, named: Called
) -> None:
    """Read the programs of a team, and run them.

    Raises:
        HostError: this computer cannot do it.
    """
    name = inspection.display_name or team.name
    with team:
        _carried_out(found, "sources", lambda: check_sources(team, options.sandbox))
        _run(found, options, named, lambda scratch: _rehearsal(loaded, team, name, options.sandbox, scratch))


def _rehearsal(loaded: Loaded, team: Team, name: str, sandbox: str, scratch: Path) -> Rehearsal:
    from rcj_challenges.checker.rehearsal import Rehearsal  # noqa: PLC0415 - see `_run`

    return Rehearsal(loaded, team, name, sandbox, scratch)


def _run(found: _Findings, options: CheckOptions, named: Called, rehearsal_in: Callable[[Path], Rehearsal]) -> None:
    """Carry out the stages that run programs. The physics is imported only if there is something to run."""
    for name in ("start", "play"):
        obstacle = found.obstacle(name) if options.play else "not asked for (--no-play)"
        if obstacle:
            found.stages[name] = Stage(name, skipped=obstacle)
    if "start" in found.stages:
        return

    try:
        from rcj_challenges.checker.playing import check_play  # noqa: PLC0415
        from rcj_challenges.checker.starting import check_start  # noqa: PLC0415
    except (ImportError, OSError) as error:
        raise HostError(f"the physics cannot be loaded: {format_error(error)}", code="no-physics") from error

    with _private_folders() as folders:
        rehearsal = rehearsal_in(folders.place)
        missing: list[tuple[str, str]] = []  # devices, when the programs started

        def start() -> Stage:
            started = check_start(rehearsal)
            missing.extend(started.missing)
            if options.show_output and started.stage.failed:  # otherwise the match shows it
                found.started = _outputs(started.match)
            return _unless_full(started.stage, folders.place)

        def play() -> Stage:
            played = check_play(rehearsal, options.play_s, missing)
            found.matches = [_match(match, named, options) for match in played.matches]
            return _unless_full(played.stage, folders.place)

        _carried_out(found, "start", start)
        _carried_out(found, "play", play)


def _private_folders() -> PrivateFolders:
    try:
        return PrivateFolders()
    except OSError as error:
        raise temporary_folder_error(error) from error


def _unless_full(stage: Stage, place: Path) -> Stage:
    """Return a stage, unless programs failed while there was no room for what every program may write.

    Raises:
        HostError: there was none.
    """
    if stage.failed:
        try:
            ensure_room(place)
        except OSError as error:
            raise temporary_folder_error(error) from error
    return stage


def _carried_out(found: _Findings, name: StageName, stage: Callable[[], Stage]) -> None:
    """Carry out a stage, unless one that it needs failed; what goes wrong on our side becomes a finding.

    Raises:
        HostError: it goes wrong because of this computer, which is no finding about a team.
        KeyboardInterrupt: also in place of an error that a library has made of one.
    """
    obstacle = found.obstacle(name)
    if obstacle:
        found.stages[name] = Stage(name, skipped=obstacle)
        return
    try:
        found.stages[name] = stage()
    except RcjError as error:
        _raise_if_of_the_host(error)
        ours = error.exit_code == _OUR_EXIT_CODE
        found.our_fault |= ours
        remedy = _OUR_REMEDY if ours else _IMPOSSIBLE_REMEDY
        impossible = Finding(f"{name}.impossible", "unchecked", sanitize(one_line(error), 400), remedy)
        found.stages[name] = Stage(name, [impossible])
    except Exception as error:  # whatever one program causes, the others are checked
        if interruption_behind(error) is not None:
            raise KeyboardInterrupt from error
        _raise_if_of_the_host(error)
        found.our_fault = True
        found.stages[name] = Stage(name, [_stumbled(name, error)])


def _raise_if_of_the_host(error: Exception) -> None:
    """Raise a host error for an error that is about this computer; do nothing about others.

    Raises:
        HostError: this computer is the reason.
    """
    for reason in (error, error.__cause__):
        if isinstance(reason, MemoryError):
            raise HostError("there is not enough memory", code="no-memory") from error
        if isinstance(reason, UnwritableError) and reason.__cause__ is not None:  # a record that is kept there
            raise temporary_folder_error(reason.__cause__) from error
        if reason is not None and is_no_room(reason):
            raise temporary_folder_error(reason) from error
        if isinstance(reason, HostError):
            raise reason
        if reason is not None and is_of_the_host(reason):
            raise HostError(format_error(reason)) from error


def _stumbled(name: StageName, error: Exception) -> Finding:
    message = f"the check itself stumbled at {name} ({type(error).__name__}: {sanitize(error, 120)})"
    return Finding(f"{name}.stumbled", "unchecked", message, _OUR_REMEDY)


def _match(match: Rehearsed, named: Called, options: CheckOptions) -> MatchReport:
    """Report a match, keep its replay, and quote what programs printed."""
    replay = no_replay = ""
    if options.replays is not None:
        try:
            replay = from_disk(str(_keep_replay(match, named, options.replays)))
        except OSError as error:
            no_replay = sanitize(f"{error.filename or options.replays}: {error_hint(error)}", 400)
        except RecordError as error:
            no_replay = sanitize(error, 400)
    return match_report(match, replay, no_replay, _outputs(match) if options.show_output else {})


def _outputs(match: Rehearsed) -> dict[str, str]:
    """Return what programs printed, by robot, safe to show."""
    return {robot: sanitize_block(match.log(robot), _MAX_OUTPUT_LINES) for robot in match.motions}


def _keep_replay(match: Rehearsed, named: Called, folder: Path) -> Path:
    """Write the replay page of a match into a folder; return where.

    Raises:
        OSError, RecordError: it cannot be written.
    """
    from rcj_challenges.views.replay import write_replay  # noqa: PLC0415 - few ask for it

    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"{named.slug}-{'-'.join(match.seats)}.html"
    copy_page(write_replay(match.folder), target)
    return target


def _logo(inspection: Inspection | None) -> bytes | None:
    """Return a logo that a page can show."""
    logo = inspection.logo if inspection is not None else None
    return logo if logo is not None and logo.startswith(PNG_SIGNATURE) and len(logo) <= _MAX_LOGO_BYTES else None
