"""The digests of a run: `inputs` of what was played, `states` of what happened, and one over both.

``inputs`` hashes the scenario without values that are defaults, the seed, and the hashes of the programs' files. Keys
of models are sorted; named mappings keep the order of the file, in which rules are judged. So neither a new optional
key nor a moved field changes it. Params are left out: their values stand where they are used. There 15 and 15.0 are the
same wherever a number is asked for, but not in a text, event or broadcast, where programs see the difference.

``states`` hashes for each half its number, for each tick the judged state (qpos, qvel as little-endian float64), and
each event with its tick, without the time of day and without messages for people. Each part stands behind its kind and
its length, so that no two runs share a stream of bytes.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

from rcj_challenges.core.play import Event
from rcj_challenges.records.lines import canonical
from rcj_challenges.records.reflog import PROGRAM_FAULT
from rcj_challenges.scenario.models.scenario import Scenario

_INPUTS_VERSION = 1
_STATES_VERSION = 1
_CHUNK_BYTES = 1 << 15
_MESSAGES = {PROGRAM_FAULT: "detail"}


def inputs_digest(scenario: Scenario, seed: int, programs: Mapping[str, str]) -> str:
    """Return the SHA-256 of a resolved scenario, the seed and the hashes of programs by team, in hexadecimal digits."""
    played = given_values(scenario)
    played.pop("params", None)
    parts = [f"rcj-challenges inputs {_INPUTS_VERSION}", played, seed, dict(sorted(programs.items()))]
    return hashlib.sha256(canonical(parts)).hexdigest()


def given_values(value: Any) -> Any:
    """Return a model as JSON-able data: without defaults, its keys sorted."""
    if isinstance(value, BaseModel):
        given = {}
        for name, field in type(value).model_fields.items():
            inner = getattr(value, name)
            if not field.exclude and not _is_same(inner, field.get_default(call_default_factory=True)):
                given[field.alias or name] = given_values(inner)
        return dict(sorted(given.items()))
    if isinstance(value, Mapping):
        return {key: given_values(inner) for key, inner in value.items()}
    if isinstance(value, list | tuple):
        return [given_values(inner) for inner in value]
    return value


def _is_same(value: Any, default: Any) -> bool:
    """Return whether a value is the default; to Python true is 1."""
    return isinstance(value, bool) == isinstance(default, bool) and bool(value == default)


def run_digest(inputs: str, states: str) -> str:
    """Return the SHA-256 over both digests of a run."""
    return hashlib.sha256(f"{inputs} {states}".encode("ascii")).hexdigest()


class StatesDigest:
    """Builds the digest of what happens as a run goes on."""

    def __init__(self) -> None:
        self._sha = hashlib.sha256(f"rcj-challenges states {_STATES_VERSION}\n".encode("ascii"))
        self._pending = bytearray()
        self._state_bytes, self._state_head = -1, b""

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

    def _frame(self, kind: bytes, data: bytes) -> None:
        self._pending += kind + len(data).to_bytes(4, "little") + data
