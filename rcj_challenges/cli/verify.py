"""``rcj-challenge verify``: play recorded matches again, and compare the digests."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli import OK, OUR_FAULT
from rcj_challenges.cli.app import ORGANIZE, app
from rcj_challenges.cli.options import AtOnce, Json, Runs, RunsFolder, Sandbox
from rcj_challenges.cli.stdio import print_json, print_progress, require_layers
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.scenario.codes import NO_SUCH_FILE
from rcj_challenges.tournament.codes import NOT_VERIFIABLE, PROGRAMS_MISSING

if TYPE_CHECKING:
    from rcj_challenges.scenario.models.robots import Entrant
    from rcj_challenges.tournament.jobs import Program, Workplace
    from rcj_challenges.tournament.verify import Recorded, Verified

_DIFFERS = 1
_WORDS = {"not_comparable": "not comparable", "not_played": "could not be played"}


@app.register(ORGANIZE, "rcj-challenge verify --team submissions")
def verify(
    runs: Runs = None,
    team: Annotated[
        list[str] | None,
        typer.Option(
            "--team",
            metavar="PATH",
            help="The programs that played: a submission, a folder of ZIPs, or a sample team. Repeatable.",
        ),
    ] = None,
    out: RunsFolder = Path("runs"),
    at_once: AtOnce = None,
    sandbox: Sandbox = "auto",
    json_: Json = False,
) -> int:
    """Play recorded matches again and compare their digests; sample teams need not be given.

    Exit status 0: none differs; 1: one differs; 2: a record or its programs cannot be used; 3: one could not be
    played.
    """
    import tempfile

    from rcj_challenges.tournament.executor import LocalExecutor
    from rcj_challenges.tournament.jobs import Workplace
    from rcj_challenges.tournament.verify import verify_all
    from rcj_challenges.views.replay.browse import find_run

    require_layers(sandbox)
    paths = _located(team or [])
    folders = [find_run(run, out) for run in runs or (None,)]
    with tempfile.TemporaryDirectory(prefix="rcj-verify-") as temporary:
        place = Workplace(Path(temporary))
        place.submissions.mkdir(parents=True)
        found = {one.job.id: one for one in (_recorded(folder, paths, place, sandbox) for folder in folders)}
        lines = VerifyLines(len(found), as_json=json_)
        verify_all(list(found.values()), LocalExecutor(place, at_once or os.cpu_count() or 1), lines.done)
    return lines.finish()


def _located(teams: Sequence[str]) -> list[Path]:
    """Where submissions are, given by their paths or as the names of sample teams.

    Raises:
        DiagnosticError: one does not exist.
    """
    from rcj_challenges.cli.team_args import locate_team

    paths = [locate_team(team) for team in teams]
    help_ = "give a submission, a folder of ZIPs, or the name of a sample team"
    missing = [Diagnostic(NO_SUCH_FILE, f"no file or folder '{path}'", help_) for path in paths if not path.exists()]
    if missing:
        raise DiagnosticError(*missing)
    return paths


def _recorded(folder: Path, teams: Sequence[Path], place: Workplace, sandbox: str) -> Recorded:
    """A record as a match to be played again, with its programs and its scenario copied for the job.

    Raises:
        RcjError: it is not complete, or a program cannot be found.
    """
    from rcj_challenges.records.folder import SCENARIO, read_file
    from rcj_challenges.records.lines import parsed
    from rcj_challenges.records.result import has_time_fault, read_result
    from rcj_challenges.scenario.load import load_resolved
    from rcj_challenges.tournament.jobs import MatchJob, entrants_of
    from rcj_challenges.tournament.verify import Recorded

    result = read_result(folder)
    if not result.complete or "debug" in result.marks:
        why = "it was not played to its end" if not result.complete else "a program had the terminal (--debug)"
        raise DiagnosticError(Diagnostic(NOT_VERIFIABLE, f"{folder.name}: {why}", "verify another record"))
    loaded = load_resolved(parsed(read_file(folder / SCENARIO)))
    seats: dict[str, tuple[Program, ...]] = {}
    for seat, entrant in result.entrants.items():
        members = [(member.programs, member.name) for member in entrant.members] or [(entrant.programs, entrant.name)]
        found = _programs(dict(members), _candidates(folder, teams), entrants_of(seat, loaded.scenario), place)
        for digest, name in members:
            if digest not in found:
                message = f"{folder.name}: the programs of {seat} ({name}) are not here"
                raise DiagnosticError(Diagnostic(PROGRAMS_MISSING, message, "give their submission with --team PATH"))
        seats[seat] = tuple(found[digest] for digest, _ in members)
    job = MatchJob(
        scenario=place.keep_scenario(loaded),
        seats=seats,
        names={seat: entrant.name for seat, entrant in result.entrants.items()},
        seed=result.seed,
        versions=result.versions.model_dump(),
        match_id=result.match_id,
        records="result",
        sandbox=sandbox,
    )
    return Recorded(folder.name, job, result.digest, job.versions, is_timed=has_time_fault(result.model_dump()))


def _candidates(folder: Path, teams: Sequence[Path]) -> Iterable[Path]:
    """Yield the submissions among which the programs of a record may be."""
    from rcj_challenges.checker.discovery import find_submissions
    from rcj_challenges.scenario.resources import TEAMS_FOLDER

    yield from find_submissions(teams).paths
    yield from sorted((folder.resolve().parents[1] / "submissions").glob("*.*"))  # of a tournament
    yield from sorted(path for path in TEAMS_FOLDER.iterdir() if path.is_dir())


def _programs(
    wanted: Mapping[str, str], candidates: Iterable[Path], entrants: Sequence[Entrant], place: Workplace
) -> dict[str, Program]:
    """Programs that are wanted, by digest, as far as they are among some submissions."""
    from rcj_challenges.submissions.team import TeamError, open_team
    from rcj_challenges.tournament.admission import keep_submission
    from rcj_challenges.tournament.jobs import Program

    found: dict[str, Program] = {}
    for path in candidates:
        if len(found) == len(wanted):
            break
        try:
            digest = open_team(path, *entrants).digest
        except TeamError:
            continue
        if digest in wanted:
            archive, _ = keep_submission(path, place.submissions)
            found[digest] = Program(archive, digest, wanted[digest])
    return found


class VerifyLines:
    """Prints the verdicts on ``total`` matches as they come, or with ``as_json`` all of them at the end."""

    def __init__(self, total: int, *, as_json: bool) -> None:
        from rcj_challenges.views.console import console_for

        self._total = total
        self._as_json = as_json
        self._console = console_for(to_stderr=as_json)
        self._verified: list[Verified] = []

    def note(self, line: str) -> None:
        """Print a line."""
        if not self._as_json:
            print_progress(self._console, line)

    def done(self, verified: Verified) -> None:
        """Print a verdict."""
        self._verified.append(verified)
        verdict = _WORDS.get(verified.verdict, verified.verdict)
        reason = f": {verified.reason.strip().splitlines()[-1]}" if verified.reason.strip() else ""
        self.note(f"{len(self._verified)}/{self._total}  {verified.name}  {verdict}{reason}")

    def finish(self) -> int:
        """Print the JSON, if that is asked for; returns the exit code."""
        if self._as_json:
            print_json([asdict(one) for one in self._verified])
        verdicts = {one.verdict for one in self._verified}
        return _DIFFERS if "differs" in verdicts else OUR_FAULT if "not_played" in verdicts else OK
