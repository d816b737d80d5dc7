"""Compares two versions of a team by matches with the same seeds, opponents and seat."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from scipy.stats import binom, binomtest

from rcj_challenges.core.amounts import Score, add_up, round_score
from rcj_challenges.rules.ranked import Ranked

Rank = Sequence[Ranked]
Result = Mapping[str, Any]  # as in result.json

_SIGNIFICANT, _POWER = 0.05, 0.7
_SEED_STEP, _MAX_SEEDS = 5, 1000


def gains(new: Result, old: Result, team: str, rank: Rank) -> tuple[Score, ...]:
    """Return the gain of a result by criterion; of scores, the lead over the best opponent is compared."""
    compared = zip(_values(new, team, rank), _values(old, team, rank), strict=True)
    return tuple(0 if before == now else round_score(before - now) for now, before in compared)


def _values(result: Result, team: str, rank: Rank) -> list[Score]:
    """Return numbers that are the greater the worse."""
    own, *others = (entry["values"] for entry in sorted(result["ranking"], key=lambda entry: entry["team"] != team))
    best = others[0] if others else [0] * len(rank)
    compared = zip(rank, own, best, strict=True)
    return [one.number(value) - (one.number(of_best) if one.is_score else 0) for one, value, of_best in compared]


def tally(results: Sequence[Result], team: str) -> dict[str, Score]:
    """Return a team's matches won, drawn and lost (if it has opponents), points, and matches with a program fault."""
    counts: dict[str, Score] = {"matches": len(results)}
    places = [{entry["team"]: entry["place"] for entry in result["ranking"]} for result in results]
    if len(places[0]) > 1:
        leads = [min(place for name, place in one.items() if name != team) - one[team] for one in places]
        won, lost = sum(x > 0 for x in leads), sum(x < 0 for x in leads)  # integers
        counts |= {"won": won, "drawn": leads.count(0), "lost": lost}
        conceded = add_up(add_up(result["score"].values()) - result["score"][team] for result in results)
        counts["conceded"] = round_score(conceded)
    counts["scored"] = round_score(add_up(result["score"][team] for result in results))
    counts["faults"] = sum(any(fault["team"] == team for fault in result["faults"]) for result in results)  # integers
    return counts


def sign_test(better: int, worse: int, equal: int) -> dict[str, Any]:
    """Test whether chance alone may explain with how many seeds a new version is better, worse or equal.

    Returns:
        The ``verdict`` (better, worse, unclear or equal) and a ``sentence``; of the seeds that differ the ``p_value``
        of an exact two-sided sign test and the ``interval`` of Clopper and Pearson for the share of better ones (95 %
        confidence); if it is unclear ``needed_seeds``, None if that is more than 1000.
    """
    differ, most = better + worse, max(better, worse)
    p_value, needed, interval = 1.0, None, [0.0, 1.0]
    verdict, sentence = "equal", f"no difference: {equal} of {equal} seeds give the same result"
    if differ:
        test = binomtest(better, differ)
        p_value, interval = float(test.pvalue), [*map(float, test.proportion_ci(0.95, method="exact"))]
        seeds = f"{most} of {differ} seeds{' that differ' if equal else ''}"
        verdict = "better" if better >= worse else "worse"
        sentence = f"{verdict}: {seeds}, by chance in 1 of {float(f'{1 / p_value:.2g}'):.0f}"
        if p_value >= _SIGNIFICANT:
            needed = _needed_seeds(differ + equal, differ, most / differ)
            shown = "more than 1000 seeds" if needed is None else f"about {needed} seeds"
            verdict, sentence = "unclear", f"{verdict} in {seeds}: could be chance, {shown} would show it"
    return {
        "verdict": verdict, "sentence": sentence, "better": better, "worse": worse, "equal": equal,
        "p_value": p_value, "interval": interval, "needed_seeds": needed,
    }  # fmt: skip


def _needed_seeds(played: int, differ: int, share: float) -> int | None:
    """Return the number of seeds that would show a difference of this size in 7 of 10 cases."""
    for seeds in range((played // _SEED_STEP + 1) * _SEED_STEP, _MAX_SEEDS + 1, _SEED_STEP):
        tested = round(seeds * differ / played)
        if binom.sf(binom.isf(_SIGNIFICANT / 2, tested, 0.5), tested, share) >= _POWER:
            return seeds
    return None
