"""Requests of the live view whose address cannot be read."""

import socket
from collections.abc import Iterator

import pytest

from rcj_challenges.records.testing import small_scenario
from rcj_challenges.views.live import LiveShow


@pytest.fixture
def show() -> Iterator[LiveShow]:
    with LiveShow(small_scenario(halves=1, half_s=60.0), {}, 1) as shown:
        yield shown


@pytest.mark.parametrize("address", ["http://[::1", "http://[", "http://x]/", "http://[x]/?from=0"])
@pytest.mark.parametrize("method", ["GET", "HEAD", "POST", "PUT"])
def test_malformed_address_is_answered_without_a_traceback(
    method: str, address: str, show: LiveShow, capfd: pytest.CaptureFixture[str]
) -> None:
    request = f"{method} {address} HTTP/1.1\r\nHost: 127.0.0.1:{show.port}\r\nContent-Length: 0\r\n\r\n"
    with socket.create_connection(("127.0.0.1", show.port), timeout=10) as connection:
        connection.sendall(request.encode("latin-1"))
        assert connection.recv(12) == b"HTTP/1.1 400"
    assert capfd.readouterr() == ("", "")
