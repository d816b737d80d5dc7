"""The ball passing machines, judged a second time by hand: within a tick first the bounds, then goals, then passes."""

import random
from dataclasses import dataclass, field
from math import dist

import pytest

from rcj_challenges.expect.scripted_match import ScriptedMatch
from rcj_challenges.scenario.load import load

TICK_OF_A_BALL_M = 0.0077  # 0.24 m/s
QUARTER_OF = {"Y1": 1, "Y2": 2, "B2": 3, "B1": 4}
CENTRES = {1: (-0.3, -0.4), 2: (0.3, -0.4), 3: (0.3, 0.4), 4: (-0.3, 0.4)}
_BY_SIGNS = {(False, False): 1, (True, False): 2, (True, True): 3, (False, True): 4}


def quarter(x: float, y: float) -> int:
    """Return the quarter of a centre, 0 in the strips between them."""
    return 0 if abs(x) <= 0.108 or abs(y) <= 0.202 else _BY_SIGNS[x > 0, y > 0]


def goal(x: float, y: float) -> str:
    """Return whose goal a centre is in, empty if in none."""
    return ("blue" if y > 0 else "yellow") if abs(x) < 0.2 and 0.745 < abs(y) < 0.849 else ""


@dataclass
class ByHand:
    """The rules of the challenge, on the positions of one tick after the other."""

    at: int = 1
    streak: int = 0
    score: int = 0
    visited: dict[str, bool] = field(default_factory=lambda: {"yellow": False, "blue": False})
    was_in: str = ""

    def judge(self, ball: tuple[float, float], robots: dict[str, tuple[float, float]]) -> list[tuple[str, dict]]:
        for name, place in robots.items():
            if quarter(*place) != QUARTER_OF[name]:
                return self._all_back("ROBOT_LEFT_QUARTER", {"robot_name": name})
        now_in = goal(*ball)
        if now_in != self.was_in and self.at == {"yellow": 1, "blue": 3}.get(now_in):
            self.visited[now_in] = True
        self.was_in = now_in
        reached = quarter(*ball)
        if reached in {0, self.at}:
            return []
        if reached != self.at % 4 + 1:
            return self._all_back("WRONG_PASS", {})
        self.at = reached
        return self._round() if reached == 1 else []

    def _round(self) -> list[tuple[str, dict]]:
        self.streak += 1
        self.score += self.streak + sum(self.visited.values())
        goals = {"blue_goal": self.visited["blue"], "yellow_goal": self.visited["yellow"]}
        self.visited = {"yellow": False, "blue": False}
        return [("SUCCESSFUL_PASS", {"added_score": self.streak, **goals})]

    def _all_back(self, event: str, payload: dict) -> list[tuple[str, dict]]:
        self.at, self.streak, self.was_in = 1, 0, ""
        self.visited = {"yellow": False, "blue": False}
        return [(event, payload)]


def next_aim(rng: random.Random, at: int) -> tuple[float, float]:
    """Return where the ball goes next: mostly on, often by way of a goal, sometimes astray."""
    kind = rng.random()
    if kind < 0.75:
        x, y = CENTRES[at % 4 + 1]
        return (x * rng.uniform(0.4, 1.5), y * rng.uniform(0.6, 1.7))
    if kind < 0.97:
        return (rng.uniform(-0.19, 0.19), rng.choice([-0.8, 0.8]))
    return (rng.uniform(-0.6, 0.6), rng.uniform(-0.7, 0.7))


def towards(here: tuple[float, float], aim: tuple[float, float], step_m: float) -> tuple[float, float]:
    """Return where the ball is after a tick on its way; beside the goals the end walls stop it."""
    share = min(1.0, step_m / max(dist(here, aim), step_m))
    x, y = (a + share * (b - a) for a, b in zip(here, aim, strict=True))
    return (x, max(-0.73, min(0.73, y)) if abs(x) > 0.2 else y)


@pytest.mark.parametrize("step_m", [TICK_OF_A_BALL_M, 0.04])
@pytest.mark.parametrize("seed", [4, 5, 9])
def test_bounds_are_judged_before_goals_and_goals_before_passes(seed, step_m):
    loaded = load("pass_the_ball")
    play, hand, rng = ScriptedMatch(loaded.scenario, loaded.roster), ByHand(), random.Random(seed)  # noqa: S311 - a walk
    starts = {name: play.pose(name)[:2] for name in loaded.roster.entities}
    aim = next_aim(rng, hand.at)
    for _ in range(3600):
        here = play.pose("ball")[:2]
        if dist(here, aim) < step_m:
            aim = next_aim(rng, hand.at)
        play.place("ball", *towards(here, aim, step_m))
        if rng.random() < 0.002:
            play.place(rng.choice(list(QUARTER_OF)), rng.uniform(-0.6, 0.6), rng.uniform(-0.7, 0.7))
        said = len(play.events)
        expected = hand.judge(play.pose("ball")[:2], {name: play.pose(name)[:2] for name in QUARTER_OF})
        play.play()
        assert [(event.name, event.payload) for event in play.events[said:]] == expected
        assert play.referee.scores["yellow"] == hand.score
        assert {colour: play.referee.flags[f"{colour}_goal_visited"] for colour in hand.visited} == hand.visited
        if expected and expected[0][0] != "SUCCESSFUL_PASS":
            assert {name: play.pose(name)[:2] for name in starts} == starts
            aim = next_aim(rng, hand.at)
    assert hand.score > 0
