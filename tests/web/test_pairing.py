"""Match-making: placements first, then what shows most; nobody waits for long, and points cannot be farmed."""

from __future__ import annotations

import random
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.web.ladder.pairing import MEETINGS, Candidate, Pairing, choose
from rcj_challenges.web.ladder.ratings import PLACEMENTS, Fit, Result, fit

NAMES = "abcdefgh"


def candidate(
    digest: str, group: int = 0, most: int = MEETINGS, waited_h: float = 0.0, lane_s: float = 10.0
) -> Candidate:
    return Candidate(digest, {group: most}, waited_h, lane_s)


def fitted(results: Sequence[Result] = (), names: str = NAMES) -> Fit:
    return fit(results, dict.fromkeys(names))


def met_in(results: Sequence[Result]) -> Counter[tuple[str, str]]:
    return Counter((min(r.blue, r.yellow), max(r.blue, r.yellow)) for r in results)


def pair(pairing: Pairing) -> tuple[str, str]:
    return min(pairing.blue, pairing.yellow), max(pairing.blue, pairing.yellow)


def play_all(candidates: Sequence[Candidate], at_once: int = 4) -> list[list[Pairing]]:
    """Choose until no match is left; each is won by the first of the alphabet."""
    results: list[Result] = []
    rounds = []
    names = "".join(one.digest for one in candidates)
    while chosen := choose(fitted(results, names), candidates, met_in(results), [], at_once):
        rounds.append(chosen)
        results += [Result(one.blue, one.yellow, one.blue < one.yellow, one.blue > one.yellow) for one in chosen]
    return rounds


def test_all_programs_play_their_placements_first_and_then_no_pair_more_than_three_times() -> None:
    rounds = play_all([candidate(name) for name in NAMES])
    matches = [one for chosen in rounds for one in chosen]
    assert set(met_in([Result(*pair(one), 0, 0) for one in matches]).values()) == {MEETINGS}
    assert len(matches) == MEETINGS * len(NAMES) * (len(NAMES) - 1) // 2
    last = max(i for i, one in enumerate(matches) if one.is_placement)
    games = Counter(name for one in matches[: last + 1] for name in (one.blue, one.yellow))
    assert min(games.values()) == PLACEMENTS
    assert last < PLACEMENTS * len(NAMES)
    assert all(not one.is_placement for one in matches[last + 1 :])


def test_opponents_of_placements_are_nearest_and_random_in_turn_so_that_all_are_connected() -> None:
    chain = [Result(a, b, 3, 0) for a, b in zip("abcdefg", "bcdefgh", strict=True) for _ in range(PLACEMENTS)]
    known = fitted(chain, NAMES + "z")
    met: Counter[tuple[str, str]] = Counter()
    opponents = []
    for _ in range(PLACEMENTS):
        (one,) = choose(known, [candidate(name) for name in NAMES + "z"], met_in(chain) + met, [], 1)
        assert "z" in pair(one)
        met[pair(one)] += 1
        opponents.append(pair(one)[0])
    assert set(opponents[0::2]) <= {"d", "e"}  # in the middle of the chain, where a new program is expected
    assert len(set(opponents)) > 3


def test_after_the_placements_a_match_of_equals_that_are_uncertain_shows_most() -> None:
    lots = [Result(a, b, a < b, a > b) for a in NAMES for b in NAMES if a < b for _ in range(2)]
    new = [Result("y", "a", 0, 0), Result("y", "h", 1, 0), Result("y", "d", 0, 0)] * 3
    known = fitted([*lots, *new], NAMES + "y")
    everyone = [candidate(name) for name in NAMES + "y"]
    games = met_in(lots) + Counter({("w", "y"): PLACEMENTS})  # those against a program that plays no more
    (one,) = choose(known, everyone, games, [], 1)
    assert "y" in pair(one)


def test_who_has_waited_longer_and_who_is_quick_goes_first() -> None:
    lots = [Result(a, b, a < b, a > b) for a in NAMES for b in NAMES if a < b for _ in range(2)]
    everyone = [candidate(name) for name in NAMES]
    first = pair(choose(fitted(lots), everyone, met_in(lots), [], 1)[0])
    for change, is_chosen in (({"waited_h": 50.0}, True), ({"lane_s": 0.1}, True), ({"lane_s": 1e4}, False)):
        late = next(name for name in NAMES if (name in first) is not is_chosen)
        changed = [replace(one, **change) if one.digest == late else one for one in everyone]  # type: ignore[arg-type]
        assert (late in pair(choose(fitted(lots), changed, met_in(lots), [], 1)[0])) is is_chosen


def test_a_match_in_the_queue_is_not_chosen_again_for_what_it_will_show() -> None:
    lots = [Result(a, b, a < b, a > b) for a in NAMES for b in NAMES if a < b for _ in range(2)]
    everyone = [candidate(name) for name in NAMES]
    first = pair(choose(fitted(lots), everyone, met_in(lots), [], 1)[0])
    assert pair(choose(fitted(lots), everyone, met_in(lots), [first] * 20, 1)[0]) != first


@pytest.mark.parametrize("most", [0, 1])
def test_programs_of_one_group_meet_as_often_as_it_allows(most: int) -> None:
    everyone = [candidate(name, group=i % 2, most=most if i % 2 == 0 else MEETINGS) for i, name in enumerate(NAMES)]
    met = met_in([Result(*pair(one), 0, 0) for chosen in play_all(everyone) for one in chosen])
    assert {met[a, b] for a in "aceg" for b in "aceg" if a < b} == {most}
    assert {met[a, b] for a in "bdfh" for b in "bdfh" if a < b} == {MEETINGS}


def test_program_of_two_groups_is_held_by_the_stricter_of_those_it_shares() -> None:
    both = Candidate("a", {1: 0, 2: 1}, 0.0, 10.0)
    others = [candidate("b", 1, 0), candidate("c", 2, 1), candidate("d", 3)]
    met = met_in([Result(*pair(one), 0, 0) for chosen in play_all([both, *others]) for one in chosen])
    assert (met["a", "b"], met["a", "c"], met["a", "d"]) == (0, 1, MEETINGS)


@given(
    st.lists(st.tuples(st.sampled_from(NAMES), st.sampled_from(NAMES), st.integers(-1, 1)), max_size=60), st.randoms()
)
def test_the_same_database_gives_the_same_choice_in_whatever_order_it_is_read(
    played: list[tuple[str, str, int]], shuffler: random.Random
) -> None:
    results = [Result(a, b, max(lead, 0), max(-lead, 0)) for a, b, lead in played if a != b]
    met = met_in(results)
    everyone = [candidate(name, i % 3, 1 + i % 2, float(i), 5.0 + i) for i, name in enumerate(NAMES)]
    first = choose(fitted(results), everyone, met, [], 8)
    shuffler.shuffle(everyone)
    shuffler.shuffle(results)
    again = choose(fitted(results), everyone, dict(reversed(met.items())), [], 8)
    assert again == first
    for one in first:
        assert one.blue != one.yellow


def test_choice_of_eight_matches_for_300_programs_takes_less_time_than_a_lease() -> None:
    rng = np.random.default_rng(1)
    names = [f"{i:03}" for i in range(300)]
    results = [Result(*rng.choice(names, 2, replace=False), 1, 0) for _ in range(3000)]
    known = fit(results, dict.fromkeys(names))
    began = time.perf_counter()
    chosen = choose(known, [candidate(name) for name in names], met_in(results), [], 8)
    assert len(chosen) == 8
    assert time.perf_counter() - began < 2.0
