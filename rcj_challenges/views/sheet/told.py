"""What a rule sheet says about what programs are told: the referee's packets, the broadcast, the events in the log."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator, Mapping, Sequence

from rcj_challenges.devices.supervisor_receiver import SupervisorReceiverDevice
from rcj_challenges.facts.messages import MOST_LETTERS
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.robots.channels import entrant_of, listening_channels
from rcj_challenges.rules.actions.emit import Emit
from rcj_challenges.rules.fields import Scalar
from rcj_challenges.rules.phrasing import listed, plain
from rcj_challenges.rules.values import Value, value_words
from rcj_challenges.rules.values.draw import DrawValue
from rcj_challenges.rules.values.position_of import PositionValue
from rcj_challenges.rules.values.word import WordValue
from rcj_challenges.scenario.heard import referee_listens, robots_that_speak
from rcj_challenges.scenario.models.robots import Kit
from rcj_challenges.scenario.models.scenario import Broadcast, Scenario
from rcj_challenges.scenario.own_devices import devices_of
from rcj_challenges.views.sheet.blocks import Block, Heading, Items, Paragraph, Table
from rcj_challenges.views.sheet.machines import has
from rcj_challenges.views.sheet.nouns import Nouns
from rcj_challenges.views.sheet.spoken import spoken

_FLAG_PACKETS = {
    "v2.1": 'It is one byte, whether a kick-off is awaited; Python unpacks it with struct.unpack("?", packet).',
    "v2.2": 'It is JSON text: {"waiting_for_kickoff": true} while a kick-off is awaited, otherwise false stands in it.',
}
"""The packets that hold nothing but the flag, by the kit's messages."""


_TOLD_APART = {
    # A number of 8 bytes may begin with any of them, also with that of "{"; what it ends with is no letter.
    False: 'A packet for which packet.endswith(b"}") is true is that object, any other the official one.',
    True: "That with the key “waiting_for_kickoff” is the official packet, the other one is that object.",
}
"""How programs tell the broadcast from the official packet: whether both are JSON text."""


