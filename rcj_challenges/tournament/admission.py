"""What teams hand in: each submission is kept by the hash of its file, and checked before anything is played."""

from __future__ import annotations

import hashlib
import io
import zipfile
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from rcj_challenges.checker.check import CheckOptions
from rcj_challenges.checker.discovery import SubmissionName, name_submissions
from rcj_challenges.checker.many import check_many
from rcj_challenges.checker.report import FileReport, check_report
from rcj_challenges.checker.report_files import write_page
from rcj_challenges.checker.report_html import html_page
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError, InFile
from rcj_challenges.core.errors import format_error
from rcj_challenges.core.files import open_regular
from rcj_challenges.records.folder import replaced, utc_now
from rcj_challenges.records.lines import json_line
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.submissions.archive import Contents, TeamError, read_contents
from rcj_challenges.submissions.limits import MAX_PACKED_BYTES
from rcj_challenges.submissions.team import opening_of
from rcj_challenges.tournament.codes import SUBMISSION_UNREADABLE
from rcj_challenges.tournament.entries import TeamEntry
from rcj_challenges.tournament.store.store import Store
from rcj_challenges.tournament.store.tables import SubmissionRow

_MAX_PACKED_BYTES = 4 * MAX_PACKED_BYTES
"""What is larger is not even kept; between the two the check says what is wrong."""
_EPOCH = (1980, 1, 1, 0, 0, 0)


Submissions = Mapping[tuple[str, str], SubmissionRow]
"""By team and purpose."""


def purpose_of(entry: TeamEntry, stage: str, challenge: str) -> str:
    """Return the purpose of the submission with which a team plays a fixture."""
    return f"{stage}/{challenge}" if entry.challenges.get((stage, challenge)) is not None else ""


def take_submissions(entries: Iterable[TeamEntry], store: Store) -> dict[tuple[str, str], SubmissionRow]:
    """Keep a copy of what each team hands in now, and note what is new.

    Raises:
        DiagnosticError: some cannot be read, or the copies cannot be written.
    """
    before = store.current_submissions()
    handed: dict[tuple[str, str], SubmissionRow] = {}
    problems: list[Diagnostic] = []
    for entry in entries:
        sources = {purpose_of(entry, *key): source for key, source in entry.challenges.items() if source is not None}
        for purpose, source in {"": entry.source, **sources}.items():
            try:
                handed[entry.id, purpose] = _take(entry.id, purpose, source, store)
            except (OSError, TeamError) as error:
                message = f"the submission of {entry.id} cannot be read: {format_error(error)}"
                problems.append(Diagnostic(SUBMISSION_UNREADABLE, message, _REPLACE, InFile(str(source))))
    if problems:
        raise DiagnosticError(*problems)
    for key, one in handed.items():
        if key not in before or before[key].archive != one.archive:
            store.add_submission(one)
    return handed


_REPLACE = "replace it; or take the team out of the tournament with 'tournament decide FILE --withdraw TEAM'"


def _take(team: str, purpose: str, source: Path, store: Store) -> SubmissionRow:
    archive, path = keep_submission(source, store.place.submissions)
    name = opening_of(path, read_contents(path)).name
    file = path.relative_to(store.place.submissions).as_posix()
    return SubmissionRow(team, purpose, archive, file, name.text if name.given else team, utc_now())


def keep_submission(source: Path, folder: Path) -> tuple[str, Path]:
    """Keep a copy of a submission by its hash (of a single program: of its name too); returns that, and the copy.

    Raises:
        OSError: it cannot be read, or the copy cannot be written.
        TeamError: there is nothing that can be opened.
    """
    content = _packed(read_contents(source)) if source.is_dir() else _bytes_of(source)
    archive = hashlib.sha256(content).hexdigest()
    path = folder / f"{archive}.zip"
    if source.is_file() and source.suffix.casefold() == ".py":  # its name counts in the digest of the programs
        archive = hashlib.sha256(source.name.encode() + b"\0" + content).hexdigest()
        path = folder / archive / source.name
        path.parent.mkdir(exist_ok=True)
    if not path.is_file() or path.stat().st_size != len(content):
        with replaced(path) as file:
            file.write(content)
    return archive, path


def _bytes_of(path: Path) -> bytes:
    with open_regular(path) as file:
        content = file.read(_MAX_PACKED_BYTES + 1)
    if len(content) > _MAX_PACKED_BYTES:
        raise TeamError(f"it is larger than {_MAX_PACKED_BYTES // 1_000_000} MB")
    return content


