"""Counts the record of one run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.records.referee_log import score_so_far
from rcj_challenges.records.reflog import PROGRAM_FAULT
from rcj_challenges.records.run_record import RunRecord, read_run
from rcj_challenges.records.trajectory import HalfTrack
from rcj_challenges.scenario.halves import teams_by_seat
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.naming import titles
from rcj_challenges.views.stats.ends import attacked_ends, goal_widths, own_end
from rcj_challenges.views.stats.motion import Motion, motion_of, play_mask
from rcj_challenges.views.stats.tally import Stats, Tally, TeamTally
from rcj_challenges.views.stats.touches import Goals, contacts_of, owners, shots_of, touch_ends
from rcj_challenges.views.timeline import POINTS, TimelineEvent, timeline_of

NO_CALLS = frozenset({"MATCH_START", "MATCH_FINISH", "KICKOFF", PROGRAM_FAULT, POINTS})
"""Events that are not calls of the referee; an event that scores is not one either."""


def run_stats(folder: Path, run: RunRecord | None = None) -> Stats:
    """Return the sums of one run: finished, going on, killed or damaged.

    Raises:
        RecordError: there is nothing in the folder that could be counted.
    """
    run = run or read_run(folder)
    notes = [*run.problems]
    if not run.log.ticks and not run.log.damaged_lines:
        notes.append("The referee's log is missing: no calls are counted, and what awaits a kick-off counts as play.")
    stats = Stats(runs=[folder.name], notes=[f"{folder.name}: {note}" for note in notes])
    counting = _RunCounter(run, stats)
    # Of a run that was killed the log goes on for longer than the poses: the figures end with these.
    log = run.log.up_to({half.info.half: half.ticks for half in run.halves})
    timeline = timeline_of(run.scenario, run.halves, log)
    for half in run.halves:
        counting.half(half, play_mask(half.ticks, timeline.halves[half.info.half].changes["phases"]))
    for event in timeline.events:
        counting.call(event)
    for fault in run.result.faults:
        counting.robot(fault.half, fault.robot).faults[fault.kind] += 1
    names = titles(run.scenario, run.result)
    if names != {team: entrant.name or team for team, entrant in run.result.entrants.items()}:
        stats.notes.append(f"{folder.name}: teams of one name played each other; their seats tell them apart")
    points = score_so_far(run.result, run.scenario, log)
    for team, entrant in run.result.entrants.items():
        tally = stats.teams.setdefault(names[team], TeamTally())
        tally.points += points.get(team, 0)
        tally.runs += 1
        tally.programs.add(entrant.programs)
    return stats


class _RunCounter:
    def __init__(self, run: RunRecord, stats: Stats) -> None:
        self._stats = stats
        self._scenario = run.scenario
        self._roster = Roster.of(run.scenario)
        self._ends = attacked_ends(run.scenario, self._roster)
        self._sides = {half.info.half: half.info.teams for half in run.halves}
        self._seat_of = {robot: seat for seat, entrant in run.scenario.entrants.items() for robot in entrant.robots}
        self._labels = _labels(run)
        self._names = titles(run.scenario, run.result)
        widths = goal_widths(run.scenario.field)
        field = run.scenario.field
        self._goals = Goals(field.length_m / 2, field.width_m / 2 - field.corner_cut_m, widths)
        stats.has_goals = bool(widths) and any(self._ends.values())

    def robot(self, half: int, name: str) -> Tally:
        """Return the tally of a robot in a half, by its team."""
        seat = self._seat_of.get(name)
        team = self._sides.get(half, {}).get(seat or "", seat or "")
        if seat is None or team not in self._names:  # an obstacle that looks like a robot
            return Tally()
        robots = self._stats.teams.setdefault(self._names[team], TeamTally()).robots
        return robots.setdefault(self._labels.get((team, name), name), Tally())

    def half(self, half: HalfTrack, play: Any) -> None:
        """Add a half; ``play`` is the result of `play_mask`."""
        self._stats.ticks += half.ticks
        play_ticks = int(play.sum())
        ball_ticks = play_ticks * self._roster.balls
        self._stats.play_ticks += play_ticks
        motion = motion_of(half)
        number = half.info.half
        for team in filter(self._names.__contains__, dict.fromkeys(half.info.teams.values())):
            self._stats.teams.setdefault(self._names[team], TeamTally()).ball_ticks += ball_ticks
        names = self._roster.entities
        for index in range(self._roster.robots):
            tally = self.robot(number, names[index])
            tally.ball_ticks += ball_ticks
            own = own_end(self._ends.get(self._seat_of.get(names[index], ""), frozenset()))
            _add_motion(tally, motion, play, index, own)
        for index in range(self._roster.robots, self._roster.robots + self._roster.balls):
            _add_motion(self._stats.balls.setdefault(names[index], Tally()), motion, play, index)
        self._add_balls(half, motion, play)

    def _add_balls(self, half: HalfTrack, motion: Motion, play: Any) -> None:
        roster, number = self._roster, half.info.half
        seats = [self._seat_of.get(name) for name in roster.entities[: roster.robots]]
        ends = {robot: self._ends.get(seat, frozenset()) for robot, seat in enumerate(seats) if seat is not None}
        for ball in range(roster.robots, roster.robots + roster.balls):
            contacts = contacts_of(half, roster.robots, ball)
            placed_at = [tick for tick, placed in half.placements.items() if any(p.entity == ball for p in placed)]
            owner = owners(contacts, seats, half.ticks, placed_at)
            shots = shots_of(contacts, motion.places[:, ball], placed_at, ends, self._goals)
            for robot in ends:
                tally = self.robot(number, roster.entities[robot])
                tally.owned_ticks += int((play & (owner == robot)).sum())
                tally.touches += _in_play(touch_ends(contacts, robot), play)
                tally.shots += _in_play([shot.tick for shot in shots if shot.robot == robot], play)
                tally.on_goal += _in_play([shot.tick for shot in shots if shot.robot == robot and shot.on_goal], play)

    def call(self, event: TimelineEvent) -> None:
        """Add an event, if it is a call of the referee."""
        if event.name in NO_CALLS or event.scored:
            return
        named = event.payload.get("robot_name") or (event.cause.entity if event.cause is not None else None)
        known = isinstance(named, str) and named in self._seat_of
        calls = self.robot(event.half, str(named)).calls if known else self._stats.calls
        calls[event.name] += 1


def _add_motion(tally: Tally, motion: Motion, play: Any, index: int, own: int | None = None) -> None:
    """Add the motion of an entity; ``own`` is the end that its team defends, None: both or none."""
    counted = play & motion.on_field[:, index]
    tally.field_ticks += int(counted.sum())
    tally.distance_m += float(motion.steps_m[counted, index].sum())
    if counted.any():
        tally.fastest_mps = max(tally.fastest_mps, float(np.max(motion.steps_m[counted, index])) / TICK_S)
    if own is not None:
        tally.sided_ticks += int(counted.sum())
        tally.own_half_ticks += int((counted & (own * motion.places[:, index, 1] > 0)).sum())


def _in_play(ticks: list[int], play: Any) -> int:
    return sum(bool(play[tick - 1]) for tick in ticks)


def _labels(run: RunRecord) -> dict[tuple[str, str], str]:
    """Return by team and robot what the robot is called: all names that its program had in the run, ``B1/Y1``.

    The n-th robot of a seat and the n-th of the seat that the team changes to are one, if the same program drives them.
    """
    entrants = run.scenario.entrants
    labels = {(seat, name): name for seat, entrant in entrants.items() for name in entrant.robots}
    for seat, other in teams_by_seat(run.scenario, min(2, run.scenario.match.halves)).items():
        pairs = zip(entrants[seat].robots.items(), entrants[other].robots.items(), strict=False)
        for (name, program), (twin, other_program) in pairs if seat != other else ():
            if program == other_program:
                labels[seat, name] = labels[seat, twin] = f"{name}/{twin}"
    return labels
