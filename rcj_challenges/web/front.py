"""Stands before Django: Django reads every body whole before it looks at the address, so bodies are limited here.

Limits by path and counted bytes; few bodies are read at a time, so that the other pages stay quick; an archive that a
program sends is written to the disk and hashed while it comes. The feed of the stage is sent here, too: in Django each
spectator would hold a thread.
"""

from __future__ import annotations

import asyncio
import hashlib
import secrets
import time
from collections.abc import Awaitable, Callable, MutableMapping
from datetime import UTC, datetime
from typing import Any

from django.utils.translation import gettext, gettext_noop

from rcj_challenges.web.blobs import Blobs, stage_folder
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.stream import FEED, Stream

Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Message, Receive, Send], Awaitable[None]]

FORM_PATH = "/my/upload"
RAW_PATH = "/api/v1/submissions"
PAGE_BYTES = 64_000
_FORM_SLACK_BYTES = 20_000
MAX_BODY_S = 120.0
_FORMS, _RAW, _WAITING = 4, 16, 200
_DRAIN_BYTES, _DRAIN_S = 64_000_000, 5.0
_NO_ROOM = gettext_noop("The site has no room for more. The organizers can see this.")
_POLICY = b"default-src 'none'; frame-ancestors 'none'"


class _Refused(Exception):  # noqa: N818 - it carries an answer
    def __init__(self, status: int, text: str) -> None:
        super().__init__(text)
        self.status = status


class Front:
    """An ASGI application around Django's.

    Args:
        app: Django's.
        config: the settings of the site.
        clock: by which feeds of the stage are sent, in s since 1970.
    """

    def __init__(self, app: App, config: SiteConfig, clock: Callable[[], float] = time.time) -> None:
        self._app = app
        self._stream = Stream(stage_folder(config.folder), clock)
        self._config = config
        self._blobs = Blobs(config.folder)
        (config.folder / "incoming").mkdir(exist_ok=True)
        self._forms = asyncio.Semaphore(_FORMS)
        self._raw = asyncio.Semaphore(_RAW)
        self._waiting = 0
        self._teams: set[int] = set()

    async def __call__(self, scope: Message, receive: Receive, send: Send) -> None:
        """Answer a request."""
        if scope["type"] != "http":
            return
        scope["rcj.begun_at"] = datetime.now(UTC)
        if scope["method"] == "GET" and (feed := FEED.fullmatch(scope["path"])):
            await self._stream(feed[1], scope["query_string"], receive, send)
            return
        headers = dict(scope["headers"])
        is_upload = scope["method"] == "POST" and scope["path"] in {FORM_PATH, RAW_PATH}
        limit = self._limit(scope["path"]) if is_upload else PAGE_BYTES
        try:
            self._check_headers(headers, limit, is_upload=is_upload)
            if is_upload:
                await self._upload(scope, receive, send, limit)
            else:
                await self._pass_on(scope, receive, send, limit)
        except _Refused as refused:
            await _answer(send, refused.status, str(refused), receive)
        except OSError:  # of an upload or the spool of a form: the disk is full
            await _answer(send, 507, gettext(_NO_ROOM), receive)

    def _limit(self, path: str) -> int:
        return self._config.upload_bytes + (_FORM_SLACK_BYTES if path == FORM_PATH else 0)

    def _check_headers(self, headers: dict[bytes, bytes], limit: int, *, is_upload: bool) -> None:
        """Refuse what need not be read.

        Raises:
            _Refused: it is too large, has no length, or there is no room.
        """
        length = headers.get(b"content-length")
        if (
            length is None
            and b"transfer-encoding" in headers
            and headers.get(b"content-type", b"").startswith(b"multi")
        ):
            raise _Refused(411, gettext("A form must be sent with its length."))
        if length is not None and (not length.isdigit() or int(length) > limit):
            raise _Refused(413, gettext("At most {limit} bytes are taken here.").format(limit=limit))
        if is_upload and not self._blobs.has_room():
            raise _Refused(507, gettext(_NO_ROOM))

    async def _upload(self, scope: Message, receive: Receive, send: Send, limit: int) -> None:
        if self._waiting >= _WAITING:
            raise _Refused(503, gettext("Many are handing in at this moment. Try again."))
        slots = self._raw if scope["path"] == RAW_PATH else self._forms
        team = await asyncio.to_thread(_team_of, dict(scope["headers"]), is_raw=scope["path"] == RAW_PATH)
        if team is None:
            raise _Refused(401, gettext("Enter with the card of your team first."))
        if team in self._teams:
            raise _Refused(429, gettext("Another upload of this team is under way. Wait for its end."))
        mine = {team}
        self._teams |= mine

        async def send_and_let_go(message: Message) -> None:
            if message["type"] == "http.response.body" and not message.get("more_body", False):
                # Before the answer ends: whoever has read it may hand in again at once.
                self._teams -= mine
                mine.clear()
            await send(message)

        try:
            await self._upload_in_turn(slots, scope, receive, send_and_let_go, limit)
        finally:
            self._teams -= mine

    async def _upload_in_turn(
        self, slots: asyncio.Semaphore, scope: Message, receive: Receive, send: Send, limit: int
    ) -> None:
        self._waiting += 1
        try:
            await slots.acquire()
        finally:
            self._waiting -= 1
        try:
            if scope["path"] == RAW_PATH:
                await self._raw_upload(scope, receive, send, limit)
            else:
                await self._pass_on(scope, receive, send, limit)
        finally:
            slots.release()

    async def _raw_upload(self, scope: Message, receive: Receive, send: Send, limit: int) -> None:
        """Write a body to the disk; Django gets an empty one, and ``rcj.upload`` in the scope."""
        path = self._blobs.incoming / f"upload-{secrets.token_hex(8)}"
        digest, size = hashlib.sha256(), 0
        until = time.monotonic() + MAX_BODY_S
        try:
            with path.open("xb") as file:
                more = True
                while more:
                    message = await _receive_until(receive, until)
                    if message["type"] == "http.disconnect":
                        return
                    body = message.get("body", b"")
                    size += len(body)
                    if size > limit:
                        raise _Refused(413, gettext("At most {limit} bytes are taken here.").format(limit=limit))
                    digest.update(body)
                    await asyncio.to_thread(file.write, body)
                    more = message.get("more_body", False)
            scope["rcj.upload"] = (path, digest.hexdigest(), size)
            headers = [one for one in scope["headers"] if one[0] not in {b"content-length", b"transfer-encoding"}]
            await self._app({**scope, "headers": headers}, _empty_body(receive), send)
        finally:
            path.unlink(missing_ok=True)

    async def _pass_on(self, scope: Message, receive: Receive, send: Send, limit: int) -> None:
        """Have Django answer; a body that grows too large or takes too long is cut off."""
        size, refused, is_begun, is_whole = 0, None, False, False
        until = time.monotonic() + MAX_BODY_S

        async def counted() -> Message:
            nonlocal size, refused, is_whole
            if is_whole:
                return await receive()
            try:
                message = await _receive_until(receive, until)
            except _Refused as error:
                refused = error
                return {"type": "http.disconnect"}
            size += len(message.get("body", b""))
            if size > limit:
                refused = _Refused(413, gettext("At most {limit} bytes are taken here.").format(limit=limit))
                return {"type": "http.disconnect"}
            is_whole = not message.get("more_body", False)
            return message

        async def unless_refused(message: Message) -> None:
            nonlocal is_begun
            if refused is None:
                is_begun = True
                await send(message)

        await self._app(scope, counted, unless_refused)
        if refused is not None and not is_begun:
            raise refused


