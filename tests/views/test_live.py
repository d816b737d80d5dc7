"""The live view without a browser: who is let in, who may steer, what spectators are sent, and what it does not change."""

import http.client
import json
import socket
import struct
import threading
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.changes import ScoreChange
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.play import Firing, Placement, RefereeOutput
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.views.live import MAX_SPEED, LiveShow, Pace
from rcj_challenges.views.live.encoder import LiveObserver
from rcj_challenges.views.live.feed import Feed
from rcj_challenges.views.live.server import MAX_CONNECTIONS, apply_command
from tests.made_up_runs import (
    half_info,
    made_up_play,
    made_up_snapshot,
    small_header,
    small_scenario,
    write_made_up_run,
)

SCENARIO = small_scenario(halves=2, half_s=60.0)
HEADER = small_header(SCENARIO)
ROBOTS = len(SCENARIO.robots)
CHANNELS, ENTITIES = 5, ROBOTS + 1


@pytest.fixture
def show() -> Iterator[LiveShow]:
    with LiveShow(SCENARIO, dict(HEADER.team_names), 1) as shown:
        yield shown


def _token(show: LiveShow) -> str:
    return show.steering_address.partition("#token=")[2]


def _match(page: str) -> str:
    facts = page.partition('id="facts">')[2].partition("</script>")[0]
    return str(json.loads(facts)["match"])


Ask = Callable[..., tuple[int, dict[str, str], bytes]]


@pytest.fixture
def ask(show: LiveShow) -> Ask:
    def asked(
        method: str = "GET", path: str = "/", body: bytes | None = None, **headers: str
    ) -> tuple[int, dict[str, str], bytes]:
        connection = http.client.HTTPConnection("127.0.0.1", show.port, timeout=120)
        named = {name.replace("_", "-"): value for name, value in headers.items()}
        connection.putrequest(method, path, skip_host="Host" in named)
        if body is not None:
            connection.putheader("Content-Length", str(len(body)))
        for name, value in named.items():
            connection.putheader(name, value)
        connection.endheaders(body)
        answer = connection.getresponse()
        read = answer.read() if method != "HEAD" else b""
        connection.close()
        return answer.status, dict(answer.getheaders()), read

    return asked


def _messages(data: bytes) -> list[Any]:
    """Return what a piece of the feed says: dicts, and (half, tick, rows) of poses."""
    found: list[Any] = []
    while data:
        kind, length = struct.unpack_from("<BI", data)
        body, data = data[5 : 5 + length], data[5 + length :]
        if kind == 1:
            found.append(json.loads(body))
        elif kind == 2:
            half, tick = struct.unpack_from("<HI", body)
            found.append((half, tick, body[6:]))
    return found


# --- who is let in -----------------------------------------------------------------------------------------------------


def test_the_page_needs_no_token_and_connects_to_no_other_server(show: LiveShow, ask: Ask) -> None:
    status, headers, body = ask()
    page = body.decode()
    assert status == 200
    assert headers["Content-Type"] == "text/html; charset=utf-8"
    assert "default-src 'none'" in page
    assert "connect-src 'self'" in page
    assert "unsafe" not in page.partition("<style>")[0]
    assert headers["Content-Security-Policy"] == "frame-ancestors 'none'"
    assert headers["X-Content-Type-Options"] == "nosniff"
    assert _token(show) not in page


def test_it_listens_on_loopback_only(show: LiveShow) -> None:
    assert show.address == f"http://127.0.0.1:{show.port}/"
    assert show._server.socket.getsockname()[0] == "127.0.0.1"


@pytest.mark.parametrize(
    "host", ["evil.example", "evil.example:{port}", "127.0.0.1", "127.0.0.1:1", "localhost.evil:{port}", ""]
)
def test_a_request_for_another_host_is_refused(host: str, show: LiveShow, ask: Ask) -> None:
    # A name of another site that resolves to this machine (DNS rebinding).
    order = {"Host": host.format(port=show.port)}
    assert ask(**order)[0] == 403
    assert ask("POST", "/steer", b'{"do": "pause"}', Authorization=f"Bearer {_token(show)}", **order)[0] == 403
    assert show.pace.state["paused"] is False


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "https://127.0.0.1:{port}", "http://127.0.0.1:1"])
def test_another_pages_script_is_refused(origin: str, show: LiveShow, ask: Ask) -> None:
    here = {"Origin": origin.format(port=show.port), "Authorization": f"Bearer {_token(show)}"}
    assert ask("POST", "/steer", b'{"do": "pause"}', **here)[0] == 403
    assert ask("GET", "/feed?match=x&from=0", **here)[0] == 403
    assert ask("OPTIONS", "/steer", **here)[0] == 403
    assert show.pace.state["paused"] is False


