"""What is behind a fault: a program for other messages or of older days, a file never read, a wait without end."""

from __future__ import annotations

import re
import struct
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Any

from rcj_challenges.checker.advice.asked_of_the_system import on_system
from rcj_challenges.checker.advice.crash_lines import OF_NONE
from rcj_challenges.checker.advice.early_ends import why_it_ended
from rcj_challenges.checker.advice.no_device import InsteadOf, asked_in_vain, behind_none, ignored_calls
from rcj_challenges.checker.advice.old_names import on_old_name
from rcj_challenges.checker.advice.slips import NOTHING_THERE, on_slip
from rcj_challenges.checker.modules import COMPILED, Library, places_of
from rcj_challenges.checker.not_given import on_not_given
from rcj_challenges.checker.others import looks_like, others_that_fit
from rcj_challenges.checker.preloaded import never_read
from rcj_challenges.controllers.log import AFTER_ITS_END, ANOTHER_THREAD
from rcj_challenges.controllers.team import Team
from rcj_challenges.facts.shown import shown
from rcj_challenges.scenario.models.scenario import Scenario

WHEREABOUTS = "It was here, the innermost call first:\n"
"""What the match writes into a program's log when it had to end it."""

_MESSAGES_2021 = "2021"
_FIRST_TICKS = 8  # who misreads the referee's packets does so with the first of them
_MOST_CODE_LETTERS = 80
_MOST_CODE_BYTES = 500  # of a line that is looked at: in a longer one the search could take for ever

_PLACE = re.compile(r'^  File "(?P<file>[^"]+)", line (?P<line>[0-9]{1,7})\b', re.MULTILINE)
_BYTE_READ_AS_JSON = re.compile(r"JSONDecodeError: .*\(char 0\)")
_TEXT_READ_AS_BYTES = re.compile(r"a bytes-like object is required, not 'str'|'str' object has no attribute 'decode'")
_BYTES_READ_AS_TEXT = re.compile(r"UnicodeDecodeError: ")
_OTHER_SIZE = re.compile(r"struct\.error: unpack requires a buffer of (?P<bytes>[0-9]{1,9}) bytes")
_PACKETS_OF_2021 = (struct.calcsize("20d?"), struct.calcsize("20d"))
"""Bytes of a match's packet: three numbers for each of six robots, two for the ball, a flag but in the first demo."""
_READS_JSON, _READS_FILE = re.compile(r"\bloads\b"), re.compile(r"\b(open|read|read_text|read_bytes)\(")
_READS_PACKET = re.compile(rb"\.(getData|getString|getBytes|data|string|bytes)\b")
_READS_AS_TEXT = re.compile(r"\.(getData|getString)\(")
_KNOWS_JSON = re.compile(rb"\bjson\.loads\b|\bfrom json import\b")
# The byte of v2.1: by its format, or as the first of the packet.
# A letter alone is a format only where one is read: nearly all programs compare their colour with "B".
_READS_A_FLAG = re.compile(
    rb"""["'](?:[<>=!@]?\?|[<>=!@][bBc])["']|(?:unpack\w*\(|Struct\(|(?i:fmt|format)\w*\s*=)\s*["'][bBc]["']"""
    rb"""|\.(?:getData|getBytes|data|bytes)(?:\(\))?\s*\[0\]"""
)
_HEARS_THE_REFEREE = re.compile(rb"\bsupervisor\b")  # the name of its receiver may be made of parts
_NO_SUCH_NAME = re.compile(r"cannot import name '(?P<name>\w+)' from (partially initialized module )?'(?P<module>\w+)'")
_NO_SUCH_MODULE = re.compile(r"No module named '(?:\w+\.)*(?P<module>\w+)'")
_NO_SUCH_ATTRIBUTE = re.compile(r"module '(?P<module>\w+)' has no attribute '(?P<name>\w+)'")
_NO_SUCH_KEY = re.compile(r"^KeyError: '(?P<key>\w{1,100})'")
_CAME_TO_ITS_END = "the program came to its end"
_CALLED_EXIT = "the program called sys.exit"
_LATER = (
    "leave out exit(), quit() and sys.exit(), or call them only after step has returned -1: "
    "the robot of a program that ends stands for the rest of the half"
)
_THREADS_ALONE = (
    "the program itself came to its end, and only its threads go on: let one of them call robot.step(32) in a loop, or "
    "keep that loop in the program itself"
)
_NO_REFEREE = "only a referee is told where things are; a player asks its own devices (gps, compass, ball receiver)"
_NOBODY_TYPES = "EOFError: EOF when reading a line"
# Calls of Python's own library that come back only when something else happens. ``wait`` and the like stand here with
# empty brackets or a time: what a team calls so itself, or ``", ".join(…)``, is none.
_WAITS = re.compile(
    r"\basyncio\.run\(|\.run_until_complete\(|\.run_forever\(|\bselect\(|\binput\("
    r"|\.(?:wait|join|get|acquire|result|readline)\(\s*(?:timeout\s*=.*|[\d.]+\s*)?\)"
)
# Who imports threading and starts none has one thread, as nearly all programs.
_STARTS_THREADS = re.compile(rb"\b(?:Thread|Timer|ThreadPool\w*|concurrent|_thread)\b")


