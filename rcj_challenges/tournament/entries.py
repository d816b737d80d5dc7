"""The teams of a tournament as its file lists them: ids, and where each submission is."""

from __future__ import annotations

import os
import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from hashlib import sha256
from itertools import islice
from pathlib import Path

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.errors import format_error
from rcj_challenges.scenario.errors import did_you_mean, listing
from rcj_challenges.scenario.resources import TEAMS_FOLDER
from rcj_challenges.scenario.tree import Entries, mark_of
from rcj_challenges.submissions.paths import ignored_folder
from rcj_challenges.tournament import codes
from rcj_challenges.tournament.models import ChallengeScenario, General, TeamModel
from rcj_challenges.tournament.season import Team

_MAX_STRAYS, _MAX_SEARCHED = 10, 1000
"""Folders without programs in a folder of submissions, and files that are looked at in each: more are no teams."""


@dataclass(frozen=True, slots=True)
class TeamEntry:
    """One team as the file lists it.

    Attributes:
        id: unique without regard to case; Latin letters, digits and ``_``.
        source: its ZIP or folder.
        name: as in the file; None: that of the submission.
        pot: for drawing groups; 0: none.
        challenges: by stage and challenge the submission for it, where that is another one; None: it takes no part.
    """

    id: str
    source: Path
    name: str | None = None
    pot: int = 0
    is_sample: bool = False
    challenges: Mapping[tuple[str, str], Path | None] = field(default_factory=dict)

    @property
    def team(self) -> Team:
        """The team as the file names it; a submission's own name is not known here."""
        return Team(self.id, self.name or self.id, self.pot)

    def submission(self, stage: str = "", challenge: str = "") -> Path | None:
        """Return the submission for a challenge of a stage, or for the matches; None: it takes no part in it."""
        return self.challenges.get((stage, challenge), self.source)


