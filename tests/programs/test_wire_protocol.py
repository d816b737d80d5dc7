"""The protocol: both ends agree, and nothing that a program may send harms the match."""

from __future__ import annotations

import json
import math
import struct
import sys
from pathlib import Path

import pytest
from fake_match import INDEX, SPEC
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.programs.pipes import FrameBuffer
from rcj_challenges.programs.processes import PROGRAM_SIDE
from rcj_challenges.programs.protocol import Codec, Ended, ProtocolError, hello_frame, max_frame_bytes
from rcj_challenges.core.traffic import DeviceSpec, MotorCommand, Observation, Packet, Request, RobotSpec

sys.path.insert(0, str(PROGRAM_SIDE))  # before the package of the same name that editors read
from controller import _boot, _connection, _wire  # type: ignore[import-not-found]  # the program's end, as programs import it

MESSAGE_BYTES = 4_000
CODEC = Codec(SPEC, MESSAGE_BYTES)

GOOD = Request(1)
PRINTED_AT, PRINTED = 17, struct.Struct("<Q")

ticks = st.integers(0, 2**32 - 1)
some_ticks = st.integers(1, 2**31 - 1)
numbers = st.floats(allow_nan=False)
payloads = st.binary(max_size=200)
packets = st.builds(Packet, st.sampled_from([8, 9, 10]), payloads, numbers, st.tuples(numbers, numbers, numbers))
observations = st.builds(
    Observation,
    ticks,
    st.lists(numbers, min_size=SPEC.values, max_size=SPEC.values),
    st.lists(packets, max_size=4),
    st.booleans(),
)
wheels = st.sampled_from([INDEX["left wheel motor"], INDEX["right wheel motor"]])
sensors = st.sampled_from([INDEX["gps"], INDEX["ball receiver"], INDEX["lidar"]])
receivers = st.sampled_from([INDEX["team receiver"], INDEX["ball receiver"]])
channels = st.integers(-(2**31), 2**31 - 1)
positions = st.one_of(st.just(math.inf), st.floats(allow_nan=False, allow_infinity=False))
requests = st.builds(
    Request,
    advance_ticks=some_ticks,
    missed_ticks=some_ticks,
    motors=st.lists(
        st.builds(MotorCommand, wheels, st.floats(-10, 10), positions), max_size=2, unique_by=lambda m: m.device
    ).map(tuple),
    sampling=st.lists(st.tuples(sensors, some_ticks), max_size=3, unique_by=lambda s: s[0]).map(tuple),
    channels=st.lists(st.tuples(receivers, channels), max_size=2, unique_by=lambda c: c[0]).map(tuple),
    frequencies=st.lists(st.tuples(st.just(INDEX["lidar"]), st.floats(1, 25)), max_size=1).map(tuple),
    emissions=st.lists(st.tuples(st.just(INDEX["team emitter"]), channels, payloads), max_size=4).map(tuple),
)


class LoopedWire:
    """Takes what a program asks for, and gives it an observation."""

    def __init__(self, answer: bytes) -> None:
        self.asked = b""
        self._answer = answer

    def exchange(self, frame: bytes) -> bytes:
        self.asked = frame
        return self._answer


class SomeOutput:
    def __init__(self, printed_bytes: int = 0) -> None:
        self.printed_bytes = printed_bytes


class StillClock:
    def __init__(self, missed: int = 0) -> None:
        self._missed = missed

    def missed_ticks(self) -> int:
        return self._missed

    def step_began(self) -> None:
        pass

    def tick_began(self, tick: int) -> None:
        pass


def program_end(
    answer: bytes, request: Request = GOOD, printed_bytes: int = 0
) -> tuple[_connection.Connection, LoopedWire]:
    """The program's end, connected to a wire that answers like this."""
    reported = json.loads(hello_frame(SPEC, {"limits": {"message_bytes": 10**6}})[5:])
    wire = LoopedWire(answer)
    return _connection.Connection(wire, reported, StillClock(request.missed_ticks), SomeOutput(printed_bytes)), wire


