"""What programs receive from the referee and can send to it, for a rule sheet."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator, Mapping

from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.messages import MAX_CHARACTERS
from rcj_challenges.core.timing import TICK_MS
from rcj_challenges.devices.supervisor_receiver import SupervisorReceiverDevice
from rcj_challenges.robots.channels import entrant_of, listening_channels
from rcj_challenges.rules.base import ValueWord
from rcj_challenges.rules.phrasing import listed, plain
from rcj_challenges.rules.values import Value, value_words
from rcj_challenges.scenario.kits import devices_of, referee_listens, robots_with_emitter
from rcj_challenges.scenario.models.robots import Kit
from rcj_challenges.scenario.models.scenario import Broadcast, Scenario
from rcj_challenges.views.sheet.document import Block, Items, Section, Table
from rcj_challenges.views.sheet.phrasebook import Phrasebook
from rcj_challenges.views.sheet.robots import has

_FLAG_PACKETS = {
    "v2.1": 'It is one byte, whether a kick-off is awaited; Python unpacks it with struct.unpack("?", packet).',
    "v2.2": 'It is JSON text: {"waiting_for_kickoff": true} while a kick-off is awaited, otherwise false stands in it.',
}
"""The packets that hold nothing but the flag, by the kit's messages."""

_DISTINCTION = {
    # A number of 8 bytes may begin with any of them, also with that of "{"; what it ends with is not a letter.
    False: 'A packet for which packet.endswith(b"}") is true is that object, any other the official one.',
    True: "That with the key “waiting_for_kickoff” is the official packet, the other one is that object.",
}
"""How programs distinguish the broadcast from the official packet: whether both are JSON text."""


def program_sections(scenario: Scenario, phrases: Phrasebook) -> Iterator[Section]:
    """Yield the sections about messages between programs and the referee."""
    yield Section("What programs receive", tuple(_received(scenario, phrases)))
    if sent := tuple(_sent(scenario, phrases)) if referee_listens(scenario) else ():
        yield Section("What programs can send to the referee", sent)


def _received(scenario: Scenario, phrases: Phrasebook) -> Iterator[Block]:
    driven = grouped((scenario.robots[name].kit, name) for name in entrant_of(scenario))
    receiving = (name for name in entrant_of(scenario) if has(scenario, name, SupervisorReceiverDevice))
    hearing = grouped((scenario.robots[name].kit, name) for name in receiving)
    if not hearing:
        yield "No robot has a receiver of the referee's packets."
    for kit_name, robots in hearing.items():
        is_every = robots == driven[kit_name]
        receivers = f"each robot with the kit {kit_name}" if is_every else listed([*map(plain, robots)], "and")
        yield from _packet(scenario.kits[kit_name], receivers, phrases)
    if hearing and scenario.broadcast is not None:
        yield from _broadcast(scenario.broadcast, [scenario.kits[name] for name in hearing], phrases)


def _packet(kit: Kit, receivers: str, phrases: Phrasebook) -> Iterator[Block]:
    often = f"The referee sends {receivers} a packet {_every(kit.packet_every_ticks)}."
    if kit.messages != "2021":
        yield f"{often} {_FLAG_PACKETS[kit.messages]}"
        return
    balls = tuple(phrases.scenario.balls)
    parts = [
        *(f"{plain(robot)}: X, Z, orientation" for robot in kit.packet_lists),
        *(f"{phrases.thing(ball)}: X, Z" for ball in balls),
        *(["True while a kick-off is awaited, False otherwise"] if kit.packet_has_flag else []),
    ]
    layout = "".join(
        (
            f"{3 * len(kit.packet_lists)}d" if kit.packet_lists else "",
            f"{2 * len(balls)}d" if balls else "",
            "?" if kit.packet_has_flag else "",
        )
    )
    if not parts:
        yield f"{often} It is empty."
        return
    yield Items(tuple(parts), f"{often} It holds, in this order:", numbered=True)
    yield (
        "X is the y of this sheet, Z is its x, both in m. The orientation is the way the robot looks, in rad "
        "counter-clockwise from +x, from -π to π. What is off the field has coordinates far outside its walls. Python "
        f'unpacks the {struct.calcsize(layout)} bytes with struct.unpack("{layout}", packet).'
    )


def _broadcast(broadcast: Broadcast, kits: list[Kit], phrases: Phrasebook) -> Iterator[Block]:
    every, to = _every(broadcast.every_ticks), "" if broadcast.fields else " for some robots"
    if all(broadcast.every_ticks % kit.packet_every_ticks == 0 for kit in kits):
        yield f"After the referee's packet, {every}, one JSON object follows on the same channel{to}:"
    else:
        # It is made on a tick on which the official packet may be missing; then it waits, and a newer one replaces it.
        yield f"One JSON object is made {every}; the newest follows the next packet{to}, on its channel:"
    if broadcast.fields:
        yield _values(broadcast.fields, phrases)
    for name, fields in (broadcast.only or {}).items():
        if fields:
            yield f"Only for {phrases.all_of(name).text}; here a key replaces the same one above:"
            yield _values(fields, phrases)
    yield from (_DISTINCTION[both] for both in sorted({kit.messages == "v2.2" for kit in kits}))


def _values(fields: Mapping[str, Value], phrases: Phrasebook) -> Table:
    rows = (
        (
            key,
            json.dumps(entry, ensure_ascii=False)
            if isinstance(entry, str | int | float)
            else value_words(phrases, entry) + _exactly(phrases, entry),
        )
        for key, entry in fields.items()
    )
    return Table(("key", "value"), tuple(rows))


def _exactly(phrases: Phrasebook, entry: object) -> str:
    """Return the exact values that a program compares with, or that a list holds."""
    exactly = entry.exactly(phrases) if isinstance(entry, ValueWord) else ""
    if not isinstance(exactly, str):
        # As JSON, since 1 and true are one to Python.
        exactly = listed(list(dict.fromkeys(json.dumps(one, ensure_ascii=False) for one in exactly)), "or")
    return exactly and f": {exactly}"


def _sent(scenario: Scenario, phrases: Phrasebook) -> Iterator[Block]:
    by_channels = grouped(
        (listening_channels(scenario, devices_of(scenario, name).values()), name)
        for name in robots_with_emitter(scenario)
    )
    for channels, names in by_channels.items():
        if not channels:
            continue
        senders, where = phrases.all_of(tuple(names)).text, listed([str(channel) for channel in channels], "or")
        yield (
            f"The referee receives what {senders} {'sends' if len(names) == 1 else 'send'} with the team emitter on "
            f"channel {where}: text of up to {MAX_CHARACTERS} characters, or one or two numbers. In a tick it receives "
            "one message of each robot, the tick after it is sent at the earliest; other robots do not receive it. In "
            "Python: "
            f'emitter.setChannel({channels[0]}), emitter.send("…"), then back to the own channel.'
        )


def _every(ticks: int) -> str:
    return f"every {ticks * TICK_MS} ms"
