"""A match of a tournament as a job: plain data with a content address, and the folder that jobs work in."""

from __future__ import annotations

import hashlib
import shutil
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Self

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.errors import format_error
from rcj_challenges.core.files import slug
from rcj_challenges.records.digest import given_values
from rcj_challenges.records.folder import REPLAY, SENSORS, TRAJECTORY, replaced
from rcj_challenges.records.lines import canonical, parsed
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import Loaded, load_resolved
from rcj_challenges.scenario.models.robots import Entrant
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.tournament.codes import DATA_FILE_MISSING
from rcj_challenges.tournament.models import Records

STATS = "stats.json"
"""Of a record: the statistics of the match, so that they outlive the trajectory from which they are counted."""

_DROPPED: Mapping[Records, tuple[str, ...]] = {
    "full": (),
    # The page has all that it shows in itself. Of 17 MB of a match of 20 minutes less than 1 MB is left.
    "replay": (SENSORS, TRAJECTORY),
    "result": (SENSORS, TRAJECTORY, REPLAY),
}

_ID_CHARACTERS = 32
"""128 bits: no two matches share an id, and the rest of a path still fits on Windows."""


@dataclass(frozen=True)
class Program:
    """The programs of one team, for the robots of a side or for one of them.

    Attributes:
        archive: SHA-256 of the submission's file.
        digest: SHA-256 over names and contents of its files, as records have it.
    """

    archive: str
    digest: str
    name: str


@dataclass(frozen=True)
class MatchJob:
    """One match that can be played on any computer that has the scenario and the submissions.

    Attributes:
        scenario: its `scenario_hash`.
        seats: by seat of the first half: one team, or one for each robot of the side.
        versions: as in ``result.json``: they decide the bits of a result in addition to the inputs.
        match_id: as printed in the match's log.
        records: the files that are kept.
        sandbox: ``auto``, ``strict`` or ``off``.
    """

    scenario: str
    seats: Mapping[str, tuple[Program, ...]]
    names: Mapping[str, str]
    seed: int
    versions: Mapping[str, str]
    match_id: int = 0
    records: Records = "replay"
    sandbox: str = "auto"

    @cached_property
    def id(self) -> str:
        """The content address: equal for two jobs exactly if the same match is played. Names do not count."""
        seats = {seat: [one.digest for one in programs] for seat, programs in self.seats.items()}
        inputs = [self.scenario, seats, self.seed, self.match_id, dict(self.versions)]
        return hashlib.sha256(canonical(inputs)).hexdigest()[:_ID_CHARACTERS]

    def to_json(self) -> dict[str, Any]:
        """Return JSON-able data."""
        return asdict(self)

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Self:
        """Return the job that `to_json` has made data of."""
        seats = {seat: tuple(Program(**one) for one in programs) for seat, programs in data["seats"].items()}
        return cls(**{**data, "seats": seats})


class Workplace:
    """The folder of a tournament's data, as far as jobs use it.

    Attributes:
        submissions: by hash.
        records: by job.
        playing: records of matches that are being played; what a killed run left there is worthless.
        progress: of a run, for `status`: the fixtures in play, and the time left in s; None if that is unknown.
        reports: of the check, by team.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.submissions = folder / "submissions"
        self.records = folder / "records"
        self.playing = self.records / ".playing"
        self.progress = folder / "progress.json"
        self.reports = folder / "checks"

    def record_of(self, job_id: str) -> Path:
        """Return the folder of a record."""
        return self.records / job_id

    def report_folder(self, team: str, archive: str) -> Path:
        """Return the folder of the check's reports on a submission of a team."""
        return self.reports / slug(team) / archive[:12]

    def keep_scenario(self, loaded: Loaded) -> str:
        """Write a resolved scenario where jobs find it; returns its hash.

        Raises:
            OSError: it cannot be written.
        """
        scenario = scenario_hash(loaded.scenario)
        path = self._scenario(scenario)
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            with replaced(path) as file:
                file.write(canonical(loaded.resolved))
        return scenario

    def load_scenario(self, scenario: str) -> Loaded:
        """Load a scenario by its hash.

        Raises:
            DiagnosticError: it is not there, or damaged.
        """
        path = self._scenario(scenario)
        try:
            data = parsed(path.read_bytes())
            loaded = load_resolved(data)
        except (OSError, ValueError, ScenarioError) as error:
            raise data_file_error(path, format_error(error)) from error
        # What an older version wrote reads as other data.
        if loaded.resolved == data and scenario_hash(loaded.scenario) != scenario:
            raise data_file_error(path, "its content does not match its name")
        return loaded

    def submission(self, archive: str) -> Path:
        """Return the file of a submission by its hash.

        Raises:
            DiagnosticError: it is not there.
        """
        packed = self.submissions / f"{archive}.zip"
        for path in (packed, *sorted((self.submissions / archive).glob("*.py"))):
            if path.is_file():
                return path
        raise data_file_error(packed, "no such file")

    def read_inputs(self, job: MatchJob) -> dict[str, bytes]:
        """Return the files that a job needs, by their names in this folder.

        Raises:
            DiagnosticError: one is not there.
        """
        archives = {program.archive for programs in job.seats.values() for program in programs}
        paths = [self._scenario(job.scenario), *map(self.submission, sorted(archives))]
        try:
            return {path.relative_to(self.folder).as_posix(): path.read_bytes() for path in paths}
        except OSError as error:
            raise data_file_error(Path(error.filename), format_error(error)) from error

    def _scenario(self, scenario: str) -> Path:
        return self.folder / "scenarios" / f"{scenario}.json"


def entrants_of(seat: str, scenario: Scenario) -> tuple[Entrant, ...]:
    """Return the entrants whose robots a team drives that begins on a seat: all, if sides are changed."""
    entrants = scenario.entrants
    return tuple(entrants.values()) if scenario.match.swap_sides else (entrants[seat],)


def scenario_hash(scenario: Scenario) -> str:
    """Return the SHA-256 of a resolved scenario, without values that are defaults."""
    return hashlib.sha256(canonical(given_values(scenario))).hexdigest()


def data_file_error(path: Path, why: str) -> DiagnosticError:
    """Return the error of an unusable file of the tournament's data."""
    message = f"a file of the tournament's data cannot be used: {path}: {why}"
    return DiagnosticError(Diagnostic(DATA_FILE_MISSING, message, "put it back, or delete it and run again"))


def trim_record(folder: Path, records: Records) -> None:
    """Remove the files of a complete record that are not kept.

    Raises:
        OSError: something cannot be removed.
    """
    for name in _DROPPED[records]:
        path = folder / name
        if path.is_dir():
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)


def sizes(folder: Path) -> dict[str, int]:
    """Return the size of each file of a record by its name, logs included: a record with others is damaged.

    Raises:
        OSError: it cannot be read.
    """
    return {
        path.relative_to(folder).as_posix(): path.stat().st_size for path in sorted(folder.rglob("*")) if path.is_file()
    }