def sent_by_program(tick: int, request: Request) -> bytes:
    """What a program sends that asks for all this after the observation of ``tick``."""
    connection, wire = program_end(CODEC.encode(Observation(0, [0.0] * SPEC.values, [])), request)
    connection.tick = tick
    for motor in request.motors:
        connection.command(motor.device, motor.velocity_radps, motor.position_rad)
    for device, period in request.sampling:
        connection.sample(device, period)
    for device, channel in request.channels:
        connection.tune(device, channel)
    for device, frequency in request.frequencies:
        connection.spin(device, frequency)
    for emission in request.emissions:
        assert connection.emit(*emission)
    connection._step_ms, connection._step_ticks = 1.0, request.advance_ticks
    connection.exchange(1.0)
    return wire.asked


def body_of(frame: bytes) -> bytes:
    (length,) = struct.unpack_from("<I", frame)
    assert length == len(frame) - 4
    return frame[4:]


def told_to(connection: _connection.Connection) -> list[float]:
    """The numbers of all devices, slot by slot; a lidar's are kept packed."""
    slots: list[float] = []
    for entry in connection.numbers[6:]:
        slots += struct.unpack(f"<{len(entry) // 8}d", entry) if isinstance(entry, bytes) else [entry]
    return slots


@given(observations)
def test_a_program_receives_exactly_what_was_observed(observation: Observation) -> None:
    frame = CODEC.encode(observation)
    body_of(frame)
    connection, _ = program_end(frame)
    assert connection.exchange(32) is not observation.over
    assert (connection.tick, connection.over, told_to(connection)) == (
        observation.tick,
        observation.over,
        observation.values,
    )
    for device, queue in connection.queues.items():
        assert list(queue) == [
            (p.data, p.strength, *p.direction) for p in observation.packets if p.device == device
        ]


def test_of_all_settings_of_a_device_in_a_step_the_last_is_sent() -> None:
    sensor, radio, lidar = INDEX["gps"], INDEX["team receiver"], INDEX["lidar"]
    asked = Request(
        1,
        sampling=((sensor, 1), (sensor, 2)),
        channels=((radio, 5), (radio, 3)),
        frequencies=((lidar, 10.0), (lidar, 20.0)),
    )
    sent = CODEC.decode(body_of(sent_by_program(7, asked)), 7)
    assert sent == Request(1, sampling=((sensor, 2),), channels=((radio, 3),), frequencies=((lidar, 20.0),))


@pytest.mark.parametrize("kind", ["motors", "sampling", "channels", "frequencies", "emissions"])
def test_a_request_with_more_than_a_robot_can_want_is_refused_before_it_is_read(kind: str) -> None:
    counts = {"motors": 0, "sampling": 0, "channels": 0, "frequencies": 0, "emissions": 0}
    counts[kind] = 60_000
    body = struct.pack("<BIIIQHHHHI", 0x52, 3, 1, 0, 0, *counts.values()) + bytes(60_000 * 18)
    with pytest.raises(
        ProtocolError,
        match=f"too many settings or packets in one step: .*60000 {'packets' if kind == 'emissions' else 'settings'}",
    ):
        CODEC.decode(body, 3)


@given(st.integers(0, 2**63))
def test_the_reported_output_size_of_a_program_does_not_change_its_requests(printed_bytes: int) -> None:
    connection, wire = program_end(CODEC.encode(Observation(0, [0.0] * SPEC.values, [])), printed_bytes=printed_bytes)
    connection.exchange(32)
    assert PRINTED.unpack_from(wire.asked, PRINTED_AT) == (printed_bytes,)
    assert CODEC.decode(body_of(wire.asked), 0) == GOOD


def test_packets_beyond_what_a_step_may_send_are_dropped() -> None:
    connection, _ = program_end(b"")
    sent = [connection.emit(INDEX["team emitter"], 3, b"x") for _ in range(1_010)]
    assert sent == [True] * 1_000 + [False] * 10


