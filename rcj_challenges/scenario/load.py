"""From a file to a checked scenario: read, extend, override, resolve params, validate, cross-check.

All that is wrong is reported at once, as far as it can be known: what is not YAML hides the content of the file, and a
malformed section hides the references into it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.checks.run import check
from rcj_challenges.scenario.codes import WRONG_VALUE
from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.kits import fill_in_devices
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.reading.extend import Source, find_scenario, read_chain, tree_of
from rcj_challenges.scenario.reading.merge import TESTS, Merger, Repeated
from rcj_challenges.scenario.reading.params import apply_overrides, resolve_params, sets_param
from rcj_challenges.scenario.reading.repeating import entry_of, merged, repeat_entries
from rcj_challenges.scenario.resources import PRESETS_FOLDER
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.tree import RESOLVED, Entries, Leaf, check_size, nodes_in, plain


@dataclass(frozen=True)
class Loaded:
    """A scenario that can be played.

    Attributes:
        name: short name for records and messages: the file's stem.
        path: the file it came from; None if it came from a record or a text.
        resolved: the whole scenario as JSON-able data with all defaults filled in, base files merged, params and
            overrides applied; `load_resolved` reads it again. Records keep it.
        unresolved: the same before entries are repeated and params take their places, without tests. Records keep it
            for `load_recorded`.
        written: the merged tree with the place of each value in its file, for lint; None if there is no such place.
        bases: the files that it extends, the nearest first; presets are not among them.
        left_out: inherited tests that do not fit this scenario, by name, with what is wrong with each.
        repeated: where each copy of a repeated entry comes from, by section and name, for lint.
    """

    scenario: Scenario
    roster: Roster
    name: str
    path: Path | None
    resolved: dict[str, Any]
    unresolved: dict[str, Any] = field(default_factory=dict, repr=False, compare=False)
    written: Entries | None = field(default=None, repr=False, compare=False)
    bases: tuple[Path, ...] = field(default=(), repr=False, compare=False)
    left_out: Mapping[str, Diagnostic] = field(default_factory=dict, repr=False, compare=False)
    repeated: Mapping[tuple[str, str], Repeated] = field(default_factory=dict, repr=False, compare=False)


def load(source: str | Path, overrides: Sequence[str] = ()) -> Loaded:
    """Load a scenario from a file, or a shipped one by its bare name (``match``).

    Overrides are ``PATH=VALUE`` each: a param's name, or a dotted path.

    Raises:
        ScenarioError: everything that is wrong with it.
    """
    path = find_scenario(source)
    written = Source.of_file(path, str(source) if path == Path(source) else path.name)
    extends = written.tree.entries.get("extends")
    if path.suffix == ".json" and isinstance(extends, Leaf) and extends.value is None:  # a record's scenario.json
        return load_resolved(plain(written.tree), overrides=overrides)
    return _load(written, overrides, path.stem, path)


def load_text(text: str, overrides: Sequence[str] = (), *, file: str = "scenario.yaml") -> Loaded:
    """Load a scenario from a text, as if it were a file of that name.

    Raises:
        ScenarioError: everything that is wrong with it.
    """
    return _load(Source.of_text(text, file), overrides, Path(file).stem, None)


def load_resolved(resolved: Mapping[str, Any], name: str = "", overrides: Sequence[str] = ()) -> Loaded:
    """Load ``Loaded.resolved``, for example from a record; without a name it is called by its ``id``.

    The values of params stand where they are used: overrides can change them there.

    Raises:
        ScenarioError: it is not what this version writes, or is wrong with the overrides.
    """
    tree, merger = tree_of(resolved, RESOLVED), Merger()
    apply_overrides(tree, overrides, merger, is_resolved=True)
    scenario = _checked(tree, merger)
    return Loaded(scenario, Roster.of(scenario), name or scenario.id, None, scenario.dumped())


def load_recorded(resolved: Mapping[str, Any], unresolved: Mapping[str, Any], overrides: Sequence[str]) -> Loaded:
    """Load a recorded scenario with overrides, also of params.

    Params are set first; paths then lead into the scenario as it was played, where repeated entries have their names.
    ``unresolved`` is empty for a record without it, in which no param can be set.

    Raises:
        ScenarioError: something is wrong with the overrides, or with the data.
    """
    if not unresolved:
        return load_resolved(resolved, overrides=overrides)
    tree, merger = tree_of(unresolved, RESOLVED), Merger()
    tree.entries.pop(TESTS, None)  # a record may have tests that did not fit the scenario
    of_params = [override for override in overrides if sets_param(tree, override)]
    if of_params:
        apply_overrides(tree, of_params, merger)
        _resolve(tree, merger)
        resolved = _checked(tree, merger).dumped()
    return load_resolved(resolved, overrides=[override for override in overrides if override not in of_params])


def _resolve(tree: Entries, merger: Merger) -> None:
    """Work in what stands in a merged tree for something else: repeated entries, params, devices of kits."""
    repeat_entries(tree, merger)
    resolve_params(tree, merger)
    fill_in_devices(tree)


def _load(source: Source, overrides: Sequence[str], name: str, path: Path | None) -> Loaded:
    merger = Merger()
    tree = Entries({}, source.tree.mark)
    chain = read_chain(source)
    for part in chain:
        merger.merge(tree, part.tree, Scenario)
    bases = tuple(part.path for part in reversed(chain[:-1]) if part.path.parent != PRESETS_FOLDER)
    tree.entries.pop("extends", None)
    apply_overrides(tree, overrides, merger)
    unresolved = {key: value for key, value in plain(tree).items() if key != TESTS}
    _resolve(tree, merger)
    scenario, left_out = _checked_but_inherited_tests(tree, merger, {part.shown for part in chain[:-1]})
    return Loaded(
        scenario, Roster.of(scenario), name, path, scenario.dumped(), unresolved, tree, bases, left_out, merger.repeated
    )


def _checked_but_inherited_tests(
    tree: Entries, merger: Merger, bases: set[str]
) -> tuple[Scenario, dict[str, Diagnostic]]:
    """Return the scenario of a finished tree without the inherited tests that do not fit it, and those.

    A scenario that plays the match with two robots a side, or for three minutes, changes a line or two. The tests of
    its bases (files, as marks name them) about what it removed are no mistakes of its author: lint says which.

    Raises:
        ScenarioError: all else that is wrong.
    """
    left_out: dict[str, Diagnostic] = {}
    while True:
        try:
            return _checked(tree, merger), left_out
        except ScenarioError as error:
            tests, before = tree.entries.get(TESTS), len(left_out)
            for problem in error.diagnostics:
                section, name = entry_of(problem)
                if section == TESTS and isinstance(tests, Entries) and name in tests.entries:
                    marks = [tests.key_marks[name], *(node.mark for node in nodes_in(tests.entries[name]))]
                    if all(mark.file in bases for mark in marks):
                        left_out[name] = problem
                        tests.drop(name)
            if len(left_out) == before:
                raise


def _checked(tree: Entries, merger: Merger) -> Scenario:
    """Return the scenario of a finished tree.

    Raises:
        ScenarioError: all that was and is wrong; of problems at one place the first kind only.
    """
    check_size(tree)
    problems = list(merger.problems)
    scenario: Scenario | None = None
    try:
        scenario = Scenario.model_validate(plain(tree, tuple))
    except ValidationError as error:
        from rcj_challenges.scenario.messages.explain import explain  # noqa: PLC0415 - needed for errors only

        problems += explain(error, tree, Scenario)
        # Errors that only repeat another one are left out, but never all of them.
        problems = problems or [tree.mark.error(WRONG_VALUE, f"not valid: {error.errors()[0]['msg']}")]
    seen = {(place.file, place.line, place.column) for place in map(place_of, problems)}
    later = [(place_of(one), one) for one in check(scenario, tree, merger.removed)]
    problems += [one for at, one in later if at.line is None or (at.file, at.line, at.column) not in seen]
    if problems or scenario is None:
        raise ScenarioError(merged(problems, merger.repeated))
    return scenario