def _packed(contents: Contents) -> bytes:
    """Return the files of a folder as a ZIP, the same bytes for the same files.

    Raises:
        TeamError: they cannot be used.
    """
    if contents.refused:
        raise TeamError(str(contents.refused[0]))
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in sorted(contents.files.items()):
            archive.writestr(zipfile.ZipInfo(str(path), _EPOCH), content, zipfile.ZIP_DEFLATED)
    return packed.getvalue()


class CheckObserver(Protocol):
    """Sees the checks as they are done."""

    def checked(self, team: str, scenario: str, level: str, done: int, total: int) -> None:
        """A submission was checked."""


@dataclass(frozen=True)
class Failure:
    """One reason why the submissions of a team do not pass the check.

    Attributes:
        message: empty if they could not be checked, by no fault of their own.
        scenarios: titles.
        report: page of the check's report for the first of them.
    """

    team: str
    message: str
    scenarios: tuple[str, ...]
    report: Path

    @property
    def is_unchecked(self) -> bool:
        """Whether nothing is known about the submissions."""
        return not self.message


@dataclass(frozen=True)
class CheckTask:
    """Submissions that are to be checked for a scenario, which is given by its hash too."""

    scenario: str
    loaded: Loaded
    handed: tuple[SubmissionRow, ...]


def check_submissions(
    tasks: Iterable[CheckTask], store: Store, *, jobs: int, sandbox: str, observer: CheckObserver
) -> list[Failure]:
    """Check all submissions that were not checked before; return why some do not pass: each reason of a team once."""
    reasons: dict[tuple[str, str], tuple[str, list[str], Path]] = {}
    for task in tasks:
        known = store.checks()
        todo = {
            one.archive: one
            for one in task.handed
            if (one.archive, task.scenario) not in known or not _report_page(one, task, store).exists()
        }
        if todo:
            paths = [store.place.submissions / one.file for one in todo.values()]
            named = dict(zip(name_submissions(paths), todo.values(), strict=True))
            on_done = _noting(named, task, store, sandbox, observer)
            check_many(paths, task.loaded, CheckOptions(sandbox=sandbox), jobs, on_done)
        known = store.checks()
        for one in task.handed:
            row = known.get((one.archive, task.scenario))
            page = _report_page(one, task, store)
            for code, message in [("", "")] if row is None else row.findings:
                _, scenarios, _ = reasons.setdefault((one.team, code), (message, [], page))
                scenarios.append(task.loaded.scenario.title)
    return [
        Failure(team, message, tuple(dict.fromkeys(scenarios)), page)
        for (team, _), (message, scenarios, page) in reasons.items()
    ]


def _noting(
    todo: Mapping[SubmissionName, SubmissionRow], task: CheckTask, store: Store, sandbox: str, observer: CheckObserver
) -> Callable[[FileReport], None]:
    """Return the handler of a report: it notes the verdict, and keeps the report for each of its teams."""
    by_name = {named.name: one for named, one in todo.items()}
    count = 0

    def on_done(report: FileReport) -> None:
        nonlocal count
        count += 1
        one = by_name[report.file]
        if report.level != "unchecked":  # of what could not be checked nothing is known: next time it is tried again
            for own in task.handed:
                if own.archive == one.archive:
                    _keep_report(report, own, task, store, sandbox)
            found = (finding for stage in report.stages for finding in stage.findings)
            failures = [(str(finding.code), finding.message) for finding in found if finding.level == "error"]
            store.add_check(one.archive, task.scenario, report.level, failures)
        observer.checked(one.team, task.loaded.scenario.id, report.level, count, len(todo))

    return on_done


def _report_page(one: SubmissionRow, task: CheckTask, store: Store) -> Path:
    folder = store.place.report_folder(one.team, one.archive)
    return folder / f"{task.loaded.scenario.id}-{task.scenario[:8]}.html"


def _keep_report(report: FileReport, one: SubmissionRow, task: CheckTask, store: Store, sandbox: str) -> None:
    page = _report_page(one, task, store)
    page.parent.mkdir(parents=True, exist_ok=True)
    named = report.model_copy(update={"file": f"{one.team}{Path(one.file).suffix}"})
    scenario = task.loaded.scenario
    whole = check_report(scenario.id, scenario.title, sandbox, [named], [])
    with replaced(page.with_suffix(".json")) as file:
        file.write(json_line(whole.model_dump(mode="json")))
    write_page(page, html_page(whole, page.parent))
