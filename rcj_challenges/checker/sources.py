"""Stage *sources*: the programs are valid Python and can run here, and everything that they import is there."""

from __future__ import annotations

import platform
import re
import sys
from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from pathlib import PurePosixPath

from rcj_challenges.checker import codes
from rcj_challenges.checker.file_beside import help_for_module_beside
from rcj_challenges.checker.findings import Stage
from rcj_challenges.checker.modules import (
    INSTALLED,
    Library,
    Module,
    is_always_pythons,
    is_here,
    places_of,
    refused_use,
)
from rcj_challenges.checker.reading import Import, Risk, Source, read_sources
from rcj_challenges.checker.unreadable import PYTHON, describe_error
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.code import Code, Level
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.similarity import nearest_name
from rcj_challenges.submissions.team import Team

Unit = tuple[PurePosixPath, int]
"""A file that a program runs, and in how many packages it lies then: relative imports lead as far up, no further."""

_MAX_FINDINGS = 40
_MAX_LOOKED_FOR = 30  # of modules that are nowhere: to look through thousands of files for each would take hours
_RISKS: tuple[Risk, ...] = ("certain", "caught", "possible")
"""The most serious first: a file that is imported in several ways counts as it does in the most serious of them."""
# Programs that write modules, or import them from ZIP files: whether an import finds one shows only when it runs.
_MAKES_MODULES = re.compile(
    rb"""\bsys\.modules[ ]?\[[^\]\n]{1,80}\][ ]?=|\.zip["']|\bmeta_path\b|\.py["'],[ ]?(?:mode[ ]?=[ ]?)?["'][wx]"""
)
_RUNNING_SHOWS = "; only running the programs can show whether that ends one"
_NOT_LOOKED_INTO = (codes.SOURCES_LARGE, codes.SOURCES_TOO_MANY_IMPORTS, codes.SOURCES_UNREAD)


def check_sources(team: Team) -> Stage:
    """Check the Python files of a team without running them.

    Errors are reported for what a program certainly runs when it is started, by itself or by importing; for all else
    warnings: the stages that run it decide.
    """
    files = dict(team.files)
    entries = {PurePosixPath(entry) for entry in team.entries.values()}
    sources = read_sources(files, entries)
    used: dict[PurePosixPath, bool] = {}
    found: dict[Diagnostic, None] = {}
    for entry in sorted(entries):
        walk = _Walk(team, sources, entry)
        used |= {path: used.get(path, False) or risk == "certain" for path, risk in walk.used.items()}
        found |= dict.fromkeys(walk.findings)
    found |= dict.fromkeys(_unreadable(files, sources, used))
    for entry in sorted(entries & sources.keys()):
        if sources[entry].empty:
            help_ = "put your program into this file"
            found[Diagnostic(codes.SOURCES_EMPTY, "the program is empty", help_, sanitize(entry))] = None
    found |= dict.fromkeys(_taken_names(files, entries))
    ok = Diagnostic(codes.SOURCES_OK, f"{counted(len(sources), 'Python file')} in order for {PYTHON}")
    return Stage("sources", _in_order(found) or [ok])


