"""A made-up season for tests of the site: a real engine, made-up records and names of strangers."""

from __future__ import annotations

import json
import shutil
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from functools import cached_property
from pathlib import Path
from typing import Any
from zoneinfo import ZoneInfo

from rcj_challenges.records.sensors import SensorWriter
from rcj_challenges.tournament.engine import Season
from rcj_challenges.tournament.load import load_tournament
from rcj_challenges.tournament.played import Played, PlayedMatch, Submission
from rcj_challenges.tournament.season import Fixture, FixtureKind, Outcome, Ruled, Team
from rcj_challenges.tournament.site import SiteSource
from rcj_challenges.tournament.store.tables import RulingRow
from rcj_challenges.views.replay import write_replay
from tests.made_up_runs import write_made_up_run
from tests.views.sensing_play import SENSED, sense

HOSTILE = "</script><script>alert(1)</script><img src=x onerror=alert(2)>"
RIGHT_TO_LEFT = "فريق الروبوت"
EMOJI = "🤖⚽ Röbo Kickers 東京"
SECRET = "ZeroDivisionError"
"""Part of the detail of the fault in made-up records: only the team may see it."""
NOW = datetime(2026, 6, 26, 18, 0, tzinfo=UTC)

NAMES = {
    "ada": "Ada Lovelaces", "bee": HOSTILE, "cat": RIGHT_TO_LEFT, "dog": EMOJI, "elk": "Same Name", "fox": "Same Name",
    "gnu": "=cmd|'/C calc'!A0", "hen": "\u202egnp.exe\u2066",
    "ibex": "The team with the longest name that anybody could think of", "jay": "Jay", "koi": "\x1b[2J \ud83d", "lynx": "L",
}  # fmt: skip
"""What the teams call themselves, by id."""

CUP = f"""
tournament_version: 1
title: Test Cup & Friends
description: Twelve teams for a test.
seed: a seed of at least some length
set: {{match.half_s: 10}}
time_zone: Europe/Berlin
teams: {{{", ".join(f"{team}: {{sample: ball_chaser}}" for team in NAMES)}}}
tie_breaks: [points, goal_difference, goals, head_to_head, lot]
stages:
  groups: {{stage: round_robin, groups: 2, title: Group stage}}
  finals: {{stage: knock_out, from: groups, places: 1-2, third_place: true, title: Finals}}
  super: {{stage: super_team, title: SuperTeam}}
  skills:
    stage: challenge
    title: Technical challenges
    seeds: 3
    scenarios:
      shooting: {{scenario: fast_shooter}}
      lidar: {{scenario: precision_lidar}}
"""


@dataclass
class MadeUpSeason:
    """A tournament file, records, and outcomes for as much of it as a test wants.

    Attributes:
        folder: where all of it lies.
        record: a made-up record with its replay.
    """

    folder: Path
    record: Path

    @cached_property
    def engine(self) -> Season:
        """The engine of the file."""
        path = self.folder / "test_cup.yaml"
        path.write_text(CUP, "utf-8")
        return Season(load_tournament(path), {team: Team(team, name) for team, name in NAMES.items()})

    def outcomes(self, rounds: Mapping[str, int]) -> dict[str, Outcome]:
        """Return outcomes of the stages up to a round of each; what is drawn there goes on until it is decided."""
        found: dict[str, Outcome] = {}
        while True:
            fixtures = self.engine.state(found).open_fixtures()
            here = [fixture for fixture in fixtures if fixture.round <= rounds.get(fixture.stage, 0)]
            if not here:
                return found
            found |= {fixture.id: outcome(fixture) for fixture in here}

    def source(self, outcomes: Mapping[str, Outcome], *, recorded: bool = True, **changes: Any) -> SiteSource:
        """Return what the site is made from; all that has an outcome was played.

        Args:
            outcomes: by fixture.
            recorded: whether the first and the last match of each stage have a record.
            changes: of the fields of the source.
        """
        state = self.engine.state(outcomes)
        fixtures = [fixture for stage in state.stages for fixture in stage.fixtures if fixture.id in outcomes]
        last = {fixture.stage: fixture.id for fixture in fixtures}
        first = {fixture.stage: fixture.id for fixture in reversed(fixtures)}
        with_record = {*first.values(), *last.values()}
        played = Played(
            {
                fixture.id: self.played(fixture, at, recorded=recorded and fixture.id in with_record)
                for at, fixture in enumerate(fixtures)
            },
            tuple(
                Submission(team, team[0] * 64, self.submission(team), NOW - timedelta(days=2)) for team in state.teams
            ),
        )
        tournament = self.engine.loaded.tournament
        return replace(
            SiteSource(
                id="test_cup",
                title=tournament.title,
                description=tournament.description,
                seed=str(tournament.seed),
                time_zone=ZoneInfo(tournament.time_zone),
                state=state,
                played=played,
                now=NOW,
            ),
            **changes,
        )

    def submission(self, team: str) -> Path:
        """Return the folder of a submission: a program of one line."""
        folder = self.folder / "submissions" / team
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "robot.py").write_text(f"print('{team}')\n", "utf-8")
        return folder

    def played(self, fixture: Fixture, at: int, *, recorded: bool) -> PlayedMatch:
        """Return a match that was played; one that was corrected has its ruling."""
        result = json.loads((self.record / "result.json").read_text("utf-8"))
        if fixture.kind is FixtureKind.CHALLENGE:
            result |= {"faults": [], "events": [], "halves": []}
        corrected = outcome(fixture).ruled is Ruled.CORRECTED
        return PlayedMatch(
            fixture.id,
            self.record if recorded and fixture.kind is not FixtureKind.CHALLENGE else None,
            result,
            {team: team[0] * 64 for side in fixture.sides for team in side.teams},
            NOW - timedelta(hours=20) + timedelta(minutes=2 * at),
            doubtful=at % 7 == 3,
            rulings=(RulingRow("corrected", f"{HOSTILE} was not in goal", NOW, scores=(1, 0)),) if corrected else (),
        )


def outcome(fixture: Fixture) -> Outcome:
    """Return a made-up outcome that depends on the fixture only."""
    if fixture.kind is FixtureKind.CHALLENGE:
        number = zlib.crc32(fixture.id.encode())
        return Outcome((float(number % 9),), values=(float(number % 9),))
    number = fixture.seed
    if number % 11 == 0:
        return Outcome((1.0, 0.0), Ruled.CORRECTED, f"{HOSTILE} was not in goal")
    return Outcome((float(number % 4), float(number // 7 % 5)))


def make_season(folder: Path, ticks: int = 900) -> MadeUpSeason:
    """Make a season in a folder; its record has a goal, a fault, and a private log."""
    record = write_made_up_run(folder / "records", ticks=ticks, halves=2, names=("Ada Lovelaces", HOSTILE))
    for half in (1, 2):
        writer = SensorWriter(record, half, SENSED)
        for tick in range(50):
            sense(writer, tick)
        writer.close()
    write_replay(record)
    shutil.rmtree(record / "logs", ignore_errors=True)
    (record / "logs").mkdir()
    for robot in ("B1", "B2", "B3", "Y1", "Y2", "Y3"):
        (record / "logs" / f"{robot}.log").write_text(f"{robot} printed this\n", "utf-8")
    return MadeUpSeason(folder, record)
