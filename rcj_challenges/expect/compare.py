"""Compares the outcome of a test with what it expects: single values, and events in order."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from itertools import zip_longest
from math import isclose
from typing import Any, NamedTuple

from rcj_challenges.core.amounts import counted
from rcj_challenges.core.play import Event
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules.fields import Scalar
from rcj_challenges.rules.phrasing import spelled
from rcj_challenges.scenario.models.scenario import Expectation, ExpectedEvent

_COUNTS_AS_EQUAL = 1e-9
MAX_DIFFERENCES = 10
"""At most so many differences of events are listed; further ones mostly have the same cause."""
MAX_PAIRS = 250_000
"""More pairs than these are compared by position, because finding the best order would take seconds."""
IGNORED_BY_DEFAULT: tuple[str, ...] = Expectation.model_fields["ignore"].default

_Pair = tuple[Event | None, int | None]
"""An event that came, and the number of the expected one that it stands beside; None: there is none."""


class Difference(NamedTuple):
    """What came out differently.

    Attributes:
        line: what was expected, and what is.
        lacks: what a rule would have changed, as kind and name: ``("event", "GOAL")`` or ``("event", "rule goal")`` if
            that is missing, ``("score", "blue")``, ``("counters", "laps")``, ``("flags", "out")``,
            ``("phase", "goal")``, ``("ended", "half")``, ``("held", "Y1")``; empty if it is none of these.
        at_s: the time in s at which an event was expected, if at any.
    """

    line: str
    lacks: tuple[str, ...] = ()
    at_s: float | None = None


def difference(
    what: str, expected: Scalar, found: Scalar | None, lacks: tuple[str, ...] = (), tolerance: float | None = None
) -> Iterator[Difference]:
    """Yield the difference if a value is not the expected one, or a number further off than a tolerance."""
    if equal(expected, found, tolerance or 0):
        return
    allowed = "" if tolerance is None else f"; up to {tolerance:g} off is allowed"
    yield Difference(f"{what}: expected {shown(expected)}, is {shown(found)}{allowed}", lacks)


def sent_difference(
    what: str, expected: Scalar | tuple[float, ...], found: Any, tolerance_m: float
) -> Iterator[Difference]:
    """Yield the difference if a value that was sent to a program is not the expected one.

    Of a position the first numbers are expected; each may be off by the tolerance, in m and rad.
    """
    if not isinstance(expected, tuple):
        yield from difference(what, expected, found if isinstance(found, str | int | float) else None)
        return
    numbers = found if isinstance(found, list) else []
    near = len(numbers) >= len(expected) and all(map(partial(equal, tolerance=tolerance_m), expected, numbers))
    if not near:
        shown_ones = [f"[{', '.join(map(shown, one))}]" if one else "nothing" for one in (expected, numbers)]
        allowed = f"up to {tolerance_m:g} off is allowed, more by tolerance_m"
        yield Difference(f"{what}: expected {shown_ones[0]}, is {shown_ones[1]}; {allowed}")


def equal(expected: Scalar, found: object, tolerance: float = 0) -> bool:
    """Return whether a value is as expected; numbers need not be of the same type."""
    numbers = (int, float)
    if isinstance(expected, bool) or isinstance(found, bool):
        return expected is found
    if isinstance(expected, numbers) and isinstance(found, numbers):
        near = abs(expected - found) <= tolerance + _COUNTS_AS_EQUAL
        return near if tolerance else isclose(expected, found, rel_tol=1e-9, abs_tol=1e-9)
    return expected == found


def shown(value: object) -> str:
    """Return a value as differences show it."""
    if value is None:
        return "nothing"
    return f"{value:g}" if isinstance(value, float) else spelled(value)


# --- events -----------------------------------------------------------------------------------------------------------


def event_differences(
    found: Sequence[Event], expected: Sequence[ExpectedEvent], ignored: Sequence[str]
) -> Iterator[Difference]:
    """Yield where the events that came are others than expected; those that the test ignores are not among them.

    Those that belong together are found first, so that one event too many is one difference.
    """
    pairs = _beside(found, expected)
    moved = {} if _is_flood(found, expected) else _elsewhere(pairs, expected)
    reported_there = set(moved.values())
    differences = [
        one
        for place, pair in enumerate(pairs)
        if place not in reported_there
        for one in (
            [_out_of_order(pairs, place, moved[place])] if place in moved else _differences_of(pair, expected, ignored)
        )
    ]
    yield from differences[:MAX_DIFFERENCES]
    more = len(differences) - MAX_DIFFERENCES
    if more > 0:
        yield Difference(f"and {counted(more, 'more difference')} of events")


def _differences_of(pair: _Pair, expected: Sequence[ExpectedEvent], ignored: Sequence[str]) -> Iterator[Difference]:
    event, index = pair
    if index is None:
        if event is not None:
            yield Difference(f"superfluous: {_format_event(event)}{_no_longer_ignored(event.name, ignored)}")
    elif event is None:
        wanted = expected[index]
        when = "" if wanted.at_s is None else f" at {wanted.at_s:g} s"
        line = f"missing: {wanted.what}{when}{_payload(wanted.payload)}, event {index + 1} of the test"
        yield Difference(line, ("event", wanted.what), wanted.at_s)
    else:
        yield from (Difference(f"differs: {line}") for line in _within(event, index + 1, expected[index]))


def _elsewhere(pairs: Sequence[_Pair], expected: Sequence[ExpectedEvent]) -> dict[int, int]:
    """Return the events in another order than the test's: place of the event to that of what is missing."""
    lacks = [(place, index) for place, (event, index) in enumerate(pairs) if event is None and index is not None]
    moved: dict[int, int] = {}
    for place, (event, index) in enumerate(pairs):
        if event is None or index is not None:
            continue
        fitting = (lack for lack in lacks if expected[lack[1]].what == event.name)
        found = next((lack for lack in fitting if not any(_within(event, 0, expected[lack[1]]))), None)
        if found is not None:
            moved[place] = found[0]
            lacks.remove(found)
    return moved