def test_who_is_refused_may_end_the_sentence(show: LiveShow) -> None:
    head = f"POST /steer HTTP/1.1\r\nHost: 127.0.0.1:{show.port}\r\nContent-Length: 40000\r\n\r\n"
    with socket.create_connection(("127.0.0.1", show.port), timeout=10) as connection:
        connection.sendall(head.encode())
        answer = connection.recv(4096)
        for _ in range(40):
            connection.sendall(b"x" * 1000)  # fails where the server has stopped reading
    assert answer.startswith(b"HTTP/1.1 403 ")


def test_what_another_page_embeds_is_refused(ask: Ask) -> None:
    assert ask("GET", "/feed?match=x&from=0", Sec_Fetch_Site="cross-site")[0] == 403
    assert ask("GET", "/", Sec_Fetch_Site="cross-site")[0] == 200  # a link to the page is no harm


@pytest.mark.parametrize(
    "path", ["/etc/passwd", "/../result.json", "/runs/", "/%2e%2e/", "//evil.example/", "/index.html"]
)
def test_no_other_file_is_served(path: str, ask: Ask) -> None:
    status, _, body = ask("GET", path)
    assert status == 404
    assert b"passwd" not in body


@pytest.mark.parametrize("address", ["http://[::1", "http://[x]/?from=0"])
@pytest.mark.parametrize("method", ["GET", "HEAD", "POST", "PUT"])
def test_malformed_address_is_answered_without_a_traceback(
    method: str, address: str, show: LiveShow, capfd: pytest.CaptureFixture[str]
) -> None:
    request = f"{method} {address} HTTP/1.1\r\nHost: 127.0.0.1:{show.port}\r\nContent-Length: 0\r\n\r\n"
    with socket.create_connection(("127.0.0.1", show.port), timeout=10) as connection:
        connection.sendall(request.encode("latin-1"))
        assert connection.recv(12) == b"HTTP/1.1 400"
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("method", "path"), [("POST", "/"), ("GET", "/steer"), ("PUT", "/"), ("DELETE", "/feed"), ("POST", "/feed")]
)
def test_other_methods_are_refused(method: str, path: str, ask: Ask) -> None:
    assert ask(method, path, b"" if method != "GET" else None)[0] == 405


@pytest.mark.parametrize("start", ["-1", "x", "1e3", "٣", "9" * 40])
def test_a_place_in_the_feed_is_a_number(start: str, ask: Ask) -> None:
    page = ask()[2].decode()
    assert ask("GET", f"/feed?match={_match(page)}&from={quote(start)}")[0] == 400


def test_page_of_another_match_is_refused(ask: Ask) -> None:
    assert ask("GET", "/feed?match=another&from=0")[0] == 409


def test_there_is_no_replay_before_the_end(ask: Ask) -> None:
    assert ask("GET", "/replay.html")[0] == 404


def test_the_65th_connection_is_refused_and_the_first_goes_on(show: LiveShow, ask: Ask) -> None:
    match = _match(ask()[2].decode())
    waiting = []
    try:
        for _ in range(MAX_CONNECTIONS):
            spectator = socket.create_connection(("127.0.0.1", show.port), timeout=10)
            spectator.sendall(
                f"GET /feed?match={match}&from=0 HTTP/1.1\r\nHost: 127.0.0.1:{show.port}\r\n\r\n".encode()
            )
            assert spectator.recv(12) == b"HTTP/1.1 200"
            waiting.append(spectator)
        assert ask()[0] == 503
        # A client that sends first and then reads gets it whole too; a reset connection would lose it.
        late = socket.create_connection(("127.0.0.1", show.port), timeout=10)
        waiting.append(late)
        late.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{show.port}\r\n\r\n".encode())
        reply = b"".join(iter(lambda: late.recv(1024), b""))
        assert reply.startswith(b"HTTP/1.1 503 ")
        assert reply.endswith(b"\r\n\r\n")
    finally:
        for spectator in waiting:
            spectator.close()


