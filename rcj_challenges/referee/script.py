"""Scripted plays: poses, touches, tilts and faults fed straight to a referee, without physics or programs.

`ScriptedPlay` is a puppet stage for tests of rules; `run_expectation` plays the ``expect`` blocks of a scenario on it
and says what came out differently.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import zip_longest
from math import hypot, isclose
from typing import Any, Protocol

from rcj_challenges.facts.amounts import on_paper
from rcj_challenges.facts.play import Event, Fault, Firing, HalfInfo, Placement, Pose2, Snapshot, Verdict
from rcj_challenges.facts.timing import SUBSTEPS_PER_TICK, s_from_ticks, ticks_from_s
from rcj_challenges.referee.engine import Referee
from rcj_challenges.referee.outlines import obstacle_outline
from rcj_challenges.referee.state import Number, float32
from rcj_challenges.referee.wrong_way import WrongWays
from rcj_challenges.scenario.drawn import Series, series_of
from rcj_challenges.scenario.halves import half_length_s
from rcj_challenges.scenario.models.base import Scalar
from rcj_challenges.scenario.models.scenario import Expectation, ExpectedEvent, Given, Keyframe, Scenario
from rcj_challenges.scenario.roster import Roster

# Where the stage shows what is off the field; the referee must not look there.
_PARKED_X_M, _PARKED_STEP_M = 3.0, 0.2
_STANDING_HEIGHT_M = 0.0375
_COUNTS_AS_EQUAL = 1e-9


class HasScenario(Protocol):
    """A loaded scenario, as `rcj_challenges.scenario.load.load` returns it."""

    @property
    def scenario(self) -> Scenario:
        """The models."""

    @property
    def roster(self) -> Roster:
        """Names to indices."""


def half_of(scenario: Scenario, half: int = 1, seed: int = 1) -> HalfInfo:
    """Return the facts of a half as a test needs them: no points yet, teams named by their seats' titles."""
    seats = list(scenario.entrants)
    swapped = scenario.match.swap_sides and half % 2 == 0
    return HalfInfo(
        half=half,
        halves=max(half, scenario.match.halves),
        ticks=ticks_from_s(half_length_s(scenario.match, half)),
        match_seed=seed,
        match_id=1,
        team_names={seat: scenario.entrants[seat].title or seat for seat in seats},
        teams=dict(zip(seats, reversed(seats) if swapped else seats, strict=True)),
        scores=dict.fromkeys(seats, 0),
    )


@dataclass
class _Glide:
    to: tuple[float, ...]
    substeps_left: int


