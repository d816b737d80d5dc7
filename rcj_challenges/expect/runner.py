"""Plays ``expect`` blocks of a scenario and compares the outcome with what they expect."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import islice
from math import hypot
from typing import TYPE_CHECKING, Any

from rcj_challenges.core.amounts import counted, number_words, round_score, times
from rcj_challenges.core.play import Event, HalfInfo
from rcj_challenges.core.timing import s_from_ticks, ticks_from_s
from rcj_challenges.expect.compare import Difference, difference, event_differences, sent_difference
from rcj_challenges.expect.denied import Lacks, denied_condition_notes, has_kind, missed_notes, silent_rules
from rcj_challenges.expect.scripted_match import ScriptedMatch, half_of
from rcj_challenges.referee.carry_over import CarryOver
from rcj_challenges.referee.engine import Referee
from rcj_challenges.referee.ranking import ranking
from rcj_challenges.rules.effects import Emits, Ends
from rcj_challenges.scenario.draw_order import places_of
from rcj_challenges.scenario.halves import by_seat
from rcj_challenges.scenario.models.scenario import Expectation, Given, Keyframe, MatchExpectation, Scenario
from rcj_challenges.scenario.models.state import Counter, Flag
from rcj_challenges.scenario.roster import Roster, as_tuple
from rcj_challenges.tracking.state import Number

if TYPE_CHECKING:
    from rcj_challenges.scenario.load import Loaded

MAX_PHASES = 5
"""At most so many changes of phases are noted for a failed test."""


@dataclass(frozen=True)
class TestResult:
    """The outcome of one ``expect`` block.

    Attributes:
        differences: what came out differently, one line each, then notes on why that may be: what found no room, draws
            that were not drawn, gates crossed the wrong way, what a rule put where it should enter, rules of which a
            condition did not hold, the course of the phases; empty if all is as expected.
        fired: the rules that fired, in the order of their first time.
    """

    __test__ = False  # pytest must not collect it

    differences: tuple[str, ...]
    ticks: int
    fired: tuple[str, ...]


def run_test(loaded: Loaded, name: str) -> TestResult:
    """Play one ``expect`` block of a scenario.

    A keyframe takes effect in the snapshot of its tick (one at 0 in that of tick 1). If the script outlasts the half,
    or a rule ends it, the rules of ``half_ended`` run as well.

    Raises:
        KeyError: there is no block of this name.
        ValueError: the block decides a draw that does not exist, or a value that it cannot have.
    """
    expected, scenario = loaded.scenario.expect[name], loaded.scenario
    if isinstance(expected, Expectation):
        return _play(loaded, expected, half_of(scenario, expected.half, expected.seed))[1]
    carry_over, period = CarryOver(scenario), scenario.match.period
    match: ScriptedMatch | None = None
    differences: list[str] = []
    ticks, fired = 0, dict[str, None]()
    for number, part in enumerate(expected.halves, start=1):
        if match is not None and match.output.ends_match:
            differences.append(f"{period} {number}: not played, as the match was over")
            break
        half = half_of(scenario, number, expected.seed)
        titles = {seat: scenario.entrants[team].title or team for seat, team in half.teams.items()}
        scores = by_seat(carry_over.scores, half.teams)
        half = replace(half, team_names=titles, scores=scores, kept=carry_over.kept)
        match, result = _play(loaded, part, half, is_last=number == len(expected.halves))
        carry_over.add(half, match.referee)
        differences += (f"{period} {number}: {line}" for line in result.differences)
        ticks, fired = ticks + result.ticks, fired | dict.fromkeys(result.fired)
    assert match is not None  # noqa: S101 - there is at least one half
    differences += (one.line for one in _total_differences(match.referee, carry_over, expected))
    return TestResult(tuple(differences), ticks, tuple(fired))


def _play(
    loaded: Loaded, expected: Expectation, half: HalfInfo, *, is_last: bool = True
) -> tuple[ScriptedMatch, TestResult]:
    """Play a half; unless it is the last, it is over after its script."""
    scenario = loaded.scenario
    half = replace(
        half,
        scores=half.scores | {seat: round_score(score) for seat, score in expected.given.score.items()},
        kept=_kept(scenario, loaded.roster, expected.given, half.kept),
    )
    spots = {name: places_of(places) for name, places in (expected.spots or {}).items()}
    match = ScriptedMatch(scenario, loaded.roster, half, expected.draws, spots)
    _follow(match, expected)
    if match.output.ended is not None or match.referee.time_is_up or not is_last:
        match.finish()
    fired = dict.fromkeys(firing.rule for firing in match.firings if firing.suppressed is None)
    differences = [*_differences(match, scenario, expected), *_unsettled(match)]
    lacks = {one.lacks: one.at_s for one in reversed(differences) if one.lacks}
    silent = silent_rules(scenario, lacks, fired)
    notes = (
        (
            *_no_room(match),
            *_not_drawn(match, expected),
            *missed_notes(match.referee.missed, scenario, silent),
            *denied_condition_notes(match.referee.rounds.denied or {}, silent, lacks),
            *_early_end_notes(match, scenario, expected, lacks),
            *_course(match, lacks),
        )
        if differences
        else ()
    )
    return match, TestResult((*(one.line for one in differences), *notes), match.tick, tuple(fired))


def _follow(match: ScriptedMatch, expected: Expectation) -> None:
    """Play the script."""
    before = 0
    for keyframe in expected.keyframes:
        at = max(1, ticks_from_s(keyframe.at_s))
        # Glides begin at the keyframe before; two keyframes in one tick make a jump of it.
        match.play_until(min(before, at - 1))
        away = [entity for entity in keyframe.move if match.is_off(entity)]
        for entity, to in keyframe.move.items():
            if entity not in away:
                match.glide(entity, to, at - match.tick)
        match.play_until(at - 1)
        back = {entity: keyframe.move[entity] for entity in away if match.is_off(entity)}
        for entity, to in (keyframe.place | back).items():
            match.place(entity, *to)
        _act(match, keyframe)
        before = at
    match.play_until(ticks_from_s(expected.lasts_s))


def _unsettled(match: ScriptedMatch) -> Iterable[Difference]:
    """Yield the rules that would go on setting each other off after the half."""
    rules = dict.fromkeys(firing.rule for firing in match.firings if firing.suppressed == "unsettled")
    if rules:
        line = f"unsettled: after the last tick these rules set each other off without end: {', '.join(rules)}"
        yield Difference(line)


def _no_room(match: ScriptedMatch) -> Iterable[str]:
    """Return notes on placements without room: often the reason why something is not where a test expects it."""
    first = {(f.rule, f.says): f for f in reversed(match.firings) if f.suppressed == "no_room"}
    for firing in sorted(first.values(), key=lambda firing: firing.tick):
        yield f"note: from {s_from_ticks(firing.tick):g} s on {firing.says} (rule {firing.rule})"


def _early_end_notes(match: ScriptedMatch, scenario: Scenario, expected: Expectation, lacks: Lacks) -> Iterable[str]:
    """Return a note on the rule that ended the half or the match, where the test would have gone on."""
    last = ticks_from_s(expected.lasts_s)
    if match.output.ended is None or match.tick >= last:
        return
    left_out = any(ticks_from_s(one.at_s) > match.tick for one in expected.keyframes)
    if not (has_kind(lacks, "event") or left_out or expected.ended == "none"):
        return
    what = "match" if match.output.ends_match else "half"
    ending = (f.rule for f in reversed(match.firings) if f.suppressed is None and scenario.rules[f.rule].effects(Ends))
    rule = next(ending, None)
    if rule is not None:
        at_s = s_from_ticks(match.tick)
        yield f"note: {rule} ended the {what} at {at_s:g} s, and so the test; it lasts {expected.lasts_s:g} s"


def _course(match: ScriptedMatch, lacks: Lacks) -> Iterable[str]:
    """Return the course of the phases if an event is missing: rules are inactive in phases that are not theirs."""
    if len(match.phases) == 1 or not has_kind(lacks, "event"):
        return
    entered = [*match.phases[1 : MAX_PHASES + 1], None]
    course = [
        phase if after is None else f"{phase} until {s_from_ticks(after[0]):g} s"
        for (_, phase), after in zip(match.phases, entered, strict=False)
    ]
    more = ", …" if len(match.phases) > len(course) else ""
    yield f"note: the phase was {', then '.join(course)}{more}"


def _not_drawn(match: ScriptedMatch, expected: Expectation) -> Iterable[str]:
    """Return notes on draws and spots that chance decided less often than the test decides them."""
    for name, left in match.referee.undecided().items():
        series = as_tuple(expected.draws[name])
        drawn = len(series) - len(left)
        yield f"note: {name} was drawn {times(drawn)}; draws decides {counted(len(series), 'value')}"
    for name, missing in match.referee.undecided_spots().items():
        places = len(places_of((expected.spots or {})[name]))
        decides = "a place" if places == 1 else f"{places} places"
        yield f"note: chance set {name} {times(places - missing)}; spots decides {decides}"


def _kept(scenario: Scenario, roster: Roster, given: Given, kept: Mapping[str, Any]) -> dict[str, Any]:
    """Return what the half before left, and what a test presets as if it had; members without a preset are at first."""
    roles = {role: None if name == "none" else name for role, name in given.roles.items()}
    presets: tuple[tuple[str, Mapping[str, Counter | Flag], Mapping[str, Any]], ...] = (
        ("counters", scenario.counters, given.counters), ("flags", scenario.flags, given.flags),
    )  # fmt: skip
    found = {**kept, "draws": kept.get("draws", {}) | roles}
    for section, entries, preset in presets:
        own = {name: _preset(entries[name], value, roster) for name, value in preset.items()}
        found[section] = kept.get(section, {}) | own
    return found


def _preset(entry: Counter | Flag, value: Any, roster: Roster) -> Any:
    if isinstance(value, int | float) and entry.per is None:
        return value if isinstance(value, bool) else round_score(value)
    members = () if entry.per is None else roster.keepers(entry.per)
    found = dict.fromkeys(members, entry.first) | (value if isinstance(value, dict) else dict.fromkeys(members, value))
    return {member: one if one is None or isinstance(one, bool) else round_score(one) for member, one in found.items()}


def _act(match: ScriptedMatch, keyframe: Keyframe) -> None:
    for first, second in keyframe.touch:
        match.touch(first, second, 1 if keyframe.touch_lasts_s is None else ticks_from_s(keyframe.touch_lasts_s))
    for robot in keyframe.tips:
        match.tip(robot)
    for robot in keyframe.fault:
        match.fail(robot)
    for robot, said in (keyframe.tells or {}).items():
        match.tell(robot, " ".join(map(str, said)) if isinstance(said, tuple) else str(said))


def _differences(match: ScriptedMatch, scenario: Scenario, expected: Expectation) -> Iterable[Difference]:
    referee = match.referee
    if expected.events is not None:
        wanted = {event.what for event in expected.events}
        ignored = set(expected.ignore) - wanted
        events = [event for event in _happened(match, scenario, wanted) if event.name not in ignored]
        yield from event_differences(events, expected.events, expected.ignore)
    for entrant, score in expected.score.items():
        yield from difference(f"score of {entrant}", score, referee.scores.get(entrant), ("score", entrant))
    yield from _counter_differences(referee, expected)
    yield from _kept_differences("flag", expected.flags, referee.flags)
    holders = {role: referee.draws.get(role) or "none" for role in expected.roles}
    yield from _kept_differences("role", expected.roles, holders)
    for what, value, found in (("phase", expected.phase, referee.phase), ("ended", expected.ended, _ended(match))):
        if value is not None:
            yield from difference(what, value, found, (what, value))
    if expected.ranking is not None:
        by_now = referee.ranked(half_of(scenario))  # what the test has given counts, too
        yield from _ranking_differences(ranking(scenario.result.rank, [*by_now], [by_now]), expected.ranking)
    for name, is_held in (expected.held or {}).items():
        yield from difference(f"{name} held", is_held, referee.held.get(name), ("held", name))
    yield from _pose_differences(match, expected)
    for robots, fields in (expected.told or {}).items():
        for robot in match.roster.expand(robots):
            for key, sent in fields.items():
                received = match.received.get(robot, {}).get(key)
                yield from sent_difference(f"{key} told to {robot}", sent, received, expected.tolerance_m)


def _happened(match: ScriptedMatch, scenario: Scenario, wanted: Container[str]) -> Iterator[Event]:
    """Yield the events in order, and where a rule of which firings are expected fired, this as an event."""
    events = iter(match.events)
    for firing in match.firings:
        if firing.suppressed is None:
            about = {"entity": firing.entity, "place": firing.place, "other": firing.other}
            fired = Event(firing.tick, f"rule {firing.rule}", {key: name for key, name in about.items() if name})
            if fired.name in wanted:
                yield fired
            yield from islice(events, len(scenario.rules[firing.rule].effects(Emits)))


def _counter_differences(referee: Referee, expected: Expectation | MatchExpectation) -> Iterable[Difference]:
    yield from _kept_differences("counter", expected.counters, referee.counters, expected.tolerance_counters)


def _kept_differences(
    kind: str, expected: Mapping[str, Any], found: Mapping[str, Any], tolerance: float | None = None
) -> Iterable[Difference]:
    """Yield what is kept with another value; of what is kept for several the sum, or whether any flag is set."""
    for name, value in expected.items():
        kept, lacks = found.get(name), (f"{kind}s", name)
        if isinstance(value, dict):
            of_each = kept if isinstance(kept, dict) else {}
            for member, own in value.items():
                yield from difference(f"{kind} {name} of {member}", own, of_each.get(member), lacks, tolerance)
            continue
        if isinstance(kept, dict):
            kept = any(kept.values()) if kind == "flag" else round_score(sum(one or 0 for one in kept.values()))
        yield from difference(f"{kind} {name}", value, kept, lacks, tolerance)


def _pose_differences(match: ScriptedMatch, expected: Expectation) -> Iterable[Difference]:
    for name in match.roster.expand(expected.off or ()):
        yield from difference(f"{name} off the field", True, match.is_off(name))
    for name, (x, y) in expected.poses.items():
        if match.is_off(name):
            yield Difference(f"{name}: expected at ({x:g}, {y:g}), is off the field")
            continue
        here = match.referee.spots.get(name) or match.pose(name)
        off = hypot(here[0] - x, here[1] - y)
        if off > expected.tolerance_m:
            found = f"({here[0]:.4g}, {here[1]:.4g}), {off:.3g} m off"
            allowed = f"up to {expected.tolerance_m:g} m off is allowed, more by tolerance_m"
            yield Difference(f"{name}: expected at ({x:g}, {y:g}), is at {found}; {allowed}")


def _total_differences(referee: Referee, carry_over: CarryOver, expected: MatchExpectation) -> Iterable[Difference]:
    """Yield what differs at the end of several halves, by team."""
    for team, score in expected.score.items():
        yield from difference(f"score of {team}", score, carry_over.scores.get(team))
    yield from _counter_differences(referee, expected)
    if expected.ranking is not None:
        yield from _ranking_differences(carry_over.ranking(), expected.ranking)


def _ranking_differences(
    ranked: Iterable[dict[str, Any]], expected: tuple[str | tuple[str, ...], ...]
) -> Iterable[Difference]:
    """Yield the ranking, if it is not the expected one, with what was compared."""
    places: dict[int, dict[str, list[Number | None]]] = {}
    for entry in ranked:
        places.setdefault(entry["place"], {})[entry["team"]] = entry["values"]
    found = [set(sharing) for sharing in places.values()]
    if found != [{one} if isinstance(one, str) else set(one) for one in expected]:
        shown = ", then ".join(
            " and ".join(f"{seat} ({', '.join(map(number_words, values))})" for seat, values in sharing.items())
            for sharing in places.values()
        )
        wanted = ", then ".join(one if isinstance(one, str) else " and ".join(one) for one in expected)
        yield Difference(f"ranking: expected {wanted}; is {shown}")


def _ended(match: ScriptedMatch) -> str:
    """Return the end that a test has reached: the match by a rule, or the half by a rule or by its time."""
    if match.output.ends_match:
        return "match"
    return "half" if match.is_over else "none"
