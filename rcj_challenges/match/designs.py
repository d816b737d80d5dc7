"""Designs of teams become kits of the scenario that is played."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import PurePosixPath
from typing import Any

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.scenario.designs import ROBOT_FILE, Verdict, judge_designs
from rcj_challenges.scenario.kits import kit_of
from rcj_challenges.scenario.load import Loaded, load_resolved
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.team import SuperTeam, Team


@dataclass
class Brought:
    """The kits that a team brings along: their data by name, that of each robot, and the verdicts on its files."""

    kits: dict[str, dict[str, Any]] = field(default_factory=dict)
    robots: list[str] = field(default_factory=list)
    verdicts: list[Verdict] = field(default_factory=list)

    @property
    def problems(self) -> list[Diagnostic]:
        """All that is wrong."""
        return [problem for verdict in self.verdicts for problem in verdict.problems]


def brought_by(team: Team | SuperTeam, seat: str, scenario: Scenario) -> Brought | None:
    """The designs of a team for a seat; None if it has none, or they do not count there."""
    entrant, brought = scenario.entrants[seat], Brought()
    guideline = scenario.guidelines.get(entrant.design or "")
    if guideline is None:
        return None
    verdicts: dict[bytes, Verdict] = {}
    ball_m = max((ball.radius_m for ball in scenario.balls.values()), default=0.0)
    for number, robot in enumerate(entrant.robots):
        data, kit = team.driving(number).files.get(PurePosixPath(ROBOT_FILE)), kit_of(scenario, robot)
        if data is None:
            brought.robots.append(scenario.robots[robot].kit)
            continue
        kept = {name: device for name, device in kit.devices.items() if name in guideline.keeps}
        if data not in verdicts:
            verdicts[data] = judge_designs(data, guideline, len(entrant.robots), ball_m, kept)
        verdict = verdicts[data]
        if verdict.problems:
            continue
        name = verdict.robots[number]
        design, label = verdict.designs[name], f"design_{seat}_{list(verdicts).index(data) + 1}_{name}"
        made = kit.model_copy(update={"chassis": design.chassis, "devices": kept | design.devices})
        label = next((known for known, data in brought.kits.items() if data == made.model_dump(mode="json")), label)
        brought.kits[label] = made.model_dump(mode="json", by_alias=True)
        brought.robots.append(label)
    brought.verdicts = list(verdicts.values())
    return brought if verdicts else None


def with_designs(loaded: Loaded, teams: Mapping[str, Team | SuperTeam]) -> Loaded:
    """Return a scenario with the kits that teams, by seat of the first half, bring along.

    Raises:
        DiagnosticError: a design is not as the guidelines demand, with all that is wrong.
    """
    found = {seat: brought_by(team, seat, loaded.scenario) for seat, team in teams.items()}
    brought = {seat: one for seat, one in found.items() if one is not None}
    problems = [problem for one in brought.values() for problem in one.problems]
    if problems:
        raise DiagnosticError(*problems)
    if not brought:
        return loaded
    made = load_resolved(_added(loaded.resolved, brought), loaded.name)
    unresolved = _added(loaded.unresolved, brought) if loaded.unresolved else {}
    return replace(loaded, scenario=made.scenario, roster=made.roster, resolved=made.resolved, unresolved=unresolved)


def _added(data: Mapping[str, Any], brought: Mapping[str, Brought]) -> dict[str, Any]:
    kits = {name: kit for one in brought.values() for name, kit in one.kits.items()}
    entrants = {
        seat: entrant | ({"kits": brought[seat].robots} if seat in brought else {})
        for seat, entrant in data["entrants"].items()
    }
    return {**data, "kits": {**data["kits"], **kits}, "entrants": entrants}
