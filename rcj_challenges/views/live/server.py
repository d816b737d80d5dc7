"""The server of a live match: standard library, loopback only, a thread for each connection.

Its addresses (`docs/live.md`): ``GET /`` the page, ``GET /feed?match=ID&from=N`` the feed from a byte on for as long
as it grows, ``GET /replay.html`` the finished page, ``POST /steer`` with the token: pause, resume, step, speed.
"""

from __future__ import annotations

import hmac
import json
import secrets
import socket
import socketserver
import sys
import threading
from contextlib import suppress
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

from rcj_challenges.views.live.feed import KEEP_ALIVE, Feed
from rcj_challenges.views.live.pace import MAX_SPEED, MAX_STEPS, Pace

HOST = "127.0.0.1"
MAX_CONNECTIONS = 64
"""Further spectators get status 503."""

_TIMEOUT_S = 20.0
"""Idle connections are closed after this time; the page connects again by itself."""
_KEEP_ALIVE_S = 5.0
_MAX_COMMAND_BYTES = 1_024
_MAX_DIGITS = 12
_MAX_DRAINED_BYTES = 65_536
_LINGER_S = 1.0
_REFUSED_WITHIN_S = 0.2
"""How long a connection that is refused may hold up the next one."""

_HEADERS = {
    "Cache-Control": "no-store",
    "Content-Security-Policy": "frame-ancestors 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}
_HTML = "text/html; charset=utf-8"
_JSON = "application/json"
_TEXT = "text/plain; charset=utf-8"


class SpectatorServer(ThreadingHTTPServer):
    """Listens on loopback and shows one match; `serve_forever` runs in a thread of its own.

    The threads of connections end with the process: a spectator never holds up the end.

    Attributes:
        token: gives the right to steer.
        replay: the finished page, once there is one.
    """

    daemon_threads = True
    block_on_close = False
    # Elsewhere it lets a port be used again at once; on Windows it would let two programs share one.
    allow_reuse_address = sys.platform != "win32"
    request_queue_size = 32

    def __init__(self, port: int, page: bytes, match: str, feed: Feed, pace: Pace) -> None:
        """Listen; port 0 takes a free one, ``page`` is the viewer in UTF-8.

        ``match`` identifies this match, so that a page of another one does not receive its feed.

        Raises:
            OSError: the port is taken or not allowed.
        """
        self.page, self.match, self.feed, self.pace = page, match, feed, pace
        self.token = secrets.token_urlsafe(24)
        self.replay: Path | None = None
        self._free = threading.BoundedSemaphore(MAX_CONNECTIONS)
        super().__init__((HOST, port), _Handler)
        self.port: int = self.server_address[1]
        self.hosts = frozenset(
            name for host in (HOST, "localhost") for name in (f"{host}:{self.port}", *((host,) * (self.port == 80)))
        )
        self.origins = frozenset(f"http://{host}" for host in self.hosts)

    def server_bind(self) -> None:
        """Bind without a look-up of the host's name, which may take seconds."""
        socketserver.TCPServer.server_bind(self)
        self.server_name, self.server_port = HOST, self.server_address[1]

    def process_request(self, request: Any, client_address: Any) -> None:
        """Give the connection a thread, if there is one left."""
        if not self._free.acquire(blocking=False):
            with suppress(OSError):
                request.settimeout(_REFUSED_WITHIN_S)
                request.sendall(b"HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 0\r\n\r\n")
                request.shutdown(socket.SHUT_WR)
                request.recv(_MAX_DRAINED_BYTES)  # unread bytes would discard the answer on Windows
            self.shutdown_request(request)
            return
        super().process_request(request, client_address)

    def process_request_thread(self, request: Any, client_address: Any) -> None:
        """Serve one connection, and give its place back."""
        try:
            super().process_request_thread(request, client_address)
        finally:
            self._free.release()

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Ignore spectators that are gone."""
        if not isinstance(sys.exception(), OSError):
            super().handle_error(request, client_address)


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server_version = "rcj-challenges"
    sys_version = ""
    timeout = _TIMEOUT_S
    server: SpectatorServer

    def do_GET(self) -> None:
        """Show the page, the feed or the replay, or steer the match, if the request is allowed."""
        server = self.server
        answers = {
            "/": (self._page, ("GET", "HEAD")),
            "/feed": (self._feed, ("GET",)),
            "/replay.html": (self._replay, ("GET", "HEAD")),
            "/steer": (self._steer, ("POST",)),
        }
        origin, site = self.headers.get("Origin"), self.headers.get("Sec-Fetch-Site", "none")
        try:
            path = urlsplit(self.path).path
        except ValueError:  # such as "http://[::1"
            self._refuse(400, "this address cannot be read")
            return
        answer, methods = answers.get(path, (None, ()))
        if self.headers.get("Host", "").lower() not in server.hosts or len(self.headers.get_all("Host", [])) != 1:
            # A name that merely resolves to this machine would let another site's script read and steer.
            self._refuse(403, f"ask for http://{HOST}:{server.port}/")
        elif (origin is not None and origin.lower() not in server.origins) or (
            site not in ("none", "same-origin") and path != "/"
        ):
            self._refuse(403, "not from another page")
        elif answer is None:
            self._refuse(404, "there is nothing of that name")
        elif self.command not in methods:
            self._refuse(405, "not in this way", {"Allow": ", ".join(methods)})
        else:
            answer()

    # The names that http.server looks for.
    do_HEAD = do_POST = do_PUT = do_DELETE = do_PATCH = do_OPTIONS = do_GET  # noqa: N815

    # --- answers ----------------------------------------------------------------------------------------------------

    def _page(self) -> None:
        self._answer(200, self.server.page, _HTML)

    def _feed(self) -> None:
        server = self.server
        asked = parse_qs(urlsplit(self.path).query)
        start = asked.get("from", ["0"])[0]
        if not _is_count(start):
            return self._refuse(400, "from: a number of bytes")
        if asked.get("match", [""])[0] != server.match:
            return self._refuse(409, "another match is played here now")
        self._head(200, {"Content-Type": "application/octet-stream", "Transfer-Encoding": "chunked"})
        at = min(int(start), server.feed.size_bytes)
        while (chunk := server.feed.read(at, _KEEP_ALIVE_S)) is not None:
            sent = chunk or KEEP_ALIVE
            self.wfile.write(b"%x\r\n%b\r\n" % (len(sent), sent))
            at += len(chunk)
        self.wfile.write(b"0\r\n\r\n")
        return None

    def _replay(self) -> None:
        replay = self.server.replay
        page = None
        with suppress(OSError):
            page = replay.read_bytes() if replay else None
        if page is None:
            return self._refuse(404, "the match is not over yet, or its replay was not written")
        return self._answer(200, page, _HTML)

    def _steer(self) -> None:
        given = self.headers.get("Authorization", "").encode("utf-8", "replace")
        if not hmac.compare_digest(given, f"Bearer {self.server.token}".encode()):
            why = "only the person who started the match may steer it: use the address with the token"
            return self._refuse(403, why)
        length = self.headers.get("Content-Length", "")
        if not _is_count(length) or int(length) > _MAX_COMMAND_BYTES:
            return self._refuse(413, f"a command of at most {_MAX_COMMAND_BYTES} bytes")
        try:
            apply_command(self.server.pace, json.loads(self.rfile.read(int(length))))
        except (ValueError, TypeError, RecursionError) as error:
            return self._refuse(400, str(error), keep=True)
        return self._answer(200, json.dumps(self.server.pace.state).encode(), _JSON)

    def _refuse(self, status: int, why: str, more: dict[str, str] | None = None, *, keep: bool = False) -> None:
        """Refuse a request; the connection ends, unless all of the request was read."""
        if not keep:
            self.close_connection = True
            more = {"Connection": "close", **(more or {})}
        self._answer(status, f"{why}\n".encode(), _TEXT, more)
        if not keep:
            self._drain_request()

    def _drain_request(self) -> None:
        """Read a little of what is still sent: closing a connection with unread bytes would discard the answer."""
        with suppress(OSError):
            self.wfile.flush()
            self.connection.shutdown(socket.SHUT_WR)
            self.connection.settimeout(_LINGER_S)
            left = _MAX_DRAINED_BYTES
            while left > 0 and (taken := self.connection.recv(min(left, _MAX_COMMAND_BYTES))):
                left -= len(taken)

    def _answer(self, status: int, body: bytes, kind: str, more: dict[str, str] | None = None) -> None:
        self._head(status, {"Content-Type": kind, "Content-Length": str(len(body)), **(more or {})})
        if self.command != "HEAD":
            self.wfile.write(body)

    def _head(self, status: int, more: dict[str, str]) -> None:
        self.send_response(status)
        for name, value in (_HEADERS | more).items():
            self.send_header(name, value)
        self.end_headers()

    def log_message(self, format: str, *arguments: Any) -> None:  # noqa: A002 - the name that http.server gives it
        """Log nothing: the terminal belongs to the match, and addresses are private."""


def _is_count(text: str) -> bool:
    """Return whether a text is a whole number of so few digits that Python converts it."""
    return text.isascii() and text.isdigit() and len(text) <= _MAX_DIGITS


def apply_command(pace: Pace, command: Any) -> None:
    """Apply a command: ``{"do": "pause"}``, ``resume``, ``step`` (with ``ticks``), ``speed`` (a number or null).

    Raises:
        ValueError: it is not a command; the message lists them.
    """
    match command:
        case {"do": "pause"}:
            pace.pause()
        case {"do": "resume"}:
            pace.resume()
        case {"do": "step"}:
            ticks = command.get("ticks", 1)
            if type(ticks) is not int or not 1 <= ticks <= MAX_STEPS:
                raise ValueError(f"ticks: a whole number from 1 to {MAX_STEPS}")
            pace.step(ticks)
        case {"do": "speed"}:
            speed = command.get("speed")
            if speed is not None and (isinstance(speed, bool) or not isinstance(speed, int | float)):
                raise ValueError("speed: a number, or null for as fast as it can")
            pace.set_speed(MAX_SPEED if speed is None else speed)
        case _:
            raise ValueError("do: one of pause, resume, step, speed")
