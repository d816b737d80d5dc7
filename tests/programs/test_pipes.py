"""Exchanging frames without ever waiting longer than asked: both ways alike."""

from __future__ import annotations

import itertools
import os
import struct
import sys
import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass
from types import SimpleNamespace

import pytest

from rcj_challenges.programs import pipes
from rcj_challenges.programs.pipes import Channel, ChannelClosedError, FrameTooLongError, open_channel

LIMIT = 3_000_000


def framed(body: bytes) -> bytes:
    return struct.pack("<I", len(body)) + body


@dataclass
class Line:
    """A channel and the other side's ends of its pipes."""

    channel: Channel
    their_read: int
    their_write: int

    def says(self, data: bytes) -> None:
        while data:
            data = data[os.write(self.their_write, data) :]

    def hears(self, size: int) -> bytes:
        heard = b""
        while len(heard) < size:
            heard += os.read(self.their_read, size - len(heard))
        return heard

    def hangs_up(self) -> None:
        os.close(self.their_write)
        self.their_write = -1

    def goes_deaf(self) -> None:
        os.close(self.their_read)
        self.their_read = -1


def opened_line(*, portable: bool) -> Iterator[Line]:
    read_fd, their_write = os.pipe()
    their_read, write_fd = os.pipe()
    line = Line(open_channel(read_fd, write_fd, LIMIT, portable=portable), their_read, their_write)
    yield line
    for fd in (line.their_read, line.their_write):
        if fd >= 0:
            os.close(fd)
    line.channel.close()


@pytest.fixture(params=[False, True], ids=["polled", "threaded"])
def line(request: pytest.FixtureRequest) -> Iterator[Line]:
    if sys.platform == "win32" and not request.param:
        pytest.skip("pipes cannot be polled on Windows")
    yield from opened_line(portable=request.param)


def test_frames_come_one_by_one_in_order(line: Line) -> None:
    line.says(framed(b"one") + framed(b"") + framed(b"three"))
    assert [line.channel.receive(5) for _ in range(3)] == [b"one", b"", b"three"]
    assert line.channel.receive(0) is None


@pytest.mark.parametrize("timeout_s", [0.0, -1.0, 0.05])
def test_receive_returns_none_when_the_time_is_over(line: Line, timeout_s: float) -> None:
    began = time.perf_counter()
    assert line.channel.receive(timeout_s) is None
    assert time.perf_counter() - began >= timeout_s - 0.005


def test_what_is_here_already_is_received_without_waiting(line: Line) -> None:
    assert line.channel.receive(0.0) is None
    line.says(framed(b"one") + framed(b"two")[:5])
    assert line.channel.receive(5) == b"one"  # the threaded one may need a moment
    assert line.channel.receive(0.0) is None
    line.says(framed(b"two")[5:] + framed(b"three"))
    assert line.channel.receive(5) == b"two"
    until = time.perf_counter() + 60
    while (third := line.channel.receive(0.0)) is None and time.perf_counter() < until:
        time.sleep(0.001)
    assert third == b"three"
    line.hangs_up()
    with pytest.raises(ChannelClosedError):
        nothing_until_it_ends(line.channel)


