"""Finds the shipped scenario for which a submission seems to be made, if not the one that it is checked for."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from pathlib import PurePosixPath

from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.robots import Entrant
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER, names_in
from rcj_challenges.submissions.archive import Contents
from rcj_challenges.submissions.team import opening_of


def seats_of(scenario: Scenario) -> list[tuple[Entrant, ...]]:
    """The seats that a submission may fill: all, or, where teams keep their sides, any one of them."""
    entrants = tuple(scenario.entrants.values())
    if scenario.match.swap_sides or len(entrants) == 1:
        return [entrants]
    return [entrants, *((entrant,) for entrant in entrants)]


def others_that_fit(
    files: Mapping[PurePosixPath, bytes], asked: Scenario, suits: Callable[[Scenario], bool] = lambda _: True
) -> list[str]:
    """Return the names of shipped scenarios whose programs are all in a submission.

    Args:
        files: of the submission.
        asked: the scenario that it is checked for, which is never among them.
        suits: which scenarios to consider.
    """
    contents = Contents("folder", dict(files))
    return [
        name
        for name, scenario in _shipped().items()
        if scenario.id != asked.id and suits(scenario) and _fits(contents, scenario)
    ]


def suggest_scenarios(names: Sequence[str]) -> str:
    """The command that checks a submission for another scenario, as the beginning of a help text."""
    return f"it looks like one for {' or '.join(names)}: rcj-challenge check … --scenario {names[0]}"


def _fits(contents: Contents, scenario: Scenario) -> bool:
    # Where a submission came from matters only for the name of its team.
    return any(not opening_of(SCENARIOS_FOLDER, contents, *seats).missing for seats in seats_of(scenario))


@functools.cache
def _shipped() -> dict[str, Scenario]:
    folder = SCENARIOS_FOLDER
    return {name: load(folder / f"{name}.yaml").scenario for name in names_in(folder)}
