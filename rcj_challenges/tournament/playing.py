"""Playing a job in this process."""

from __future__ import annotations

from rcj_challenges.match.designs import with_designs
from rcj_challenges.match.runner import MatchPlan, PlayedMatch, play_match
from rcj_challenges.records.folder import replaced
from rcj_challenges.records.lines import json_line
from rcj_challenges.records.run_record import read_run
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.submissions.team import SuperTeam, Team, open_team
from rcj_challenges.tournament.jobs import (
    STATS,
    MatchJob,
    Program,
    Workplace,
    data_file_error,
    entrants_of,
    trim_record,
)
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.stats import run_stats, stats_as_json


def play_job(job: MatchJob, place: Workplace) -> PlayedMatch:
    """Play a job in this process; its record is in a folder of its own in ``place.playing``.

    Raises:
        RcjError: a submission or the scenario is missing, or the match cannot be played on this computer.
        MatchInterruptedError: it was interrupted.
    """
    loaded = place.load_scenario(job.scenario)
    teams: dict[str, Team | SuperTeam] = {}
    for seat in loaded.scenario.entrants:
        members = tuple(_open_program(program, seat, loaded, place) for program in job.seats[seat])
        teams[seat] = members[0] if len(members) == 1 else SuperTeam(members)
    plan = MatchPlan(
        loaded=with_designs(loaded, teams),
        teams=teams,
        team_names=job.names,
        seed=job.seed,
        match_id=job.match_id,
        out=place.playing,
        record_name=job.id,
        sandbox=job.sandbox,
        record_sensors=job.records == "full",
    )
    played = play_match(plan)
    if job.records != "result" and any(half["ticks"] for half in played.result["halves"]):
        run = read_run(played.folder)
        write_replay(played.folder, run)
        with replaced(played.folder / STATS) as file:
            file.write(json_line(stats_as_json(run_stats(played.folder, run))))
    trim_record(played.folder, job.records)
    return played


def _open_program(program: Program, seat: str, loaded: Loaded, place: Workplace) -> Team:
    """Open a submission for a seat, as a match does.

    Raises:
        RcjError: it is missing, cannot be opened, or holds other programs than it should.
    """
    path = place.submission(program.archive)
    team = open_team(path, *entrants_of(seat, loaded.scenario))
    if team.digest != program.digest:
        raise data_file_error(path, "its programs are not those that were handed in")
    return team
