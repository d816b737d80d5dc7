"""Stage *play*: a short match on each side against a sample team, and whether the robots take part in it."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from typing import Any

from rcj_challenges.checker import codes
from rcj_challenges.checker.advice.devices import MAX_COMPLAINTS, complaints_in
from rcj_challenges.checker.advice.hints import standing_help
from rcj_challenges.checker.faults import MissingDevices, device_findings, fault_findings, missing_by_device
from rcj_challenges.checker.findings import Stage
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed, late_from_ticks, rehearse
from rcj_challenges.core.amounts import number_words
from rcj_challenges.core.code import Level
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.sanitize import sanitize, sanitize_block
from rcj_challenges.core.timing import s_from_ticks, ticks_from_s
from rcj_challenges.match.observers import ProgramTimes
from rcj_challenges.scenario.halves import longest_half_s
from rcj_challenges.scenario.load import Loaded

_STANDS_M = 0.02  # the suspension of a braked robot settles by less
_STANDS_RAD = 0.2
_ABSENT_SHARE = 0.05  # a program that steps 640 ms at a time takes part in as many ticks
_SLOW_SHARE = 0.5
_TOO_SLOW_SHARE = 2.0  # this computer may be slower than the tournament's, and is busy with other things
_MUCH_SHARE = 0.5
_TOO_MUCH_SHARE = 2.0  # it would be ended before the middle of a half; for less, ten seconds are too short
# What Python itself writes when a thread beside the one that steps ends by an error.
_THREAD_ENDED = re.compile(
    r"^Exception in thread .+:\n(?P<report>Traceback \(most recent call last\):\n(?:[ \t].*\n)*(?P<error>\S.*))",
    re.MULTILINE,
)


def check_play(rehearsal: Rehearsal, seconds: float, known: Collection[str] = ()) -> tuple[Stage, list[Rehearsed]]:
    """Play on each side that the team can take; return the findings on its robots, and the matches.

    Args:
        rehearsal: what is to be played.
        seconds: how long, on each side.
        known: missing devices that the stage *start* reported, as in `MissingDevices`.

    Raises:
        RcjError: it cannot be played for a reason that is not the team's.
    """
    stage, matches = Stage("play"), []
    seats = rehearsal.seats()
    for seat in seats:
        side = f"as {seat}, " if len(seats) > 1 else ""
        match = rehearse(rehearsal, (seat,), seconds)
        if _slow(rehearsal, match, side) and not match.faults:
            # The computer was perhaps busy: the shorter times of two rehearsals count.
            match.waits.update(_shorter(match.waits, rehearse(rehearsal, (seat,), seconds).waits))
        matches.append(match)
        missing = {found: robots for found, robots in missing_by_device(match).items() if found not in known}
        stage.findings += _findings(rehearsal, match, side, missing)
    return stage, matches


def _findings(rehearsal: Rehearsal, match: Rehearsed, side: str, missing: MissingDevices) -> list[Diagnostic]:
    """Return all findings: fatal ones after their possible causes and before hints at likely mistakes."""
    absent = _rarely_stepping(match)
    return [
        *device_findings("play", missing, rehearsal, side),
        *fault_findings("play", rehearsal, match, side),
        *_prints_much(rehearsal, match, side),
        *_rare_step_findings(match, absent, side),
        *_standing(rehearsal, match, absent, side),
        *_away_from_ball(rehearsal, match, side),
        *_slow(rehearsal, match, side),
        *_threads(match, side),
        *_complaints(match, side),
        _summary(match, side),
    ]


def _rarely_stepping(match: Rehearsed) -> dict[str, int]:
    """Return the robots whose programs did not fail, but called ``step`` very rarely, and how often they did."""
    failed = {fault["robot"] for fault in match.faults}
    least = _ABSENT_SHARE * ticks_from_s(match.simulated_s)
    return {robot: wait.steps for robot, wait in match.waits.items() if robot not in failed and wait.steps < least}


def _rare_step_findings(match: Rehearsed, absent: Mapping[str, int], side: str) -> list[Diagnostic]:
    if not absent:
        return []
    ticks = ticks_from_s(match.simulated_s)
    message = f"{side}took part in {min(absent.values())} of {ticks} ticks; it slept or waited through the rest"
    help_ = (
        "look for time.sleep, a wait, or a step of many seconds: meanwhile the motors keep their last speeds, and "
        "the robot sees nothing; in a loop call robot.step(32) instead, and compare robot.getTime()"
    )
    return [Diagnostic(codes.PLAY_ABSENT, message, help_, ", ".join(absent))]


def _standing(rehearsal: Rehearsal, match: Rehearsed, absent: Collection[str], side: str) -> list[Diagnostic]:
    """Return a warning for each program whose robots did not move: without those that failed or were absent."""
    known = {*absent, *(fault["robot"] for fault in match.faults)}
    standing = grouped(  # by program
        (rehearsal.team.entries[robot], robot)
        for robot, one in match.robots.items()
        if one.path_m < _STANDS_M and one.turned_rad < _STANDS_RAD and robot not in known
    )
    message = f"{side}did not move in {match.simulated_s:.0f} s"
    helps = {entry: standing_help(rehearsal.scenario, rehearsal.team, robots[0]) for entry, robots in standing.items()}
    return [
        Diagnostic(codes.PLAY_STANDS, message, helps[entry], ", ".join(robots)) for entry, robots in standing.items()
    ]


def _away_from_ball(rehearsal: Rehearsal, match: Rehearsed, side: str) -> list[Diagnostic]:
    if not _is_about_a_ball(rehearsal.loaded) or any(activity.ball_touches for activity in match.robots.values()):
        return []
    message = f"{side}no robot touched the ball in {match.simulated_s:.0f} s"
    help_ = "do they find it? Watch the replay (--replay DIR)"
    return [Diagnostic(codes.PLAY_NO_TOUCH, message, help_, ", ".join(match.robots))]


def _is_about_a_ball(loaded: Loaded) -> bool:
    """Return whether any rule mentions a ball: in a race through gates it may stay untouched."""
    balls = {*loaded.scenario.balls, "balls"}
    balls |= {group for group, members in loaded.roster.groups.items() if balls.intersection(members)}
    return any(word in balls for part in ("rules", "sequences") for word in _words(loaded.resolved.get(part)))


def _words(data: Any) -> Iterator[str]:
    if isinstance(data, dict | list):
        for value in data.values() if isinstance(data, dict) else data:
            yield from _words(value)
    elif isinstance(data, str):
        yield data


def _slow(rehearsal: Rehearsal, match: Rehearsed, side: str) -> list[Diagnostic]:
    """Compare the time that programs took with what a half and a step allow."""
    scenario = rehearsal.loaded.scenario
    limits, half_s = scenario.limits, longest_half_s(scenario.match)
    half_ticks = ticks_from_s(half_s)
    findings = []
    for robot, wait in match.waits.items():
        share = match.simulated_s / half_s
        whole_s = wait.waited_s / share if share else 0.0
        mean_ms = 1000 * limits.half_s / half_ticks
        if whole_s > _SLOW_SHARE * limits.half_s and half_ticks:
            message = (
                f"{side}uses {wait.waited_s:.1f} s in {match.simulated_s:.0f} s of play, "
                f"that is {whole_s:.0f} s in a half; {limits.half_s:g} s are allowed"
            )
            level: Level = "error" if whole_s > _TOO_SLOW_SHARE * limits.half_s else "warning"
            help_ = f"do less in each step: {mean_ms:.1f} ms for each tick of 32 ms is the limit in the long run"
            findings.append(Diagnostic(codes.PLAY_SLOW, message, help_, robot, level=level))
        elif wait.slowest_s > _SLOW_SHARE * limits.step_s:
            message = f"{side}the slowest step takes {wait.slowest_s:.1f} s; {limits.step_s:g} s are allowed"
            findings.append(Diagnostic(codes.PLAY_SLOW_STEP, message, "spread long work over many steps", robot))
    return findings


def _shorter(first: Mapping[str, ProgramTimes], second: Mapping[str, ProgramTimes]) -> dict[str, ProgramTimes]:
    """Return the shorter waits of two rehearsals of one match, by robot."""
    return {
        robot: replace(
            wait,
            waited_s=min(wait.waited_s, second[robot].waited_s),
            slowest_s=min(wait.slowest_s, second[robot].slowest_s),
        )
        for robot, wait in first.items()
        if robot in second
    }


def _prints_much(rehearsal: Rehearsal, match: Rehearsed, side: str) -> list[Diagnostic]:
    """Compare what programs printed, scaled up to a half, with what they may print."""
    half_s, limit_mb = longest_half_s(rehearsal.loaded.scenario.match), rehearsal.loaded.scenario.limits.output_mb
    failed = {fault["robot"] for fault in match.faults}
    late_s = match.simulated_s - s_from_ticks(late_from_ticks(match.simulated_s))
    near_mb = {
        robot: whole_mb
        for robot, activity in match.robots.items()
        if robot not in failed
        and late_s > 0
        and (whole_mb := (activity.printed_bytes + activity.late_bytes * (half_s - match.simulated_s) / late_s) / 1e6)
        > _MUCH_SHARE * limit_mb
    }
    if not near_mb:
        return []
    most_mb, robot = max((whole_mb, robot) for robot, whole_mb in near_mb.items())
    message = (
        f"{side}prints {match.robots[robot].printed_bytes / 1e6:.1f} MB in {match.simulated_s:.1f} s of play, "
        f"that is about {most_mb:.0f} MB in a half; {limit_mb:g} MB are allowed"
    )
    if most_mb > limit_mb:
        message += ": it would be ended (output_flood)"
    level: Level = "error" if most_mb > _TOO_MUCH_SHARE * limit_mb else "warning"
    of_level = (name for name, mb in near_mb.items() if level == "warning" or mb > _TOO_MUCH_SHARE * limit_mb)
    help_ = "print less: only what changes, or in every 30th step"
    return [Diagnostic(codes.PLAY_PRINTS_MUCH, message, help_, ", ".join(of_level), level=level)]


def _threads(match: Rehearsed, side: str) -> list[Diagnostic]:
    """Return the errors that ended threads of a program that goes on."""
    ended: dict[str, tuple[str, list[str]]] = {}
    for robot in match.robots:
        for found in _THREAD_ENDED.finditer(match.log(robot)):
            _, robots = ended.setdefault(found["error"], (found["report"], []))
            if robot not in robots:
                robots.append(robot)
    help_ = "correct the line below: the program continues without this thread, whose work is not done"
    return [
        Diagnostic(
            codes.PLAY_THREAD,
            f"{side}a thread of the program ended by an error: {sanitize(error, 300)}",
            help_,
            ", ".join(robots),
            details=sanitize_block(report),
        )
        for error, (report, robots) in list(ended.items())[:MAX_COMPLAINTS]
    ]


def _complaints(match: Rehearsed, side: str) -> list[Diagnostic]:
    """The notes of the controller module on calls of the program."""
    complaints = grouped((found, robot) for robot in match.robots for found in complaints_in(match.notes[robot]))
    return [
        Diagnostic(codes.PLAY_COMPLAINT, f"{side}{what}", help_, ", ".join(robots))
        for (what, help_), robots in list(complaints.items())[:MAX_COMPLAINTS]
    ]


def _summary(match: Rehearsed, side: str) -> Diagnostic:
    against = "".join(f" against {sanitize(name)}" for name in match.opponents.values())
    score = " : ".join(map(number_words, match.result["score"].values()))
    touches = sum(1 for activity in match.robots.values() if activity.ball_touches)
    summary = f"{side}{match.simulated_s:.0f} s played{against}, score {score}"
    if touches:
        summary += f", {touches} of {len(match.robots)} robots touched the ball"
    return Diagnostic(codes.PLAY_PLAYED, summary)
