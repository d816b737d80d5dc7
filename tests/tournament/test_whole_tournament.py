"""One tournament with real checks and matches, from the files to a judgement by changed rules."""

import json
from dataclasses import replace

import pytest

from rcj_challenges.tournament.admission import take_submissions
from rcj_challenges.tournament.fixtures import JobMaker
from rcj_challenges.tournament.jobs import MatchJob
from rcj_challenges.tournament.playing import play_job
from tests.cli.in_this_process import here
from tests.tournament.store_helpers import Home
from tests.tournament.test_killed import new_home

SUPER = """
tournament_version: 1
title: Super
seed: 7
set: {match.half_s: 0.2, match.halves: 1}
teams_folder: teams
records: result
stages: {super: {stage: super_team, super_teams: {one: [ada, bee, cid], two: [dee, eva, fay]}}}
"""


def test_a_job_of_super_teams_is_played_from_kept_submissions_and_leaves_what_is_to_be_kept(tmp_path):
    home = Home(tmp_path, SUPER, teams=("ada", "bee", "cid", "dee", "eva", "fay"))
    with home.opened() as tournament:
        handed = take_submissions(tournament.loaded.entries.values(), tournament.store)
        tournament.refresh()
        (fixture,) = tournament.state().open_fixtures()
        job = JobMaker(tournament, handed, "off").job_for(fixture)
        played = play_job(MatchJob.from_json(json.loads(json.dumps(job.to_json()))), tournament.store.place)
    assert played.result["entrants"]["blue"]["name"] == "Team ada + Team bee + Team cid"
    assert [one["name"] for one in played.result["entrants"]["yellow"]["members"]] == [
        "Team dee",
        "Team eva",
        "Team fay",
    ]
    assert played.result["faults"] == []
    names = {path.name for path in played.folder.iterdir()}
    turned = replace(job, seats={"blue": job.seats["blue"][::-1], "yellow": job.seats["yellow"]})
    assert turned.id != job.id, "who drives which robot makes another match"
    assert {"result.json", "logs", "reflog.jsonl"} <= names
    assert names.isdisjoint({"trajectory.chunks", "replay.html"})


@pytest.mark.nightly
@pytest.mark.timeout(900)
def test_a_tournament_is_played_verified_made_again_and_judged(tmp_path, monkeypatch, capsys):
    new_home(tmp_path)

    def command(*arguments):
        code = here(monkeypatch, tmp_path, "tournament", *arguments, "--data", "data")
        return code, capsys.readouterr().out

    assert command("run", "league.yaml", "--accept", "ada", "--accept", "bee")[0] == 0
    assert {one["verdict"] for one in json.loads(command("verify", "league.yaml", "--json")[1])} == {"same"}
    records = tmp_path / "data" / "records"
    kept = {path.name for path in next(records.glob("[0-9a-f]*")).iterdir()}
    assert {"replay.html", "result.json"} <= kept
    assert "trajectory.chunks" not in kept
    assert command("judge", "league.yaml")[0] == 2
    assert command("rerun", "league.yaml")[0] == 0
    assert all((record / "trajectory.chunks").is_file() for record in records.glob("[0-9a-f]*"))
    code, out = command("judge", "league.yaml", "--json")
    assert code == 0
    assert all(one["judged"] == one["recorded"] for one in json.loads(out)["outcomes"].values())
