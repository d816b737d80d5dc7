"""Teams leave at any moment and in any order: what the site shows, and what stands."""

import tempfile
from datetime import UTC, datetime
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rcj_challenges.tournament.load import load_tournament
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.played import RulingKind
from rcj_challenges.tournament.rulings import decide, withdraw
from rcj_challenges.tournament.site.source import site_source
from rcj_challenges.tournament.store.store import Store

NOW = datetime(2026, 6, 26, 18, 0, tzinfo=UTC)
TEAMS = [f"t{number}" for number in range(5)]
STAGES = {
    "round_robin": "{stage: round_robin}",
    "swiss": "{stage: swiss, rounds: 2}",
    "knock_out": "{stage: knock_out, third_place: true}",
    "double_elimination": "{stage: double_elimination}",
    "challenge": "{stage: challenge, scenarios: {shots: {scenario: fast_shooter}}}",
}


@cache
def loaded(kind, withdrawn):
    with tempfile.TemporaryDirectory() as folder:
        teams = "".join(f"  {team}: {{sample: ball_chaser}}\n" for team in TEAMS)
        file = Path(folder) / "cup.yaml"
        text = f"tournament_version: 1\ntitle: Cup\nseed: 7\n{withdrawn}teams:\n{teams}stages:\n  one: {STAGES[kind]}\n"
        file.write_text(text, encoding="utf-8")
        return load_tournament(file)


def take_step(tournament, state, *, leaves, number):
    """Let a team leave, or a match have a score; of what is possible the one of this number."""
    present = [team for team, one in state.teams.items() if not one.withdrawn]
    todo = state.open_fixtures()
    if leaves and present:
        withdraw(tournament, present[number % len(present)], "left", cascade=True)
    elif todo:
        fixture = todo[number % len(todo)]
        scores = [number % 3, number // 3 % 3][: len(fixture.sides)]
        decide(tournament, fixture.id, RulingKind.CORRECTED, "as seen", scores=scores)


@pytest.mark.parametrize("withdrawn", ["", "withdrawn: {lost: [0, 3]}\n"], ids=["annulled", "lost"])
@pytest.mark.parametrize("kind", STAGES)
@settings(max_examples=settings.default.max_examples // 3)
@given(steps=st.lists(st.tuples(st.booleans(), st.integers(0, 20)), max_size=10))
def test_the_site_shows_the_places_of_the_results_and_what_is_decided_stays(kind, withdrawn, steps):
    with tempfile.TemporaryDirectory() as folder, Store(Path(folder), writing=True) as store:
        tournament = OpenTournament(loaded(kind, withdrawn), store)
        state = tournament.state()
        for leaves, number in steps:
            (before,) = state.stages
            take_step(tournament, state, leaves=leaves, number=number)
            state = tournament.state()
            (after,) = state.stages
            assert site_source(tournament, NOW).state == state
            if before.status == "finished" and not before.ties:
                assert (after.tables, after.places) == (before.tables, before.places)
            played = {tie.id: tie for tie in before.ties if tie.decided_by in ("match", "lot")}
            assert [tie for tie in after.ties if tie.id in played] == list(played.values())
            for tie in after.ties:
                if tie.decided_by and not tie.winner:
                    assert all(not team or state.teams[team].withdrawn for team in tie.teams)
