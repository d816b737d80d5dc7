"""Stage *sources*: the programs are Python that can run here, and everything that they import is there."""

from __future__ import annotations

import platform
import re
from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from enum import Enum
from pathlib import PurePosixPath

from rcj_challenges.checker.file_beside import help_for_module_beside
from rcj_challenges.checker.findings import Finding, Level, Stage
from rcj_challenges.checker.modules import (
    INSTALLED,
    WELL_KNOWN,
    Library,
    Module,
    is_here,
    is_pythons,
    places_of,
    refused_use,
)
from rcj_challenges.checker.preloaded import never_read
from rcj_challenges.checker.reading import Import, Source, read_sources
from rcj_challenges.checker.unreadable import PYTHON, what_is_wrong
from rcj_challenges.controllers.team import Team
from rcj_challenges.core.likeness import nearest_name
from rcj_challenges.core.sanitize import sanitize

_MAX_FINDINGS = 40
_MAX_LOOKED_FOR = 30  # of modules that are nowhere: to look through thousands of files for each would take hours

Unit = tuple[PurePosixPath, int]
"""A file that a program runs, and in how many packages it lies then: relative imports lead as far up, no further."""


class _Weight(Enum):
    """The effect on a program when something that it runs fails; the most serious first."""

    FATAL = "it ends, for it comes there at once"
    CAUGHT = "it is ready for that"
    IF_REACHED = "only running it can show whether it comes there"


def check_sources(team: Team, sandbox: str = "auto") -> Stage:
    """Check the Python files of a team without running them.

    Failures are reported for what a program certainly runs when it is started, by itself or by importing; for all else
    warnings: the stages that run it decide.

    Args:
        team: whose files.
        sandbox: ``auto``, ``strict`` or ``off``, as programs will be started.
    """
    stage = Stage("sources")
    files = dict(team.files)
    entries = {PurePosixPath(entry) for entry in team.entries.values()}
    sources = read_sources(files, entries)
    used: dict[PurePosixPath, bool] = {}
    found: dict[Finding, None] = {}
    unread: dict[PurePosixPath, str] = {}
    for entry in sorted(entries):
        passed_over = never_read(files, entry, sandbox)
        unread |= {path: name for name, path in passed_over.items() if path not in entries}
        walk = _Walk(team, sources, entry, passed_over)
        used |= {path: used.get(path, False) or weight is _Weight.FATAL for path, weight in walk.used.items()}
        found |= dict.fromkeys(walk.findings)
    found |= dict.fromkeys(_unreadable(files, sources, used))
    found |= dict.fromkeys(_empty(sources, entries))
    found |= dict.fromkeys(_shadowing(files, entries, unread))
    stage.findings = _in_order(_gravest(found))
    if not stage.findings:
        count = len(sources)
        told = "1 Python file is" if count == 1 else f"{count} Python files are"
        stage.findings.append(Finding("sources.ok", "passed", f"{told} in order for {PYTHON}"))
    return stage