@dataclass
class TeamLists:
    """Reads the teams of a tournament file that is in ``folder``."""

    tournament: General
    folder: Path
    tree: Entries
    problems: list[Diagnostic] = field(default_factory=list)

    def entries(self) -> dict[str, TeamEntry]:
        """Return the teams by id, in the order of the file, then of the folder."""
        submitted = self._submitted(("teams_folder",), self.tournament.teams_folder)
        entries = {}
        for key, model in self.tournament.teams.items():
            source = self._source(key, model, submitted)
            if source is not None:
                entries[key] = TeamEntry(key, source, model.name, model.pot, model.sample is not None)
        named = {entry.source for entry in entries.values()}
        for key, source in submitted.items():
            if source not in named:
                entries.setdefault(key, TeamEntry(key, source))
        self._refuse_same_ids(entries)
        return entries

    def with_challenges(
        self,
        entries: Mapping[str, TeamEntry],
        challenges: Mapping[tuple[str, str], ChallengeScenario],
        samples: Mapping[tuple[str, str], Path | None],
    ) -> dict[str, TeamEntry]:
        """Return the teams with their submissions for challenges (by stage and name).

        ``samples`` are the sample teams of challenges, None if there is none.
        """
        found: dict[str, dict[tuple[str, str], Path | None]] = {team: {} for team in entries}
        for (name, key), one in challenges.items():
            where = ("stages", name, "scenarios", key, "teams_folder")
            submitted = self._submitted(where, one.teams_folder)
            self._refuse_strangers(where, submitted, entries)
            for team, entry in entries.items():
                if entry.is_sample and team not in submitted:
                    found[team][name, key] = samples.get((name, key)) or entry.source
                elif one.teams_folder is not None:
                    found[team][name, key] = submitted.get(team)
        return {team: replace(entry, challenges=found[team]) for team, entry in entries.items()}

    def _add(self, path: tuple[str, ...], code: Code, message: str, help_: str, *, at_key: bool = False) -> None:
        mark = mark_of(self.tree, path, at_key=at_key)
        self.problems.append(mark.error(code, message, help_, ".".join(path)))

    def _submitted(self, where: tuple[str, ...], name: str | None) -> dict[str, Path]:
        """Return the submissions of a folder by team id."""
        found: dict[str, Path] = {}
        try:
            paths = sorted((self.folder / name).iterdir()) if name is not None else []
        except (OSError, ValueError) as error:
            message = f"the folder '{name}' cannot be read: {format_error(error)}"
            self._add(where, codes.TEAMS_FOLDER, message, "create it, and put each team's ZIP into it")
            return {}
        strays = [path for path in paths if path.is_dir() and not _has_program(path)]
        if len(strays) > max(_MAX_STRAYS, len(paths) // 2):
            message = f"the folder '{name}' has {len(strays)} folders without programs, such as '{strays[0].name}'"
            self._add(where, codes.TEAMS_FOLDER, message, "give the folder in which each team has its ZIP")
            return {}
        for path in paths:
            is_folder = path.is_dir()
            is_submission = is_folder or path.suffix.lower() == ".zip"
            if path.name.startswith(".") or ignored_folder(path.name) or not is_submission:
                continue
            if not _is_inside(path):
                message = f"'{path.name}' is a pipe, a device, or a link that does not lead to a file in the folder"
                self._add(where, codes.TEAMS_FOLDER, message, "put the team's ZIP itself there")
                continue
            key = id_of(path.name if is_folder else path.stem)
            twin = next((other for other in found if other.casefold() == key.casefold()), None)
            if twin is not None:
                message = f"'{found[twin].name}' and '{path.name}' give the same team id '{twin}'"
                self._add(where, codes.SAME_TEAM_ID, message, "rename one of them, or remove it")
            found.setdefault(key if twin is None else twin, path)
        return found

    def _source(self, key: str, model: TeamModel, submitted: Mapping[str, Path]) -> Path | None:
        code, message, help_ = codes.NO_SUBMISSION, f"team '{key}' has no submission", ""
        if model.path is not None and model.sample is not None:
            code, message, help_ = codes.TWO_SOURCES, "both 'path' and 'sample' are given", "keep one of them"
        elif model.path is not None:
            if os.path.exists(self.folder / model.path):  # noqa: PTH110 - that of pathlib raises for odd names
                return self.folder / model.path
            message, help_ = f"no submission at '{model.path}'", "paths are relative to the tournament file"
        elif model.sample is not None:
            samples = sorted(one.name for one in TEAMS_FOLDER.iterdir() if one.is_dir())
            if model.sample in samples:
                return TEAMS_FOLDER / model.sample
            code, message = codes.UNKNOWN_SAMPLE, f"no sample team '{model.sample}'"
            help_ = did_you_mean(model.sample, samples, f"Sample teams: {listing(samples, 30)}")
        elif key in submitted:
            return submitted[key]
        else:
            help_ = did_you_mean(key, submitted, "Give 'path' or 'sample', or put its ZIP into teams_folder")
        self._add(("teams", key), code, message, help_, at_key=True)
        return None

    def _refuse_same_ids(self, entries: Mapping[str, TeamEntry]) -> None:
        first: dict[str, str] = {}
        for key in entries:
            if (twin := first.setdefault(key.casefold(), key)) != key:
                message = f"the team ids '{twin}' and '{key}' differ by case only"
                self._add(("teams", key), codes.SAME_TEAM_ID, message, "give one of them another id", at_key=True)

    def _refuse_strangers(
        self, where: tuple[str, ...], submitted: Mapping[str, Path], entries: Mapping[str, TeamEntry]
    ) -> None:
        for key, path in submitted.items():
            if key not in entries:
                message = f"'{path.name}' is of no team of this tournament"
                help_ = did_you_mean(key, entries, "Name it after its team's id, or remove it")
                self._add(where, codes.UNKNOWN_TEAM, message, help_)


def _has_program(folder: Path) -> bool:
    """Return whether there is a program among the first files in a folder and those below it."""
    names = (name for _, _, files in os.walk(folder) for name in files)
    return any(name.lower().endswith(".py") for name in islice(names, _MAX_SEARCHED))


def _is_inside(path: Path) -> bool:
    """Return whether a path is a folder or a regular file; a link has to lead to a file in its own folder."""
    if not path.is_symlink():
        return path.is_dir() or path.is_file()
    target = Path(os.path.realpath(path))
    return target.is_file() and Path(os.path.realpath(path.parent)) in target.parents


def id_of(file_name: str) -> str:
    """Return the team id of a submission's name without its suffix: Latin letters, digits and ``_``."""
    plain = unicodedata.normalize("NFKD", file_name)
    plain = "".join(character for character in plain if not unicodedata.combining(character))
    found = re.sub(r"[^A-Za-z0-9]+", "_", plain).strip("_")[:40]
    return found or f"team_{sha256(file_name.encode('utf-8', 'surrogatepass')).hexdigest()[:6]}"
