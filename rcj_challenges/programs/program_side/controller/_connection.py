"""What all devices of a robot share: the latest observation, what is to be requested, and the exchange itself."""

from __future__ import annotations

import math
import sys
from _thread import RLock
from struct import Struct

from ._wire import (
    HEAD_FIELDS,
    OBSERVATION,
    OBSERVATION_HEAD,
    OVER,
    PACKET,
    Emission,
    Wire,
    leave,
    request_frame,
    with_missed_ticks,
    with_notes,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections import deque
    from collections.abc import Callable
    from typing import Any

    Seen = tuple[int, tuple[Any, ...]]
    """A tick, and the numbers of a sample that was taken then."""
else:
    from _collections import deque

Packet = tuple[bytes, float, float, float, float]
"""Payload, strength, and the direction's x, y, z in the robot's frame."""

QUEUE_BYTES = 16 << 20
"""Limit for the unread packets of one receiver, about 80 000 small ones; honest programs leave up to 20 000. It is
checked now and then: in between there may be some thousand small ones more."""

MAX_EMISSIONS = 1_000
"""Packets that one step may send. At 115200 baud 460 of one byte are on the air in a tick."""

EMITTED_BYTES = 1 << 15
"""What one step may send in all where two of the largest packets are less. With what stands around 1000 packets and
with the settings it is within the 64 KiB that a message may have beyond two of the largest packets."""

_PACKET_OVERHEAD = 200
_TRIMMED_EVERY_BYTES = 1 << 19  # that arrive: of thousands of ticks, if packets are small; counting them takes its time
_PRINTED_TIMES = 10
"""How often one complaint is printed; then only the 100th, the 1000th: an error in each step of a half occurs 18750
times, and would hide the program's own output."""
_MAX_NOTES, _MAX_NOTE_CHARACTERS = 30, 150  # whatever the characters are, all fit into one frame
_MAX_TICKS = 2**31 - 1
_MAX_DEPTH, _REHEARSALS = 150, 60  # `check` plays 10 s, the 60th part of a half


RECOGNITION = 0x8000
"""Added to a camera's index: the number of its recognition."""


def trim(packets: deque[Packet]) -> None:
    """Forget the oldest packets of a queue beyond the bound; the newest always stays."""
    # Of a copy, which is made at once: meanwhile another thread may take packets out.
    too_many_bytes = sum([len(packet[0]) + _PACKET_OVERHEAD for packet in packets.copy()]) - QUEUE_BYTES
    while too_many_bytes > 0 and len(packets) > 1:
        too_many_bytes -= len(packets.popleft()[0]) + _PACKET_OVERHEAD


class Samples:
    """The last two samples of a sensor that the program could see."""

    __slots__ = ("_begin", "_period", "before", "latest")

    def __init__(self, latest: Seen, before: Seen) -> None:
        """Begin with what a sensor shows that samples at every tick, or not at all."""
        self.latest, self.before = latest, before
        self._period, self._begin = 1, latest[0]

    def set_period(self, period_ticks: int, tick: int) -> None:
        """Set the period from a tick on; one that the sensor has already goes on."""
        if (period := max(1, period_ticks)) != self._period:
            self._period, self._begin = period, tick

    def see(self, tick: int, numbers: tuple[Any, ...]) -> None:
        """Take note of an observation: whether it shows another sample."""
        passed = tick - self._begin
        taken = tick - passed % self._period
        if passed >= self._period and taken > self.latest[0]:
            self.latest, self.before = (taken, numbers), self.latest


class Connection:
    """The robot's side of the exchange with the match.

    Attributes:
        root: folder of the team's files; empty until it is known.
        numbers: the latest observation: six numbers of its head, then those of all devices, as of ``tick``. Those of a
            lidar stand packed in one piece: they are many, and seldom looked at.
        place_of: by a device's slot, where in ``numbers`` its own begin.
        previous: the observation before, of ``previous_tick``.
        queues: by the index of a receiver its unread packets, oldest first; by that of a camera and of its recognition
            the latest picture, and what it recognizes.
        devices: all devices of the robot by name, once it is made.
        motors: settings for the next request, by the motor's index: index, velocity in rad/s, position in rad.
    """

    def __init__(self, wire: Wire, hello: dict[str, Any], clock: Any, output: Any) -> None:
        self.spec: dict[str, Any] = hello["robot"]
        self.tick_ms: int = hello["tick_ms"]
        self.root = ""
        self.tick = 0
        form, self.place_of = _layout(self.spec["devices"])
        self._form = Struct(OBSERVATION_HEAD + form)
        nothing_yet = _nothing_yet(self.spec["devices"], self.spec["values"])
        self.numbers: tuple[Any, ...] = self._form.unpack(bytes(self._form.size - len(nothing_yet)) + nothing_yet)
        self.previous, self.previous_tick = self.numbers, 0
        self.queues: dict[int, deque[Packet]] = {
            device["index"]: deque() for device in self.spec["devices"] if device["kind"] == "receiver"
        }
        cameras = [device["index"] for device in self.spec["devices"] if device["kind"] == "camera"]
        self.queues |= {index + extra: deque((), 1) for index in cameras for extra in (0, RECOGNITION)}
        self.over = False
        self.robot_made = False
        self.devices: dict[str, Any] = {}
        self._wire = wire
        self._clock = clock
        self._output = output
        self._turn = RLock()  # threads that step together take turns; a handler of a signal may step within a step
        self.raised: BaseException | None = None  # by the program's handler of a signal, in the middle of an exchange
        self.message_bytes: int = hello["limits"]["message_bytes"]
        self.motors: dict[int, tuple[int, float, float]] = {}
        self._has_others = False
        self._ramps: dict[int, Callable[[int], bool]] = {}
        self._sampling: dict[int, int] = {}
        self._followed: dict[int, Samples] = {}
        self._new_periods: dict[int, int] = {}  # periods that are asked for with the next request
        self._channels: dict[int, int] = {}
        self._frequencies: dict[int, float] = {}
        self._emissions: list[Emission] = []
        self._emitted_bytes = 0
        self._appends = {device: queue.append for device, queue in self.queues.items()}
        self._untrimmed_bytes = 0
        self._step_ms: float | None = None
        self._step_ticks = 0
        self._begun: bytes | None = None
        self._begun_ms: float = -1.0
        self._ending = False
        self._next_search = 2
        self._reported: set[str] = set()
        self._notes: list[tuple[str, str, str, str]] = []
        self._noted: set[str] = set()

    def time_s(self) -> float:
        """Return simulated seconds at the latest observation."""
        return round(self.tick * self.tick_ms / 1000, 3)

    def ticks_from_ms(self, duration_ms: float) -> int:
        """Return the ticks that cover a duration: at least one, rounded up."""
        return int(min(max(1, -(-duration_ms // self.tick_ms)), _MAX_TICKS))

    def duration_ms(self, *given: float | None) -> float:
        """Return the duration of a step that was given by any of its names, or else the basic one."""
        return next((duration for duration in given if duration is not None), float(self.spec["basic_step_ms"]))

    def command(self, device: int, velocity_radps: float, position_rad: float) -> None:
        """Set a motor; the last setting before the step counts."""
        self.motors[device] = (device, velocity_radps, position_rad)

    def ramp(self, device: int, approach: Callable[[int], bool]) -> None:
        """Before each request call ``approach``, which commands the motor, with the step's ticks, until it is False."""
        self._has_others = True
        self._ramps[device] = approach

    def sample(self, device: int, period_ticks: int) -> None:
        """Let a sensor or receiver sample every so many ticks; 0 stops it."""
        self._has_others = True
        self._sampling[device] = period_ticks

    def follow(self, device: int) -> None:
        """Remember from now on when a sensor's samples are taken, for `before_sample`: it has sampled at every tick."""
        if device not in self._followed:
            self._followed[device] = Samples((self.tick, self.numbers), (self.previous_tick, self.previous))

    def before_sample(self, device: int) -> tuple[int, tuple[Any, ...]]:
        """Return the ticks between the last two samples, and the numbers of the first; 0 if none."""
        samples = self._followed.get(device)
        if samples is None:
            return self.tick - self.previous_tick, self.previous
        return samples.latest[0] - samples.before[0], samples.before[1]

    def tune(self, device: int, channel: int) -> None:
        """Set the channel of a receiver."""
        self._has_others = True
        self._channels[device] = channel

    def spin(self, device: int, frequency_hz: float) -> None:
        """Set the frequency of a lidar's head."""
        self._has_others = True
        self._frequencies[device] = frequency_hz

    def emit(self, device: int, channel: int, data: bytes) -> bool:
        """Hand a packet to an emitter. Return False if it, or all of this step together, is too large."""
        size = len(data)
        if size > self.message_bytes or self._emitted_bytes + size > max(EMITTED_BYTES, 2 * self.message_bytes):
            return False
        if len(self._emissions) >= MAX_EMISSIONS:
            return False
        self._has_others = True
        self._emitted_bytes += size
        self._emissions.append((device, channel, data))
        return True

    def exchange(self, duration_ms: float) -> bool:
        """Send what was asked for, wait until the time is over, take in what came. Returns False at the end.

        Several threads take turns, as in the original.
        """
        with self._turn:
            return self.exchange_in_turn(duration_ms)

    def exchange_in_turn(self, duration_ms: float) -> bool:
        """Do what `exchange` does, while no other thread does."""
        if self.over:
            return False
        if duration_ms != self._step_ms:
            self._step_ms, self._step_ticks = duration_ms, self._checked_ticks(duration_ms)
        clock = self._clock
        missed, printed = clock.missed_ticks(), self._output.printed_bytes
        if self._has_others:
            request = self._with_others(self.tick, self._step_ticks, missed, printed)
        else:
            motors, self.motors = self.motors, {}
            request = request_frame(self.tick, self._step_ticks, missed, printed, motors.values())
        if self._notes:
            request = self.take_notes_with(request)
        clock.step_began()
        frame = self._wire.exchange(request)
        if self._followed:
            self._set_periods(self.tick + missed)
        self._take_in(frame)
        if self.raised is not None:
            # The step is taken all the same, as in the original, where nothing can break it off.
            raised, self.raised = self.raised, None
            raise raised
        return not self.over

    def note(self, text: str, code: str, subject: str, help_: str) -> None:
        """Send a complaint to the match with the next request, each text once."""
        if text not in self._noted and len(self._noted) < _MAX_NOTES:
            self._noted.add(text)
            what = text.partition(": ")[2].removesuffix(".").removesuffix(help_).rstrip(":; ")
            self._notes.append((code, subject[:_MAX_NOTE_CHARACTERS], what[:_MAX_NOTE_CHARACTERS], help_))

    def take_notes_with(self, frame: bytes) -> bytes:
        """Return a request or fault with the notes that were not sent yet."""
        notes, self._notes = self._notes, []
        return with_notes(notes, frame) if notes else frame

    def _take_in(self, frame: bytes) -> None:
        self.previous, self.previous_tick = self.numbers, self.tick
        self.numbers = numbers = self._form.unpack_from(frame)
        _, kind, tick, flags, _, packets = numbers[:HEAD_FIELDS]
        if kind != OBSERVATION:
            leave(1)
        if packets:
            self._queue(frame, packets)
        self.tick = tick
        if tick >= self._next_search:
            self._report_unknown_attributes()
        if self._followed:
            for samples in self._followed.values():
                samples.see(tick, numbers)
        self._clock.tick_began(tick)
        if flags & OVER:
            self.over = True
            self._warn_of_depth()
            if self._notes:  # no request follows
                self._wire.send(self.take_notes_with(b""))

    def _report_unknown_attributes(self) -> None:
        """Warn, once for each, of values set to an attribute that a device lacks and that is nearly one of its names.

        Searched for at tick 2, 8, 32 and so on: to notice each assignment would slow down every one.
        """
        self._next_search = 4 * max(self._next_search, self.tick)
        for device in self.devices.values():
            unknown = [name for name in vars(device) if not name.startswith("_") and not hasattr(type(device), name)]
            for name in unknown:
                from difflib import get_close_matches  # noqa: PLC0415 - only for a slip: each import costs every program

                known = [one for one in dir(type(device)) if not one.startswith("_")]
                near = get_close_matches(name, known, 1, 0.8)
                if near and name not in self._reported:
                    self._reported.add(name)
                    what = f"{device.name!r} has no attribute {name!r}: setting it does nothing"
                    complain(f"Warning: {what}; did you mean {near[0]!r}?")

    def _warn_of_depth(self) -> None:
        """Report a function that continues by calling itself: in a rehearsal of some seconds nothing else shows it."""
        depth, frame = 0, sys._getframe()  # noqa: SLF001 - it is documented
        while frame.f_back is not None:
            depth, frame = depth + 1, frame.f_back
        limit = sys.getrecursionlimit()
        if depth > _MAX_DEPTH and depth * _REHEARSALS > limit:
            ends_s, help_ = self.time_s() * limit / depth, "write a while loop"
            complain(
                f"Warning: step was called {depth} calls deep: a function calls itself to continue. At "
                f"{limit} Python ends the program, after about {ends_s:.0f} s; {help_}.",
                help_,
            )

    def _checked_ticks(self, duration_ms: Any) -> int:
        return self.ticks_from_ms(number(duration_ms, "step takes a number of ms, such as 32"))

    def begin(self, duration_ms: float) -> None:
        """Keep what was asked for until now as the request of a step that `end` takes."""
        with self._turn:  # the step of another thread may be under way
            if self._begun is not None:
                raise RuntimeError("stepBegin was called again before stepEnd")
            ticks, printed = self._checked_ticks(duration_ms), self._output.printed_bytes
            self._begun = self._with_others(self.tick, ticks, 0, printed)
            self._begun_ms = duration_ms
            self._has_others = True  # the exchange is to look here for its request

    def is_within_step(self) -> bool:
        """Return whether a step was begun that has not ended: no other can be taken before."""
        return self._begun is not None

    def end(self) -> bool:
        """Take the step that `begin` began. What was set since then acts in the next one. Returns False at the end."""
        with self._turn:
            if self._begun is None:
                raise RuntimeError("stepEnd was called without stepBegin before it")
            self._ending = True
            try:
                return self.exchange(self._begun_ms)
            finally:
                self._ending, self._begun = False, None

    def _with_others(self, tick: int, advance_ticks: int, missed_ticks: int, printed: int) -> bytes:
        """Return a request with all that is asked for, and forget it.

        What another thread asks for meanwhile stays for the next one: everything is taken and replaced at once.
        """
        if self._begun is not None:
            if not self._ending:
                raise RuntimeError("step was called between stepBegin and stepEnd")
            return with_missed_ticks(self._begun, missed_ticks)
        self._has_others = False
        ramps, self._ramps = self._ramps, {}
        for device, approach in ramps.items():
            if approach(advance_ticks):
                self._has_others = True
                self._ramps.setdefault(device, approach)
        motors, self.motors = self.motors, {}
        emissions, self._emissions, self._emitted_bytes = self._emissions, [], 0
        sampling, self._sampling = self._sampling, {}
        channels, self._channels = self._channels, {}
        frequencies, self._frequencies = self._frequencies, {}
        self._new_periods = {one: period for one, period in sampling.items() if one in self._followed}
        # Lists, made at once: a thread that has just been about to set something may still do that.
        settings = list(sampling.items()), list(channels.items()), list(frequencies.items())
        return request_frame(tick, advance_ticks, missed_ticks, printed, motors.values(), *settings, emissions)

    def _set_periods(self, tick: int) -> None:
        """Take note of the periods that a request has asked for, as of the tick in which it acts."""
        for device, period_ticks in self._new_periods.items():
            self._followed[device].set_period(period_ticks, tick)
        self._new_periods = {}

    def _queue(self, frame: bytes, count: int) -> None:
        at, appends, unpack, head_bytes = self._form.size, self._appends, PACKET.unpack_from, PACKET.size
        for _ in range(count):
            device, size, strength, x, y, z = unpack(frame, at)
            begin = at + head_bytes
            at = begin + size
            appends[device]((frame[begin:at], strength, x, y, z))
        self._untrimmed_bytes += at
        if self._untrimmed_bytes > _TRIMMED_EVERY_BYTES:
            self._untrimmed_bytes = 0
            for queue in self.queues.values():
                trim(queue)


def _layout(devices: list[dict[str, Any]]) -> tuple[str, dict[int, int]]:
    """Return the layout of all devices' numbers in an observation, and the place of each slot's."""
    form, place_of, place = "", {}, HEAD_FIELDS
    for device in sorted(devices, key=lambda device: device["slot"]):
        if width := device["width"]:
            place_of[device["slot"]] = place
            packed = device["kind"] == "lidar"
            form += f"{8 * width}s" if packed else f"{width}d"
            place += 1 if packed else width
    return form, place_of


def _nothing_yet(devices: list[dict[str, Any]], count: int) -> bytes:
    """Return the numbers of all devices before the first observation: NaN, and 0.0 the cells of a lidar."""
    numbers = [math.nan] * count
    for device in devices:
        if device["kind"] == "lidar":
            begin, width = device["slot"], device["width"]
            numbers[begin : begin + width] = [0.0] * width
    return Struct(f"<{count}d").pack(*numbers)


_connection: Connection | None = None


def connect(connection: Connection) -> None:
    """Make ``connection`` the one that ``Robot()`` uses."""
    global _connection  # noqa: PLW0603 - a process drives one robot
    _connection = connection


def connected() -> Connection:
    """Return the connection of this process.

    Raises:
        RuntimeError: the program was not started by a match.
    """
    if _connection is None:
        raise RuntimeError("this program drives a robot only when `rcj-challenge run` starts it")
    return _connection


_times_printed: dict[str, int] = {}


def complain(text: str, help_: str = "", *, code: str = "", subject: str = "") -> None:
    """Print a complaint for the program's author on standard error; repetitions are printed now and then.

    One that comes with help or a code is also sent to the match, for its hints. The subject is what the code is about.
    """
    if (help_ or code) and _connection is not None:
        _connection.note(text, code, subject, help_)
    times = _times_printed[text] = _times_printed.get(text, 0) + 1
    if times > _PRINTED_TIMES and str(times).strip("0") != "1":
        return
    print(text, file=sys.stderr)
    if times == _PRINTED_TIMES:
        print(f"(printed {times} times; from now on only the 100th time, the 1000th and so on)", file=sys.stderr)
    elif times > _PRINTED_TIMES:
        print(f"(this is the {times}th time)", file=sys.stderr)


def number(given: Any, wanted: str) -> float:
    """Return a number that a program gave.

    Raises:
        TypeError: it is none; the text says what was wanted, and what was found.
    """
    try:
        math.isnan(given)  # accepts everything that converts to a number, but no text
    except TypeError:
        raise TypeError(f"{wanted}; {format_given(given)} was given") from None
    return given if isinstance(given, int) else float(given)


def format_given(given: object) -> str:
    """Format an argument for a message: ``'32' (str)``."""
    return f"{repr(given)[:60]} ({type(given).__name__})"