@pytest.mark.skipif(sys.platform == "win32", reason="pipes cannot be polled on Windows")
class TestOneThatAnswersAtOnce:
    """Whoever waits for it looks again and again for a moment: to sleep and be woken takes longer than its answer."""

    @pytest.fixture
    def looks(self, monkeypatch: pytest.MonkeyPatch) -> list[int]:
        """Counts how often the other side is given its turn while it is waited for."""
        counted: list[int] = []
        monkeypatch.setattr(pipes, "_let_others_run", lambda: counted.append(len(counted)))
        return counted

    @pytest.fixture
    def line(self) -> Iterator[Line]:
        yield from opened_line(portable=False)

    def test_its_frame_is_received_without_sleeping(
        self, line: Line, looks: list[int], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(pipes, "MOMENT_S", 60.0)
        monkeypatch.setattr(pipes, "_let_others_run", lambda: (looks.append(0), line.says(framed(b"soon"))))
        assert line.channel.receive_soon() == b"soon"
        assert line.channel.receive(5) == b"soon"
        assert len(looks) == 2

    def test_the_rest_of_its_frame_is_looked_for_too(self, line: Line) -> None:
        line.says(framed(b"whole")[:6])
        assert line.channel.receive(0.0) is None
        line.says(framed(b"whole")[6:])
        assert line.channel.receive(0.0) == b"whole"

    def test_one_that_takes_longer_is_slept_for_until_it_answers_at_once_again(
        self, line: Line, looks: list[int], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        assert line.channel.receive_soon() is None
        looks.clear()
        assert line.channel.receive_soon() is None
        assert line.channel.receive(0.001) is None
        assert looks == []
        monkeypatch.setattr(pipes, "MOMENT_S", 60.0)
        threading.Timer(0.01, line.says, [framed(b"one")]).start()
        assert line.channel.receive(5) == b"one"
        assert looks == []
        monkeypatch.setattr(pipes, "_let_others_run", lambda: (looks.append(0), line.says(framed(b"two"))))
        assert line.channel.receive_soon() == b"two"
        assert looks == [0]

    def test_one_that_takes_longer_is_given_another_chance_now_and_then(
        self, line: Line, looks: list[int], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        moments_s = itertools.count(0.0, pipes.MOMENT_S / 3)  # each look at the clock takes so long
        monkeypatch.setattr(pipes, "time", SimpleNamespace(perf_counter=lambda: next(moments_s)))
        tried = []
        for _ in range(60):
            looks.clear()
            assert line.channel.receive_soon() is None
            tried.append(bool(looks))
        assert [at for at, looked in enumerate(tried) if looked] == [0, 17, 34, 51]

    def test_receive_without_time_does_not_wait(self, line: Line, looks: list[int]) -> None:
        assert line.channel.receive(0.0) is None
        assert looks == []

    def test_a_side_that_is_gone_raises_an_error(self, line: Line) -> None:
        line.hangs_up()
        with pytest.raises(ChannelClosedError):
            line.channel.receive_soon()


def nothing_until_it_ends(channel: Channel) -> None:
    until = time.perf_counter() + 60
    while time.perf_counter() < until:
        assert channel.receive(0.0) is None


def test_half_a_frame_is_kept_until_the_rest_comes(line: Line) -> None:
    line.says(framed(b"whole")[:6])
    assert line.channel.receive(0.02) is None
    line.says(framed(b"whole")[6:] + framed(b"next")[:2])
    assert line.channel.receive(5) == b"whole"
    assert line.channel.receive(0.02) is None
    line.says(framed(b"next")[2:])
    assert line.channel.receive(5) == b"next"


def test_sending_more_than_a_pipe_holds_does_not_wait(line: Line) -> None:
    large = framed(bytes(2_000_000))
    line.channel.send(large)
    heard: list[bytes] = []

    def other_side() -> None:
        heard.append(line.hears(len(large)))
        line.says(framed(b"answer"))

    listener = threading.Thread(target=other_side)
    listener.start()
    assert line.channel.receive(30) == b"answer"
    listener.join()
    assert heard == [large]


@pytest.mark.skipif(sys.platform == "win32", reason="pipes cannot be polled on Windows")
def test_for_one_that_answers_without_reading_nothing_is_kept() -> None:
    read_fd, their_write = os.pipe()
    their_read, write_fd = os.pipe()
    line = Line(open_channel(read_fd, write_fd, LIMIT, portable=False), their_read, their_write)
    line.says(framed(b"in advance") * 3)
    for _ in range(3):
        line.channel.send(framed(bytes(200_000)))
        assert line.channel.receive(30) == b"in advance"
    with pytest.raises(ChannelClosedError):
        line.channel.receive(30)
    line.channel.close()
    os.set_blocking(their_read, False)
    kept = 0
    while chunk := os.read(their_read, 1 << 20):
        kept += len(chunk)
    assert kept < 200_000
    line.hangs_up()
    line.goes_deaf()


def test_a_large_frame_is_received_whole(line: Line) -> None:
    body = bytes(range(256)) * 8_000
    talker = threading.Thread(target=line.says, args=(framed(body),))
    talker.start()
    assert line.channel.receive(30) == body
    talker.join()


def test_messages_sent_before_closing_are_still_received(line: Line) -> None:
    line.says(framed(b"last words"))
    line.hangs_up()
    assert line.channel.receive(5) == b"last words"
    for _ in range(2):
        with pytest.raises(ChannelClosedError):
            line.channel.receive(5)


def test_a_side_that_stopped_reading_is_still_read(line: Line) -> None:
    line.goes_deaf()
    line.says(framed(b"why"))
    line.channel.send(framed(b"unheard"))
    assert line.channel.receive(5) == b"why"


def test_a_frame_beyond_the_limit_is_refused_by_its_length(line: Line) -> None:
    line.says(struct.pack("<I", LIMIT + 1))
    with pytest.raises(FrameTooLongError) as caught:
        line.channel.receive(5)
    assert caught.value.args == (LIMIT + 1,)