@given(ticks, requests)
def test_the_match_receives_exactly_the_requests_of_a_program(tick: int, request: Request) -> None:
    assert CODEC.decode(body_of(sent_by_program(tick, request)), tick) == request


@given(st.sampled_from(_wire.FAULT_KINDS), st.text(st.characters(min_codepoint=33, max_codepoint=126), max_size=40))
def test_the_match_receives_exactly_how_a_program_ended(kind: str, detail: str) -> None:
    body = body_of(_wire.fault_frame(kind, detail, "line 1\n  line 2\n"))
    if "0x" not in detail:
        assert CODEC.decode(body, 0) == Ended(kind, detail, "line 1\n  line 2\n")


@given(
    ticks, requests, st.lists(st.tuples(*[st.text(st.characters(min_codepoint=97, max_codepoint=122))] * 4), max_size=9)
)
def test_the_match_receives_a_request_and_the_notes_that_it_brings(
    tick: int, request: Request, notes: list[tuple[str, str, str, str]]
) -> None:
    codec = Codec(SPEC, MESSAGE_BYTES)
    frame = _wire.with_notes(notes, sent_by_program(tick, request))
    assert codec.decode(body_of(frame), tick) == request
    assert codec.notes == notes


@pytest.mark.parametrize(
    "notes",
    [
        b"[",
        b"1",
        b"[1]",
        b"[[1, 2]]",
        b'[["", "", "", 1]]',
        b"[" * 5000,
        b'[{"a": 1}]',
        b'{"abcd": 1}',
        b'["abcd"]',
        b'[[["a"], "", "", ""]]',
    ],
)
def test_notes_of_another_form_break_the_protocol(notes: bytes) -> None:
    body = struct.pack("<BI", 0x4E, len(notes)) + notes + body_of(sent_by_program(0, GOOD))
    with pytest.raises(ProtocolError):
        CODEC.decode(body, 0)


@pytest.mark.parametrize("character", ["a", "\0", "\N{GRINNING FACE}", "\ud800"])
def test_the_notes_of_a_program_never_make_a_frame_too_long(character: str) -> None:
    connection, wire = program_end(CODEC.encode(Observation(0, [0.0] * SPEC.values, [])))
    for number in range(200):
        connection.note(f"Warning: {number} {character * 500}", "no-device", character * 500, "correct this call")
    connection.exchange(32)
    assert len(body_of(wire.asked)) <= max_frame_bytes(message_bytes=0)
    codec = Codec(SPEC, MESSAGE_BYTES)
    assert isinstance(codec.decode(body_of(wire.asked), 0), Request)
    assert codec.notes


def test_more_notes_than_the_module_sends_break_the_protocol() -> None:
    codec, frame = Codec(SPEC, MESSAGE_BYTES), _wire.with_notes([("", "", "", "")] * 60, sent_by_program(0, GOOD))
    codec.decode(body_of(frame), 0)
    with pytest.raises(ProtocolError):
        codec.decode(body_of(frame), 0)


@given(st.binary(max_size=300))
def test_no_message_of_arbitrary_bytes_does_more_than_break_the_protocol(body: bytes) -> None:
    try:
        answer = CODEC.decode(body, 0)
    except ProtocolError as error:
        assert "\n" not in str(error)  # noqa: PT017 - the property is about every error
    else:
        assert isinstance(answer, (Request, Ended))


@given(requests, st.data())
def test_a_request_with_a_changed_byte_is_refused_or_valid(request: Request, data: st.DataObject) -> None:
    body = bytearray(body_of(sent_by_program(7, request)))
    at = data.draw(st.integers(0, len(body) - 1))
    body[at] = data.draw(st.integers(0, 255))
    try:
        answer = CODEC.decode(bytes(body), 7)
    except ProtocolError:
        return
    if isinstance(answer, Request):
        assert answer.advance_ticks >= 1
        assert all(abs(motor.velocity_radps) <= 10.00001 for motor in answer.motors)
        assert all(motor.position_rad > -math.inf for motor in answer.motors)
        assert all(len(payload) <= MESSAGE_BYTES for _, _, payload in answer.emissions)


