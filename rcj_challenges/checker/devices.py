"""Devices that the programs of a team asked for in vain, as findings."""

from __future__ import annotations

from rcj_challenges.checker.advice.devices import DeviceAdvice, missing_devices
from rcj_challenges.checker.findings import Finding, StageName
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed
from rcj_challenges.facts.shown import shown

Asked = dict[tuple[str, str], list[str]]
"""Robots by the name that they asked for in vain, and by what they have."""

_MOST_DEVICES = 10


def asked_by_robots(match: Rehearsed) -> Asked:
    """Return what the robots of the team asked for in vain in a match."""
    asked: Asked = {}
    for robot in match.motions:
        for found in missing_devices(match.log(robot)).items():
            asked.setdefault(found, []).append(robot)
    return asked


def device_findings(stage: StageName, asked: Asked, rehearsal: Rehearsal, side: str = "") -> list[Finding]:
    """Return a warning for each device that a program asked for in vain.

    Args:
        stage: in which it was found.
        asked: what was asked for.
        rehearsal: what was to be played.
        side: where the team played, as the message begins.
    """
    instead = DeviceAdvice(rehearsal.loaded.scenario, rehearsal.team, [name for name, _ in asked])
    findings = []
    for (name, has), robots in list(asked.items())[:_MOST_DEVICES]:
        message = f'{side}asks for a device "{shown(name)}"; there is none'
        if made_for := instead.made_for(name):
            message += f": {made_for}"
        remedy = instead.remedy(name, robots[0], has)
        findings.append(Finding(f"{stage}.no_device", "warning", message, remedy, ", ".join(robots)))
    return findings