def test_a_taken_port_is_reported_with_help(show: LiveShow) -> None:
    with pytest.raises(RcjError) as error:
        LiveShow(SCENARIO, {}, 1, port=show.port)
    assert error.value.code == "port-taken"
    assert error.value.exit_code == 2


def test_it_ends_although_spectators_are_connected(ask: Ask, show: LiveShow) -> None:
    match = _match(ask()[2].decode())
    spectator = socket.create_connection(("127.0.0.1", show.port), timeout=10)
    spectator.sendall(f"GET /feed?match={match}&from=0 HTTP/1.1\r\nHost: 127.0.0.1:{show.port}\r\n\r\n".encode())
    assert spectator.recv(12) == b"HTTP/1.1 200"
    silent = socket.create_connection(("127.0.0.1", show.port), timeout=10)  # never asks for anything
    show.close()
    show.close()
    with pytest.raises(ConnectionError):
        socket.create_connection(("127.0.0.1", show.port), timeout=1)
    spectator.close()
    silent.close()


# --- who may steer -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "given", [None, "", "Bearer ", "Bearer wrong", "Bearer {token}x", "Basic {token}", "{token}", "Bearer é"]
)
def test_steering_without_the_token_is_refused(given: str | None, show: LiveShow, ask: Ask) -> None:
    headers = {} if given is None else {"Authorization": given.format(token=_token(show))}
    before = show.pace.state
    for order in (b'{"do": "pause"}', b'{"do": "speed", "speed": 8}', b'{"do": "step"}'):
        assert ask("POST", "/steer", order, **headers)[0] == 403
    assert show.pace.state == before


def test_who_has_the_token_steers(show: LiveShow, ask: Ask) -> None:
    key = {"Authorization": f"Bearer {_token(show)}", "Origin": show.address.rstrip("/")}
    assert json.loads(ask("POST", "/steer", b'{"do": "pause"}', **key)[2]) == {"paused": True, "speed": 1.0}
    assert json.loads(ask("POST", "/steer", b'{"do": "speed", "speed": null}', **key)[2]) == {
        "paused": True,
        "speed": None,
    }
    assert json.loads(ask("POST", "/steer", b'{"do": "resume"}', **key)[2]) == {"paused": False, "speed": None}


@pytest.mark.parametrize(
    ("order", "why"),
    [
        (b"", "Expecting value"), (b"[]", "do: one of"), (b'{"do": "stop"}', "do: one of"), (b'{"do": ["pause"]}', "do: one of"),
        (b'{"do": "step", "ticks": 0}', "ticks"), (b'{"do": "step", "ticks": true}', "ticks"), (b'{"do": "step", "ticks": 1001}', "ticks"),
        (b'{"do": "speed", "speed": 0}', "a speed is"), (b'{"do": "speed", "speed": -1}', "a speed is"), (b'{"do": "speed", "speed": NaN}', "a speed is"),
        (b'{"do": "speed", "speed": "8"}', "speed: a number"), (b"\xff\xfe", "Expecting value"), (b"[" * 1000, ""),
    ],
)  # fmt: skip
def test_an_invalid_order_is_reported_and_changes_nothing(order: bytes, why: str, show: LiveShow, ask: Ask) -> None:
    before = show.pace.state
    status, _, body = ask("POST", "/steer", order, Authorization=f"Bearer {_token(show)}")
    assert status == 400
    assert why in body.decode()
    assert show.pace.state == before


@pytest.mark.parametrize("length", ["1025", "999999999999", "9" * 5000, "-1", "x"])
def test_a_long_order_is_not_read(length: str, show: LiveShow, ask: Ask) -> None:
    assert ask("POST", "/steer", None, Authorization=f"Bearer {_token(show)}", Content_Length=length)[0] == 413


@given(
    st.recursive(
        st.none() | st.booleans() | st.floats() | st.text(max_size=8),
        lambda inner: (
            st.dictionaries(st.sampled_from(["do", "ticks", "speed", "x"]), inner, max_size=3)
            | st.lists(inner, max_size=2)
        ),
    )
)
def test_any_json_is_an_order_or_refused(order: Any) -> None:
    pace = Pace()
    with suppress(ValueError):
        apply_command(pace, order)
    speed = pace.state["speed"]
    assert speed is None or 0 < speed <= 1000
    assert set(pace.state) == {"paused", "speed"}


