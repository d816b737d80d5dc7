"""The digest of a run: equal inputs give an equal digest on one kind of machine.

SHA-256 over, each part behind a letter and its length so that no two runs share a stream of bytes: the resolved
scenario, the seed, the hashes of the teams' programs; then per half its number, per tick the judged state (qpos, qvel
as little-endian float64), and each event with its tick, without the time of day and without messages for people.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any

from rcj_challenges.facts.play import Event
from rcj_challenges.records.lines import canonical
from rcj_challenges.records.reflog import PROGRAM_FAULT

DIGEST_VERSION = 1
_CHUNK_BYTES = 1 << 15
_MESSAGES = {PROGRAM_FAULT: "detail"}


class Digest:
    """Builds the digest as a run goes on."""

    def __init__(self, scenario: Mapping[str, Any], seed: int, programs: Mapping[str, str]) -> None:
        """Begin with what decides a run.

        Args:
            scenario: the resolved scenario as JSON-able data.
            seed: of the match.
            programs: hash of the programs' files, by team.
        """
        self._sha = hashlib.sha256(f"rcj-challenges digest {DIGEST_VERSION}\n".encode("ascii"))
        self._pending = bytearray()
        self._state_bytes = -1
        self._state_head = b""
        for part in (scenario, seed, dict(programs)):
            self._frame(b"I", canonical(part))

    def half(self, half: int) -> None:
        """A half begins."""
        self._frame(b"H", canonical(half))

    def state(self, state: bytes) -> None:
        """Add the judged state of one tick."""
        if len(state) != self._state_bytes:
            self._state_bytes = len(state)
            self._state_head = b"S" + len(state).to_bytes(4, "little")
        pending = self._pending
        pending += self._state_head
        pending += state
        if len(pending) > _CHUNK_BYTES:
            self._sha.update(pending)
            pending.clear()

    def event(self, event: Event) -> None:
        """Add one event."""
        message = _MESSAGES.get(event.name)
        payload = {key: value for key, value in event.payload.items() if key != message}
        self._frame(b"E", canonical([event.tick, event.name, payload]))

    def hexdigest(self) -> str:
        """Return the digest of everything so far, as 64 hexadecimal digits."""
        self._sha.update(self._pending)
        self._pending.clear()
        return self._sha.hexdigest()

    def _frame(self, letter: bytes, data: bytes) -> None:
        self._pending += letter + len(data).to_bytes(4, "little") + data