class _Walk:
    """Follows the imports of one program through the submission."""

    def __init__(
        self,
        team: Team,
        sources: Mapping[PurePosixPath, Source],
        entry: PurePosixPath,
        unread: Collection[str],
    ) -> None:
        self._team = team
        self._sources = sources
        self._makes_modules = any(_MAKES_MODULES.search(team.files[path]) for path in sources)
        self._unread = unread
        self._looked_for = 0
        self._usual = Library(team.files, places_of(entry))
        self._library = self._usual
        self._follow(entry)
        if any(sources[path].moves_path for path in self.used):
            self._library = self._usual.everywhere()
            self._follow(entry)

    def _follow(self, entry: PurePosixPath) -> None:
        self.used: dict[PurePosixPath, _Weight] = {}
        self.findings: list[Finding] = []
        todo: dict[_Weight, list[Unit]] = {weight: [] for weight in _Weight}
        todo[_Weight.FATAL].append((entry, 0))
        seen: set[Unit] = set()
        led: dict[tuple[PurePosixPath, Import], list[Unit]] = {}
        # The gravest first: a file that is imported in several ways counts as it does in the gravest of them.
        while (weight := next((weight for weight in _Weight if todo[weight]), None)) is not None:
            unit = todo[weight].pop()
            file, _ = unit
            if unit in seen or file not in self._sources:
                continue
            seen.add(unit)
            self.used.setdefault(file, weight)
            for wanted in self._sources[file].imports:
                counted = _counted(wanted, weight)
                todo[_weight(counted)] += self._lead(unit, counted, led)

    def _lead(self, unit: Unit, wanted: Import, led: dict[tuple[PurePosixPath, Import], list[Unit]]) -> list[Unit]:
        """Return what an import runs; what is wrong with it becomes a finding.

        Args:
            unit: the file that imports.
            wanted: what.
            led: where imports lead that were followed before, for files that lie in no package: one that is run again,
                in other packages, runs the same files.
        """
        file, depth = unit
        if wanted.level > depth:
            return self._outside(unit, wanted)
        if (file, wanted) not in led:
            led[file, wanted] = self._relative(file, wanted) if wanted.level else self._absolute(unit, wanted)
        inside = depth - wanted.level if wanted.level else 0
        return [(run, inside + packages) for run, packages in led[file, wanted]]

    def _absolute(self, unit: Unit, wanted: Import) -> list[Unit]:
        first, *rest = wanted.module.split(".")
        if first in (*INSTALLED[2:], "__main__"):  # there before any file is looked for
            return []
        module = self._top(first, rest) if first not in self._unread else None
        if module is None and (is_pythons(first) or first in INSTALLED):
            self._library_module(unit, wanted, first)
            return []
        module = module or self._library.top_namespace(first)
        if module is None:
            self._say(unit, wanted, *self._missing(first, rest))
            return []
        return self._through(unit, wanted, module, rest, first)

    def _top(self, name: str, parts: list[str]) -> Module | None:
        """Return the module that an import begins with.

        A program that changes ``sys.path`` may put any folder first: of several modules that one is taken which has
        the parts that are asked for. It need not look into all folders, either: then what only another folder has
        does not hide a folder of that name without ``__init__.py``.
        """
        found = self._library.tops(name)
        if self._library is not self._usual:
            found.sort(key=lambda module: not self._library.has(module, parts))
            folder = self._usual.top_namespace(name) if not self._usual.tops(name) else None
            if folder is not None and not (found and self._library.has(found[0], parts)):
                return folder
        return found[0] if found else None

    def _outside(self, unit: Unit, wanted: Import) -> list[Unit]:
        written = "." * wanted.level + sanitize(wanted.module)
        message = f'"from {written} import …" does not work here: this file is not inside a package'
        self._say(unit, wanted, "relative_import", message, "write it without the dots")
        return []

    def _relative(self, file: PurePosixPath, wanted: Import) -> list[Unit]:
        folder = file.parent
        for _ in range(wanted.level - 1):
            folder = folder.parent
        parts = wanted.module.split(".") if wanted.module else []
        package = Module(folder, None)
        return self._through((file, wanted.level), wanted, package, parts, folder.name)

    def _through(self, unit: Unit, wanted: Import, module: Module, parts: list[str], name: str) -> list[Unit]:
        """Walk down ``module.parts``, then to the names that are modules themselves; return all files that are run.

        Args:
            unit: the file that imports.
            wanted: what.
            module: the module already found.
            parts: names still to find, one in the other.
            name: what ``module`` is called, for messages.

        Returns:
            The files, each with the number of packages that it lies in more than ``module``.
        """
        run: list[Unit] = []
        depth = 0
        for part in ["", *parts]:
            if part:
                inner = self._library.inside(module.folder, part) if module.folder is not None else None
                if inner is None:
                    self._say(unit, wanted, *self._no_such_part(module, name, part))
                    return run
                module, name = inner, f"{name}.{part}"
            depth += module.folder is not None
            if module.file is not None:
                run.append((module.file, depth))
        if module.folder is None:
            return run
        for part in wanted.names:
            inner = self._library.inside(module.folder, part)
            if inner is not None and inner.file is not None:
                run.append((inner.file, depth + (inner.folder is not None)))
            elif inner is None and module.file is None and wanted.level == 0 and part != "*":
                self._say(unit, wanted, *self._no_such_part(module, name, part))
        return run

    def _library_module(self, unit: Unit, wanted: Import, first: str) -> None:
        use = refused_use(wanted.module, wanted.names)
        if use:
            message = (
                f'imports "{sanitize(wanted.module)}", which is for {use}: a match refuses that as soon as it is used'
            )
            self._add(unit, wanted, "warning", "refused_module", message, "play without it; unused, it does no harm")
        if is_pythons(first) and not is_here(first):
            system = platform.system()
            module = sanitize(first)
            message = f'imports "{module}", which is part of Python on some computers, but not on this one ({system})'
            self._say(unit, wanted, "not_on_this_computer", message, "do without it: matches are played on any system")

    def _missing(self, name: str, inside: list[str]) -> tuple[str, str, str]:
        """Return code, message and remedy for a module that is nowhere.

        Args:
            name: what it is called.
            inside: names of what is asked for in it, one in the other: then it is a folder.
        """
        quoted = sanitize(name)
        nowhere = f'imports "{quoted}", which is neither part of Python, nor numpy or scipy, nor in the submission'
        self._looked_for += 1
        if self._looked_for > _MAX_LOOKED_FOR:
            return "missing_module", nowhere, f"put {quoted}.py beside the program, or do without it"
        names = self._usual.names()
        other_case = next((near for near in names if near.casefold() == name.casefold()), None)
        if other_case is not None:
            called = sanitize(other_case)
            message = f'imports "{quoted}", but the module is called "{called}": capital and small letters count'
            return (
                "wrong_case",
                message,
                f'write "{sanitize(other_case)}"; on Windows and macOS the mistake does not show',
            )
        place = self._usual.lies_at(name)
        if place is not None:
            message = f'imports "{quoted}", but {sanitize(place)} is not where Python looks for it'
            return "elsewhere", message, "move the file beside the program, or import it by the name of its folder"
        return "missing_module", nowhere, self._instead_of_missing(name, inside, names)

    def _instead_of_missing(self, name: str, inside: list[str], names: list[str]) -> str:
        """Return what to do about a module that is nowhere, where ``names`` could be imported."""
        if name in WELL_KNOWN:
            return f"do without it: {_IN_A_MATCH}"
        beside = help_for_module_beside(self._team, name)
        if beside:
            return beside
        hidden = self._usual.hidden(name)
        if hidden is not None:
            return f"call {sanitize(hidden)} {sanitize(name)}.py: Windows hides the last ending"
        near = nearest_name(name, [*INSTALLED, *names], 0.75)
        # Of robot1, robot2 and robot3 none is another one misspelled: that file was forgotten.
        if near is not None and re.findall(r"\d+", near) == re.findall(r"\d+", name):
            return f'did you mean "{sanitize(near)}"?'
        if inside:
            folder = f"the folder {sanitize(name)} (with {sanitize('/'.join(inside))}.py in it)"
            return f"put {folder} beside the program or the program's folder, or do without it"
        return f"put {sanitize(name)}.py beside the program, or do without it"

    def _no_such_part(self, module: Module, name: str, part: str) -> tuple[str, str, str]:
        whole = sanitize(f"{name}.{part}")
        if module.folder is None:
            return (
                "missing_part",
                f'imports "{whole}", but "{sanitize(name)}" is a file, not a folder',
                f"correct the import: a file of the same folder is imported as {sanitize(part)}",
            )
        message = f'imports "{whole}", but there is no {sanitize(part)}.py in the folder {sanitize(module.folder)}'
        return "missing_part", message, "add the file to the submission, or correct the import"

    def _say(self, unit: Unit, wanted: Import, code: str, message: str, remedy: str) -> None:
        """Report an import that fails: it ends the program, unless it is caught or never reached."""
        weight = _weight(wanted)
        if weight is _Weight.CAUGHT:
            message += "; the program has a way out (try … except)"
            self._add(unit, wanted, "warning", f"{_OPTIONAL}{code}", message, "make sure that it plays well without")
        elif weight is _Weight.IF_REACHED:
            self._add(unit, wanted, "warning", f"{_CONDITIONAL}{code}", message + _ONLY_IF_REACHED, remedy)
        elif self._makes_modules and code == "missing_module":
            self._add(unit, wanted, "warning", f"{_CONDITIONAL}{code}", message + _RUNNING_SHOWS, remedy)
        else:
            self._add(unit, wanted, "failure", code, message, remedy)

    def _add(self, unit: Unit, wanted: Import, level: Level, code: str, message: str, remedy: str) -> None:
        where = f"{sanitize(unit[0])}:{wanted.line}:{wanted.column}"
        self.findings.append(Finding(f"sources.{code}", level, message, remedy, where))


