"""The match's end of the protocol: what goes to a program and what is taken from it (``docs/protocol.md``).

Messages from programs are validated strictly: one that is not exactly as described, or asks for something impossible,
raises a `ProtocolError`, and nothing of it is carried out.
"""

from __future__ import annotations

import json
import math
import re
import unicodedata
from dataclasses import asdict, dataclass
from struct import Struct
from struct import error as StructError  # noqa: N812 - the standard library's name is too plain to be read alone
from typing import Any

from rcj_challenges.core.amounts import counted
from rcj_challenges.core.timing import TICK_MS
from rcj_challenges.core.traffic import MotorCommand, Note, Observation, Packet, Request, RobotSpec
from rcj_challenges.devices import device_of_class
from rcj_challenges.devices.camera import RECOGNITION

PROTOCOL_VERSION = 1
HELLO, OBSERVATION, REQUEST, FAULT, NOTES = 0x48, 0x4F, 0x52, 0x46, 0x4E
OVER = 1  # flag of an observation
FAULT_KINDS = ("crash", "exit", "memory", "output_flood", "start")

MAX_EMISSIONS = 1_000
"""Packets that one step may send. At 115200 baud 460 of one byte are on the air in a tick."""

MAX_NOTES = 100
"""Notes that a program may send in a half; the module ``controller`` sends each once."""

LENGTH = Struct("<I")
_OBSERVATION = "<IBIBII"  # with its length; then the values
_PACKET = Struct("<HI4d")
_REQUEST = Struct("<BIIIQHHHHI")
_REQUEST_BEGINS = Struct("<BI")
_MOTOR = Struct("<Hdd")
_BOTH_WHEELS = Struct("<BIIIQHHHHIHddHdd")
"""The commonest request: two motors, and nothing else."""
_SAMPLING = Struct("<HI")
_CHANNEL = Struct("<Hi")
_FREQUENCY = Struct("<Hd")
_EMISSION = Struct("<HiI")
_FAULT = Struct("<BBI")
_NOTES = Struct("<BI")

_ADDRESS = re.compile(r"\b0x[0-9a-fA-F]{6,}")
_SPEED_TOLERANCE = 1e-9
_MAX_TRACEBACK = 20_000  # characters


class ProtocolError(ValueError):
    """A message that is not as the protocol demands. The text is one line for the team."""


@dataclass(frozen=True, slots=True)
class Ended:
    """A program's own report of its end: kind of `Fault`, one line, traceback."""

    kind: str
    detail: str
    traceback: str


def max_frame_bytes(message_bytes: int) -> int:
    """Return the largest size of a message from an honest program.

    A step may carry radio packets of twice the largest packet in all; the rest is room for settings and faults.
    """
    return 2 * message_bytes + (1 << 16)


def hello_frame(spec: RobotSpec, setup: dict[str, Any]) -> bytes:
    """Return the first message: the robot, and what its process needs to know, as JSON."""
    hello = {"protocol": PROTOCOL_VERSION, "tick_ms": TICK_MS, "robot": asdict(spec), **setup}
    body = json.dumps(hello, ensure_ascii=False, allow_nan=False).encode()
    return LENGTH.pack(1 + len(body)) + bytes((HELLO,)) + body


