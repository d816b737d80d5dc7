"""The check of one submission, stage by stage, each doing what the tournament does."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rcj_challenges.checker.archives import Inspection, inspect
from rcj_challenges.checker.codes import CHECK_BROKEN, CHECK_IMPOSSIBLE
from rcj_challenges.checker.designs import check_designs
from rcj_challenges.checker.discovery import SubmissionName, name_submissions
from rcj_challenges.checker.findings import STAGES, Stage, StageName, most_serious
from rcj_challenges.checker.report import FileReport, MatchReport, first_cause, match_report, stage_report
from rcj_challenges.checker.report_files import write_page
from rcj_challenges.checker.sources import check_sources
from rcj_challenges.core.code import Level
from rcj_challenges.core.codes import NO_MEMORY, NO_PHYSICS
from rcj_challenges.core.diagnostics import Diagnostic, one_line
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
from rcj_challenges.core.temporary_folder import temporary_folder_error
from rcj_challenges.programs.private_folders import PrivateFolders
from rcj_challenges.programs.scratch import ensure_room
from rcj_challenges.records.errors import RecordError, UnwritableError
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.submissions.team import Team, TeamError

if TYPE_CHECKING:
    from rcj_challenges.checker.rehearsal import Rehearsed

_NEEDS: dict[StageName, tuple[StageName, ...]] = {
    "archive": (),
    "layout": ("archive",),
    "identity": ("archive",),
    "design": ("archive", "layout"),
    "sources": ("archive", "layout"),
    "start": ("archive", "layout", "design", "sources"),
    "play": ("archive", "layout", "design", "sources", "start"),
}
PLAY_S = 10.0
"""As long as the web checker of the original played (reference, section 7)."""

_MAX_OUTPUT_LINES = 200
_MAX_LOGO_BYTES = 500_000
_OUR_HELP = "this is the fault of the check, not the team's: please send the submission to the people of this project"
_OUR_EXIT_CODE = 3
_IMPOSSIBLE_HELP = "this says nothing about the team: check whether the scenario can be played here at all"


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


def check_file(
    path: Path,
    loaded: Loaded,
    options: CheckOptions,
    repaired: list[str] | None = None,
    named: SubmissionName | None = None,
    on_stage: Callable[[StageName], None] = lambda _: None,
) -> FileReport:
    """Check one submission. Whatever its bytes are, this ends with a report.

    Args:
        path: a ZIP, a folder or a ``.py`` file that exists.
        loaded: the scenario that it is for.
        options: what to do.
        repaired: earlier repairs of it, safe to show.
        named: its name among several; None: that of its file.
        on_stage: called when a stage begins.

    Raises:
        TeamError: there is nothing at this path that can be opened.
    """
    began = time.perf_counter()
    check = _Check(loaded, options, named or name_submissions([path])[0], on_stage)
    try:
        check.run(path)
    except HostError as error:
        check.blocked_by, check.blocked_code = sanitize(one_line(error)), error.code or ""
    return check.report(repaired or [], time.perf_counter() - began)


def crashed_report(named: SubmissionName, message: str, details: str = "") -> FileReport:
    """Return the report on a submission whose check itself failed: nothing is known about it."""
    block = sanitize_block(details) if details else ""
    finding = Diagnostic(CHECK_BROKEN, sanitize(message, 400), _OUR_HELP, details=block)
    return _report_without_check(named, finding, finding.message)


def unchecked_report(named: SubmissionName, blocked_by: str) -> FileReport:
    """Return the report on a submission that this computer could not check: nothing is known about it."""
    return _report_without_check(named, None, sanitize(blocked_by, 400))


def _report_without_check(named: SubmissionName, finding: Diagnostic | None, blocked_by: str) -> FileReport:
    stages = [Stage(name, skipped="the submission could not be checked") for name in STAGES]
    if finding is not None:
        stages[0] = Stage("archive", [finding])
    return FileReport(
        file=named.name,
        level="unchecked",
        blocked_by=blocked_by,
        our_fault=finding is not None,
        team="",
        digest="",
        repaired=[],
        stages=[stage_report(stage) for stage in stages],
        matches=[],
        wall_s=0.0,
    )


class _Check:
    """The check of one submission, and its results so far.

    Attributes:
        blocked_by: what this computer could not do; empty if it could.
        blocked_code: of that error.
    """

    def __init__(
        self, loaded: Loaded, options: CheckOptions, named: SubmissionName, on_stage: Callable[[StageName], None]
    ) -> None:
        self._on_stage = on_stage
        self.blocked_by = ""
        self.blocked_code = ""
        self._loaded = loaded
        self._options = options
        self._named = named
        self._inspection: Inspection | None = None
        self._stages: dict[StageName, Stage] = {}
        self._started: dict[str, str] = {}
        self._matches: list[MatchReport] = []
        self._our_fault = False

    def run(self, path: Path) -> None:
        """Carry out all stages.

        Raises:
            HostError: this computer cannot do it.
            TeamError: there is nothing at this path that can be opened.
        """
        with self._errors_as_findings("archive"):
            self._inspection = inspect(path, self._loaded.scenario)
        if self._inspection is None:
            return
        self._stages |= {stage.name: stage for stage in self._inspection.stages}
        team = self._inspection.team
        if team is not None:
            self._carry_out("design", lambda: check_designs(team, self._loaded))
            self._carry_out("sources", lambda: check_sources(team))
            self._run_programs(team, self._inspection.opening.name.text or team.name)

    def report(self, repaired: list[str], wall_s: float) -> FileReport:
        """Return the report. Stages that were not come to are skipped."""
        missing = "this computer could not go on" if self.blocked_by else "the submission could not be opened"
        for name in STAGES:
            if name not in self._stages:
                self._stages[name] = Stage(name, skipped=self._obstacle(name) or missing)
        stages = [self._stages[name] for name in STAGES]
        level: Level = "unchecked" if self.blocked_by else most_serious(stage.level for stage in stages)
        unknown = [one.message for stage in stages for one in stage.findings if one.level == "unchecked"]
        inspection = self._inspection
        logo = inspection.logo if inspection is not None else None
        return FileReport(
            file=self._named.name,
            level=level,
            cause=first_cause(stages, level),
            code=self.blocked_code,
            blocked_by=self.blocked_by or next(iter(unknown), ""),
            our_fault=self._our_fault and not self.blocked_by,
            team=sanitize(inspection.opening.name.text) if inspection is not None else "",
            digest=inspection.team.digest if inspection is not None and inspection.team is not None else "",
            repaired=repaired,
            stages=[stage_report(stage) for stage in stages],
            started=self._started,
            matches=self._matches,
            wall_s=round(wall_s, 3),
            logo=logo if logo is not None and len(logo) <= _MAX_LOGO_BYTES else None,
        )

    def _obstacle(self, name: StageName) -> str:
        """Return why a stage must be skipped; empty if it need not."""
        failed = next((need for need in _NEEDS[name] if need in self._stages and self._stages[need].failed), None)
        if failed is None:
            return ""
        known = self._stages[failed].level == "error"
        return f'the stage "{failed}" {"must pass first" if known else "could not be checked"}'

    def _run_programs(self, team: Team, name: str) -> None:
        """Carry out the stages that run programs. The physics is imported only if there is something to run."""
        skipped = self._obstacle("start") if self._options.play else "not asked for (--no-play)"
        if skipped:
            self._stages |= {"start": Stage("start", skipped=skipped), "play": Stage("play", skipped=skipped)}
            return
        try:
            from rcj_challenges.checker.playing import check_play  # noqa: PLC0415
            from rcj_challenges.checker.rehearsal import Rehearsal  # noqa: PLC0415
            from rcj_challenges.checker.starting import check_start  # noqa: PLC0415
        except (ImportError, OSError) as error:
            raise HostError(f"the physics cannot be loaded: {format_error(error)}", code=NO_PHYSICS) from error
        with PrivateFolders() as folders:
            rehearsal = Rehearsal(self._loaded, team, name, self._options.sandbox, folders.place)
            missing: list[str] = []  # devices, when the programs started

            def start() -> Stage:
                stage, match, lacking = check_start(rehearsal)
                missing.extend(lacking)
                if self._options.show_output and stage.failed:  # otherwise the match shows it
                    self._started = _outputs(match)
                return _unless_full(stage, folders.place)

            def play() -> Stage:
                stage, matches = check_play(rehearsal, self._options.play_s, missing)
                self._matches = [self._match(match) for match in matches]
                return _unless_full(stage, folders.place)

            self._carry_out("start", start)
            self._carry_out("play", play)

    def _carry_out(self, name: StageName, stage: Callable[[], Stage]) -> None:
        """Carry out a stage, unless one that it needs failed."""
        obstacle = self._obstacle(name)
        if obstacle:
            self._stages[name] = Stage(name, skipped=obstacle)
            return
        self._on_stage(name)
        with self._errors_as_findings(name):
            self._stages[name] = stage()

    @contextmanager
    def _errors_as_findings(self, name: StageName) -> Iterator[None]:
        """Make errors findings of a stage: whatever one submission causes, the others are checked.

        Raises:
            HostError: it goes wrong because of this computer, which is no finding about a team.
            KeyboardInterrupt: also in place of an error that a library made of one.
            TeamError: there is nothing that can be opened.
        """
        try:
            yield
        except RcjError as error:
            _raise_if_of_the_host(error)
            if name == "archive" and isinstance(error, TeamError):
                raise
            ours = error.exit_code == _OUR_EXIT_CODE
            self._our_fault |= ours
            help_ = _OUR_HELP if ours else _IMPOSSIBLE_HELP
            finding = Diagnostic(CHECK_IMPOSSIBLE, sanitize(one_line(error), 400), help_)
            self._stages[name] = Stage(name, [finding])
        except Exception as error:
            if interruption_behind(error) is not None:
                raise KeyboardInterrupt from error
            _raise_if_of_the_host(error)
            self._our_fault = True
            message = f"the check itself failed at {name} ({type(error).__name__}: {sanitize(error, 120)})"
            self._stages[name] = Stage(name, [Diagnostic(CHECK_BROKEN, message, _OUR_HELP)])

    def _match(self, match: Rehearsed) -> MatchReport:
        """Report a match, keep its replay page, and quote what programs printed."""
        replay = no_replay = ""
        folder = self._options.replays
        if folder is not None:
            from rcj_challenges.views.replay import write_replay  # noqa: PLC0415 - few ask for it

            try:
                folder.mkdir(parents=True, exist_ok=True)
                target = folder / f"{self._named.slug}-{'-'.join(match.seats)}.html"
                write_page(target, write_replay(match.folder).read_text(encoding="utf-8"))
                replay = str(target)
            except OSError as error:
                no_replay = sanitize(f"{error.filename or folder}: {error_hint(error)}", 400)
            except RecordError as error:
                no_replay = sanitize(error, 400)
        return match_report(match, replay, no_replay, _outputs(match) if self._options.show_output else {})


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


def _raise_if_of_the_host(error: Exception) -> None:
    """Raise a host error for an error that is about this computer; do nothing about others.

    Raises:
        HostError: this computer is the reason.
    """
    for reason in (error, error.__cause__):
        if isinstance(reason, MemoryError):
            raise HostError("there is not enough memory", code=NO_MEMORY) from error
        if isinstance(reason, UnwritableError) and reason.__cause__ is not None:  # a record that is kept there
            raise temporary_folder_error(reason.__cause__) from error
        if reason is not None and is_no_room(reason):
            raise temporary_folder_error(reason) from error
        if isinstance(reason, HostError):
            raise reason
        if reason is not None and is_of_the_host(reason):
            raise HostError(format_error(reason)) from error


def _outputs(match: Rehearsed) -> dict[str, str]:
    """The output of programs, by robot, safe to show."""
    return {robot: sanitize_block(match.log(robot), _MAX_OUTPUT_LINES) for robot in match.robots}