def _weight(wanted: Import) -> _Weight:
    if wanted.guarded:
        return _Weight.CAUGHT
    return _Weight.FATAL if wanted.certain else _Weight.IF_REACHED


def _counted(wanted: Import, weight: _Weight) -> Import:
    """Return an import as it counts in a file that is run with such a weight itself."""
    if _weight(wanted) is not _Weight.FATAL:
        return wanted
    return replace(wanted, guarded=weight is _Weight.CAUGHT, certain=weight is not _Weight.IF_REACHED)


def _unreadable(
    files: Mapping[PurePosixPath, bytes], sources: Mapping[PurePosixPath, Source], used: Mapping[PurePosixPath, bool]
) -> Iterable[Finding]:
    """Report files that are not valid Python.

    Args:
        files: contents by path.
        sources: what is in them.
        used: those that programs run, each with whether one does for certain.
    """
    for path, source in sources.items():
        if not source.wrong:
            continue
        code, message, remedy = what_is_wrong(source, files[path])
        where = ":".join([sanitize(path), *(str(number) for number in (source.line, source.column) if number)])
        level: Level = "failure" if used.get(path) and code not in _NOT_LOOKED_INTO else "warning"
        if path not in used:
            message += "; no program seems to use this file"
        elif not used[path] and code not in _NOT_LOOKED_INTO:
            message += _RUNNING_SHOWS
        yield Finding(f"sources.{code}", level, message, remedy, where)