@dataclass(frozen=True)
class Hint:
    """What is behind a fault.

    Attributes:
        remedy: what to do.
        message: what follows on the message of the fault; mostly empty.
    """

    remedy: str
    message: str = ""


def hint_on(
    scenario: Scenario, team: Team, fault: dict[str, Any], whereabouts: str, sandbox: str = "auto"
) -> Hint | None:
    """Return what is behind a fault, where the evidence is clear.

    Args:
        scenario: what was played.
        team: whose program failed.
        fault: as in the result.
        whereabouts: where the program was when it was ended; empty if that is not known.
        sandbox: ``auto``, ``strict`` or ``off``, as it was started.
    """
    if fault["kind"] in ("step_timeout", "start_timeout") and whereabouts:
        return _on_place(team, fault["kind"], whereabouts)
    return hint_at_once(scenario, team, fault, sandbox)


def hint_at_once(scenario: Scenario, team: Team, fault: Mapping[str, Any], sandbox: str | None = None) -> Hint | None:
    """Return what is behind a program that crashed or ended, as far as its own words and lines tell it.

    Args:
        scenario: what was played.
        team: whose program failed.
        fault: as in the result.
        sandbox: how to start a program that finds out which modules hide others; None starts nothing.
    """
    if fault["kind"] == "crash":
        outside = on_messages(scenario, team, fault) or on_files(team, fault)
        names = outside or _on_names(team, fault, sandbox)
        return names or _on_typing(fault["detail"]) or _on_system(team, fault) or _on_slip(scenario, team, fault)
    if fault["kind"] == "exit" and fault["detail"].startswith(_CAME_TO_ITS_END):
        entry = team.entries.get(fault["robot"])
        has_stepped = fault["tick"] > 0
        remedy = why_it_ended(team.files, PurePosixPath(entry), has_stepped=has_stepped) if entry is not None else ""
        return Hint(remedy) if remedy else None
    if fault["kind"] == "exit" and fault["detail"].startswith(_CALLED_EXIT):
        return Hint(_LATER)
    return None


def on_messages(scenario: Scenario, team: Team, fault: Mapping[str, Any]) -> Hint | None:
    """Return what is behind a crash of a program that was written for other packets than the referee sends here."""
    kit = scenario.robots[fault["robot"]].kit
    messages, detail = scenario.kits[kit].messages, fault["detail"]
    if not 0 < fault["tick"] <= _FIRST_TICKS:
        return None
    if messages == _MESSAGES_2021:
        return _on_flag(scenario, kit, detail) or _on_lists(scenario, team, kit, detail)
    if not _any_mentions(team, _HEARS_THE_REFEREE):
        return None
    code = _code(team, _places(fault["traceback"]))
    if messages == "v2.1" and _BYTE_READ_AS_JSON.search(detail) and _is_packet_read_as_json(team, code):
        return Hint(
            "the referee's packet here is one byte (messages v2.1), your program reads JSON (v2.2): if that is what "
            f'your tournament uses, play with "--set kits.{kit}.messages=v2.2" (check and run); else read it with '
            'struct.unpack("?", receiver.getData())',
            ": this program seems to be written for messages v2.2",
        )
    if messages == "v2.2" and _is_text_read_as_bytes(team, detail, code):
        return Hint(
            "getData() gives text here and the referee's packet is JSON (messages v2.2), your program reads bytes "
            f'(v2.1): if that is what your tournament uses, play with "--set kits.{kit}.messages=v2.1"; else read '
            "that packet with json.loads(receiver.getData()), and bytes of your own with getBytes()",
            ": this program seems to be written for messages v2.1",
        )
    return _on_positions(detail) if messages == "v2.1" else None


