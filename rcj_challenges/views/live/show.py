"""One live match: its address, its spectators, and its end."""

from __future__ import annotations

import errno
import math
import secrets
import threading
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, Self

from rcj_challenges.core.errors import RcjError
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import REPLAY
from rcj_challenges.records.result import read_result
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.codes import PORT_TAKEN
from rcj_challenges.views.live.encoder import LiveObserver, live_facts
from rcj_challenges.views.live.feed import Feed, json_message
from rcj_challenges.views.live.pace import Pace
from rcj_challenges.views.live.server import HOST, SpectatorServer
from rcj_challenges.views.replay.page import LIVE_PAGE, about_run, add_logos, page_text, places

_FLUSH_EVERY_S = 0.1
"""Three ticks at real time: fine enough to be smooth, rare enough to cost a fast match nothing."""
_BEAT_S = 0.5
_ACCEPT_EVERY_S = 0.05
"""How long the end of the server may take; connections are accepted at once."""


class LiveShow:
    """Serves a match from before its first tick until it is closed; a context manager.

    Pass `observer` to the match; afterwards call `match_over`, then `linger` for as long as spectators shall be served.
    Leaving the context closes all connections.

    ``port`` is on loopback only.
    """

    def __init__(
        self,
        scenario: Scenario,
        titles: Mapping[str, str],
        seed: int,
        *,
        logos: Mapping[str, bytes] | None = None,
        port: int = 0,
        speed: float = 1.0,
    ) -> None:
        """Open the port (0: a free one) and serve the page; titles and logos are by the seats of the first half.

        Raises:
            RcjError: the port is in use or not allowed.
        """
        self._scenario = scenario
        self._feed = Feed()
        self.pace = Pace(speed, lambda state: self._feed.append(json_message({"say": "pace", **state})))
        self._feed.append(json_message({"say": "pace", **self.pace.state}))
        self.observer = LiveObserver(scenario, self._feed, self.pace)
        match = secrets.token_urlsafe(9)
        facts = live_facts(scenario, dict(titles), seed)
        self._no_logos = add_logos(facts, (logos or {}).get)
        page = page_text({**facts, "match": match}, {}, kind=LIVE_PAGE).encode()
        try:
            self._server = SpectatorServer(port, page, match, self._feed, self.pace)
        except OSError as error:
            raise _port_error(port, error) from error
        self.port = self._server.port
        self._ended = threading.Event()
        threading.Thread(target=self._server.serve_forever, args=(_ACCEPT_EVERY_S,), daemon=True).start()
        threading.Thread(target=self._flush_regularly, daemon=True).start()

    @property
    def address(self) -> str:
        """The address for spectators on this machine."""
        return f"http://{HOST}:{self.port}/"

    @property
    def steering_address(self) -> str:
        """The same with the right to steer. Browsers do not send the token, because it stands behind ``#``."""
        return f"{self.address}#token={self._server.token}"

    def match_over(self, folder: Path) -> None:
        """Send the end of the match, and serve the replay page of its record, if it is there."""
        self.observer.flush()
        self.pace.release()
        page = folder / REPLAY
        self._server.replay = page if page.is_file() else None
        over: dict[str, Any] = {"about": [], "places": [], "complete": False}
        with suppress(RecordError):
            result = read_result(folder)
            over["about"], over["places"] = [*about_run(result), *self._no_logos], places(self._scenario, result)
            over["complete"] = result.complete
        self._feed.append(json_message({"say": "over", **over, "replay": self._server.replay is not None}))
        self._feed.close()

    def linger(self, seconds: float | None) -> None:
        """Go on serving for so long, or (None) until Ctrl-C."""
        until_s = math.inf if seconds is None else time.monotonic() + seconds
        with suppress(KeyboardInterrupt):
            while (left_s := until_s - time.monotonic()) > 0:
                # In slices: on some systems a long wait cannot be interrupted.
                self._ended.wait(min(_BEAT_S, left_s))

    def close(self) -> None:
        """Close all connections. Can be called again."""
        self._ended.set()
        self.pace.release()
        self._feed.close()
        self._server.shutdown()
        self._server.server_close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: object, error: object, trace: object) -> None:
        self.close()

    def _flush_regularly(self) -> None:
        while not self._ended.wait(_FLUSH_EVERY_S):
            self.observer.flush()


def _port_error(port: int, error: OSError) -> RcjError:
    taken = error.errno == errno.EADDRINUSE
    what = "is in use already" if taken else f"cannot be listened on: {error.strerror}"
    help_ = "take another port, or leave it out: a free one is found"
    return RcjError(f"--live: port {port} {what}", help_, code=PORT_TAKEN)