class Codec:
    """Encodes observations for one robot and decodes its program's messages; ``notes`` came with them."""

    def __init__(self, spec: RobotSpec, message_bytes: int) -> None:
        self._values = spec.values
        self._form = Struct(f"{_OBSERVATION}{spec.values}d")
        self._accepts = {device.index: device_of_class(device.kind).ACCEPTS for device in spec.devices}
        self._accepts |= {
            device.index + RECOGNITION: frozenset({"sampling"})
            for device in spec.devices
            if device.facts.get("recognition")
        }
        # By motor, the highest velocity that it may be asked for.
        self._motors = {
            device.index: float(device.facts.get("max_velocity", spec.max_velocity_radps)) * (1 + _SPEED_TOLERANCE)
            for device in spec.devices
            if "motors" in self._accepts[device.index]
        }
        self._message_bytes = message_bytes
        self._first_packet: Packet | None = None
        self._first_bytes = b""
        self._asked_last = b""
        self._request = Request(1)
        self.notes: list[Note] = []

    def encode(self, observation: Observation) -> bytes:
        """Return an observation as a frame."""
        tick, values, packets, over = observation
        flags = OVER if over else 0
        form = self._form
        if not packets:
            return form.pack(form.size - 4, OBSERVATION, tick, flags, self._values, 0, *values)
        first = packets[0]
        if first is not self._first_packet:  # the referee's packet comes first and stays the same for minutes
            self._first_packet, self._first_bytes = first, _packed(first)
        tail = self._first_bytes
        if len(packets) > 1:
            tail += b"".join([_packed(packet) for packet in packets[1:]])
        length = form.size - 4 + len(tail)
        return form.pack(length, OBSERVATION, tick, flags, self._values, len(packets), *values) + tail

    def decode(self, body: bytes, tick: int) -> Request | Ended:
        """Return the request or farewell in a message (a frame without its length) that answers ``tick``.

        Raises:
            ProtocolError: it is not as the protocol demands.
        """
        if body[:5] != _REQUEST_BEGINS.pack(REQUEST, tick):
            if body[:1] != bytes((NOTES,)):
                return _other_than_request(body, tick)
            body = self._without_notes(body)
            if body[:5] != _REQUEST_BEGINS.pack(REQUEST, tick):
                return _other_than_request(body, tick)
        # Most requests repeat the one before.
        if (asked := body[5:]) != self._asked_last:
            self._request = self._requested(body)
            self._asked_last = asked
        return self._request

    def _without_notes(self, body: bytes) -> bytes:
        """Keep the notes that a message brings; return the message itself."""
        try:
            _, size = _NOTES.unpack_from(body)
            notes = _notes(json.loads(body[_NOTES.size : _NOTES.size + size]))
        except (StructError, ValueError, TypeError, RecursionError):
            raise ProtocolError("invalid notes") from None
        if len(self.notes) + len(notes) > MAX_NOTES:
            raise ProtocolError(f"more than {MAX_NOTES} notes")
        self.notes += notes
        return body[_NOTES.size + size :]

    def _requested(self, body: bytes) -> Request:
        if len(body) == _BOTH_WHEELS.size and (request := self._of_both_wheels(body)) is not None:
            return request
        try:
            _, _, advance, missed, _, motors, sampling, channels, frequencies, emissions = _REQUEST.unpack_from(body)
        except StructError:
            raise ProtocolError(f"a request of {counted(len(body), 'byte')}") from None
        if advance < 1:
            raise ProtocolError("a request to advance by 0 ticks")
        settings = max(motors, sampling, channels, frequencies)
        if settings > len(self._accepts) or emissions > MAX_EMISSIONS:
            found = f"{settings} settings and {emissions} packets"
            raise ProtocolError(f"a request with too many settings or packets in one step: {found}")
        at = _REQUEST.size + motors * _MOTOR.size
        if len(body) < at:
            raise ProtocolError("a request that ends too early")
        commands = self._commands(body[_REQUEST.size : at])
        if not (sampling or channels or frequencies):  # as nearly always
            return Request(advance, missed, commands, self._emissions(body, at, emissions))
        periods, at = self._settings(body, at, sampling, _SAMPLING, "sampling", "a sensor")
        tuned, at = self._settings(body, at, channels, _CHANNEL, "channels", "a receiver")
        paces, at = self._settings(body, at, frequencies, _FREQUENCY, "frequencies", "a lidar")
        for device, frequency_hz in paces:
            if not math.isfinite(frequency_hz):
                raise ProtocolError(f"device {device}: a frequency of {frequency_hz:g} Hz")
        return Request(advance, missed, commands, self._emissions(body, at, emissions), periods, tuned, paces)

    def _of_both_wheels(self, body: bytes) -> Request | None:
        """Return a request that sets two motors; None if it is another one, or something is wrong with it."""
        (_, _, advance, missed, _, motors, sampling, channels, frequencies, emissions,
         left, left_radps, left_to, right, right_radps, right_to) = _BOTH_WHEELS.unpack(body)  # fmt: skip
        if advance < 1 or motors != 2 or sampling or channels or frequencies or emissions:
            return None
        most = self._motors
        if not (abs(left_radps) <= most.get(left, -1.0) and left_to > -math.inf):
            return None
        if not (abs(right_radps) <= most.get(right, -1.0) and right_to > -math.inf):
            return None
        return Request(
            advance, missed, (MotorCommand(left, left_radps, left_to), MotorCommand(right, right_radps, right_to))
        )

    def _commands(self, settings: bytes) -> tuple[MotorCommand, ...]:
        commands = []
        for device, velocity, position in _MOTOR.iter_unpack(settings):
            # The bounds are written so that NaN is within none.
            if not (abs(velocity) <= self._motors.get(device, -1.0) and position > -math.inf):
                raise ProtocolError(self._what_is_wrong(device, velocity, position))
            commands.append(MotorCommand(device, velocity, position))
        return tuple(commands)

    def _what_is_wrong(self, device: int, velocity: float, position: float) -> str:
        if device not in self._motors:
            return f"device {device} is not a motor"
        if not abs(velocity) <= self._motors[device]:
            return f"device {device}: a velocity of {velocity:g}"
        return f"device {device}: a position of {position:g}"

    def _settings(
        self, body: bytes, at: int, count: int, form: Struct, accepts: str, wanted: str
    ) -> tuple[tuple[Any, ...], int]:
        """Return so many settings of a kind, each of a device and a number, and where they end."""
        end = at + count * form.size
        if end > len(body):
            raise ProtocolError("a request that ends too early")
        settings = tuple(form.iter_unpack(body[at:end]))
        for device, _ in settings:
            self._must_be(device, accepts, wanted)
        return settings, end

    def _emissions(self, body: bytes, at: int, count: int) -> tuple[tuple[int, int, bytes], ...]:
        sent = []
        for _ in range(count):
            begins = at + _EMISSION.size
            if begins > len(body):
                raise ProtocolError("a request that ends too early")
            device, channel, size = _EMISSION.unpack_from(body, at)
            self._must_be(device, "emissions", "an emitter")
            if size > self._message_bytes:
                raise ProtocolError(f"a radio packet of {size} bytes")
            at = begins + size
            if at > len(body):
                raise ProtocolError("a request that ends too early")
            sent.append((device, channel, body[begins:at]))
        if at != len(body):
            raise ProtocolError(f"a request with {counted(len(body) - at, 'byte')} too many")
        return tuple(sent)

    def _must_be(self, device: int, named_in: str, wanted: str) -> None:
        if named_in not in self._accepts.get(device, ()):
            raise ProtocolError(f"device {device} is not {wanted}")