# Modules by a name of the program's own, from an archive, or written before they are imported.
_MAKES_MODULES = re.compile(
    rb"""\bsys\.modules[ ]?\[[^\]\n]{1,80}\][ ]?=|\.zip["']|\bmeta_path\b|\.py["'],[ ]?(?:mode[ ]?=[ ]?)?["'][wx]"""
)
_OPTIONAL = "optional_"
_CONDITIONAL = "conditional_"
_ONLY_IF_REACHED = "; that ends the program only if it is reached"
_RUNNING_SHOWS = "; only running the programs can show whether that ends one"
_IN_A_MATCH = "in a match there are only Python's own library, numpy and scipy"
_NOT_LOOKED_INTO = ("large", "too_many_imports", "unread")


def _empty(sources: Mapping[PurePosixPath, Source], entries: set[PurePosixPath]) -> Iterable[Finding]:
    for entry in sorted(entries):
        if entry in sources and sources[entry].empty:
            message = "the program is empty"
            yield Finding("sources.empty", "failure", message, "put your program into this file", sanitize(entry))


def _shadowing(
    files: Iterable[PurePosixPath], entries: set[PurePosixPath], unread: Mapping[PurePosixPath, str]
) -> Iterable[Finding]:
    """Report files that a program imports by mistake, and those that it never gets.

    Args:
        files: all files.
        entries: the programs.
        unread: the files in whose place Python always gives a module of its own, with its name.
    """
    listed = tuple(files)
    hiding = {path for entry in entries for path in Library(listed, places_of(entry)).shadows()} - entries
    for path in sorted(_never_imported(listed, entries)):
        message = f'"import controller" always gives the module of the match: {sanitize(path)} is never imported'
        remedy = "give it another name if programs need what is in it; if it is only for your editor, all is well"
        yield Finding("sources.passed_over", "warning", message, remedy, sanitize(path))
    for path, name in sorted(unread.items()):
        file = sanitize(path)
        message = f'"import {name}" always gives the module of Python, loaded before any program: {file} is never read'
        remedy = "give it another name, and import it by that; as it is, no program gets what is in it"
        yield Finding("sources.passed_over", "warning", message, remedy, sanitize(path))
    for path in sorted(hiding - unread.keys()):
        message = (
            f'this file hides "{sanitize(path.stem)}", a module of Python or of numpy and scipy, from your programs'
        )
        yield Finding(
            "sources.shadows", "warning", message, "give it another name, unless you mean that", sanitize(path)
        )


def _never_imported(files: Iterable[PurePosixPath], entries: set[PurePosixPath]) -> set[PurePosixPath]:
    """Return the files that programs would find as ``controller`` if the match did not give them its own."""
    found = {module.file for entry in entries for module in Library(files, places_of(entry)).tops(INSTALLED[2])}
    return {path for path in found if path is not None} - entries


def _gravest(found: Iterable[Finding]) -> list[Finding]:
    """Leave out warnings where there is a failure of the kind: one program comes there for certain, another may not."""
    listed = list(found)
    fatal = {(finding.where, finding.code) for finding in listed if finding.level == "failure"}
    return [finding for finding in listed if finding.level == "failure" or (finding.where, _kind(finding)) not in fatal]


def _kind(finding: Finding) -> str:
    return finding.code.replace(_OPTIONAL, "").replace(_CONDITIONAL, "")


def _in_order(found: Iterable[Finding]) -> list[Finding]:
    """Return the most serious first, and at most as many as are readable."""
    ordered = sorted(found, key=lambda finding: finding.level != "failure")
    if len(ordered) > _MAX_FINDINGS:
        left_out = len(ordered) - _MAX_FINDINGS
        ordered = [
            *ordered[:_MAX_FINDINGS],
            Finding("sources.more", "warning", f"{left_out} more of the kind", "start with those above"),
        ]
    return ordered