# --- pace --------------------------------------------------------------------------------------------------------------


class Clock:
    """A clock that moves when somebody waits for it."""

    def __init__(self) -> None:
        self.now_s = 0.0

    def __call__(self) -> float:
        return self.now_s


@pytest.mark.parametrize("speed", [0.5, 1.0, 4.0])
def test_ticks_come_at_the_speed_that_is_set(speed: float) -> None:
    clock = Clock()
    pace = Pace(speed, clock=clock)
    for tick in range(1, 200):
        while (wait_s := pace._wait_s(tick)) > 0:
            clock.now_s += wait_s
    assert clock.now_s == pytest.approx(198 * TICK_S / speed)


def test_a_match_that_is_late_does_not_race_afterwards() -> None:
    clock = Clock()
    pace = Pace(1.0, clock=clock)
    pace.before_tick(1)
    clock.now_s += 30.0
    assert pace._wait_s(2) == 0.0
    assert pace._wait_s(3) == pytest.approx(TICK_S)


def test_a_paused_match_waits_and_a_step_plays_so_many_ticks() -> None:
    clock = Clock()
    asked = threading.Semaphore(0)

    def time_s() -> float:
        now_s = clock()
        asked.release()
        return now_s

    pace = Pace(MAX_SPEED, clock=time_s)
    assert asked.acquire(timeout=60)
    pace.pause()
    played = threading.Semaphore(0)
    held_up_s: list[float] = []

    def play() -> None:
        for tick in range(1, 6):
            held_up_s.append(pace.before_tick(tick))
            played.release()

    match = threading.Thread(target=play, daemon=True)
    match.start()
    assert not played.acquire(timeout=0.05)
    assert asked.acquire(timeout=60)  # the match waits for its first tick
    clock.now_s = 7.0
    pace.step(3)
    assert all(played.acquire(timeout=60) for _ in range(3))
    assert not played.acquire(timeout=0.05)
    assert all(asked.acquire(timeout=60) for _ in range(6))  # and now for its fourth
    clock.now_s = 9.0
    pace.resume()
    match.join(60)
    assert not match.is_alive()
    assert held_up_s == [7.0, 0.0, 0.0, 2.0, 0.0]


def test_a_half_after_another_keeps_the_pace() -> None:
    clock = Clock()
    pace = Pace(1.0, clock=clock)
    for tick in (1, 2, 3, 1, 2):
        while (wait_s := pace._wait_s(tick)) > 0:
            clock.now_s += wait_s
    assert clock.now_s == pytest.approx(3 * TICK_S)


# --- the feed ----------------------------------------------------------------------------------------------------------


@given(st.lists(st.binary(min_size=1, max_size=50), max_size=20), st.integers(0, 400))
def test_whoever_reads_from_anywhere_gets_the_same_bytes(chunks: list[bytes], start: int) -> None:
    feed = Feed()
    for chunk in chunks:
        feed.append(chunk)
    feed.close()
    whole = b"".join(chunks)
    read = b""
    while (piece := feed.read(start + len(read), 0.0)) is not None:
        read += piece
    assert read == whole[start:]


def test_who_has_read_everything_waits_for_more() -> None:
    feed = Feed()
    feed.append(b"abc")
    assert feed.read(3, 0.01) == b""
    threading.Timer(0.05, feed.append, (b"def",)).start()
    assert feed.read(3, 10.0) == b"def"


def test_a_spectator_that_reads_nothing_does_not_hold_up_the_match(show: LiveShow, ask: Ask) -> None:
    match = _match(ask()[2].decode())
    stuck = socket.create_connection(("127.0.0.1", show.port), timeout=10)
    stuck.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    stuck.sendall(f"GET /feed?match={match}&from=0 HTTP/1.1\r\nHost: 127.0.0.1:{show.port}\r\n\r\n".encode())
    show.observer.half_started(half_info(SCENARIO, 1, 1875, HEADER))
    for snapshot, output in made_up_play(ROBOTS, 1875):
        show.observer.after_tick(snapshot, output)
        if snapshot.tick % 100 == 0:
            show.observer.flush()
    show.observer.flush()
    assert show._feed.size_bytes > 1875 * CHANNELS * ENTITIES * 2
    stuck.close()


