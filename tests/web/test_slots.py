"""The few slots in which uploads are read are for teams, one for each."""

from __future__ import annotations

import contextlib
import socket
from collections.abc import Callable

import pytest

from rcj_challenges.web.config import SiteConfig
from tests.web.conftest import Served, make_team, use_site


def begin(served: Served, path: str, headers: str) -> socket.socket:
    """Send all of an upload but the end of its body."""
    host, port = served.address.removeprefix("http://").split(":")
    connection = socket.create_connection((host, int(port)), timeout=30)
    kind = "Content-Type: multipart/form-data; boundary=x\r\nContent-Length: 5000\r\n"
    connection.sendall(f"POST {path} HTTP/1.1\r\nHost: localhost\r\n{headers}{kind}\r\n--x\r\n".encode())
    return connection


@pytest.mark.parametrize("path", ["/my/upload", "/api/v1/submissions"])
def test_strangers_do_not_occupy_the_slots_and_a_team_one_at_a_time(quiet: Served, path: str) -> None:
    with use_site(quiet.config):
        from django.contrib.sessions.backends.db import SessionStore

        team, code = make_team()
        session = SessionStore()
        session["team"], session["epoch"] = team.pk, team.epoch
        session.save()
    card = f"Authorization: Bearer {code}\r\nCookie: session={session.session_key}\r\n"
    wrong = "Authorization: Bearer 0000\r\nCookie: session=0000\r\n"
    with contextlib.ExitStack() as stack:
        stack.enter_context(begin(quiet, path, card))
        strangers = [
            stack.enter_context(begin(quiet, path, wrong)) for _ in range(20)
        ]  # its card is read before theirs
        assert [stranger.recv(12)[-3:] for stranger in strangers] == [b"401"] * 20
        headers = dict(line.split(": ") for line in card.splitlines())
        assert quiet.send(path, b"x", headers)[0] == 429


def test_upload_while_the_database_is_away_is_to_be_tried_again(
    folder: Callable[..., SiteConfig], serve: Callable[..., Served]
) -> None:
    config = folder()
    served = serve(config, "--no-dispatch")
    for path in config.folder.glob("site.sqlite3*"):
        path.unlink()
    (config.folder / "site.sqlite3").mkdir()
    assert served.send("/api/v1/submissions", b"x", {"Authorization": "Bearer 0000"})[0] == 503