def _out_of_order(pairs: Sequence[_Pair], came: int, lacks: int) -> Difference:
    event, number = pairs[came][0], pairs[lacks][1]
    assert event is not None and number is not None  # noqa: S101, PT018 - so `_elsewhere` chose them
    others = [other for other, _ in pairs[min(came, lacks) : max(came, lacks)] if other is not None and other != event]
    at_once = any(other.tick == event.tick for other in others)
    why = "; events of one tick come in the order in which their rules are judged" if at_once else ""
    when = "earlier" if came < lacks else "later"
    return Difference(
        f"out of order: {_format_event(event)}, event {number + 1} of the test, came {when} than the test has it{why}"
    )


def _no_longer_ignored(name: str, ignored: Sequence[str]) -> str:
    """Return a note where a test ignores other events, and so no longer those that all others ignore."""
    if name not in IGNORED_BY_DEFAULT or name in ignored:
        return ""
    return (
        f"; ignore: [{', '.join(ignored)}] replaces the list that holds otherwise ({', '.join(IGNORED_BY_DEFAULT)}): "
        f"add {name} to it"
    )


def _within(event: Event, number: int, wanted: ExpectedEvent) -> Iterator[str]:
    if not _is_in_time(event, wanted):
        allowed = f"up to {wanted.tolerance_s:g} s off is allowed, more by tolerance_s beside at_s"
        at_s = s_from_ticks(event.tick)
        yield f"event {number} ({event.name}): expected at {wanted.at_s:g} s, came at {at_s:g} s; {allowed}"
    for key, value in wanted.payload.items():
        if not equal(value, event.payload.get(key)):
            is_now = shown(event.payload.get(key))
            yield f"event {number} ({event.name}): expected {key} {shown(value)}, is {is_now}"


def _is_in_time(event: Event, wanted: ExpectedEvent) -> bool:
    return _off_s(event, wanted) <= wanted.tolerance_s + _COUNTS_AS_EQUAL


def _off_s(event: Event, wanted: ExpectedEvent) -> float:
    return 0 if wanted.at_s is None else abs(s_from_ticks(event.tick) - wanted.at_s)


def _format_event(event: Event) -> str:
    return f"{event.name} at {s_from_ticks(event.tick):g} s{_payload(event.payload)}"


def _payload(payload: dict[str, Scalar]) -> str:
    entries = ", ".join(f"{key} {shown(value)}" for key, value in payload.items())
    return f" ({entries})" if entries else ""


# --- which belong together --------------------------------------------------------------------------------------------


def _beside(found: Sequence[Event], expected: Sequence[ExpectedEvent]) -> list[_Pair]:
    """Return events beside what is expected, in order: as many as can be of one name, then those most alike."""
    if _is_flood(found, expected):
        return list(_by_position(found, expected))
    # best[i][j]: how well the events from i on and the expected ones from j on go together.
    best = [[0.0] * (len(expected) + 1) for _ in range(len(found) + 1)]
    for i in reversed(range(len(found))):
        for j in reversed(range(len(expected))):
            together = _similarity(found[i], expected[j]) + best[i + 1][j + 1]
            best[i][j] = max(best[i + 1][j], best[i][j + 1], together if found[i].name == expected[j].what else 0)
    pairs: list[_Pair] = []
    i = j = 0
    while i < len(found) and j < len(expected):
        together = _similarity(found[i], expected[j]) + best[i + 1][j + 1]
        if found[i].name == expected[j].what and together == best[i][j]:
            pairs.append((found[i], j))
            i, j = i + 1, j + 1
        elif best[i + 1][j] == best[i][j]:
            pairs.append((found[i], None))
            i += 1
        else:
            pairs.append((None, j))
            j += 1
    return [*pairs, *((event, None) for event in found[i:]), *((None, left) for left in range(j, len(expected)))]


def _is_flood(found: Sequence[Event], expected: Sequence[ExpectedEvent]) -> bool:
    return len(found) * len(expected) > MAX_PAIRS


def _by_position(found: Sequence[Event], expected: Sequence[ExpectedEvent]) -> Iterable[_Pair]:
    for event, index in zip_longest(found, range(len(expected))):
        if event is not None and index is not None and event.name == expected[index].what:
            yield event, index
        else:
            yield from (pair for pair in ((event, None), (None, index)) if pair != (None, None))


_SAME_NAME = 1 << 20
"""More than all that makes events alike beside their name can add up to: pairs are at most 250 000."""


def _similarity(event: Event, wanted: ExpectedEvent) -> float:
    """Return the similarity of an event to the expected one, apart from its name: its payload, then its time."""
    as_told = sum(equal(value, event.payload.get(key)) for key, value in wanted.payload.items())
    payload = as_told / len(wanted.payload) if wanted.payload else 1
    # A sixteenth of a second counts as much as half a payload; halves keep sums of floats exact.
    time = 1.0 if _is_in_time(event, wanted) else 2.0 ** -min(20, 1 + int(_off_s(event, wanted) * 16))
    return _SAME_NAME + round(payload * 1024) / 1024 + time