@given(requests, st.integers(1, 60))
def test_a_request_that_is_cut_or_followed_by_more_is_refused(request: Request, count: int) -> None:
    body = body_of(sent_by_program(3, request))
    for wrong in (body[:-count], body + bytes(count)):
        with pytest.raises(ProtocolError):
            CODEC.decode(wrong, 3)


@pytest.mark.parametrize(
    ("request_", "says"),
    [
        (GOOD._replace(advance_ticks=0), "a request to advance by 0 ticks"),
        (GOOD._replace(motors=(MotorCommand(0, math.nan, 0.0),)), "device 0: a velocity of nan"),
        (GOOD._replace(motors=(MotorCommand(0, math.inf, 0.0),)), "device 0: a velocity of inf"),
        (GOOD._replace(motors=(MotorCommand(1, -10.1, 0.0),)), "device 1: a velocity of -10.1"),
        (GOOD._replace(motors=(MotorCommand(0, 1.0, math.nan),)), "device 0: a position of nan"),
        (GOOD._replace(motors=(MotorCommand(4, 1.0, 0.0),)), "device 4 is not a motor"),
        (GOOD._replace(motors=(MotorCommand(99, 1.0, 0.0),)), "device 99 is not a motor"),
        (GOOD._replace(sampling=((0, 1),)), "device 0 is not a sensor"),
        (GOOD._replace(channels=((4, 1),)), "device 4 is not a receiver"),
        (GOOD._replace(channels=((11, 1),)), "device 11 is not a receiver"),
        (GOOD._replace(frequencies=((4, 10.0),)), "device 4 is not a lidar"),
        (GOOD._replace(frequencies=((12, math.nan),)), "device 12: a frequency of nan Hz"),
        (GOOD._replace(emissions=((10, 3, b"x"),)), "device 10 is not an emitter"),
        (GOOD._replace(emissions=((11, 3, bytes(MESSAGE_BYTES + 1)),)), "a radio packet of 4001 bytes"),
    ],
)
def test_an_impossible_request_is_refused_with_a_reason(request_: Request, says: str) -> None:
    with pytest.raises(ProtocolError) as caught:
        CODEC.decode(body_of(sent_by_program(0, request_)), 0)
    assert str(caught.value) == says


@pytest.mark.parametrize(("device", "most"), [(0, 0.8), (1, 50.0), (2, 10.0)])
def test_each_motor_has_a_limit_of_its_own(device: int, most: float) -> None:
    facts: tuple[dict[str, float], ...] = {"max_velocity": 0.8}, {"max_velocity": 50.0}, {}
    motors = tuple(DeviceSpec(str(at), "motor", at, -1, 0, fact) for at, fact in enumerate(facts))
    codec = Codec(RobotSpec("B1", motors, 0, "bytes"), MESSAGE_BYTES)
    for velocity, is_taken in ((most, True), (-most, True), (most * 1.01, False)):
        request = Request(1, motors=(MotorCommand(device, velocity, math.inf),))
        body = body_of(sent_by_program(0, request))
        if is_taken:
            assert codec.decode(body, 0) == request
        else:
            with pytest.raises(ProtocolError, match=f"device {device}: a velocity of "):
                codec.decode(body, 0)


def test_a_request_that_answers_another_tick_is_refused() -> None:
    with pytest.raises(ProtocolError, match="answers tick 4 at tick 5"):
        CODEC.decode(body_of(sent_by_program(4, GOOD)), 5)


def test_the_end_message_of_a_program_is_sanitized() -> None:
    body = body_of(_wire.fault_frame("crash", "bad\x1b[31m\n\u202eline  at 0x7f00deadbeef", "a\n\x07b"))
    assert CODEC.decode(body, 0) == Ended("crash", "bad [31m line at 0x…", "a\n b")


