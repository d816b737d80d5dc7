"""Ratings depend on the results alone, and mean what they say."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import minimize

from rcj_challenges.web.ladder.ratings import FIRST_SD, MEAN, NEXT_SD, PLACEMENTS, POINTS, Result, fit, standings

PROGRAMS = {"a": None, "b": None, "c": None, "d": "a", "e": "d", "f": None}
RESULTS = st.lists(
    st.builds(Result, st.sampled_from("abcdef"), st.sampled_from("abcdef"), st.integers(0, 3), st.integers(0, 3)),
    max_size=40,
)


def match(outcome: str) -> Result:
    """The result that `a3:1b` stands for."""
    return Result(outcome[0], outcome[-1], int(outcome[1]), int(outcome[3]))


def ladder(seed: int, teams: int, matches: int) -> tuple[dict[str, float], list[Result]]:
    """A season of random pairs whose truth is the model: a quarter of the matches between equals is drawn."""
    rng = np.random.default_rng(seed)
    truth = rng.normal(0, FIRST_SD, teams)
    results = []
    for _ in range(matches):
        blue, yellow = rng.choice(teams, 2, replace=False)
        half = (truth[blue] - truth[yellow]) / 2
        weights = np.exp([half, math.log(2 / 3), -half])
        lead = 1 - int(rng.choice(3, p=weights / weights.sum()))
        results.append(Result(f"{blue:03}", f"{yellow:03}", max(lead, 0), max(-lead, 0)))
    return {f"{i:03}": float(value) for i, value in enumerate(truth)}, results


@given(RESULTS, st.randoms(use_true_random=False), st.data())
def test_the_order_of_results_and_which_side_is_blue_change_no_bit(results: list[Result], random, data) -> None:  # type: ignore[no-untyped-def]
    before = fit(results, PROGRAMS)
    others = [
        Result(r.yellow, r.blue, r.yellow_goals, r.blue_goals) if data.draw(st.booleans()) else r for r in results
    ]
    random.shuffle(others)
    programs = list(PROGRAMS.items())
    random.shuffle(programs)
    after = fit(iter(others), dict(programs))
    assert after.strengths.tobytes() == before.strengths.tobytes()
    assert after.covariance.tobytes() == before.covariance.tobytes()
    assert standings(after, PROGRAMS) == standings(before, PROGRAMS)


@given(RESULTS)
def test_the_fit_is_the_maximum_that_a_general_optimizer_finds(results: list[Result]) -> None:
    rated = [r for r in results if r.blue != r.yellow]
    has_draws = any(r.blue_goals == r.yellow_goals for r in rated)

    def loss(at: Sequence[float]) -> float:
        strength = dict(zip("abcdef", at, strict=False))
        tie = at[6] if has_draws else -math.inf
        total = sum(
            (strength[p] - (strength[before] if before else 0)) ** 2 / 2 / (NEXT_SD if before else FIRST_SD) ** 2
            for p, before in PROGRAMS.items()
        )
        total += math.log(2 + math.exp(tie)) if has_draws else 0
        for r in rated:
            half = (strength[r.blue] - strength[r.yellow]) / 2
            logs = {1: half, 0: tie, -1: -half}
            total += math.log(sum(map(math.exp, logs.values())))
            total -= logs[int(np.sign(r.blue_goals - r.yellow_goals))]
        return total

    found = minimize(loss, np.zeros(6 + has_draws), method="BFGS", options={"gtol": 1e-6})
    fitted = fit(results, PROGRAMS)
    assert fitted.strengths == pytest.approx(found.x[:6], abs=1e-3)
    if has_draws:
        assert fitted.tie == pytest.approx(found.x[6], abs=1e-3)


@given(RESULTS, st.integers(0, 39), st.integers(1, 5))
def test_only_the_winner_counts_not_the_goals(results: list[Result], index: int, more: int) -> None:
    decided = [r for r in results if r.blue_goals > r.yellow_goals]
    if decided:
        chosen = decided[index % len(decided)]
        others = [replace(r, blue_goals=r.blue_goals + more) if r is chosen else r for r in results]
        assert fit(others, PROGRAMS).strengths.tobytes() == fit(results, PROGRAMS).strengths.tobytes()


@given(RESULTS, st.sampled_from("abcdef"), st.sampled_from("abcdef"))
def test_one_more_win_never_lowers_the_winner_nor_lifts_the_loser(
    results: list[Result], winner: str, loser: str
) -> None:
    if winner != loser:
        decided = [r for r in results if r.blue_goals != r.yellow_goals]
        before = fit(decided, PROGRAMS)
        after = fit([*decided, Result(winner, loser, 1, 0)], PROGRAMS)
        change = dict(zip(after.digests, after.strengths - before.strengths, strict=True))
        assert change[winner] > -1e-9
        assert change[loser] < 1e-9
        assert change[winner] - change[loser] > 1e-6


def test_a_program_without_matches_has_the_mean_and_its_doubt() -> None:
    fitted = fit([], {"a": None, "b": "a"})
    assert fitted.strengths.tolist() == [0, 0]
    assert np.sqrt(np.diag(fitted.covariance)) * POINTS == pytest.approx([250, math.hypot(250, 150)])
    assert [(r.value, r.games, r.rank) for r in standings(fitted, "ab")] == [(MEAN, 0, None)] * 2


def test_a_next_program_starts_from_the_last_one() -> None:
    won = [match("a1:0b")] * 10
    fitted = fit(won, {"a": None, "b": None, "c": "a"})
    assert fitted.strengths[2] == pytest.approx(fitted.strengths[0])
    assert fitted.covariance[2, 2] == pytest.approx(fitted.covariance[0, 0] + NEXT_SD**2)


def test_a_match_against_the_same_program_is_not_rated() -> None:
    fitted = fit([match("a3:0a")], {"a": None})
    assert (fitted.games.tolist(), fitted.strengths.tolist()) == ([0], [0])


def test_if_all_matches_are_drawn_all_are_equal() -> None:
    fitted = fit([match("a1:1b"), match("b0:0c")] * 50, {"a": None, "b": None, "c": None})
    assert fitted.strengths == pytest.approx([0, 0, 0], abs=1e-9)
    assert math.exp(fitted.tie) == pytest.approx(200)  # twice the number of draws: the imagined match


def test_a_hundred_wins_in_a_row_have_a_finite_rating() -> None:
    value = fit([match("a9:0b")] * 100, {"a": None, "b": None}).strengths[0] * POINTS
    assert 300 < value < 1000


def test_equal_results_share_a_rank_whatever_the_last_bits() -> None:
    circle = [match("a1:0b"), match("b1:0c"), match("c1:0d"), match("d1:0a")] * 20
    fitted = fit(circle, {"a": None, "b": None, "c": None, "d": None})
    assert {(r.low, r.high) for r in standings(fitted, "abcd")} == {(1, 4)}
    even = replace(fitted, strengths=np.array([0.5, 0.5, -0.5, -1.5]) / POINTS)
    for nudge in (-1e-12, 1e-12):
        other = replace(even, strengths=even.strengths + np.array([nudge, -nudge, nudge, -nudge]))
        assert [(r.digest, r.value, r.rank) for r in standings(other, "abcd")] == [
            ("a", 1001, 1), ("b", 1001, 1), ("c", 1000, 3), ("d", 999, 4),
        ]  # fmt: skip


def test_a_program_without_opponents_has_no_rank() -> None:
    assert [r.rank for r in standings(fit([], {"a": None}), "a")] == [None]
    assert standings(fit([], {}), "") == []


@pytest.mark.parametrize(("others", "needed"), [(2, 2), (4, 4), (8, PLACEMENTS), (12, PLACEMENTS)])
def test_programs_that_are_placing_have_no_rank_and_take_none(others: int, needed: int) -> None:
    truth, results = ladder(1, others, 200)
    few = [Result("new", "000", 1, 0)] * (needed - 1)
    programs = {**dict.fromkeys(truth), "new": None}
    table = standings(fit([*results, *few], programs), programs)
    assert [(r.digest, r.low, r.high) for r in table if r.rank is None] == [("new", None, None)]
    assert [r.rank for r in table if r.rank is not None] == list(range(1, others + 1))
    placed = standings(fit([*results, *few, Result("new", "000", 1, 0)], programs), programs)
    assert [r.rank for r in placed] == list(range(1, others + 2))


def test_the_best_of_a_small_club_has_the_first_rank_although_nobody_knows_how_good_it_is() -> None:
    names = "abcd"
    beaten = [Result(a, b, 1, 0) for a in names for b in names if a < b for _ in range(3)]
    table = standings(fit(beaten, dict.fromkeys(names)), names)
    assert [(r.digest, r.rank, r.low) for r in table] == [("a", 1, 1), ("b", 2, 1), ("c", 3, 2), ("d", 4, 3)]
    assert table[0].sd > 100


@pytest.mark.parametrize(
    "programs", [{"a": "b", "b": "a"}, {"a": "a", "b": None}, {"a": "x", "b": None}, {"a": None}], ids=str
)
def test_unlisted_programs_and_circles_of_predecessors_are_refused(programs: dict[str, str | None]) -> None:
    with pytest.raises(ValueError, match=r"program|cycle"):
        fit([match("a1:0b")], programs)


@pytest.mark.nightly
def test_intervals_cover_the_truth_as_often_as_they_promise() -> None:
    values, ranks, total = 0, 0, 0
    for seed in range(200):
        truth, results = ladder(seed, 30, 600)
        best_first = sorted(truth, key=lambda digest: -truth[digest])
        fitted = fit(results, dict.fromkeys(truth))
        middle = sum(truth.values()) / len(truth)
        strengths = dict(zip(fitted.digests, fitted.strengths - fitted.strengths.mean(), strict=True))
        for rating in standings(fitted, truth):
            if rating.rank is None:
                continue
            digest = rating.digest
            assert rating.low is not None
            assert rating.high is not None
            total += 1
            values += abs(strengths[digest] - truth[digest] + middle) * POINTS < 1.96 * rating.sd
            ranks += rating.low <= best_first.index(digest) + 1 <= rating.high
    assert total > 3000
    assert 0.93 <= values / total <= 0.98
    assert 0.87 <= ranks / total <= 0.97