def _received(ticks: list[tuple[Any, RefereeOutput]], every: int = 7) -> list[Any]:
    feed = Feed()
    observer = LiveObserver(SCENARIO, feed, Pace(MAX_SPEED))
    observer.half_started(half_info(SCENARIO, 1, len(ticks) - 1, HEADER))
    for number, (snapshot, output) in enumerate(ticks):
        observer.after_tick(snapshot, output)
        if number % every == 0:
            observer.flush()
    observer.flush()
    feed.close()
    return _messages(_all(feed))


def _all(feed: Feed) -> bytes:
    read = b""
    while (piece := feed.read(len(read), 0.0)) is not None:
        read += piece
    return read


def test_every_tick_is_sent_once_and_in_order_however_it_is_flushed() -> None:
    ticks = list(made_up_play(ROBOTS, 500))
    for every in (1, 7, 10_000):
        rows = [message for message in _received(ticks, every) if isinstance(message, tuple)]
        at = 0
        for half, first, numbers in rows:
            assert (half, first) == (1, at)
            at += len(numbers) // (2 * CHANNELS * ENTITIES)
        assert at == 501


def test_goals_faults_phases_and_jumps_are_sent_with_their_tick() -> None:
    news = [
        message
        for message in _received(list(made_up_play(ROBOTS, 900)))
        if isinstance(message, dict) and message["say"] == "news"
    ]
    goals = [message for message in news if "score_changes" in message]
    assert [message["score_changes"][0][0] for message in goals] == [400, 800]
    assert goals[-1]["score_changes"] == [[800, {"blue": 0, "yellow": 2}]]
    assert goals[-1]["jumps"] == {str(ROBOTS): [800]}
    assert goals[-1]["phases"] == [[800, "goal_pause", True]]
    event = goals[-1]["events"][0]
    assert (event["name"], event["standing"], event["measured"]) == ("GOAL", "0 : 2", 0.76)
    (failed,) = [message for message in news if "faults" in message]
    (fault,), (event,) = failed["faults"], failed["events"]
    assert (fault["tick"], fault["robot"], event["name"]) == (300, "Y1", "PROGRAM_FAULT")


def test_events_after_the_last_tick_are_shown() -> None:
    feed = Feed()
    observer = LiveObserver(SCENARIO, feed, Pace(MAX_SPEED))
    half = half_info(SCENARIO, 1, 2, HEADER)
    observer.half_started(half)
    for tick in range(3):
        observer.after_tick(made_up_snapshot(tick, ROBOTS), RefereeOutput())
    firing = Firing(2, "goal", None, "half_ended", scored={"yellow": 5})
    change = ScoreChange(2, {"blue": 0, "yellow": 5})
    observer.after_last_tick(RefereeOutput(firings=(firing,), changes=(change,)), half)
    feed.close()
    last = _messages(_all(feed))[-1]
    assert last["score_changes"] == [[2, {"blue": 0, "yellow": 5}]]


def test_the_start_is_shown_as_the_first_tick_finds_it() -> None:
    start = RefereeOutput(placements=(Placement(ROBOTS, 0.25, -0.5, 0.0),))
    (message,) = [sent for sent in _received([(made_up_snapshot(0, ROBOTS), start)]) if isinstance(sent, tuple)]
    row = struct.unpack(f"<{CHANNELS * ENTITIES}h", message[2])
    unit = max(1e-4, (max(SCENARIO.field.width_m, SCENARIO.field.length_m) / 2 + 3.0) / 32_767)
    assert row[ENTITIES - 1] * unit == pytest.approx(0.25, abs=2e-4)
    assert row[2 * ENTITIES - 1] * unit == pytest.approx(-0.5, abs=2e-4)


def test_the_record_never_holds_the_token(tmp_path: Path, show: LiveShow) -> None:
    folder = write_made_up_run(tmp_path, ticks=50, halves=1)
    show.match_over(folder)
    token = _token(show).encode()
    assert all(token not in path.read_bytes() for path in folder.rglob("*") if path.is_file())
    assert token not in _all(show._feed)