class ScriptedPlay:
    """A stage on which things stand where they are put, and a referee who watches.

    What the referee places is put there; everything else stays put until it is moved by hand.

    Args:
        scenario: a checked scenario.
        roster: its roster.
        half: facts of the half; left out: the first half with seed 1.
        draws: draws decided beforehand.

    Attributes:
        referee: the referee.
        tick: the tick judged last.
        events, firings: all so far, in order.
        placements: all so far, each with its tick.
        verdict: the last verdict.
        wrong_ways: the gates that were crossed the way that does not count.
    """

    def __init__(
        self,
        scenario: Scenario,
        roster: Roster,
        half: HalfInfo | None = None,
        draws: Mapping[str, Series] | None = None,
    ) -> None:
        self.roster = roster
        self.referee = Referee(scenario, roster, half or half_of(scenario), draws)
        self.tick = 0
        self.events: list[Event] = []
        self.firings: list[Firing] = []
        self.placements: list[tuple[int, Placement]] = []
        entities = len(roster.entities)
        self._poses: list[Pose2] = [_start(scenario, name) for name in roster.entities]
        self._uprights = [1.0] * entities
        self._heights = [_STANDING_HEIGHT_M] * entities
        self._glides: dict[int, _Glide] = {}
        self._touching: dict[tuple[int, int], int] = {}
        self._faults: list[Fault] = []
        self._told: dict[int, str] = {}
        self._none_touch: tuple[tuple[tuple[int, int], ...], ...] = ((),) * SUBSTEPS_PER_TICK
        self._frozen: list[list[Pose2]] | None = None
        self._parked: set[int] = set()
        self.wrong_ways = WrongWays(scenario, roster)
        self.verdict = self._take(self.referee.start(self._snapshot()))

    # --- what the script does ---------------------------------------------------------------------------------------

    def place(self, entity: str, x_m: float, y_m: float, yaw_rad: float | None = None) -> None:
        """Put an entity somewhere by hand, upright; the next snapshot shows it there."""
        index = self.roster.index[entity]
        self._glides.pop(index, None)
        self._uprights[index] = 1.0
        self._stand(index, x_m, y_m, self._poses[index][2] if yaw_rad is None else yaw_rad)

    def glide(self, entity: str, to: tuple[float, ...], ticks: int) -> None:
        """Let an entity glide to [x, y] or [x, y, yaw] in a straight line, to arrive after so many ticks."""
        self._glides[self.roster.index[entity]] = _Glide(to, ticks * SUBSTEPS_PER_TICK)

    def touch(self, first: str, second: str, ticks: int = 1) -> None:
        """Let two things touch from the next tick on for so many ticks, in all their sub-steps."""
        a, b = self.roster.index[first], self.roster.index[second]
        pair = (min(a, b), max(a, b))
        self._touching[pair] = max(ticks, self._touching.get(pair, 0))

    def tip(self, robot: str) -> None:
        """Let a robot lie on its side from the next tick on."""
        uprights = list(self._uprights)
        uprights[self.roster.index[robot]] = 0.0
        self._uprights = uprights

    def fail(self, robot: str) -> None:
        """Let the program of a robot fail in the next tick."""
        self._faults.append(Fault(robot, "crash", self.tick + 1, 1, "scripted"))

    def tell(self, robot: str, text: str) -> None:
        """Let a robot tell the referee something by radio; it is heard in the next tick."""
        self._told[self.roster.index[robot]] = text

    def play(self, ticks: int = 1) -> Verdict:
        """Judge so many ticks and return the last verdict."""
        for _ in range(ticks):
            self.tick += 1
            snapshot = self._snapshot()
            if self.wrong_ways.passages:
                self.wrong_ways.look(self.tick, self._judged, snapshot.substeps, self._parked)
            self.verdict = self._take(self.referee.judge(snapshot))
        return self.verdict

    def play_until(self, tick: int) -> Verdict:
        """Judge up to a tick and return the last verdict."""
        return self.play(tick - self.tick)

    def finish(self) -> Verdict:
        """End the half."""
        self.verdict = self._take(self.referee.finish())
        return self.verdict

    # --- what came of it --------------------------------------------------------------------------------------------

    def pose(self, entity: str) -> Pose2:
        """Return where an entity stands now: x and y in m, yaw in rad."""
        return self._poses[self.roster.index[entity]]

    def names(self) -> list[str]:
        """Return the names of all events so far."""
        return [event.name for event in self.events]

    def events_named(self, name: str) -> list[Event]:
        """Return the events of one name so far."""
        return [event for event in self.events if event.name == name]

    # --- the stage --------------------------------------------------------------------------------------------------

    def _stand(self, index: int, x_m: float, y_m: float, yaw_rad: float) -> None:
        poses = list(self._poses)
        poses[index] = (float32(x_m), float32(y_m), float32(yaw_rad))
        self._poses, self._frozen = poses, None

    def _snapshot(self) -> Snapshot:
        if self._glides:
            substeps = [self._glided() for _ in range(SUBSTEPS_PER_TICK)]
            self._frozen = None
        else:
            if self._frozen is None:
                self._frozen = [self._poses] * SUBSTEPS_PER_TICK
            substeps = self._frozen
        touches = self._none_touch
        if self._touching:
            touches = (tuple(sorted(self._touching)),) * SUBSTEPS_PER_TICK
            self._touching = {pair: left - 1 for pair, left in self._touching.items() if left > 1}
        faults, self._faults = tuple(self._faults), []
        heard, self._told = tuple(sorted(self._told.items())), {}
        return Snapshot(self.tick, substeps, self._heights, self._uprights, touches, faults, heard)

    def _glided(self) -> list[Pose2]:
        """Move what glides by one sub-step; each step is the rest of the way over the sub-steps that are left."""
        poses = list(self._poses)
        for index, glide in list(self._glides.items()):
            here = poses[index]
            goal = (glide.to[0], glide.to[1], glide.to[2] if len(glide.to) > 2 else here[2])
            x, y, yaw = (a + (b - a) / glide.substeps_left for a, b in zip(here, goal, strict=True))
            poses[index] = (float32(x), float32(y), float32(yaw))
            glide.substeps_left -= 1
            if glide.substeps_left == 0:
                del self._glides[index]
        self._poses = poses
        return poses

    def _take(self, verdict: Verdict) -> Verdict:
        """Note a verdict and carry out its placements."""
        self.events += verdict.events
        self.firings += verdict.firings
        for placement in verdict.placements:
            self.placements.append((self.tick, placement))
            index = placement.entity
            self._glides.pop(index, None)  # it stays put until the script moves it again
            self._touching = {pair: left for pair, left in self._touching.items() if index not in pair}
            if placement.parked:
                self._parked.add(index)
                self._stand(index, _PARKED_X_M + index * _PARKED_STEP_M, 0.0, 0.0)
                continue
            self._parked.discard(index)
            self._stand(index, placement.x_m, placement.y_m, placement.yaw_rad)
            if self._uprights[index] < 1.0:
                uprights = list(self._uprights)
                uprights[index] = 1.0
                self._uprights = uprights
        self._judged = self._poses  # what a hand puts elsewhere now moves within the next tick
        return verdict


