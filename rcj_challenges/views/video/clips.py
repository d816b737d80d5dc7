"""Which moments a video shows: seconds of play, halves, highlights."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace

from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.timing import TICK_S, s_from_ticks
from rcj_challenges.views.codes import BAD_TIME, EMPTY_CLIP, NO_HIGHLIGHTS, NO_SUCH_HALF, TIME_NOT_PLAYED
from rcj_challenges.views.sentences import clock
from rcj_challenges.views.video.footage import Footage, HalfFootage

BEFORE_GOAL_S = 6.0
AFTER_GOAL_S = 1.0
"""A highlight goes on this long after the goal, so that its caption can be read."""

_TIME = re.compile(r"(?:(\d{1,4}):(?=\d{2}(?:\.|$)))?(\d{1,6}(?:\.\d{1,6})?)", re.ASCII)


@dataclass(frozen=True)
class Clip:
    """A part of one half, between two match times of it."""

    half: int
    from_s: float
    to_s: float


@dataclass(frozen=True)
class Moment:
    """What one frame shows."""

    half: HalfFootage
    t_s: float
    speed: float = 1.0


def parse_seconds(text: str) -> float:
    """Parse ``113.9`` or ``1:53.9`` as seconds.

    Raises:
        RcjError: it is neither.
    """
    match = _TIME.fullmatch(text.strip())
    if match is None or (match[1] is not None and float(match[2]) >= 60):
        raise RcjError(
            f"{text[:40]!r} is not a time",
            "write seconds, such as 113.9, or minutes and seconds, such as 1:53.9",
            code=BAD_TIME,
        )
    return int(match[1] or 0) * 60 + float(match[2])


def moment_at(footage: Footage, at_s: float, half: int | None) -> Moment:
    """Return the moment at a time, of a half if one is given, else counted over all halves.

    The end of a half is reached from it: with two halves of 600 s, second 600 is the end of the first half.

    Raises:
        RcjError: the time was not played, or there is no such half.
    """
    halves = _chosen(footage, half)
    begin_s = 0.0
    for one in halves:
        if at_s <= begin_s + one.length_s + 1e-9:
            return Moment(one, min(at_s - begin_s, one.length_s))
        begin_s += one.length_s
    raise _beyond("--at", at_s, halves)


def clips_between(footage: Footage, from_s: float | None, to_s: float | None, half: int | None) -> list[Clip]:
    """Return the clips, one for each half, between two times; None is the beginning, or the end.

    Raises:
        RcjError: a time was not played, the times are in the wrong order, or there is no such half.
    """
    halves = _chosen(footage, half)
    end_s = sum(one.length_s for one in halves)
    start_s, stop_s = from_s or 0.0, end_s if to_s is None else to_s
    for option, time_s in (("--from", start_s), ("--to", stop_s)):
        if time_s > end_s + 1e-9:
            raise _beyond(option, time_s, halves)
    if stop_s - start_s < TICK_S - 1e-9:
        raise RcjError(f"--from {start_s:g} must be before --to {stop_s:g} by at least {TICK_S} s", code=EMPTY_CLIP)
    clips = []
    begin_s = 0.0
    for one in halves:
        first_s, last_s = max(start_s - begin_s, 0.0), min(stop_s - begin_s, one.length_s)
        if last_s - first_s > 1e-9:
            clips.append(Clip(one.info.half, first_s, last_s))
        begin_s += one.length_s
    return clips


def highlights(footage: Footage, clips: list[Clip]) -> list[Clip]:
    """Return the 6 s before and the second after each change of the score within the clips; overlaps are joined.

    Raises:
        RcjError: the score does not change in these clips.
    """
    found: list[Clip] = []
    for clip in clips:
        for tick in dict.fromkeys(tick for tick, _ in footage.timeline.halves[clip.half].changes["score_changes"]):
            at_s = s_from_ticks(tick)
            if not clip.from_s <= at_s <= clip.to_s:
                continue
            new = Clip(clip.half, max(clip.from_s, at_s - BEFORE_GOAL_S), min(clip.to_s, at_s + AFTER_GOAL_S))
            if found and found[-1].half == new.half and new.from_s < found[-1].to_s:
                new = replace(new, from_s=found.pop().from_s)
            found.append(new)
    if not found:
        raise RcjError(
            "the score does not change in this part of the run", "leave --highlights out", code=NO_HIGHLIGHTS
        )
    return found


def moments(footage: Footage, clips: list[Clip], fps: float, speed: float) -> list[Moment]:
    """Return the content of each frame: ``fps`` frames for each second of video, ``speed`` s of the match in each."""
    return [
        Moment(footage.half(clip.half), clip.from_s + frame * speed / fps, speed)
        for clip in clips
        # The small amount absorbs rounding: 6 s at 30 a second are 180 frames.
        for frame in range(max(1, math.ceil((clip.to_s - clip.from_s) / speed * fps - 1e-6)))
    ]


def _chosen(footage: Footage, half: int | None) -> list[HalfFootage]:
    found = [one for one in footage.halves if half in (None, one.info.half)]
    if not found:
        halves = " and ".join(str(one.info.half) for one in footage.halves)
        period = footage.scenario.match.period
        raise RcjError(f"--half {half}: this run has {period} {halves}", code=NO_SUCH_HALF)
    return found


def _beyond(option: str, time_s: float, halves: list[HalfFootage]) -> RcjError:
    parts = " + ".join(f"{one.length_s:g} s of half {one.info.half}" for one in halves)
    total_s = sum(one.length_s for one in halves)
    return RcjError(
        f"{option} {time_s:g} is after the end of the recording: {parts} ({clock(total_s)})",
        "times count over all halves; with --half N they count from the beginning of that half",
        code=TIME_NOT_PLAYED,
    )
