"""Recognizes programs that expect other packets than the referee sends here."""

from __future__ import annotations

import re
import struct
from collections.abc import Mapping
from typing import Any

from rcj_challenges.scenario.kits import kit_of
from rcj_challenges.scenario.models.robots import Kit
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.team import Team

_FIRST_TICKS = 8  # a program that misreads the referee's packets does so with the first of them
_OTHER_SIZE = re.compile(r"struct\.error: unpack requires a buffer of (?P<bytes>[0-9]{1,9}) bytes")
_PACKET_ERROR = re.compile(
    r"\bstruct\.error: |JSONDecodeError: |^UnicodeDecodeError: |a bytes-like object is required, not 'str'"
    r"|'str' object has no attribute 'decode'"
)
_READS_THE_REFEREE = re.compile(rb"\bsupervisor\b")
_FORMS = {
    "v2.1": ("v2.2", 'one byte, whether a kick-off is pending: struct.unpack("?", receiver.getData())'),
    "v2.2": ("v2.1", "JSON: json.loads(receiver.getString())"),
}
"""By version of the messages: the other version, and how a packet is read."""


def packet_help(scenario: Scenario, team: Team, fault: Mapping[str, Any]) -> str:
    """Advice on a crash that probably comes from the referee's packets; empty on any other."""
    detail, name = fault["detail"], scenario.robots[fault["robot"]].kit
    if not 0 < fault["tick"] <= _FIRST_TICKS or not _PACKET_ERROR.search(detail):
        return ""
    kit = kit_of(scenario, fault["robot"])
    if kit.messages not in _FORMS:
        size = _OTHER_SIZE.search(detail)
        return _help_of_2021(scenario, name, kit, int(size["bytes"])) if size is not None else ""
    programs = (content for path, content in team.files.items() if path.suffix == ".py")
    if not any(map(_READS_THE_REFEREE.search, programs)):
        return ""
    other, form = _FORMS[kit.messages]
    return (
        f"if this line reads a packet of the referee: here that is {form}; if your tournament uses messages {other}, "
        f'play with "--set kits.{name}.messages={other}" (check and run)'
    )


def _help_of_2021(scenario: Scenario, name: str, kit: Kit, wanted_bytes: int) -> str:
    numbers, flag = 3 * len(kit.packet_lists) + 2 * len(scenario.balls), "?" * kit.packet_has_flag
    here_bytes = struct.calcsize(f"{numbers}d{flag}")
    if wanted_bytes == here_bytes:
        return ""
    robots = f'"ddd" * {len(kit.packet_lists)} + ' if kit.packet_lists else ""
    holds = [f"x, y and orientation of {', '.join(kit.packet_lists)}"] * bool(kit.packet_lists)
    holds += [f"x and y of {', '.join(scenario.balls)}"] * bool(scenario.balls) + ["waiting_for_kickoff"] * len(flag)
    return (
        f'the packet here has {here_bytes} bytes: struct.unpack({robots}"{"dd" * len(scenario.balls)}{flag}", packet) '
        f"gives {'; '.join(holds)}; if your tournament's packets have {'no' if flag else 'a'} waiting_for_kickoff, "
        f'play with "--set kits.{name}.packet_has_flag={str(not flag).lower()}" (check and run)'
    )
