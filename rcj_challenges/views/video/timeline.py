"""Which moments a video shows: time in seconds of play, halves, highlights."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

from rcj_challenges.facts.timing import TICK_S, s_from_ticks
from rcj_challenges.views.sentences import clock
from rcj_challenges.views.video.errors import VideoError
from rcj_challenges.views.video.footage import Footage, HalfFootage

BEFORE_GOAL_S = 6.0
AFTER_GOAL_S = 1.0
"""A highlight goes on this long after the goal, so that its caption can be read."""

_TIME = re.compile(r"(?:(\d{1,4}):(?=\d{2}(?:\.|$)))?(\d{1,6}(?:\.\d{1,6})?)", re.ASCII)


@dataclass(frozen=True)
class Clip:
    """A stretch of one half.

    Attributes:
        half: its number, from 1.
        from_s, to_s: match time in this half.
        title: shown while it lasts.
    """

    half: int
    from_s: float
    to_s: float
    title: str = ""


@dataclass(frozen=True)
class Moment:
    """What one frame shows."""

    half: HalfFootage
    t_s: float
    title: str = ""
    speed: float = 1.0


def seconds_from(text: str) -> float:
    """Return the seconds that ``113.9`` or ``1:53.9`` means.

    Raises:
        VideoError: it is neither.
    """
    found = _TIME.fullmatch(text.strip())
    minutes, seconds = (found[1], float(found[2])) if found else (None, 0.0)
    if found is None or (minutes is not None and seconds >= 60):
        raise VideoError(f"{text[:40]!r} is no time: write seconds, as 113.9, or minutes and seconds, as 1:53.9")
    return int(minutes or 0) * 60 + seconds


def moment_at(footage: Footage, at_s: float, half: int | None) -> Moment:
    """Return the moment at a time: of a half if one is given, else of all halves one after the other.

    The end of a half is reached from it: with two halves of 600 s, second 600 is the end of the first half.

    Raises:
        VideoError: the run was not played for so long, or has no such half.
    """
    halves = _chosen(footage, half)
    begin = 0.0
    for found in halves:
        if at_s <= begin + found.length_s + 1e-9:
            return Moment(found, min(at_s - begin, found.length_s))
        begin += found.length_s
    raise VideoError(f"--at {at_s:g} is beyond the end: {_length_in_words(footage, half)}")


def stretch(footage: Footage, from_s: float | None, to_s: float | None, half: int | None) -> list[Clip]:
    """Return the clips, one for each half, between two times; None: from the beginning, to the end.

    Raises:
        VideoError: a time is beyond the end, they are in the wrong order, or there is no such half.
    """
    halves = _chosen(footage, half)
    end = sum(found.length_s for found in halves)
    start_s, stop_s = from_s or 0.0, end if to_s is None else to_s
    for option, given in (("--from", start_s), ("--to", stop_s)):
        if given > end + 1e-9:
            raise VideoError(f"{option} {given:g} is beyond the end: {_length_in_words(footage, half)}")
    if stop_s - start_s < TICK_S - 1e-9:
        raise VideoError(
            f"--from {start_s:g} must be before --to {stop_s:g}, by a tick ({TICK_S} s) at least: "
            "there is nothing between them"
        )
    clips = []
    begin = 0.0
    for found in halves:
        first, last = max(start_s - begin, 0.0), min(stop_s - begin, found.length_s)
        if last - first > 1e-9:
            clips.append(Clip(found.info.half, first, last))
        begin += found.length_s
    return clips


def highlights(footage: Footage, clips: list[Clip]) -> list[Clip]:
    """Return the 6 s before and the second after each change of the score within the clips, with a title each.

    Those that overlap are joined, so that nothing is shown twice.

    Raises:
        VideoError: the score does not change in these clips.
    """
    goals = [
        (clip, tick)
        for clip in clips
        for tick in dict.fromkeys(tick for tick, _ in footage.story.score_changes.get(clip.half, ()))
        if clip.from_s <= s_from_ticks(tick) <= clip.to_s
    ]
    if not goals:
        raise VideoError("the score does not change in what is to be shown: leave --highlights out to see all of it")
    found: list[Clip] = []
    numbers: list[tuple[int, int]] = []
    names: list[set[str]] = []
    for number, (clip, tick) in enumerate(goals, 1):
        at_s = s_from_ticks(tick)
        made = Clip(clip.half, max(clip.from_s, at_s - BEFORE_GOAL_S), min(clip.to_s, at_s + AFTER_GOAL_S))
        name = _event_name(footage, clip.half, tick)
        if found and found[-1].half == made.half and made.from_s < found[-1].to_s:
            found[-1] = replace(found[-1], to_s=made.to_s)
            numbers[-1] = (numbers[-1][0], number)
            names[-1].add(name)
        else:
            found.append(made)
            numbers.append((number, number))
            names.append({name})
    return [
        replace(clip, title=_title(kinds, first, last, len(goals)))
        for clip, (first, last), kinds in zip(found, numbers, names, strict=True)
    ]


def frame_count(clips: list[Clip], fps: float, speed: float) -> int:
    """Return how many frames the clips have."""
    return sum(_frames_of(clip, fps, speed) for clip in clips)


def moments(footage: Footage, clips: list[Clip], fps: float, speed: float) -> Iterator[Moment]:
    """Yield what each frame shows: ``fps`` of them for each second of video, ``speed`` s of the match in each."""
    for clip in clips:
        half = footage.half(clip.half)
        for frame in range(_frames_of(clip, fps, speed)):
            yield Moment(half, clip.from_s + frame * speed / fps, clip.title, speed)


def _frames_of(clip: Clip, fps: float, speed: float) -> int:
    # A hair less before rounding up: 6 s at 30 a second are 180 frames, whatever floating point makes of them.
    return max(1, math.ceil((clip.to_s - clip.from_s) / speed * fps - 1e-6))


def _chosen(footage: Footage, half: int | None) -> list[HalfFootage]:
    if half is None:
        return list(footage.halves)
    found = [one for one in footage.halves if one.info.half == half]
    if not found:
        there = " and ".join(str(one.info.half) for one in footage.halves)
        raise VideoError(f"--half {half}: the run has no such half, but {there}")
    return found


def _length_in_words(footage: Footage, half: int | None) -> str:
    halves = _chosen(footage, half)
    total = sum(one.length_s for one in halves)
    if half is not None:
        return f"half {half} was recorded for {total:g} s ({clock(total)})"
    if len(halves) == 1:
        return f"the run was recorded for {total:g} s ({clock(total)})"
    parts = " + ".join(f"{one.length_s:g}" for one in halves)
    return f"the run was recorded for {parts} = {total:g} s; --half 2 counts from the beginning of a half"


def _event_name(footage: Footage, half: int, tick: int) -> str:
    names = [event["name"] for event in footage.events(half) if event["tick"] == tick and event["scored"]]
    return str(names[0]).replace("_", " ").capitalize() if names else "Score"


def _title(kinds: set[str], first: int, last: int, total: int) -> str:
    name = next(iter(kinds)) if len(kinds) == 1 else "Score"
    which = str(first) if first == last else f"{first}-{last}"
    return f"{name} {which} of {total}"