def on_none(scenario: Scenario, team: Team, fault: Mapping[str, Any], log: str) -> Hint | None:
    """Return what is behind a crash over None: what was given for a device, or as a player is no referee, or else.

    Args:
        scenario: what was played.
        team: whose program failed.
        fault: as in the result.
        log: of the robot, or its beginning.
    """
    asked = asked_in_vain(log)
    if fault["kind"] != "crash" or OF_NONE.search(fault["detail"]) is None:
        return None
    given = behind_none(fault["detail"], team, asked, ignored_calls(log))
    if given is None:
        return Hint(NOTHING_THERE)
    if not given.devices:
        return Hint(f"{given.told}: {_NO_REFEREE}")
    instead, name = InsteadOf(scenario, team, asked), given.devices[-1]
    made_for = f"{told}; " if (told := instead.made_for(name)) else ""
    remedies = {one: instead.remedy(one, fault["robot"], asked[one]) for one in given.devices}
    remedy = remedies[name] if len(remedies) == 1 or made_for else f"these robots have: {shown(asked[name], 400)}"
    return Hint(f"{given.told}: {made_for}{remedy}")


def on_files(team: Team, fault: Mapping[str, Any]) -> Hint | None:
    """Return what is behind a crash of a program that was given without the folder in which it lies."""
    remedy = on_not_given(team, fault["detail"])
    return Hint(remedy) if remedy else None


def _on_flag(scenario: Scenario, kit: str, detail: str) -> Hint | None:
    """Tell of a program that reads the packets of 2021 with their last byte where they have none, or the other way."""
    told = scenario.kits[kit]
    numbers = 3 * len(told.packet_lists) + 2 * len(scenario.balls)
    sizes = {has_flag: struct.calcsize(f"{numbers}d{'?' * has_flag}") for has_flag in (True, False)}
    found = _OTHER_SIZE.search(detail)
    if found is None or int(found["bytes"]) != sizes[not told.packet_has_flag]:
        return None
    here, there = ("with", "without") if told.packet_has_flag else ("without", "with")
    first_demo = " (as in the first demo of 2021)" if told.packet_has_flag else ""
    return Hint(
        f"the referee's packet has {found['bytes']} bytes {there} waiting_for_kickoff at its end{first_demo}, and "
        f"{sizes[told.packet_has_flag]} {here} it, as here: if your tournament uses the other one, play with "
        f'"--set kits.{kit}.packet_has_flag={str(not told.packet_has_flag).lower()}" (check and run); else '
        f'{"add" if told.packet_has_flag else "leave out"} the "?" at the end of the format',
        f": this program seems to be written for packets {there} waiting_for_kickoff",
    )


def _kits_of_2021(scenario: Scenario) -> set[str]:
    kits = {robot.kit for robot in scenario.robots.values()}
    return {kit for kit in kits if scenario.kits[kit].messages == _MESSAGES_2021}


def _packet_bytes(scenario: Scenario, kit: str) -> int:
    """Return how long the referee's packets are to robots of 2021."""
    told = scenario.kits[kit]
    numbers = 3 * len(told.packet_lists) + 2 * len(scenario.balls)
    return struct.calcsize(f"{numbers}d{'?' * told.packet_has_flag}")


def _on_lists(scenario: Scenario, team: Team, kit: str, detail: str) -> Hint | None:
    """Tell of a program that reads packets of 2021 which list others: each challenge lists its own robots."""
    told, balls, found = scenario.kits[kit], tuple(scenario.balls), _OTHER_SIZE.search(detail)
    listed, flag, size = told.packet_lists, "?" * told.packet_has_flag, _packet_bytes(scenario, kit)
    wanted = int(found["bytes"]) if found is not None else size
    if wanted == size:
        return None  # it asks for these, and was given what a challenge tells beside them
    others = others_that_fit(
        team.files, scenario, lambda other: any(_packet_bytes(other, one) == wanted for one in _kits_of_2021(other))
    )
    meant = f"{looks_like(others)}; " if others else ""
    form = (f'"ddd" * {len(listed)} + ' if listed else "") + f'"{"dd" * len(balls)}{flag}"'
    of_robots = [f"x, y and orientation of {', '.join(listed)}"] * bool(listed)
    of_balls = [f"x and y of {'the ball' if len(balls) == 1 else ', '.join(balls)}"] * bool(balls)
    return Hint(
        f"{meant}here that packet has {size} bytes: struct.unpack({form}, packet) "
        f"gives {'; '.join([*of_robots, *of_balls, *['waiting_for_kickoff'] * told.packet_has_flag])}",
        ": this program reads other packets than the referee sends here",
    )


