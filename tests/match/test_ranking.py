"""Who wins: by the values of the scenario, over the halves as they say; later ones break ties."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.referee.carry_over import CarryOver
from rcj_challenges.referee.engine import Referee
from rcj_challenges.scenario.halves import by_seat
from rcj_challenges.scenario.load import load_text

HEAD = """schema_version: 2
id: it
title: It
extends: soccersim_v2
match: {halves: 3, swap_sides: true}
counters:
  fouls: {per: robots}
  run_s: {per: entrants, initial: none}
  laps: {per: entrants}
  weight: {per: entrants}
  kept: {per: entrants, keep: match}
  of_robots: {per: robots, keep: match}
  shared: {keep: match}
  of_two: {per: two}
groups: {two: [B1, B2]}
rules: {}
result: {rank: [%s]}
"""
SWIMMING = "{counter: run_s, otherwise: 60, over: best, better: less, says: The faster of the two heats counts.}"
FOULS = "{sum: {counter: fouls, entity: each}, better: less, says: F}"


def rank_of(value, better="more", over="sum"):
    return f"{{{value}, better: {better}, over: {over}, says: It.}}"


def after(rank, *halves):
    """Return places and values by team after halves that change counters and scores, by their seats, as they say."""
    loaded = load_text(HEAD % rank)
    carry_over = CarryOver(loaded.scenario)
    for number, changes in enumerate(halves, 1):
        half = half_of(loaded.scenario, number)
        half = replace(half, scores=by_seat(carry_over.scores, half.teams), kept=carry_over.kept)
        referee = Referee(loaded.scenario, loaded.roster, half)
        for name, change in changes.items():
            if name == "score":
                referee.scores.update({seat: referee.scores[seat] + by for seat, by in change.items()})
            elif isinstance(change, dict):
                referee.counters[name].update(change)
            else:
                referee.counters[name] = change
        carry_over.add(half, referee)
    return {one["team"]: (one["place"], one["values"]) for one in carry_over.ranking()}


# In the second half the team blue sits in yellow.
@pytest.mark.parametrize(
    ("rank", "halves", "ranked"),
    [
        pytest.param(
            "{score: each, better: more}",
            [{"score": {"blue": 1}}, {"score": {"blue": 3}}],
            {"yellow": (1, [3]), "blue": (2, [1])},
            id="points are those of the team",
        ),
        pytest.param(
            f"{{score: each, better: more}}, {FOULS}",
            [{"score": {"blue": 1, "yellow": 1}, "fouls": {"B1": 1, "Y1": 3}}, {"fouls": {"Y2": 1}}],
            {"blue": (1, [1, 2]), "yellow": (2, [1, 3])},
            id="a counter per robot breaks the tie, for the team that has the robots",
        ),
        pytest.param(
            "{score: each, better: less}", [{}], {"blue": (1, [0]), "yellow": (1, [0])}, id="ties share a place"
        ),
        pytest.param(
            SWIMMING,
            [{"run_s": {"blue": 50, "yellow": 20}}, {"run_s": {"yellow": 15}}],
            {"blue": (1, [15]), "yellow": (2, [20])},
            id="the faster of two heats; who does not arrive has 60 s",
        ),
        pytest.param(
            rank_of("counter: run_s", "less"),
            [{"run_s": {"blue": 9, "yellow": 9}}, {"run_s": {"blue": 1}}],
            {"yellow": (1, [10]), "blue": (2, [None])},
            id="a sum with a half that has no value is none, and ranks last",
        ),
        pytest.param(
            rank_of("counter: run_s", "more"),
            [{}],
            {"blue": (1, [None]), "yellow": (1, [None])},
            id="without a value all share a place",
        ),
        pytest.param(
            rank_of("counter: run_s", "more", "best"),
            [{"run_s": {"blue": -9}}, {}],
            {"blue": (1, [-9]), "yellow": (2, [None])},
            id="none is worse than the lowest number",
        ),
        pytest.param(
            rank_of("counter: run_s", "less", "worst"),
            [{"run_s": {"blue": 9, "yellow": 2}}, {"run_s": {"blue": 3}}],
            {"yellow": (1, [3]), "blue": (2, [None])},
            id="and it is the worst of the halves",
        ),
        pytest.param(
            rank_of("counter: laps, times: {counter: weight}"),
            [{"laps": {"blue": 3, "yellow": 4}, "weight": {"blue": 1.5, "yellow": 1}}],
            {"blue": (1, [4.5]), "yellow": (2, [4])},
            id="laps times weight",
        ),
        pytest.param(
            rank_of("sum: {counter: laps, entity: others}", "less"),
            [{"laps": {"blue": 3, "yellow": 4}}],
            {"yellow": (1, [3]), "blue": (2, [4])},
            id="what the others have",
        ),
        pytest.param(
            ", ".join(rank_of(f"counter: {name}") for name in ("kept", "shared")),
            [{"kept": {"blue": 2}, "shared": 5}, {"kept": {"yellow": 7, "blue": 1}, "shared": 6}],
            {"blue": (1, [7, 6]), "yellow": (2, [1, 6])},
            id="a kept counter counts once, though it goes on",
        ),
        pytest.param(
            ", ".join([rank_of("counter: kept", over="best"), rank_of("counter: kept", over="last")]),
            [{"kept": {"blue": 5}}, {"kept": {"yellow": 8}}, {}],
            {"blue": (1, [5, 8]), "yellow": (2, [0, 0])},
            id="of a kept counter the best half is that which added most, the last value is the total",
        ),
        pytest.param(
            rank_of("sum: {counter: of_robots, entity: each}"),
            [{"of_robots": {"B1": 7}}, {"of_robots": {"B1": 8, "Y1": 2}}],
            {"blue": (1, [9]), "yellow": (2, [1])},
            id="what a robot has added in a half is of the team that had it",
        ),
        pytest.param(
            rank_of("sum: {counter: of_two, entity: each}"),
            [{"of_two": {"B1": 1, "B2": 2}}],
            {"blue": (1, [3]), "yellow": (2, [0])},
            id="of a team those robots that have a counter",
        ),
        pytest.param(
            rank_of("counter: laps, times: 0.1, plus: {sum: {counter: fouls, entity: each}, times: 0.3}"),
            [{"laps": {"blue": 3}, "fouls": {"Y1": 1}}],
            {"blue": (1, [0.3]), "yellow": (1, [0.3])},
            id="what is equal on paper shares a place, though as floats 3 * 0.1 > 0.3",
        ),
        pytest.param(
            ", ".join([rank_of("score: each, since: half", over="best"), rank_of("score: each, times: 2")]),
            [{"score": {"blue": 4}}, {"score": {"yellow": 3, "blue": 5}}],
            {"yellow": (1, [5, 10]), "blue": (2, [4, 14])},
            id="the best half, and twice the score",
        ),
    ],
)
def test_teams_are_ranked_by_values(rank, halves, ranked):
    assert after(rank, *halves) == ranked


SEATS = st.fixed_dictionaries({"blue": st.integers(-3, 3), "yellow": st.integers(-3, 3)})
HALF = st.fixed_dictionaries({"score": SEATS, "laps": SEATS, "kept": SEATS}, optional={"run_s": SEATS})
VALUES = ("score: each", "counter: laps", "counter: kept", "counter: run_s", "counter: laps, minus: {score: each}")
RANKS = st.lists(
    st.builds(
        rank_of, st.sampled_from(VALUES), st.sampled_from(("more", "less")), st.sampled_from(("sum", "best", "worst", "last"))
    ),
    min_size=1, max_size=3,
)  # fmt: skip


@given(RANKS, st.lists(HALF, min_size=1, max_size=3))
def test_exchanged_entrants_exchange_their_places(rank, halves):
    swapped = [{name: {"blue": own["yellow"], "yellow": own["blue"]} for name, own in half.items()} for half in halves]
    first, second = after(", ".join(rank), *halves), after(", ".join(rank), *swapped)
    assert first == {"blue": second["yellow"], "yellow": second["blue"]}


def test_the_result_of_a_match_holds_the_ranking(play):
    assert play("match.half_s=0.5").result["ranking"] == [
        {"place": 1, "team": "blue", "values": [0]},
        {"place": 1, "team": "yellow", "values": [0]},
    ]