def told_blocks(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    """Return the sections about what programs are told, and what the log is told."""
    yield Heading(2, "What programs are told")
    kits = _kits_that_hear(scenario)
    if not kits:
        yield Paragraph("No robot has a receiver of the referee's packets.")
    for name, kit in kits.items():
        yield from _packet(name, kit, nouns)
    if kits and scenario.broadcast is not None:
        yield from _broadcast(scenario.broadcast, kits, nouns)
    if referee_listens(scenario):
        yield from _to_referee(scenario, nouns)
    yield from _events(scenario, nouns)


def _kits_that_hear(scenario: Scenario) -> dict[str, Kit]:
    """Return the kits of the driven robots that have a receiver of the referee's packets, by name."""
    driven = [name for name in entrant_of(scenario) if not scenario.robots[name].idle]
    used = {scenario.robots[name].kit for name in driven if has(scenario, name, SupervisorReceiverDevice)}
    return {name: kit for name, kit in scenario.kits.items() if name in used}


def _packet(name: str, kit: Kit, nouns: Nouns) -> Iterator[Block]:
    """Return what the official packet to the robots of a kit holds."""
    to_whom = f"robots of the kit {name}{_but_the_deaf(name, nouns)}"
    often = f"The referee sends {to_whom} a packet {_every(kit.packet_every_ticks)}."
    if kit.messages != "2021":
        yield Paragraph(f"{often} {_FLAG_PACKETS[kit.messages]}")
        return
    parts = tuple(_parts_2021(kit, nouns))
    if not parts:
        yield Paragraph(f"{often} It is empty.")
        return
    yield Paragraph(f"{often} It holds, in this order:")
    yield Items(parts, numbered=True)
    yield Paragraph(_reading_2021(kit, len(nouns.scenario.balls)))


def _but_the_deaf(kit: str, nouns: Nouns) -> str:
    """Return which robots of a kit do not hear the referee as others of it do: a device was taken from them alone."""
    scenario = nouns.scenario
    alike = [name for name in entrant_of(scenario) if scenario.robots[name].kit == kit]
    deaf = [plain(name) for name in alike if not has(scenario, name, SupervisorReceiverDevice)]
    have = "have" if len(deaf) > 1 else "has"
    return f", but for {listed(deaf, 'and')}, which {have} no receiver for it," if deaf else ""


def _parts_2021(kit: Kit, nouns: Nouns) -> Iterator[str]:
    robots, balls = kit.packet_lists, tuple(nouns.scenario.balls)
    if len(robots) > 1:
        yield f"for each of {listed([plain(name) for name in robots], 'and')}, one after the other: X, Z, orientation"
    elif robots:
        yield f"of {plain(robots[0])}: X, Z, orientation"
    if len(balls) > 1:
        yield f"for each of {listed([nouns.thing(name) for name in balls], 'and')}, one after the other: X, Z"
    elif balls:
        yield f"of {nouns.thing(balls[0])}: X, Z"
    if kit.packet_has_flag:
        yield "True while a kick-off is awaited, False otherwise"


def _reading_2021(kit: Kit, balls: int) -> str:
    """Return how the numbers are meant and unpacked, whatever of them the packet has."""
    robots = len(kit.packet_lists)
    numbers = "X is the y of this sheet, Z is its x, both in m. " if robots or balls else ""
    turned = (
        "The orientation is the way the robot looks, in rad counter-clockwise from +x, from -π to π. " if robots else ""
    )
    off = "What is off the field is told to be far outside its walls. " if robots or balls else ""
    counts = (f"{3 * robots}d" if robots else "", f"{2 * balls}d" if balls else "", "?" if kit.packet_has_flag else "")
    layout = "".join(counts)
    doubles = "Each number is a double of 8 bytes in native byte order. " if robots or balls else ""
    size = struct.calcsize(layout)
    whole = "its one byte" if size == 1 else f"the {size} bytes"
    flag = "" if kit.packet_has_flag else " The packet does not tell whether a kick-off is awaited."
    return f'{numbers}{turned}{off}{doubles}Python unpacks {whole} with struct.unpack("{layout}", packet).{flag}'


def _broadcast(broadcast: Broadcast, kits: dict[str, Kit], nouns: Nouns) -> Iterator[Block]:
    """Return when the broadcast comes and what is in it."""
    every, whom = broadcast.every_ticks, "" if broadcast.fields else " for some robots"
    if all(every % kit.packet_every_ticks == 0 for kit in kits.values()):
        yield Paragraph(f"After it, {_every(every)}, one JSON object follows on the same channel{whom}:")
    else:
        # It is made on a tick on which the official packet may be missing; then it waits, and a newer one replaces it.
        newest = f"the newest follows the next packet{whom}, on its channel"
        yield Paragraph(f"One JSON object is made {_every(every)}; {newest}:")
    if broadcast.fields:
        yield _told(broadcast.fields, nouns)
    only = {name: fields for name, fields in (broadcast.only or {}).items() if fields}
    for name, fields in only.items():
        told = nouns.all_of(name).does("is told", "are told")
        yield Paragraph(f"Only {told}{' in it as well' if broadcast.fields else ''}:")
        yield _told(fields, nouns)
    if _are_told_twice(broadcast.fields, only, nouns):
        yield Paragraph("Where a robot is told two values under one key, the one further down counts.")
    yield from (Paragraph(_TOLD_APART[by_key]) for by_key in sorted({kit.messages == "v2.2" for kit in kits.values()}))


def _are_told_twice(fields: Mapping[str, Value], only: Mapping[str, Mapping[str, Value]], nouns: Nouns) -> bool:
    """Return whether a robot is told two values under the same key."""
    keys: dict[str, list[str]] = {}
    for name, own in only.items():
        for robot in nouns.meant(name):
            keys.setdefault(robot, [*fields]).extend(own)
    return any(len(told) > len(set(told)) for told in keys.values())


def _told(fields: Mapping[str, Value], nouns: Nouns) -> Table:
    told = (
        (
            key,
            json.dumps(entry, ensure_ascii=False)
            if isinstance(entry, str | int | float)
            else value_words(nouns, entry) + _exactly(nouns.scenario, entry),
        )
        for key, entry in fields.items()
    )
    return Table(("key", "value"), tuple(told))


def _exactly(scenario: Scenario, entry: object) -> str:
    """Return what of a value a program must know to the letter: what it compares with, and what a list holds."""
    match entry:
        case DrawValue():
            values: Sequence[Scalar] = scenario.draws[entry.draw].values
        case WordValue(word="phase"):
            values = ("play", *(phase for phase in scenario.phases if phase != "play"))
        case PositionValue(position_of=name):
            of_spots = {one in scenario.spots for one in _stands_for(scenario, name)}
            if of_spots == {True}:
                return ": [x, y] in m"
            return (
                f": [x, y, yaw] in m and rad, {'of a spot [x, y], ' * (True in of_spots)}null while it is off the field"
            )
        case _:
            return ""
    # As JSON, since 1 and true are one to Python.
    written = dict.fromkeys(json.dumps(one, ensure_ascii=False) for one in values)
    return f": {listed(list(written), 'or')}"


def _stands_for(scenario: Scenario, name: str) -> Sequence[Scalar]:
    """Return what a name in a value is: itself, or all among which a draw decides."""
    draw = None if name in scenario.spots else scenario.draws.get(name)
    return (name,) if draw is None else draw.values


def _to_referee(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    """Return how robots tell the referee something, and which of them can."""
    by_channels: dict[tuple[int, ...], list[str]] = {}
    for name in robots_that_speak(scenario):
        channels = listening_channels(scenario, devices_of(scenario, name).values())
        if channels:
            by_channels.setdefault(channels, []).append(name)
    if by_channels:
        yield Heading(2, "What programs can tell the referee")
    for channels, names in by_channels.items():
        who = nouns.all_of(tuple(names)).text
        where = listed([str(channel) for channel in channels], "or")
        yield Paragraph(
            f"The referee hears what {who} {'sends' if len(names) == 1 else 'send'} with the team emitter on channel "
            f"{where}: text of up to {MOST_LETTERS} letters, or one or two numbers. In a tick it hears one message of "
            "each robot, the tick after it is sent at the earliest; other robots do not hear it. In Python: "
            f'emitter.setChannel({channels[0]}), emitter.send("…"), then back to the own channel.'
        )


def _events(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    events: dict[str, list[str]] = {}
    for rule in scenario.rules.values():
        for event in {action.event: None for action in rule.actions if isinstance(action, Emit)}:
            events.setdefault(event, []).append(spoken(nouns, rule))
    if events:
        yield Heading(2, "Events in the log")
        meanings = {event: " Or: ".join(filter(None, dict.fromkeys(said))) for event, said in events.items()}
        yield Table(("event", "meaning"), tuple(meanings.items()))


def _every(ticks: int) -> str:
    return f"every tick ({TICK_S:g} s)" if ticks == 1 else f"every {ticks} ticks ({ticks * TICK_S:g} s)"