def _on_positions(detail: str) -> Hint | None:
    """Tell of a program for today's robots that still reads the packets of a match of 2021."""
    found = _OTHER_SIZE.search(detail)
    if found is None or int(found["bytes"]) not in _PACKETS_OF_2021:
        return None
    return Hint(
        "those told where everybody is; the referee's packet here is one byte, whether a kick-off is waited for: "
        'struct.unpack("?", receiver.getData()). Where you and the ball are, gps, compass and ball receiver tell',
        ": this program reads the referee's packets of 2021",
    )


def _is_packet_read_as_json(team: Team, code: str) -> bool:
    """Return whether a line reads JSON that is no file, in programs that read packets, but no packet of v2.1."""
    reads_json = _READS_JSON.search(code) is not None and _READS_FILE.search(code) is None
    return reads_json and _any_mentions(team, _READS_PACKET) and not _any_mentions(team, _READS_A_FLAG)


def _is_text_read_as_bytes(team: Team, detail: str, code: str) -> bool:
    """Return whether a fault comes of text where bytes were meant, or of bytes on the radio that are no text."""
    if _any_mentions(team, _KNOWS_JSON) and not _any_mentions(team, _READS_A_FLAG):
        return False  # it reads the referee's JSON: what fails are bytes of its own
    if _BYTES_READ_AS_TEXT.search(detail):
        return _READS_AS_TEXT.search(code) is not None
    size = _OTHER_SIZE.search(detail)
    if size is not None and size["bytes"] == "1":  # a flag: of the first ticks, that is the referee's
        return _any_mentions(team, _READS_PACKET)
    return _TEXT_READ_AS_BYTES.search(detail) is not None and _any_mentions(team, _READS_PACKET)


def _on_names(team: Team, fault: Mapping[str, Any], sandbox: str | None) -> Hint | None:
    """Tell of a name that a module does not have: the match's own, one that a file of the team hides, an older one."""
    detail = fault["detail"]
    found = _NO_SUCH_NAME.search(detail) or _NO_SUCH_ATTRIBUTE.search(detail)
    module = found["module"] if found is not None else ""
    if found is not None and module == "controller":
        return _on_controller(team, found["name"])
    if module in sys.stdlib_module_names and _own(team, module):
        return (
            None
            if sandbox is None
            else _on_own_file(team, module, PurePosixPath(team.entries[fault["robot"]]), sandbox)
        )
    compiled = _compiled_otherwise(team, detail)
    if compiled:
        return Hint(compiled)
    remedy = on_old_name(detail, lambda words: _any_mentions(team, words))
    return Hint(remedy) if remedy else None


def _compiled_otherwise(team: Team, detail: str) -> str:
    """Return what to do about a module that is there, but compiled for another Python; empty if it is none."""
    found = _NO_SUCH_MODULE.search(detail)
    name = found["module"] if found is not None else ""
    for path in team.files:
        if name and path.suffix in COMPILED and path.name.partition(".")[0] == name:
            return (
                f"{shown(path)} was compiled for one version of Python on one system, and not for this one: hand in "
                f"what it was made of ({name}.py), or do without it"
            )
    return ""


def _on_controller(team: Team, name: str) -> Hint:
    own = _own(team, "controller")
    remedy = f'"controller" is the module of the match, and has no "{shown(name)}"'
    if own:
        remedy += f": give {shown(own[0])} another name, and import it by that"
    return Hint(remedy)


def _on_own_file(team: Team, module: str, entry: PurePosixPath, sandbox: str) -> Hint | None:
    """Tell of a file that is called like a module of Python: it is never read, or it hides that module."""
    unread = never_read(team.files, entry, sandbox).get(module)
    if unread is not None:
        return Hint(
            f"{shown(unread)} is never read, for Python has a module of that name loaded before: give it another name, "
            "and import it by that"
        )
    hiding = [path for path in Library(team.files, places_of(entry)).shadows() if path.stem == module]
    if not hiding:
        return None
    return Hint(f'{shown(hiding[0])} hides the module "{module}" of Python from your programs: give it another name')