def _packed(packet: Packet) -> bytes:
    device, data, strength, (ahead, left, up) = packet
    return _PACKET.pack(device, len(data), strength, ahead, left, up) + data


def _other_than_request(body: bytes, tick: int) -> Ended:
    """Return a farewell; anything else is refused."""
    if not body:
        raise ProtocolError("an empty message")
    if body[0] == REQUEST:
        if len(body) < _REQUEST_BEGINS.size:
            raise ProtocolError(f"a request of {counted(len(body), 'byte')}")
        raise ProtocolError(f"a request that answers tick {_REQUEST_BEGINS.unpack_from(body)[1]} at tick {tick}")
    if body[0] != FAULT:
        raise ProtocolError(f"a message of unknown type {body[0]}")
    try:
        _, kind, size = _FAULT.unpack_from(body)
    except StructError:
        raise ProtocolError(f"a farewell of {counted(len(body), 'byte')}") from None
    if kind >= len(FAULT_KINDS) or _FAULT.size + size > len(body):
        raise ProtocolError("an invalid farewell")
    detail = body[_FAULT.size : _FAULT.size + size][:_MAX_TRACEBACK].decode("utf-8", "replace")
    trace = body[_FAULT.size + size :][-_MAX_TRACEBACK:].decode("utf-8", "replace")
    return Ended(FAULT_KINDS[kind], one_line(detail), _without_addresses(_printable(trace, keep="\n\t")))


def _notes(given: Any) -> list[Note]:
    are_lists = all(type(part) is list for part in (given, *given))
    if not are_lists or any(type(text) is not str for texts in given for text in texts):
        raise ValueError
    return [_note(*texts) for texts in given]


def _note(code: str, subject: str, message: str, help_: str) -> Note:
    return Note(one_line(code), subject.replace("\n", " ")[:1_000], one_line(message), one_line(help_))


def one_line(text: str) -> str:
    """Return text from a program as one harmless line: no control characters, no addresses, at most 1000 characters."""
    return _without_addresses(" ".join(_printable(text, keep="").split()))[:1_000]


def _printable(text: str, keep: str) -> str:
    return "".join(one if one in keep or unicodedata.category(one)[0] != "C" else " " for one in text)


def _without_addresses(text: str) -> str:
    """Addresses differ from run to run, and what a fault says is part of the result."""
    return _ADDRESS.sub("0x…", text)
