"""Findings on devices that the programs of a team requested and their robots lack."""

from __future__ import annotations

from rcj_challenges.checker.advice.devices import DeviceAdvice, missing_devices
from rcj_challenges.checker.findings import NO_SUCH_DEVICE, Finding, StageName
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed
from rcj_challenges.core.sanitize import sanitize

MissingDevices = dict[tuple[str, str], list[str]]
"""Robots by the name of the device that they lack, and by what they have."""

_MAX_DEVICES = 10


def missing_by_device(match: Rehearsed) -> MissingDevices:
    """Return the devices that robots of the team lacked in a match."""
    missing: MissingDevices = {}
    for robot in match.motions:
        for found in missing_devices(match.log(robot)).items():
            missing.setdefault(found, []).append(robot)
    return missing


def device_findings(stage: StageName, missing: MissingDevices, rehearsal: Rehearsal, side: str = "") -> list[Finding]:
    """Return a warning for each missing device that a program requested.

    Args:
        stage: in which it was found.
        missing: the devices.
        rehearsal: what was to be played.
        side: where the team played, as the message begins.
    """
    advice = DeviceAdvice(rehearsal.loaded.scenario, rehearsal.team, [name for name, _ in missing])
    findings = []
    for (name, has), robots in list(missing.items())[:_MAX_DEVICES]:
        message = f'{side}asks for a device "{sanitize(name)}"{NO_SUCH_DEVICE}'
        if made_for := advice.made_for(name):
            message += f": {made_for}"
        remedy = advice.remedy(name, robots[0], has)
        findings.append(Finding(f"{stage}.no_device", "warning", message, remedy, ", ".join(robots)))
    return findings
