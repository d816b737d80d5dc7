"""Recognizes programs that expect other packets than the referee sends here."""

from __future__ import annotations

import re
import struct
from collections.abc import Mapping
from typing import Any

from rcj_challenges.checker.advice.crash_site import crash_code, programs
from rcj_challenges.checker.advice.table import Hint
from rcj_challenges.checker.others import others_that_fit, suggest_scenarios
from rcj_challenges.controllers.team import Team
from rcj_challenges.scenario.models.scenario import Scenario

_MESSAGES_2021 = "2021"
_FIRST_TICKS = 8  # a program that misreads the referee's packets does so with the first of them
_OTHER_SIZE = re.compile(r"struct\.error: unpack requires a buffer of (?P<bytes>[0-9]{1,9}) bytes")
_MATCH_PACKETS_OF_2021 = (struct.calcsize("20d?"), struct.calcsize("20d"))
_READS_JSON, _READS_FILE = re.compile(r"\bloads\b"), re.compile(r"\b(open|read|read_text|read_bytes)\(")
_READS_PACKET = re.compile(rb"\.(getData|getString|getBytes|data|string|bytes)\b")
_KNOWS_JSON = re.compile(rb"\bjson\.loads\b|\bfrom json import\b")
# The byte of v2.1: by its format, or as the first of the packet. A letter alone counts as a format only where one is
# read: nearly all programs compare their colour with "B".
_READS_A_FLAG = re.compile(
    rb"""["'](?:[<>=!@]?\?|[<>=!@][bBc])["']|(?:unpack\w*\(|Struct\(|(?i:fmt|format)\w*\s*=)\s*["'][bBc]["']"""
    rb"""|\.(?:getData|getBytes|data|bytes)(?:\(\))?\s*\[0\]"""
)
_HEARS_THE_REFEREE = re.compile(rb"\bsupervisor\b")
_BYTES_EXPECTED = re.compile(
    r"a bytes-like object is required, not 'str'|'str' object has no attribute 'decode'|of 1 bytes"
)
_TEXT_OF_BYTES = re.compile(r"\.(getData|getString)\(")


def packet_hint(scenario: Scenario, team: Team, fault: Mapping[str, Any]) -> Hint | None:
    """Return the hint for a crash over the referee's packets; None if it is not one.

    Args:
        scenario: what was played.
        team: whose program crashed.
        fault: as in the result.
    """
    if not 0 < fault["tick"] <= _FIRST_TICKS:
        return None
    kit, detail = scenario.robots[fault["robot"]].kit, fault["detail"]
    size = _OTHER_SIZE.search(detail)
    wanted_bytes = int(size["bytes"]) if size is not None else 0
    messages = scenario.kits[kit].messages
    if messages == _MESSAGES_2021:
        return _hint_of_2021(scenario, team, kit, wanted_bytes)
    if not _mentions(team, _HEARS_THE_REFEREE):
        return None
    return _hint_since_2022(team, kit, messages, detail, wanted_bytes)


def _hint_since_2022(team: Team, kit: str, messages: str, detail: str, wanted_bytes: int) -> Hint | None:
    code = crash_code(detail, team.files)
    if messages == "v2.1" and wanted_bytes in _MATCH_PACKETS_OF_2021:
        remedy = (
            'the packet here is one byte, whether a kick-off is pending: struct.unpack("?", receiver.getData()). gps, '
            "compass and ball receiver say where you and the ball are"
        )
        return Hint("packets_of_2021", remedy, ": this program reads the referee's packets of 2021")
    if messages == "v2.1" and "JSONDecodeError" in detail and "(char 0)" in detail and _reads_json(team, code):
        return _other_messages(kit, "v2.2", 'struct.unpack("?", receiver.getData())')
    if messages == "v2.2" and _expects_bytes(team, detail, code):
        return _other_messages(kit, "v2.1", "json.loads(receiver.getData()), and bytes of your own with getBytes()")
    return None


def _other_messages(kit: str, wanted: str, read: str) -> Hint:
    remedy = (
        "the referee's packet is one byte in messages v2.1, and JSON in v2.2: if your tournament uses "
        f'{wanted}, play with "--set kits.{kit}.messages={wanted}" (check and run); else read it with {read}'
    )
    return Hint("other_messages", remedy, f": this program seems to be written for messages {wanted}")


def _reads_json(team: Team, code: str) -> bool:
    reads_json = _READS_JSON.search(code) is not None and _READS_FILE.search(code) is None
    return reads_json and _mentions(team, _READS_PACKET) and not _mentions(team, _READS_A_FLAG)


def _expects_bytes(team: Team, detail: str, code: str) -> bool:
    if _mentions(team, _KNOWS_JSON) and not _mentions(team, _READS_A_FLAG):
        return False  # it reads the referee's JSON, so other bytes failed
    if detail.startswith("UnicodeDecodeError: "):
        return _TEXT_OF_BYTES.search(code) is not None
    return _BYTES_EXPECTED.search(detail) is not None and _mentions(team, _READS_PACKET)


def _hint_of_2021(scenario: Scenario, team: Team, kit: str, wanted_bytes: int) -> Hint | None:
    """Return the hint for a packet of 2021 with or without its last byte, or with other robots in it."""
    listed, has_flag = scenario.kits[kit].packet_lists, scenario.kits[kit].packet_has_flag
    here_bytes = _packet_bytes(scenario, kit, has_flag=has_flag)
    if wanted_bytes in (0, here_bytes):
        return None
    if wanted_bytes == _packet_bytes(scenario, kit, has_flag=not has_flag):
        here, there = ("with", "without") if has_flag else ("without", "with")
        remedy = (
            f"the packet here has {here_bytes} bytes {here} waiting_for_kickoff at its end: if your tournament uses "
            f'the other one, play with "--set kits.{kit}.packet_has_flag={str(not has_flag).lower()}" (check and run); '
            f'else {"add" if has_flag else "leave out"} the "?" at the end of the format'
        )
        message = f": this program seems to be written for packets {there} waiting_for_kickoff"
        return Hint("packet_flag", remedy, message)
    others = others_that_fit(team.files, scenario, lambda other: wanted_bytes in _all_packet_bytes(other))
    robots = f'"ddd" * {len(listed)} + ' if listed else ""
    holds = [f"x, y and orientation of {', '.join(listed)}"] * bool(listed)
    holds += [f"x and y of {', '.join(scenario.balls)}"] * bool(scenario.balls) + ["waiting_for_kickoff"] * has_flag
    elsewhere = f"{suggest_scenarios(others)}; " if others else ""
    remedy = (
        f"{elsewhere}here that packet has {here_bytes} bytes: struct.unpack({robots}"
        f'"{"dd" * len(scenario.balls)}{"?" * has_flag}", packet) gives {"; ".join(holds)}'
    )
    return Hint("other_packets", remedy, ": this program reads other packets than the referee sends here")


def _all_packet_bytes(scenario: Scenario) -> list[int]:
    kits = {name: scenario.kits[name] for name in {robot.kit for robot in scenario.robots.values()}}
    return [
        _packet_bytes(scenario, name, has_flag=kit.packet_has_flag)
        for name, kit in kits.items()
        if kit.messages == _MESSAGES_2021
    ]


def _packet_bytes(scenario: Scenario, kit: str, *, has_flag: bool) -> int:
    numbers = 3 * len(scenario.kits[kit].packet_lists) + 2 * len(scenario.balls)
    return struct.calcsize(f"{numbers}d{'?' * has_flag}")


def _mentions(team: Team, words: re.Pattern[bytes]) -> bool:
    return any(words.search(content) for content in programs(team.files))