def _start(scenario: Scenario, name: str) -> Pose2:
    if name in scenario.robots:
        start = scenario.robots[name].start
        pose = (start.x_m, start.y_m, start.yaw_rad)
    elif name in scenario.balls:
        pose = (*scenario.balls[name].start_m, 0.0)
    else:
        pose = obstacle_outline(scenario.obstacles[name])[1]
    return (float32(pose[0]), float32(pose[1]), float32(pose[2]))


# --- the tests written in a scenario ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Trial:
    """What came of one ``expect`` block.

    Attributes:
        differences: what came out differently, one line each, then notes on why that may be: what found no room, draws
            that were not drawn, gates crossed the wrong way; empty if all is as expected.
        ticks: how many ticks were judged.
        fired: the rules that fired, in the order of their first time.
    """

    differences: tuple[str, ...]
    ticks: int
    fired: tuple[str, ...]


def run_expectation(loaded: HasScenario, name: str) -> list[str]:
    """Play one ``expect`` block of a scenario and return what came out differently; see `try_expectation`."""
    return list(try_expectation(loaded, name).differences)


def try_expectation(loaded: HasScenario, name: str) -> Trial:
    """Play one ``expect`` block of a scenario.

    A keyframe takes effect in the snapshot of its tick (one at 0 in that of tick 1). If the script outlasts the half,
    or a rule ends it, the rules of ``half_ended`` run as well.

    Args:
        loaded: scenario and roster.
        name: name of the block.

    Returns:
        What came of it.

    Raises:
        KeyError: there is no block of this name.
        ValueError: the block decides a draw that does not exist, or a value that it cannot have.
    """
    expected = loaded.scenario.expect[name]
    scenario = _as_given(loaded.scenario, expected.given)
    half = half_of(scenario, expected.half, expected.seed)
    half = replace(
        half,
        scores=half.scores | {seat: on_paper(score) for seat, score in expected.given.score.items()},
        kept=half.kept | _kept(scenario, loaded.roster, expected.given),
    )
    play = ScriptedPlay(scenario, loaded.roster, half, expected.draws)
    last = ticks_from_s(expected.lasts_s)
    before = 0
    for keyframe in sorted(expected.keyframes, key=lambda keyframe: keyframe.at_s):
        at = max(1, ticks_from_s(keyframe.at_s))
        # Glides begin at the keyframe before; two keyframes in one tick make a jump of it.
        _play_until(play, min(before, at - 1, last))
        for entity, to in keyframe.move.items():
            play.glide(entity, to, at - play.tick)
        _play_until(play, min(at - 1, last))
        if at <= last:
            _act(play, keyframe)
        before = at
    _play_until(play, last)
    if play.verdict.ended is not None or play.referee.time_is_up:
        play.finish()
    fired = dict.fromkeys(firing.rule for firing in play.firings if firing.suppressed is None)
    differences = list(_differences(play, expected))
    notes = (*_no_room(play), *_not_drawn(play, expected), *play.wrong_ways.notes()) if differences else ()
    return Trial((*differences, *notes), play.tick, tuple(fired))


