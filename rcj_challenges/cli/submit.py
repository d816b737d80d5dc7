"""``rcj-challenge submit``: hands a ZIP in on a site, waits for the check, and prints its report."""

from __future__ import annotations

import base64
import hashlib
import json
import os
import time
from http import HTTPStatus
from pathlib import Path
from typing import Annotated, Any
from urllib.parse import urlsplit

import typer

from rcj_challenges.cli.app import SUBMIT, app
from rcj_challenges.cli.codes import NOT_TAKEN, SITE_UNREACHABLE, WRONG_CARD
from rcj_challenges.cli.options import Json
from rcj_challenges.cli.stdio import print_json
from rcj_challenges.core.codes import BAD_OPTION, CANNOT_OPEN
from rcj_challenges.core.errors import RcjError, format_error
from rcj_challenges.core.sanitize import sanitize

_CODE_VARIABLE = "RCJ_CARD"
_TIMEOUT_S = 150
_POLL_S = 2.0
_AWAY_S = 60.0
_DONE = frozenset({"accepted", "rejected", "unchecked", "superseded"})
_EXIT_CODES = {"accepted": 0, "rejected": 1, "unchecked": 2, "superseded": 2}


@app.register(SUBMIT, "rcj-challenge submit my_team.zip --site http://club.lan:8000")
def submit(
    archive: Annotated[Path, typer.Argument(metavar="FILE", help="The ZIP to hand in.")],
    site: Annotated[str, typer.Option("--site", metavar="ADDRESS", help="The address of the site.")],
    code: Annotated[
        str | None,
        typer.Option("--code", metavar="CODE", help=f"The code of the card; else {_CODE_VARIABLE} or asked for."),
    ] = None,
    wait: Annotated[bool, typer.Option("--wait/--no-wait", help="Wait for the check, and print its report.")] = True,
    json_: Json = False,
) -> int:
    """Hand in a ZIP on a site, wait until it is checked, and print the report.

    Exit status as of check: 0: accepted; 1: rejected; 2: wrong usage, not taken, or not checked.
    """
    card = code or os.environ.get(_CODE_VARIABLE) or typer.prompt("code of the card", hide_input=True)
    api = _Site(site, card)
    receipt = api.hand_in(_read(archive))
    if not json_:
        late = " (late)" if receipt["is_late"] else ""
        typer.echo(f"received as number {receipt['number']}{late}: {receipt['sha256']}, {receipt['received_at']}")
    state = api.wait(receipt["id"], quiet=json_) if wait else receipt
    if json_:
        print_json(state)
    elif wait:
        _print(state)
    return _EXIT_CODES[state["state"]] if wait else 0


def _read(path: Path) -> bytes:
    try:
        if not path.is_file():
            raise RcjError(f"{sanitize(path)}: this is no file", "give a ZIP", code=CANNOT_OPEN)
        return path.read_bytes()
    except OSError as error:
        raise RcjError(f"{sanitize(path)}: {format_error(error)}", "give a ZIP", code=CANNOT_OPEN) from error


def _print(state: dict[str, Any]) -> None:
    """Print the verdict, as ``check`` does if there is a report."""
    from rcj_challenges.checker.report import FileReport, check_report
    from rcj_challenges.checker.report_text import print_report
    from rcj_challenges.views.console import console_for

    if state["report"] is not None:
        report = FileReport.model_validate(state["report"])
        print_report(console_for(to_stderr=False), check_report("", "", "strict", [report], []))
    typer.echo(f"{state['state']}{'; this one plays' if state['is_active'] else ''}")


class _Site:
    """The interface of a site.

    Args:
        address: of the site, with http or https.
        code: of the team's card.
    """

    def __init__(self, address: str, code: str) -> None:
        try:
            parts = urlsplit(address)
            is_address = parts.scheme in {"http", "https"} and parts.hostname and parts.port != 0
        except ValueError:  # the port is not a number, or too large
            is_address = False
        if not is_address:
            raise RcjError(
                f"--site {sanitize(address)}: this is no address", "--site http://club.lan:8000", code=BAD_OPTION
            )
        if not (code.isascii() and code.isprintable()):
            raise RcjError("this is no code of a card", "compare it with the card", code=WRONG_CARD)
        self._address = address
        self._parts = parts
        self._headers = {"Authorization": f"Bearer {code}"}

    def hand_in(self, data: bytes) -> dict[str, Any]:
        """Send an archive; return the receipt."""
        digest = base64.b64encode(hashlib.sha256(data).digest()).decode()
        return self._request("POST", "/api/v1/submissions", data, {"Content-Digest": f"sha-256=:{digest}:"})

    def wait(self, pk: int, *, quiet: bool) -> dict[str, Any]:
        """Wait until a submission is checked; return its state."""
        shown, reached = "", time.monotonic()
        while True:
            try:
                state = self._request("GET", f"/api/v1/submissions/{pk}")
            except RcjError as error:  # the receipt is there: a site that starts again is waited for
                if error.code != "site-unreachable" or time.monotonic() - reached > _AWAY_S:
                    raise
                time.sleep(_POLL_S)
                continue
            reached = time.monotonic()
            if state["state"] in _DONE:
                return state
            now = (
                f"place {state['place']} in the queue"
                if state["state"] == "queued"
                else f"checking {state['stage']}".rstrip()
            )
            if now != shown and not quiet:
                typer.echo(now, err=True)
                shown = now
            time.sleep(_POLL_S)

    def _request(
        self, method: str, path: str, body: bytes | None = None, headers: dict[str, str] | None = None
    ) -> dict[str, Any]:
        from http.client import HTTPConnection, HTTPException, HTTPSConnection

        kind = HTTPSConnection if self._parts.scheme == "https" else HTTPConnection
        connection = kind(self._parts.hostname or "", self._parts.port, timeout=_TIMEOUT_S)
        try:
            connection.request(method, self._parts.path.rstrip("/") + path, body, {**self._headers, **(headers or {})})
            answer = connection.getresponse()
            text = answer.read(10_000_000)
        except (OSError, HTTPException) as error:
            message = f"{sanitize(self._address)} cannot be reached: {format_error(error)}"
            raise RcjError(
                message, "check the address; nothing was handed in unless there was a receipt", code=SITE_UNREACHABLE
            ) from error
        finally:
            connection.close()
        try:
            data = json.loads(text)
        except ValueError:
            data = {"message": text.decode("utf-8", "replace")}
        if not isinstance(data, dict):
            data = {}
        if answer.status == HTTPStatus.UNAUTHORIZED:
            raise RcjError("the site refuses this code", "compare it with the card", code=WRONG_CARD)
        if answer.status >= HTTPStatus.BAD_REQUEST:
            why = sanitize(data.get("message", data.get("detail", "")), 300) or answer.reason
            raise RcjError(f"the site did not take it: {why}", "see the message; then try again", code=NOT_TAKEN)
        return data