def _team_of(headers: dict[bytes, bytes], *, is_raw: bool) -> int | None:
    """Return the key of the team that a request is signed in as; strangers must not occupy the few slots."""
    from django.conf import settings  # noqa: PLC0415 - once Django is set up
    from django.contrib.sessions.backends.db import SessionStore  # noqa: PLC0415
    from django.db import DatabaseError, connection  # noqa: PLC0415
    from django.http import parse_cookie  # noqa: PLC0415

    from rcj_challenges.web.accounts import team_of_code, team_of_session  # noqa: PLC0415

    try:
        if is_raw:
            kind, _, code = headers.get(b"authorization", b"").decode("latin-1").partition(" ")
            team = team_of_code(code.strip()[:60], datetime.now(UTC)) if kind.lower() == "bearer" else None
        else:
            cookies = parse_cookie(headers.get(b"cookie", b"").decode("latin-1"))
            team = team_of_session(SessionStore(cookies.get(settings.SESSION_COOKIE_NAME)))
        return None if team is None else team.pk
    except DatabaseError as error:
        raise _Refused(503, gettext("The database of the site is away. Try again.")) from error
    finally:
        connection.close()  # that of this thread


async def _receive_until(receive: Receive, until: float) -> Message:
    try:
        return await asyncio.wait_for(receive(), max(0.0, until - time.monotonic()))
    except TimeoutError as error:
        raise _Refused(408, gettext("The body must come within {s:.0f} s.").format(s=MAX_BODY_S)) from error


def _empty_body(receive: Receive) -> Receive:
    is_sent = False

    async def once() -> Message:
        nonlocal is_sent
        if is_sent:
            return await receive()
        is_sent = True
        return {"type": "http.request", "body": b"", "more_body": False}

    return once


async def _drain(receive: Receive) -> None:
    """Read on for a moment: a connection that is closed while the client sends may lose the answer."""
    size, until = 0, time.monotonic() + _DRAIN_S
    while size < _DRAIN_BYTES:
        try:
            message = await _receive_until(receive, until)
        except _Refused:
            return
        size += len(message.get("body", b""))
        if message["type"] == "http.disconnect" or not message.get("more_body", False):
            return


async def _answer(send: Send, status: int, text: str, receive: Receive) -> None:
    """Answer at once, and end when the body has come or was waited for."""
    body = text.encode()
    start = [
        (b"content-type", b"text/plain; charset=utf-8"),
        (b"content-length", str(len(body)).encode()),
        (b"content-security-policy", _POLICY),
        (b"x-content-type-options", b"nosniff"),
        (b"connection", b"close"),
        *([(b"retry-after", b"10")] if status == 503 else ()),
    ]
    await send({"type": "http.response.start", "status": status, "headers": start})
    await send({"type": "http.response.body", "body": body, "more_body": True})
    await _drain(receive)
    await send({"type": "http.response.body", "body": b""})


def asgi_app(config: SiteConfig) -> App:
    """Return the whole application; Django must have been set up."""
    from django.core.asgi import get_asgi_application  # noqa: PLC0415 - once Django is set up

    django: App = get_asgi_application()  # type: ignore[assignment]  # the same, in other types
    return Front(django, config)