def _no_room(play: ScriptedPlay) -> Iterable[str]:
    """Return what found no room: often the reason why something is not where a test expects it."""
    first = {(f.rule, f.says): f for f in reversed(play.firings) if f.suppressed == "no_room"}
    for firing in sorted(first.values(), key=lambda firing: firing.tick):
        yield f"note: from {s_from_ticks(firing.tick):g} s on {firing.says} (rule {firing.rule})"


def _not_drawn(play: ScriptedPlay, expected: Expectation) -> Iterable[str]:
    """Return which draws were drawn less often than a test decides them."""
    for name, left in play.referee.undecided.items():
        series = series_of(expected.draws[name])
        drawn = len(series) - len(left)
        yield f"note: {name} was drawn {'once' if drawn == 1 else f'{drawn} times'}; draws decides {len(series)} values"


def _as_given(scenario: Scenario, given: Given) -> Scenario:
    """Return the scenario with what a test presets as the initial values of its counters and flags.

    What is preset for single entities is kept from the half before instead: see `_kept`.
    """
    changed = {
        section: {
            **entries,
            **{
                name: entries[name].model_copy(
                    update={"keep": "match"} if isinstance(value, dict) else {"initial": value}
                )
                for name, value in preset.items()
            },
        }
        for section, entries, preset in _presets(scenario, given)
        if preset
    }
    return scenario.model_copy(update=changed) if changed else scenario


def _kept(scenario: Scenario, roster: Roster, given: Given) -> dict[str, dict[str, dict[str, Scalar]]]:
    """Return what a test presets for single entities, as the half before would have left it; others are at first."""
    return {
        section: {
            name: {
                member: one if isinstance(one, bool) else on_paper(one)
                for member, one in (
                    dict.fromkeys(roster.expand(entries[name].per), entries[name].initial) | value
                ).items()
            }
            for name, value in preset.items()
            if isinstance(value, dict)
        }
        for section, entries, preset in _presets(scenario, given)
    }


def _presets(
    scenario: Scenario, given: Given
) -> tuple[tuple[str, Mapping[str, Any], Mapping[str, Scalar | dict[str, Any]]], ...]:
    """Return sections of a scenario with their entries, and what a test presets of them."""
    return ("counters", scenario.counters, given.counters), ("flags", scenario.flags, given.flags)


def _play_until(play: ScriptedPlay, tick: int) -> None:
    while play.tick < tick and play.verdict.ended is None and not play.referee.time_is_up:
        play.play()


def _act(play: ScriptedPlay, keyframe: Keyframe) -> None:
    for entity, pose in keyframe.place.items():
        play.place(entity, *pose)
    for first, second in keyframe.touch:
        play.touch(first, second, 1 if keyframe.touch_lasts_s is None else ticks_from_s(keyframe.touch_lasts_s))
    for robot in keyframe.tips:
        play.tip(robot)
    for robot in keyframe.fault:
        play.fail(robot)
    for robot, said in (keyframe.tells or {}).items():
        play.tell(robot, " ".join(map(str, said)) if isinstance(said, tuple) else str(said))


