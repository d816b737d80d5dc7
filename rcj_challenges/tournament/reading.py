"""What was played and submitted, as the site and the results read it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

from rcj_challenges.records.folder import RESULT
from rcj_challenges.records.lines import parsed
from rcj_challenges.tournament.played import Played, PlayedMatch, Ruling, RulingKind, Submission
from rcj_challenges.tournament.store.store import Store
from rcj_challenges.tournament.store.tables import RulingRow


class RecordedResult(Mapping[str, Any]):
    """The content of a record's ``result.json``, read when it is asked for; of a damaged one what the store knows."""

    def __init__(self, folder: Path, summary: Mapping[str, Any]) -> None:
        self._folder = folder
        self._summary = summary

    @cached_property
    def _content(self) -> Mapping[str, Any]:
        try:
            content = parsed((self._folder / RESULT).read_bytes())
        except (OSError, ValueError):
            return self._summary
        return content if isinstance(content, dict) else self._summary

    def __getitem__(self, key: str) -> Any:
        return self._content[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._content)

    def __len__(self) -> int:
        return len(self._content)


def read_played(store: Store) -> Played:
    """Return all that was played, decided and submitted."""
    rulings: dict[str, list[Ruling]] = {}
    withdrawals: dict[str, tuple[Ruling, ...]] = {}
    for row in store.rulings():
        if row.fixture:
            rulings.setdefault(row.fixture, []).append(_ruling(row))
        else:
            withdrawals[row.team] = (*withdrawals.get(row.team, ()), _ruling(row))
    matches: dict[str, PlayedMatch] = {}
    for played, job in store.played_rows():
        folder = store.place.record_of(job.id)
        matches[played.fixture] = PlayedMatch(
            fixture=played.fixture,
            record=folder if folder.is_dir() else None,
            result=RecordedResult(folder, job.summary),
            submissions=played.submissions,
            played_at=played.played_at,
            doubtful=job.doubtful,
            rulings=tuple(rulings.get(played.fixture, ())),
        )
    for fixture, own in rulings.items():
        matches.setdefault(fixture, PlayedMatch(fixture, None, {}, rulings=tuple(own)))
    return Played(matches, tuple(_submissions(store)), withdrawals)


def _ruling(row: RulingRow) -> Ruling:
    return Ruling(RulingKind(row.kind), row.reason, row.at, tuple(row.scores))


def _submissions(store: Store) -> Iterator[Submission]:
    for row in store.submissions():
        report = store.place.report_folder(row.team, row.archive)
        path = store.place.submissions / row.file
        yield Submission(row.team, row.archive, path, row.received_at, row.purpose, report if report.is_dir() else None)
