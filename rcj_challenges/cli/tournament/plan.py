"""``rcj-challenge tournament plan``: the fixtures, and what they will take on this computer."""

from __future__ import annotations

import os
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rcj_challenges.cli.app import PLAY
from rcj_challenges.cli.options import Json
from rcj_challenges.cli.stdio import print_json, print_safely
from rcj_challenges.cli.tournament.group import Data, File, opened, tournament_app
from rcj_challenges.cli.tournament.tables import team_words
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.sanitize import sanitize

if TYPE_CHECKING:
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
        matches: in all, as far as is known.
        most_matches: with all extra time and other matches that may be needed to decide ties.
        simulated_s, most_simulated_s: of all matches that are left.
        wall_s, most_wall_s: that these take on this computer, as many at a time as it has cores; None if unknown.
        disk_bytes: of all records that are to come.
    """

    matches: int
    most_matches: int
    simulated_s: float
    most_simulated_s: float
    wall_s: float | None
    most_wall_s: float | None
    disk_bytes: float


@tournament_app.register(PLAY, "rcj-challenge tournament plan cup")
def plan(file: File, data: Data = None, json_: Json = False) -> None:
    """List the known fixtures, the number of matches, and the time and disk space that they need here."""
    with opened(file, data) as tournament:
        state = tournament.state()
        cost = estimate(tournament, state)
    if json_:
        stages = [{"stage": one.name, "matches": one.expected_matches, "known": [asdict(f) for f in one.fixtures]}
                  for one in state.stages]  # fmt: skip
        print_json({"stages": stages, "cost": asdict(cost)})
        return
    lines: list[str] = []
    for stage in state.stages:
        known, expected = len(stage.fixtures), stage.expected_matches
        later = f", {expected - known} more once their teams are known" if expected > known else ""
        lines.append(f"{sanitize(stage.title)} ({stage.name}): {counted(known, 'match', 'matches')}{later}")
        for fixture in stage.fixtures:
            sides = " - ".join(team_words(state.teams, side.teams) for side in fixture.sides)
            lines.append(f"  {fixture.id}  {sides}")
    took = ""
    if cost.wall_s is not None and cost.most_wall_s is not None:
        took = f", about {_range(cost.wall_s / 60, cost.most_wall_s / 60)} min on this computer"
    count = f"{_range(cost.matches, cost.most_matches)} match{'es' if cost.most_matches != 1 else ''}"
    disk = f"about {cost.disk_bytes / 1e6:.0f} MB of records"
    lines.append(
        f"{count} in all; what is left: "
        f"{_range(cost.simulated_s / 3600, cost.most_simulated_s / 3600, 1)} h simulated{took}, {disk}"
    )
    print_safely("\n".join(lines))


def _range(least: float, most: float, digits: int = 0) -> str:
    texts = dict.fromkeys((f"{least:.{digits}f}", f"{most:.{digits}f}"))
    return " to ".join(texts)


def estimate(tournament: OpenTournament, state: SeasonState) -> Cost:
    """Cost of the matches that have no outcome yet."""
    simulated_s = more_s = disk_bytes = 0.0
    left = tournament.work_left(state)
    for one in left:
        records = tournament.loaded.records(one.stage)
        simulated_s += one.matches * one.mean_s
        more_s += one.more * one.mean_s
        disk_bytes += one.matches * (_BYTES_PER_MATCH[records] + one.mean_s * _BYTES_PER_S[records])
    factor = _real_time_factor(tournament)
    wall_s, most_wall_s = (
        None if factor is None else total_s / factor / (os.cpu_count() or 1)
        for total_s in (simulated_s, simulated_s + more_s)
    )
    matches = sum(stage.expected_matches for stage in state.stages)
    most = matches + sum(one.more for one in left)
    return Cost(matches, most, simulated_s, simulated_s + more_s, wall_s, most_wall_s, disk_bytes)


def _real_time_factor(tournament: OpenTournament) -> float | None:
    """How many times faster than real time matches are played here; None if not even a short one can be."""
    played = list(tournament.store.summaries().values())
    wall_s = sum(summary["wall_s"] for summary in played)
    if wall_s > 0:
        return float(sum(summary["simulated_s"] for summary in played) / wall_s)
    with tempfile.TemporaryDirectory(prefix="rcj-plan-") as folder:
        return _measured(Path(folder))


def _measured(folder: Path) -> float | None:
    """Play a short match of the sample teams, as many times side by side as matches are played."""
    from rcj_challenges.match.batch import Job
    from rcj_challenges.match.worker_pool import run_all

    arguments = ("match", "--duration", str(_TRIAL_S), "--halves", "1", "--no-replay", "--quiet", "--out", str(folder))
    jobs = [Job(seed, arguments) for seed in range(1, (os.cpu_count() or 1) + 1)]
    try:
        results = [outcome.result for outcome in run_all(jobs, len(jobs), lambda _: None) if outcome.result]
    except RcjError:
        return None
    played_s = [result["wall_s"] - result["start_up_s"] for result in results]
    return sum(result["simulated_s"] for result in results) / sum(played_s) if results else None
