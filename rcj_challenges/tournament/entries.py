"""The teams of a tournament as its file lists them: ids, and where each submission is."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from rcj_challenges.scenario.errors import listing, nearest
from rcj_challenges.scenario.resources import teams_folder
from rcj_challenges.scenario.tree import Entries, mark_of
from rcj_challenges.tournament.errors import Problem, problem_at
from rcj_challenges.tournament.models import TeamModel, Tournament


@dataclass(frozen=True, slots=True)
class TeamEntry:
    """One team as the file lists it.

    Attributes:
        id: unique without regard to case; letters, digits and ``_``.
        source: its ZIP or folder.
        name: as the file says; None: what the submission calls itself.
        pot: for drawing groups; 0: none.
    """

    id: str
    source: Path
    name: str | None = None
    pot: int = 0


def list_teams(tournament: Tournament, folder: Path, tree: Entries) -> tuple[dict[str, TeamEntry], list[Problem]]:
    """Return the teams by id, in the order of the file, then of the folder, and what is wrong with them.

    Args:
        tournament: the file.
        folder: where it lies.
        tree: its positions.
    """
    problems: list[Problem] = []
    submitted = _submitted(tournament, folder, tree, problems)
    entries = {}
    for key, model in tournament.teams.items():
        source = _source(key, model, folder, submitted, tree, problems)
        if source is not None:
            entries[key] = TeamEntry(key, source, model.name, model.pot)
    for key, source in submitted.items():
        entries.setdefault(key, TeamEntry(key, source))
    problems += _same_ids(entries, tree)
    return entries, problems


def id_of(file_name: str) -> str:
    """Return the team id of a submission's name without its suffix: Latin letters, digits and ``_``."""
    plain = unicodedata.normalize("NFKD", file_name)
    plain = "".join(letter for letter in plain if not unicodedata.combining(letter))
    found = re.sub(r"[^A-Za-z0-9]+", "_", plain).strip("_")[:40]
    return found or f"team_{sha256(file_name.encode('utf-8', 'surrogatepass')).hexdigest()[:6]}"


def _submitted(tournament: Tournament, folder: Path, tree: Entries, problems: list[Problem]) -> dict[str, Path]:
    if tournament.teams_folder is None:
        return {}
    mark = mark_of(tree, ("teams_folder",))
    found: dict[str, Path] = {}
    try:
        paths = sorted((folder / tournament.teams_folder).iterdir())
    except OSError as error:
        message = f"the folder '{tournament.teams_folder}' cannot be read: {error.strerror}"
        problems.append(problem_at(mark, "teams-folder", message, "create it, and put each team's ZIP into it"))
        return {}
    for path in paths:
        is_folder = path.is_dir()
        if path.name.startswith(".") or not (is_folder or path.suffix.lower() == ".zip"):
            continue
        key = id_of(path.name if is_folder else path.stem)
        twin = next((other for other in found if other.casefold() == key.casefold()), None)
        if twin is None:
            found[key] = path
        else:
            message = f"'{found[twin].name}' and '{path.name}' give the same team id '{twin}'"
            problems.append(problem_at(mark, "same-team-id", message, "rename one of them, or remove it"))
    return found


def _source(
    key: str, model: TeamModel, folder: Path, submitted: dict[str, Path], tree: Entries, problems: list[Problem]
) -> Path | None:
    mark, path = mark_of(tree, ("teams", key), at_key=True), f"teams.{key}"
    if model.path is not None and model.sample is not None:
        problems.append(problem_at(mark, "two-sources", "both 'path' and 'sample' are given", "keep one", path))
    elif model.path is not None:
        if (folder / model.path).exists():
            return folder / model.path
        message = f"no submission at '{model.path}'"
        problems.append(problem_at(mark, "no-submission", message, "paths are relative to this file", path))
    elif model.sample is not None:
        samples = sorted(one.name for one in teams_folder().iterdir() if one.is_dir())
        if model.sample in samples:
            return teams_folder() / model.sample
        hint = nearest(model.sample, samples).removeprefix("; ")
        help_ = f"{hint} sample teams: {listing(samples, 30)}".strip()
        problems.append(problem_at(mark, "unknown-sample", f"no sample team '{model.sample}'", help_, path))
    elif key in submitted:
        return submitted[key]
    else:
        hint = nearest(key, submitted).removeprefix("; ")
        help_ = hint or "give 'path' or 'sample', or put its ZIP into teams_folder"
        problems.append(problem_at(mark, "no-submission", f"team '{key}' has no submission", help_, path))
    return None


def _same_ids(entries: dict[str, TeamEntry], tree: Entries) -> Iterator[Problem]:
    first: dict[str, str] = {}
    for key in entries:
        twin = first.setdefault(key.casefold(), key)
        if twin != key:
            mark = mark_of(tree, ("teams", key), at_key=True)
            message = f"the team ids '{twin}' and '{key}' differ by case only"
            yield problem_at(mark, "same-team-id", message, "give one of them another id", f"teams.{key}")