def _own(team: Team, module: str) -> list[PurePosixPath]:
    """Return the files of a team that are called like a module."""
    return [path for path in team.files if path.name == f"{module}.py" or path.match(f"{module}/__init__.py")]


def _on_typing(detail: str) -> Hint | None:
    if not detail.startswith(_NOBODY_TYPES):
        return None
    return Hint("nobody types in a match: do without input(), and write into the program what it asks for")


def _on_system(team: Team, fault: Mapping[str, Any]) -> Hint | None:
    entry = team.entries.get(fault["robot"])
    remedy = on_system(fault["detail"], PurePosixPath(entry), team.files) if entry is not None else ""
    return Hint(remedy) if remedy else None


def _on_slip(scenario: Scenario, team: Team, fault: Mapping[str, Any]) -> Hint | None:
    remedy = on_slip(fault["detail"], team.files) or _on_own_name(scenario, team, fault)
    return Hint(remedy) if remedy else None


def _on_own_name(scenario: Scenario, team: Team, fault: Mapping[str, Any]) -> str:
    """Tell of a program that looks something up by its robot's name, or its colour, and knows that of others only."""
    robot, found = fault["robot"], _NO_SUCH_KEY.match(fault["detail"])
    if found is None or found["key"] not in (robot, robot[0]):
        return ""
    key = found["key"]
    driven = [name for name in scenario.robots if team.entries.get(name) == team.entries.get(robot)]
    names = list(dict.fromkeys(name if key == robot else name[0] for name in driven))
    letter_of = "" if key == robot else f'the first letter of "{shown(robot)}", '
    own = f'"{shown(key)}" is {letter_of}this robot\'s own name'
    if len(names) == 1:
        return f"{own}: write an entry for it"
    colours = {scenario.robots[name].colour for name in driven}
    both = "the same program plays for both colours, " if len(colours) > 1 else ""
    return f"{own}: {both}write an entry for each (here {', '.join(names)})"


def _on_place(team: Team, kind: str, whereabouts: str) -> Hint | None:
    """Name the line in which a program was when its patience ended, and what it did there as far as it shows."""
    if AFTER_ITS_END in whereabouts.splitlines():
        return Hint(_THREADS_ALONE)
    place = next(_places(whereabouts), None)
    if place is None or ANOTHER_THREAD.strip() in whereabouts.splitlines() or _any_mentions(team, _STARTS_THREADS):
        return None  # of several threads nobody can say which one should have called step
    code = _code(team, iter([place]))
    where = f"line {place[1]} of {shown(place[0])}" + (f" ({shown(code, _MOST_CODE_LETTERS)})" if code else "")
    # A call of the team's own would have a line of its own, further in.
    if _WAITS.search(code):
        return Hint(
            f"the program was waiting in {where}, inside Python's own library, for what did not come: between two "
            "steps nothing arrives, so wait with robot.step(32)"
        )
    if kind == "start_timeout":
        return Hint(f"call robot.step(32) sooner: the program was in {where}; is there a loop, or long work?")
    return Hint(f"look for a loop that never calls robot.step(32): the program was in {where}")


def _places(report: str) -> Iterator[tuple[str, int]]:
    """Return files of the team and lines in them, in the order in which a report names them."""
    return ((found["file"], int(found["line"])) for found in _PLACE.finditer(report))


def _code(team: Team, places: Iterator[tuple[str, int]]) -> str:
    """Return the beginning of that line of a team's programs which is named last."""
    last = next(reversed(list(places)), None)
    content = team.files.get(PurePosixPath(last[0].replace("\\", "/"))) if last is not None else None
    if last is None or content is None:
        return ""
    lines = content.splitlines()  # of bytes: at the same places as Python does
    code = lines[last[1] - 1].strip() if 0 < last[1] <= len(lines) else b""
    return code[:_MOST_CODE_BYTES].decode("utf-8", "replace")


def _any_mentions(team: Team, words: re.Pattern[bytes]) -> bool:
    return any(path.suffix == ".py" and words.search(content) for path, content in team.files.items())
