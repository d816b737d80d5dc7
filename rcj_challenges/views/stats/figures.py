"""Figures, computed from sums, and their definitions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.tracking.contacts import APART_S
from rcj_challenges.views.stats.tally import Stats, Tally, TeamTally
from rcj_challenges.views.stats.touches import FREE_TICKS, SHOT_WITHIN_S


@dataclass(frozen=True)
class Definition:
    """What a figure is: the title above its column, its unit (empty for counts), and the definition."""

    title: str
    unit: str
    text: str


_PLAY = "Only ticks of play count: those without waiting for a kick-off."

DEFINITIONS: dict[str, Definition] = {
    "possession": Definition(
        "possession",
        "%",
        "Share of play in which the robot or team was the last to have touched the ball; with several balls, "
        "their mean. "
        f"{_PLAY} After a ball is placed elsewhere, no robot has it until the next touch; if two teams touch "
        f"it at once, possession does not change. Over several runs, only those count in which the robot or "
        f"team played.",
    ),
    "distance_m": Definition(
        "distance",
        "m",
        "Sum of the distances between the judged positions of the centre, tick by tick (0.032 s), in play and on the "
        "field. Placements add no distance.",
    ),
    "mean_mps": Definition("average speed", "m/s", "The distance divided by the time of play on the field."),
    "max_mps": Definition("top speed", "m/s", "The greatest distance in one tick of play divided by 0.032 s."),
    "touches": Definition(
        "touches",
        "",
        f"Times the robot touched a ball in play; contacts less than {APART_S:g} s apart are one touch.",
    ),
    "shots": Definition(
        "shots",
        "",
        "Touches after which the ball, rolling straight on, would cross the goal line at the attacked end (the whole "
        f"end line without the corner walls) within {SHOT_WITHIN_S:g} s. Its velocity is measured over the second tick "
        f"after the touch; no robot may touch it in these {FREE_TICKS} ticks. No deceleration is assumed: a rolling "
        "ball loses 0.1 % of its speed per metre. The last touch before a ball entered the attacked goal is a shot "
        "on goal, however long the ball took.",
    ),
    "on_goal": Definition(
        "on goal", "", "Those shots that would cross the line between the posts (the ball's centre)."
    ),
    "own_half": Definition(
        "own half",
        "%",
        "Share of play on the field in which the robot's centre was in the half of the goal that its team defends: the "
        "end opposite to the one where it scores.",
    ),
    "faults": Definition(
        "faults", "", "Failures of the program: crash, time limit and so on; its robot then stands still."
    ),
    "calls": Definition(
        "referee calls", "", "Events about the robot other than goals, kick-offs, start and finish, by name."
    ),
}
"""By the key in JSON, in the order of the table."""


def figure_keys(stats: Stats) -> list[str]:
    """Return the figures that make sense here.

    Touches need a ball, possession two teams as well; shots need a ball and goals, halves need sides.
    """
    left_out = set()
    if len(stats.teams) < 2 or not stats.balls:
        left_out.add("possession")
    if not stats.balls:
        left_out.add("touches")
    if not (stats.balls and stats.has_goals):
        left_out |= {"shots", "on_goal"}
    if not any(team.total.sided_ticks for team in stats.teams.values()):
        left_out.add("own_half")
    return [key for key in DEFINITIONS if key not in left_out]


def figures(tally: Tally, stats: Stats) -> dict[str, Any]:
    """Return the figures of a robot, or of all robots of a team together, by the keys of `DEFINITIONS`.

    Shares are in per cent; a share or a mean of nothing is None.
    """
    time_s = tally.field_ticks * TICK_S
    found: dict[str, Any] = {
        "possession": _percent(tally.owned_ticks, tally.ball_ticks),
        "distance_m": round(tally.distance_m, 2),
        "mean_mps": round(tally.distance_m / time_s, 3) if time_s else None,
        "max_mps": round(tally.fastest_mps, 3) if time_s else None,
        "touches": tally.touches,
        "shots": tally.shots,
        "on_goal": tally.on_goal,
        "own_half": _percent(tally.own_half_ticks, tally.sided_ticks),
        "faults": dict(sorted(tally.faults.items())),
        "calls": dict(sorted(tally.calls.items())),
    }
    return {key: found[key] for key in figure_keys(stats)}


def stats_as_json(stats: Stats) -> dict[str, Any]:
    """Return everything as JSON-able data, the definitions included."""
    keys = figure_keys(stats)
    return {
        "runs": stats.runs,
        "simulated_s": round(stats.ticks * TICK_S, 3),
        "play_s": round(stats.play_ticks * TICK_S, 3),
        "teams": {name: _team(team, stats) for name, team in stats.teams.items()},
        "balls": {
            name: {key: figures(ball, stats)[key] for key in ("distance_m", "mean_mps", "max_mps")}
            for name, ball in stats.balls.items()
        },
        "other_calls": dict(sorted(stats.calls.items())),
        "definitions": {key: {"unit": DEFINITIONS[key].unit, "text": DEFINITIONS[key].text} for key in keys},
        "notes": stats.notes,
    }


def _team(team: TeamTally, stats: Stats) -> dict[str, Any]:
    return {
        "runs": team.runs,
        "points": team.points,
        **figures(team.total, stats),
        "robots": {label: figures(tally, stats) for label, tally in sorted(team.robots.items())},
    }


def _percent(part: int, whole: int) -> float | None:
    return round(100 * part / whole, 1) if whole else None
