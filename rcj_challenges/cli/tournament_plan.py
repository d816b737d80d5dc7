"""``rcj-challenge tournament plan``: the fixtures, and what they will take on this computer."""

from __future__ import annotations

import os
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

from rcj_challenges.cli import OK
from rcj_challenges.cli.stdio import print_json, say
from rcj_challenges.cli.tournament_tables import team_words
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.errors import RcjError
from rcj_challenges.match.batch import Job, play_many
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.season import SeasonState

_TRIAL_S = 10
_BYTES_PER_S: dict[str, float] = {"full": 39_000.0, "replay": 600.0, "result": 60.0}
"""Of a record, for each simulated second of a match of six robots (measured: two halves of 600 s)."""
_BYTES_PER_MATCH: dict[str, float] = {"full": 220_000.0, "replay": 220_000.0, "result": 45_000.0}
"""What is in each record however short the match is: the scenario, and the code of the replay page."""


@dataclass(frozen=True)
class Cost:
    """What a tournament will take.

    Attributes:
        matches: in all.
        simulated_s: of all matches that are left.
        wall_s: that these take on this computer, as many at a time as it has cores; None if that is not known.
        disk_bytes: of all records that are to come.
    """

    matches: int
    simulated_s: float
    wall_s: float | None
    disk_bytes: float


def print_plan(tournament: OpenTournament, *, as_json: bool) -> int:
    """Print all fixtures that are known, and what the matches that are left take; returns the exit code."""
    state = tournament.state()
    cost = estimate(tournament, state)
    if as_json:
        stages = [{"stage": one.name, "matches": one.expected_matches, "known": [asdict(f) for f in one.fixtures]}
                  for one in state.stages]  # fmt: skip
        print_json({"stages": stages, "cost": asdict(cost)})
        return OK
    lines: list[str] = []
    for stage in state.stages:
        known, expected = len(stage.fixtures), stage.expected_matches
        later = f", {expected - known} more once their teams are known" if expected > known else ""
        lines.append(f"{stage.title} ({stage.name}): {counted(known, 'match', 'matches')}{later}")
        for fixture in stage.fixtures:
            sides = " - ".join(team_words(state.teams, side.teams) for side in fixture.sides)
            lines.append(f"  {fixture.id}  {sides}")
    took = "" if cost.wall_s is None else f", about {cost.wall_s / 60:.0f} min on this computer"
    disk = f"about {cost.disk_bytes / 1e6:.0f} MB of records"
    lines.append(
        f"{counted(cost.matches, 'match', 'matches')} in all; what is left: "
        f"{cost.simulated_s / 3600:.1f} h simulated{took}, {disk}"
    )
    say("\n".join(lines), sys.stdout)
    return OK


def estimate(tournament: OpenTournament, state: SeasonState) -> Cost:
    """Return what the matches that have no outcome yet will take."""
    infos = {(use.source, use.overrides): info for use, info in tournament.loaded.scenarios.items()}
    simulated_s = disk_bytes = 0.0
    for stage in state.stages:
        known = [infos[fixture.scenario, fixture.overrides].duration_s for fixture in stage.fixtures]
        mean_s = sum(known) / len(known) if known else _mean_s(tournament)
        left = max(0, stage.expected_matches - sum(fixture.id in state.outcomes for fixture in stage.fixtures))
        records = tournament.loaded.records(stage.name)
        simulated_s += left * mean_s
        disk_bytes += left * (_BYTES_PER_MATCH[records] + mean_s * _BYTES_PER_S[records])
    factor = _real_time_factor(tournament)
    wall_s = None if factor is None else simulated_s / factor / (os.cpu_count() or 1)
    return Cost(sum(stage.expected_matches for stage in state.stages), simulated_s, wall_s, disk_bytes)


def _mean_s(tournament: OpenTournament) -> float:
    durations_s = [info.duration_s for info in tournament.loaded.scenarios.values()]
    return sum(durations_s) / len(durations_s)


def _real_time_factor(tournament: OpenTournament) -> float | None:
    """Return how many times faster than real time matches are played here; None if not even a short one can be."""
    played = list(tournament.store.summaries().values())
    wall_s = sum(summary["wall_s"] for summary in played)
    if wall_s > 0:
        return float(sum(summary["simulated_s"] for summary in played) / wall_s)
    with tempfile.TemporaryDirectory(prefix="rcj-plan-") as folder:
        return _measured(Path(folder))


def _measured(folder: Path) -> float | None:
    """Play a short match of the sample teams, as many times side by side as matches are played."""
    arguments = ("match", "--duration", str(_TRIAL_S), "--halves", "1", "--no-replay", "--quiet", "--out", str(folder))
    jobs = [Job(seed, arguments) for seed in range(1, (os.cpu_count() or 1) + 1)]
    try:
        results = [outcome.result for outcome in play_many(jobs, len(jobs), lambda _: None) if outcome.result]
    except RcjError:
        return None
    played_s = [result["wall_s"] - result["start_up_s"] for result in results]
    return sum(result["simulated_s"] for result in results) / sum(played_s) if results else None