class _Walk:
    """Follows the imports of one program through the submission.

    Attributes:
        used: the files that the program runs, with their risk.
        findings: what is wrong with their imports.
    """

    def __init__(self, team: Team, sources: Mapping[PurePosixPath, Source], entry: PurePosixPath) -> None:
        self._team = team
        self._sources = sources
        self._makes_modules = any(_MAKES_MODULES.search(team.files[path]) for path in sources)
        self._looked_for = 0
        self._usual = Library(team.files, places_of(entry))
        self._library = self._usual
        self._follow(entry)
        if any(sources[path].moves_path for path in self.used):
            self._library = self._usual.everywhere()
            self._follow(entry)

    def _follow(self, entry: PurePosixPath) -> None:
        self.used: dict[PurePosixPath, Risk] = {}
        self.findings: list[Diagnostic] = []
        todo: dict[Risk, list[Unit]] = {risk: [] for risk in _RISKS}
        todo["certain"].append((entry, 0))
        seen: set[Unit] = set()
        followed: dict[tuple[PurePosixPath, Import], list[Unit]] = {}
        while (risk := next((risk for risk in _RISKS if todo[risk]), None)) is not None:
            unit = todo[risk].pop()
            file, _ = unit
            if unit in seen or file not in self._sources:
                continue
            seen.add(unit)
            self.used.setdefault(file, risk)
            for wanted in self._sources[file].imports:
                weighed = replace(wanted, risk=risk) if wanted.risk == "certain" else wanted
                for run in self._run_by(unit, weighed, followed):
                    is_sure = weighed.risk != "certain" or _module_name(run[0]) not in sys.stdlib_module_names
                    todo[weighed.risk if is_sure else "possible"].append(run)  # Python may have its own loaded

    def _run_by(
        self, unit: Unit, wanted: Import, followed: dict[tuple[PurePosixPath, Import], list[Unit]]
    ) -> list[Unit]:
        """The code that an import runs; what is wrong with it becomes a finding.

        Results are kept in ``followed``: a file that is run again, in other packages, runs the same files.
        """
        file, depth = unit
        if wanted.level > depth:
            written = "." * wanted.level + sanitize(wanted.module)
            message = f'"from {written} import …" does not work here: this file is not inside a package'
            self._report(file, wanted, codes.SOURCES_RELATIVE_IMPORT, message, "write it without the dots")
            return []
        if (file, wanted) not in followed:
            followed[file, wanted] = self._relative(file, wanted) if wanted.level else self._absolute(file, wanted)
        inside = depth - wanted.level if wanted.level else 0
        return [(run, inside + packages) for run, packages in followed[file, wanted]]

    def _absolute(self, file: PurePosixPath, wanted: Import) -> list[Unit]:
        first, *rest = wanted.module.split(".")
        is_pythons = first in sys.stdlib_module_names
        module = None if is_always_pythons(first) else self._library.top(first, rest)
        if module is None and (is_pythons or first in (*INSTALLED, "__main__")):
            self._check_library_module(file, wanted, first, is_pythons=is_pythons)
            return []
        module = module or self._library.top_namespace(first)
        if module is None:
            self._report(file, wanted, *self._missing(first, rest))
            return []
        return self._through(file, wanted, module, rest, first)

    def _relative(self, file: PurePosixPath, wanted: Import) -> list[Unit]:
        folder = file.parents[wanted.level - 1]
        parts = wanted.module.split(".") if wanted.module else []
        return self._through(file, wanted, Module(folder, None), parts, folder.name)

    def _through(self, file: PurePosixPath, wanted: Import, module: Module, parts: list[str], name: str) -> list[Unit]:
        """Walk down ``module.parts``, then to the names that are modules themselves.

        Returns:
            All files that are run, each with the number of packages that it lies in more than ``module``.
        """
        run: list[Unit] = []
        depth = 0
        for part in ["", *parts]:
            if part:
                inner = self._library.inside(module.folder, part) if module.folder is not None else None
                if inner is None:
                    self._report(file, wanted, *_missing_part(module, name, part))
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
                self._report(file, wanted, *_missing_part(module, name, part))
        return run

    def _check_library_module(self, file: PurePosixPath, wanted: Import, first: str, *, is_pythons: bool) -> None:
        if use := refused_use(wanted.module, wanted.names):
            message = (
                f'imports "{sanitize(wanted.module)}", which is for {use}: a match refuses that as soon as it is used'
            )
            help_ = "play without it; unused, it does no harm"
            self.findings.append(Diagnostic(codes.SOURCES_REFUSED_MODULE, message, help_, _place(file, wanted)))
        if is_pythons and not is_here(first):
            message = (
                f'imports "{sanitize(first)}", which is part of Python on some computers, but not on this one '
                f"({platform.system()})"
            )
            help_ = "do without it: matches are played on any system"
            self._report(file, wanted, codes.SOURCES_NOT_ON_THIS_COMPUTER, message, help_)

    def _missing(self, name: str, parts: list[str]) -> tuple[Code, str, str]:
        """Return code, message and help for a module that is nowhere."""
        quoted = sanitize(name)
        nowhere = f'imports "{quoted}", which is neither part of Python, nor numpy or scipy, nor in the submission'
        self._looked_for += 1
        if self._looked_for > _MAX_LOOKED_FOR:
            return codes.SOURCES_MISSING_MODULE, nowhere, f"put {quoted}.py beside the program, or do without it"
        other_case = next((near for near in self._usual.names if near.casefold() == name.casefold()), None)
        if other_case is not None:
            called = sanitize(other_case)
            message = f'imports "{quoted}", but the module is called "{called}": upper and lower case matter'
            return codes.SOURCES_WRONG_CASE, message, f'write "{called}"; Windows and macOS hide this mistake'
        place = self._usual.lies_at(name)
        if place is not None:
            message = f'imports "{quoted}", but {sanitize(place)} is not where Python looks for it'
            help_ = "move the file beside the program, or import it by the name of its folder"
            return codes.SOURCES_ELSEWHERE, message, help_
        return codes.SOURCES_MISSING_MODULE, nowhere, self._help_for_missing(name, parts)

    def _help_for_missing(self, name: str, parts: list[str]) -> str:
        if beside := help_for_module_beside(self._team, name):
            return beside
        if (hidden := self._usual.hidden(name)) is not None:
            return f"call {sanitize(hidden)} {sanitize(name)}.py: Windows hides the last ending"
        near = nearest_name(name, [*INSTALLED, *self._usual.names], 0.75)
        # Of robot1, robot2 and robot3 none is another one misspelled: that file was forgotten.
        if near is not None and re.findall(r"\d+", near) == re.findall(r"\d+", name):
            return f'did you mean "{sanitize(near)}"?'
        if parts:
            folder = f"the folder {sanitize(name)} (with {sanitize('/'.join(parts))}.py in it)"
            return f"put {folder} beside the program or the program's folder, or do without it"
        installed = "in a match there are only Python's own library, numpy and scipy"
        return f"put {sanitize(name)}.py beside the program, or do without it: {installed}"

    def _report(self, file: PurePosixPath, wanted: Import, code: Code, message: str, help_: str) -> None:
        """Report an import that fails: it ends the program, unless it is caught or never reached."""
        level: Level = "warning"
        if wanted.risk == "caught":
            message += "; the program has a way out (try … except)"
            help_ = "make sure that it plays well without"
        elif wanted.risk == "possible":
            message += "; that ends the program only if it is reached"
        elif self._makes_modules and code == codes.SOURCES_MISSING_MODULE:
            message += _RUNNING_SHOWS
        else:
            level = "error"
        self.findings.append(Diagnostic(code, message, help_, _place(file, wanted), level=level))


