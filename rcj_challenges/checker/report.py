"""The report of a check as data: the common form of terminal, JSON and HTML (``schemas/check.schema.json``)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Literal

from pydantic import Field

import rcj_challenges.checker.codes
import rcj_challenges.submissions.codes  # noqa: F401
from rcj_challenges.checker.findings import RANKS, STAGES, Stage, StageName, most_serious
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.code import Level
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import SUBSTEP_S
from rcj_challenges.records.result import Part, described

if TYPE_CHECKING:
    from rcj_challenges.checker.rehearsal import Rehearsed

REPORT_VERSION = 1


class StageReport(Part):
    """One stage."""

    name: StageName = described("which")
    about: str = described("what it is about")
    level: Level = described("the most severe of its findings")
    skipped: str = described("why it was not carried out; empty if it was")
    findings: list[Diagnostic] = described("what was found")


class RobotReport(Part):
    """How one robot of the team did in a short match. Times are CPU and idle time and differ from run to run."""

    robot: str = described("its name")
    path_m: float = described("length of its path in m", ge=0)
    turned_rad: float = described("how far it turned, both directions added up, in rad", ge=0)
    ball_touches: int = described("sub-steps of 8 ms in which it touched a ball", ge=0)
    steps: int = described("how many times its program called step", ge=0)
    start_s: float = described(
        "CPU and idle time from the launch of its program to its first step, in s; 0: it never got there", ge=0
    )
    step_mean_ms: float = described("CPU and idle time of a step, on average, in ms", ge=0)
    step_slowest_ms: float = described("CPU and idle time of the slowest step, in ms", ge=0)
    fault: str = described("how it failed: crash, exit, step_timeout …; empty if it did not")
    output: str = described("what its program printed, if requested")


ROBOT_NUMBERS: dict[str, Callable[[RobotReport], str]] = {
    "driven": lambda robot: f"{robot.path_m:.2f} m",
    "turned": lambda robot: f"{robot.turned_rad:.1f} rad",
    "at the ball": lambda robot: f"{robot.ball_touches * SUBSTEP_S:.2f} s",
    "steps": lambda robot: str(robot.steps),
    "start": lambda robot: f"{robot.start_s:.2f} s",
    "a step": lambda robot: f"{robot.step_mean_ms:.1f} ms",
    "slowest": lambda robot: f"{robot.step_slowest_ms:.0f} ms",
}
"""What a terminal and a page show of a robot, by the head of the column."""


class MatchReport(Part):
    """One short match."""

    seats: list[str] = described("where the team played")
    opponents: dict[str, str] = described("what played in the other seats")
    score: dict[str, int | float] = described("points by seat")
    simulated_s: float = described("how long was played in s", ge=0)
    wall_s: float = described("how long that took in s", ge=0)
    layers: list[str] = described("layers of isolation around the programs")
    dropped_layers: dict[str, str] = described("layers that could not be used, with the reasons", default={})
    replay: str = described("file of the replay page, if one was requested")
    no_replay: str = described("why there is no replay page although one was requested; usually empty", default="")
    robots: list[RobotReport] = described("the robots of the team")


class FileReport(Part):
    """The check of one submission."""

    file: str = described("name of the file or folder, with its parent folders if another one has the same name")
    level: Level = described(
        "the verdict: passed, warning (it plays, but look at the findings), error, "
        "or unchecked (nothing is known: the check itself could not be carried out)"
    )
    cause: str = described("what to fix first and how, in one line; empty if everything is in order", default="")
    code: str = described("the code of the error that prevented the check; usually empty", default="")
    blocked_by: str = described("why it is unchecked: what could not be done; otherwise empty", default="")
    our_fault: bool = described("whether it is unchecked because of a bug in this project", default=False)
    team: str = described("name of the team, safe to show; empty if it is not known")
    digest: str = described("SHA-256 over names and contents of its files; empty if they cannot be read")
    repaired: list[str] = described("what --fix repaired before this check")
    stages: list[StageReport] = described("the stages, in order")
    started: dict[str, str] = described(
        "what programs printed in the stage start, by robot, if requested and the stage failed", default={}
    )
    matches: list[MatchReport] = described("the short matches of the stage play")
    wall_s: float = described("how long the check took in s", ge=0)
    logo: bytes | None = Field(default=None, exclude=True, repr=False, description="its logo, a PNG; not in the JSON")

    def count(self, level: Level) -> int:
        """The number of findings of a level."""
        return sum(finding.level == level for stage in self.stages for finding in stage.findings)


class Summary(Part):
    """How many of the submissions passed."""

    files: int = described("how many were checked", ge=0)
    passed: int = described("how many are in order", ge=0)
    warning: int = described("how many play, but with warnings", ge=0)
    error: int = described("how many cannot be used as they are", ge=0)
    unchecked: int = described("how many could not be checked; nothing is known about them", ge=0)


class LeftOut(Part):
    """Something that was given, or is in a given folder, but was not checked."""

    file: str = described("its path, safe to show")
    reason: str = described("why not, and what to do if it should be checked")


class CheckReport(Part):
    """The whole output of ``rcj-challenge check --json``."""

    check: Literal[1] = described("version of this format")
    scenario: str = described("id of the scenario")
    title: str = described("title of the scenario")
    sandbox: str = described("how programs were isolated: auto, strict or off")
    level: Level = described("the most severe verdict; unchecked if the check was interrupted")
    interrupted: bool = described(
        "whether the check was interrupted before all submissions were checked", default=False
    )
    summary: Summary
    files: list[FileReport] = described("the submissions, in the order in which they were given")
    left_out: list[LeftOut] = described("what is next to them or was not reached, and was not checked", default=[])

    @property
    def lost_replays(self) -> int:
        """How many replay pages could not be written."""
        return sum(bool(match.no_replay) for file in self.files for match in file.matches)

    @property
    def exit_code(self) -> int:
        """0: all pass, maybe with warnings; 1: one does not; 2: this computer, 3: this project could not check all.

        Unknown results come first: after they are fixed, everything has to be checked again.
        """
        if any(file.our_fault for file in self.files):
            return 3
        return 2 if self.summary.unchecked or self.lost_replays else int(self.summary.error > 0)


def check_report(
    scenario: str,
    title: str,
    sandbox: str,
    files: list[FileReport],
    left_out: Sequence[LeftOut] = (),
    *,
    interrupted: bool = False,
) -> CheckReport:
    """Combine the reports of all submissions.

    Args:
        scenario: id of the scenario.
        title: its title.
        sandbox: ``auto``, ``strict`` or ``off``.
        files: of each submission that was checked.
        left_out: what was not looked at.
        interrupted: whether the check was interrupted.
    """
    counts = {level: sum(file.level == level for file in files) for level in RANKS}
    return CheckReport(
        check=REPORT_VERSION,
        scenario=scenario,
        title=title,
        sandbox=sandbox,
        level="unchecked" if interrupted else most_serious(file.level for file in files),
        interrupted=interrupted,
        summary=Summary(files=len(files), **counts),
        files=files,
        left_out=list(left_out),
    )


def stage_report(stage: Stage) -> StageReport:
    """Return a stage as data."""
    return StageReport(
        name=stage.name,
        about=STAGES[stage.name],
        level=stage.level,
        skipped=stage.skipped,
        findings=list(stage.findings),
    )


def match_report(match: Rehearsed, replay: str, no_replay: str, outputs: dict[str, str]) -> MatchReport:
    """Return a short match as data.

    Args:
        match: what was played.
        replay: file of its replay page; empty if there is none.
        no_replay: why there is none although one was asked for.
        outputs: what programs printed, by robot, safe to show.
    """
    faults = {fault["robot"]: fault["kind"] for fault in reversed(match.faults)}
    robots = []
    for robot, activity in match.robots.items():
        wait = match.waits.get(robot)
        steps = wait.steps if wait else 0
        robots.append(
            RobotReport(
                robot=robot,
                path_m=round(activity.path_m, 3),
                turned_rad=round(activity.turned_rad, 2),
                ball_touches=activity.ball_touches,
                steps=steps,
                start_s=round(wait.started_s, 3) if wait else 0.0,
                step_mean_ms=round(1000 * wait.waited_s / max(1, steps - 1), 3) if wait else 0.0,
                step_slowest_ms=round(1000 * wait.slowest_s, 3) if wait else 0.0,
                fault=faults.get(robot, ""),
                output=outputs.get(robot, ""),
            )
        )
    return MatchReport(
        seats=list(match.seats),
        opponents={seat: sanitize(name) for seat, name in match.opponents.items()},
        score=match.result["score"],
        simulated_s=match.simulated_s,
        wall_s=round(match.wall_s, 3),
        layers=list(match.result["sandbox"].get("layers", ())),
        dropped_layers=match.result["sandbox"].get("dropped", {}),
        replay=replay,
        no_replay=no_replay,
        robots=robots,
    )


LEVEL_NAMES: dict[Level, str] = {"passed": "ok", "warning": "warning", "error": "error", "unchecked": "not checked"}
"""The levels as terminal and page show them."""


def is_single(report: CheckReport) -> bool:
    """Return whether only one submission was to be checked: it needs no table."""
    return len(report.files) == 1 and not report.interrupted


def format_finding(finding: Diagnostic) -> str:
    """Return a finding in one line: where, unless the message says so itself, and what."""
    where = str(finding.where)
    needless = not where or where in finding.message
    return finding.message if needless else f"{where}: {finding.message}"


def first_cause(stages: Sequence[Stage | StageReport], level: Level) -> str:
    """The first thing to fix, in one line; empty if everything is in order."""
    found = (finding for stage in stages for finding in stage.findings)
    first = _by_hand_first([finding for finding in found if finding.level == level != "passed"])
    return "; ".join(filter(None, (format_finding(first), first.help))) if first is not None else ""


def _by_hand_first(found: Sequence[Diagnostic]) -> Diagnostic | None:
    """Return the first finding that a repair does not put right, else the first."""
    return next((finding for finding in found if not finding.repair), found[0] if found else None)


def verdict(file: FileReport) -> str:
    """Return the verdict in one or two sentences: what follows, what --fix repairs, and what to do first."""
    errors, warnings = file.count("error"), file.count("warning")
    if file.level == "unchecked":
        whose = "a fault of the check itself" if file.our_fault else "a matter of this computer"
        known = f" What failed before ({counted(errors, 'error')}) stands." if errors else ""
        return f"Not checked: {file.blocked_by}. That is {whose} and says nothing about the team.{known}"
    warned = f", {counted(warnings, 'warning')}" if warnings else ""
    found = [one for stage in file.stages for one in stage.findings if one.level == file.level != "passed"]
    repairable = sum(finding.repair for finding in found)
    amount = "this" if repairable == len(found) else "part of this"
    fix = f"; --fix OUT.zip repairs {amount}" if repairable else ""
    if errors:
        cause = _by_hand_first(found) or found[0]
        first = f" First: {cause.help or cause.message}"
        return f"It cannot play like this: {counted(errors, 'error')}{warned}{fix}.{first}"
    if any(stage.skipped for stage in file.stages):
        return f"In order as far as it was checked{warned}{fix}."
    return f"It will play{warned}{fix}."


def no_replay(match: MatchReport) -> str:
    """Return why a replay is missing, as a sentence."""
    return f"The replay could not be written on this computer: {match.no_replay}."


def summary(report: CheckReport) -> str:
    """The number of submissions that passed, as a sentence."""
    counts = report.summary
    parts = [f"{counts.passed} ok", counted(counts.warning, "warning"), counted(counts.error, "error")]
    if counts.unchecked:
        parts.append(f"{counts.unchecked} not checked")
    if report.lost_replays:
        parts.append(f"{counted(report.lost_replays, 'replay')} not written")
    if report.left_out:
        parts.append(f"{len(report.left_out)} not looked at")
    interrupted = "interrupted, " if report.interrupted else ""
    return f"{interrupted}{counted(counts.files, 'submission')}: {', '.join(parts)}"