@given(st.lists(payloads, max_size=5), st.data())
def test_frames_are_put_together_however_they_arrive(bodies: list[bytes], data: st.DataObject) -> None:
    stream = b"".join(struct.pack("<I", len(body)) + body for body in bodies)
    buffer, found = FrameBuffer(1_000), []
    while stream:
        size = data.draw(st.integers(1, len(stream)))
        buffer.held += stream[:size]
        stream = stream[size:]
        while (body := buffer.next()) is not None:
            found.append(body)
    assert found == bodies
    assert not buffer.held


facts = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(st.characters(exclude_categories=["Cs"])),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.text(st.characters(exclude_categories=["Cs"])), inner, max_size=3)
    ),
    max_leaves=8,
)


@given(facts)
def test_a_program_reads_the_hello_as_json(fact: object) -> None:
    frame = hello_frame(SPEC, {"fact": fact})
    assert frame[4] == _wire.HELLO
    reported = _boot._parsed(frame[5:].decode())
    assert reported["fact"] == fact
    assert reported["robot"]["devices"][4]["name"] == "gps"
    assert reported["protocol"] == 1


def test_the_programs_end_uses_nothing_but_the_standard_library() -> None:
    allowed = sys.stdlib_module_names | {"controller", "debugpy"}  # the last one with --debug only, if installed
    sources = list((PROGRAM_SIDE / "controller").glob("*.py"))
    assert sources
    for source in sources:
        for line in source.read_text(encoding="utf-8").splitlines():
            words = line.split()
            if words[:1] in (["import"], ["from"]) and not words[1].startswith("."):
                assert words[1].rstrip(",").split(".")[0] in allowed, f"{source.name}: {line}"


def test_the_document_of_the_protocol_names_every_form() -> None:
    text = (Path(__file__).parents[2] / "docs" / "protocol.md").read_text(encoding="utf-8")
    for form in (
        _wire.OBSERVATION_HEAD,
        _wire._REQUEST_HEAD,
        _wire.PACKET.format,
        _wire._EMISSION.format,
        _wire._FAULT.format,
        _wire._NOTES.format,
    ):
        assert form.lstrip("<").lstrip("I") in text.replace(" ", ""), form


@pytest.mark.parametrize("over", [False, True])
def test_observation_says_whether_the_half_is_over(over: bool) -> None:
    connection, _ = program_end(CODEC.encode(Observation(1, [0.0] * SPEC.values, [], over=over)))
    connection.exchange(32)
    assert connection.over == over


LEFT, RIGHT = INDEX["left wheel motor"], INDEX["right wheel motor"]


@pytest.mark.parametrize(
    ("advance", "wheels"),
    [
        (0, (LEFT, 5.0, math.inf, RIGHT, 5.0, math.inf)),
        (1, (LEFT, 5.0, math.inf, RIGHT, math.nan, math.inf)),
        (1, (LEFT, -10.1, math.inf, RIGHT, 5.0, math.inf)),
        (1, (LEFT, 5.0, math.inf, RIGHT, 5.0, -math.inf)),
        (1, (LEFT, 5.0, math.nan, RIGHT, 5.0, math.inf)),
        (1, (LEFT, 5.0, math.inf, INDEX["gps"], 5.0, math.inf)),
        (1, (INDEX["gps"], 5.0, math.inf, RIGHT, 5.0, math.inf)),
    ],
)
def test_of_the_commonest_request_nothing_is_taken_if_anything_is_wrong(
    advance: int, wheels: tuple[int, float, float, int, float, float]
) -> None:
    def body(tick: int, advance: int, wheels: tuple[float, ...]) -> bytes:
        return struct.pack("<BIIIQHHHHIHddHdd", 0x52, tick, advance, 0, 0, 2, 0, 0, 0, 0, *wheels)

    good = CODEC.decode(body(3, 1, (LEFT, 5.0, math.inf, RIGHT, -10.0, 1.5)), 3)
    assert good == Request(1, 0, (MotorCommand(LEFT, 5.0, math.inf), MotorCommand(RIGHT, -10.0, 1.5)))
    with pytest.raises(ProtocolError):
        CODEC.decode(body(4, advance, wheels), 4)