def _place(file: PurePosixPath, wanted: Import) -> str:
    return f"{sanitize(file)}:{wanted.line}:{wanted.column}"


def _module_name(path: PurePosixPath) -> str:
    return path.parent.name if path.stem == "__init__" else path.stem


def _missing_part(module: Module, name: str, part: str) -> tuple[Code, str, str]:
    whole = sanitize(f"{name}.{part}")
    if module.folder is None:
        message = f'imports "{whole}", but "{sanitize(name)}" is a file, not a folder'
        help_ = f"correct the import: a file of the same folder is imported as {sanitize(part)}"
        return codes.SOURCES_MISSING_PART, message, help_
    message = f'imports "{whole}", but there is no {sanitize(part)}.py in the folder {sanitize(module.folder)}'
    return codes.SOURCES_MISSING_PART, message, "add the file to the submission, or correct the import"


def _unreadable(
    files: Mapping[PurePosixPath, bytes], sources: Mapping[PurePosixPath, Source], used: Mapping[PurePosixPath, bool]
) -> Iterable[Diagnostic]:
    """Report files that are not valid Python; ``used`` are those that programs run, or certainly run."""
    for path, source in sources.items():
        if not source.wrong:
            continue
        code, message, help_ = describe_error(source, files[path])
        where = ":".join([sanitize(path), *(str(number) for number in (source.line, source.column) if number)])
        level: Level = "error" if used.get(path) and code not in _NOT_LOOKED_INTO else "warning"
        if path not in used:
            message += "; no program seems to use this file"
        elif not used[path] and code not in _NOT_LOOKED_INTO:
            message += _RUNNING_SHOWS
        yield Diagnostic(code, message, help_, where, level=level)


def _taken_names(files: Collection[PurePosixPath], entries: set[PurePosixPath]) -> Iterable[Diagnostic]:
    """Report files that have the name of a module of Python, numpy, scipy or the match."""
    named_so = {path for entry in entries for path in Library(files, places_of(entry)).named_like_pythons()}
    for path in sorted(named_so - entries):
        name = _module_name(path)
        file, module = sanitize(path), sanitize(name)
        if is_always_pythons(name):
            message = f'"import {module}" never finds {file}: it always gives the module of Python or of the match'
            help_ = "give it another name if programs need what is in it; if it is only for your editor, all is well"
            yield Diagnostic(codes.SOURCES_PASSED_OVER, message, help_, file)
        else:
            message = f'this file hides "{module}", a module of Python or of numpy and scipy, or is hidden by it'
            yield Diagnostic(codes.SOURCES_SHADOWS, message, "give it another name", file)


def _in_order(found: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Return the most serious first, at most as many as are readable.

    Warnings are left out where there is an error of the kind: one program certainly gets there, another may not.
    """
    errors = [finding for finding in found if finding.level == "error"]
    fatal = {(finding.where, finding.code) for finding in errors}
    warnings = [finding for finding in found if finding.level != "error" and (finding.where, finding.code) not in fatal]
    ordered = [*errors, *warnings]
    left_out = len(ordered) - _MAX_FINDINGS
    if left_out <= 0:
        return ordered
    more = Diagnostic(codes.SOURCES_MORE, f"{left_out} more of the kind", "start with those above")
    return [*ordered[:_MAX_FINDINGS], more]