def _differences(play: ScriptedPlay, expected: Expectation) -> Iterable[str]:
    referee = play.referee
    if expected.events is not None:
        wanted = {event.event for event in expected.events}
        ignored = set(expected.ignore) - wanted
        yield from _event_differences([event for event in play.events if event.name not in ignored], expected.events)
    for entrant, score in expected.score.items():
        yield from _difference(f"score of {entrant}", score, referee.scores.get(entrant))
    for name, count in expected.counters.items():
        if isinstance(count, dict):
            yield from _of_each(f"counter {name}", count, referee.counters.get(name))
        else:
            yield from _difference(f"counter {name}", count, _number(referee, name))
    for name, flag in expected.flags.items():
        value = referee.flags.get(name)
        if isinstance(flag, dict):
            yield from _of_each(f"flag {name}", flag, value)
        else:
            yield from _difference(f"flag {name}", flag, any(value.values()) if isinstance(value, dict) else value)
    if expected.phase is not None:
        yield from _difference("phase", expected.phase, referee.phase)
    for name, is_held in (expected.held or {}).items():
        yield from _difference(f"{name} held", is_held, referee.held.get(name))
    yield from _pose_differences(play, expected)


def _pose_differences(play: ScriptedPlay, expected: Expectation) -> Iterable[str]:
    for name, (x, y) in expected.poses.items():
        here = play.referee.spots.get(name) or play.pose(name)
        off = hypot(here[0] - x, here[1] - y)
        if off > expected.tolerance_m:
            found = f"({here[0]:.4g}, {here[1]:.4g}), {off:.3g} m off"
            allowed = f"up to {expected.tolerance_m:g} m off is allowed, more by tolerance_m"
            yield f"{name}: expected at ({x:g}, {y:g}), is at {found}; {allowed}"


def _number(referee: Referee, name: str) -> Number | None:
    value = referee.counters.get(name, referee.scores.get(name))
    return on_paper(sum(value.values())) if isinstance(value, dict) else value


def _of_each(what: str, expected: Mapping[str, Scalar], found: object) -> Iterable[str]:
    """Return where what is kept for each of several is different."""
    kept = found if isinstance(found, dict) else {}
    for member, value in expected.items():
        yield from _difference(f"{what} of {member}", value, kept.get(member))


def _difference(what: str, expected: Scalar, found: Scalar | None) -> Iterable[str]:
    if not _equal(expected, found):
        yield f"{what}: expected {_shown(expected)}, is {_shown(found)}"


def _event_differences(found: list[Event], expected: tuple[ExpectedEvent, ...]) -> Iterable[str]:
    for number, (event, wanted) in enumerate(zip_longest(found, expected), start=1):
        if wanted is None:
            yield f"event {number}: nothing more expected, got {_told(event)}"
        elif event is None:
            when = "" if wanted.at_s is None else f" at {wanted.at_s:g} s"
            yield f"event {number}: expected {wanted.event}{when}, nothing came"
        elif event.name != wanted.event:
            yield f"event {number}: expected {wanted.event}, got {_told(event)}"
        else:
            yield from _within_event(number, event, wanted)


def _within_event(number: int, event: Event, wanted: ExpectedEvent) -> Iterable[str]:
    at_s = s_from_ticks(event.tick)
    if wanted.at_s is not None and abs(at_s - wanted.at_s) > wanted.tolerance_s + _COUNTS_AS_EQUAL:
        allowed = f"up to {wanted.tolerance_s:g} s off is allowed, more by tolerance_s beside at_s"
        yield f"event {number} ({event.name}): expected at {wanted.at_s:g} s, came at {at_s:g} s; {allowed}"
    for key, value in wanted.payload.items():
        if not _equal(value, event.payload.get(key)):
            found = _shown(event.payload.get(key))
            yield f"event {number} ({event.name}): expected {key} {_shown(value)}, is {found}"


def _equal(expected: Scalar, found: object) -> bool:
    numbers = (int, float)
    if isinstance(expected, bool) or isinstance(found, bool):
        return expected is found
    if isinstance(expected, numbers) and isinstance(found, numbers):
        return isclose(expected, found, rel_tol=1e-9, abs_tol=1e-9)
    return expected == found


def _told(event: Event) -> str:
    payload = ", ".join(f"{key} {_shown(value)}" for key, value in event.payload.items())
    return f"{event.name} at {s_from_ticks(event.tick):g} s" + (f" ({payload})" if payload else "")


def _shown(value: object) -> str:
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value:g}" if isinstance(value, float) else str(value)
