"""What is well formed and cannot be meant: contradictions within rules, times, draws, kits and entrants."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import count

from rcj_challenges.devices.base import Device
from rcj_challenges.facts.amounts import counted
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.rules.actions.count import Count
from rcj_challenges.rules.actions.draw import DrawAction
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.conditions.counter import CounterIs
from rcj_challenges.rules.conditions.distance import Distance
from rcj_challenges.rules.conditions.flag import FlagIs
from rcj_challenges.rules.conditions.half import HalfIs
from rcj_challenges.rules.conditions.held import IsHeld
from rcj_challenges.rules.conditions.in_zone import InZone
from rcj_challenges.rules.conditions.looks import Looks
from rcj_challenges.rules.conditions.sequence_at import SequenceAt
from rcj_challenges.rules.conditions.speed import Speed
from rcj_challenges.rules.conditions.spot_free import SpotFree
from rcj_challenges.rules.conditions.timer import TimerIs
from rcj_challenges.rules.conditions.told import Told
from rcj_challenges.rules.conditions.way import WayIs
from rcj_challenges.rules.fields import Scalar, Strict
from rcj_challenges.rules.kick import Kick
from rcj_challenges.rules.quantifier import AtLeast
from rcj_challenges.rules.triggers.holds import Holds
from rcj_challenges.rules.triggers.stays_in import StaysIn
from rcj_challenges.rules.triggers.time_reached import TimeReached
from rcj_challenges.rules.values.word import NumberWord
from rcj_challenges.scenario.decided import check_decided_spots
from rcj_challenges.scenario.drawn import never_drawn
from rcj_challenges.scenario.errors import in_plain_letters, listing, nearest
from rcj_challenges.scenario.halves import clock_may_stop, half_length_s, longest_half_s
from rcj_challenges.scenario.models.field import Match
from rcj_challenges.scenario.models.scenario import Expectation, Given, Rule, Scenario
from rcj_challenges.scenario.models.state import Draw, Sequence
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import Found, visit


def check_sense(scenario: Scenario, *, half_is_set: bool, lengths_are_set: bool) -> Iterator[Found]:
    """Yield contradictions.

    Args:
        scenario: the models.
        half_is_set: the number or length of the halves was changed on the command line: a shortened half does not
            make what would have come later a mistake.
        lengths_are_set: their lengths were: then there must be as many as halves.
    """
    roster = Roster.of(scenario)
    longest_s = longest_half_s(scenario.match)
    for model, path in visit(scenario):
        yield from _place(model, path)
        yield from _bounds(model, path)
        yield from _comparison(model, path)
        yield from _quantifier(model, path, roster)
        yield from _times(model, path, scenario, longest_s, half_is_set=half_is_set)
        if isinstance(model, Match) and (lengths_are_set or not half_is_set):
            yield from _lengths(model, path, at_number=not lengths_are_set)
        yield from _draw(model, path)
        yield from _whose_way(model, path)
        if isinstance(model, Rule) and isinstance(model.phases, tuple) and "any" in model.phases:
            yield Found(
                (*path, "phases"), "'any' is no phase in a list: any phase is written phases: any, without brackets"
            )
        if isinstance(model, Expectation):
            yield from _series(model, path, scenario)
            yield from _places(model, path, scenario)
            yield from check_decided_spots(model, path, scenario, roster)
            yield from _told(model, path, scenario, roster)
        if isinstance(model, Expectation | Given):
            yield from _one_by_one(model, path, scenario, roster)
        if isinstance(model, Device):
            yield from (Found((*path, key), message) for key, message in model.contradictions())
    yield from _robots(scenario, roster)
    yield from _entrants(scenario)


# --- rules ------------------------------------------------------------------------------------------------------------


def _draw(model: Strict, path: Path) -> Iterator[Found]:
    if not isinstance(model, Draw) or len(set(map(repr, model.values))) > 1:
        return
    if model.not_last:
        yield Found((*path, "not_last"), "one value alone cannot be drawn twice running; give two different ones")
    if model.not_again is not None:
        yield Found((*path, "not_again"), "one value alone comes again every time; give two different ones")


def _whose_way(model: Strict, path: Path) -> Iterator[Found]:
    """Yield a sequence of which nobody knows whose way it is: nobody's, or one's and each's."""
    match model:
        case Sequence(entity=None, per=None):
            yield Found(path, "whose way? give 'entity', or 'per': a group, with a sequence for each of its members")
        case Sequence(entity=str(), per=str()):
            message = "a sequence has either 'entity' or 'per', not both; leave one of them out"
            yield Found((*path, "per"), message, other=(*path, "entity"))


def _series(test: Expectation, path: Path, scenario: Scenario) -> Iterator[Found]:
    """Yield what a test decides of a draw and chance could not: one after the other, they follow its own rules."""
    actions = (action for rule in scenario.rules.values() for action in rule.actions)
    set_by_rules = {action.draw for action in actions if isinstance(action, DrawAction) and action.as_ is not None}
    for name, decided in test.draws.items():
        draw = scenario.draws.get(name)
        # What a rule sets meanwhile is not known here.
        if draw is None or name in set_by_rules or not isinstance(decided, tuple):
            continue
        index = never_drawn(draw, decided)
        if index is None or decided[index] not in draw.values:
            continue
        twice = draw.not_last and decided[index] == decided[index - 1]
        why = "twice running (not_last)" if twice else "again before all have been drawn (not_again)"
        yield Found((*path, "draws", name, index), f"{_as_written(decided[index])} is not drawn {why}")


def _told(test: Expectation, path: Path, scenario: Scenario, roster: Roster) -> Iterator[Found]:
    """Yield what a test says that robots are told and the broadcast never tells them."""
    broadcast = scenario.broadcast
    only = (broadcast.only or {}) if broadcast is not None else {}
    for name, told in (test.told or {}).items():
        for robot in roster.expand(name):
            known = dict.fromkeys(broadcast.fields if broadcast is not None else ())
            for whom, fields in only.items():
                known |= dict.fromkeys(fields if robot in roster.expand(whom) else ())
            for key in told:
                if key not in known:
                    message = f"the broadcast never tells '{robot}' {key}; it tells it {listing(known) or 'nothing'}"
                    yield Found((*path, "told", name, key), message, at_key=True)


def _one_by_one(test: Expectation | Given, path: Path, scenario: Scenario, roster: Roster) -> Iterator[Found]:
    """Yield what a test tells of single owners of a counter or flag that has no such owners."""
    for noun, told, known in (("counter", test.counters, scenario.counters), ("flag", test.flags, scenario.flags)):
        for name, values in told.items():
            kept = known.get(name)
            if kept is None or not isinstance(values, dict):
                continue
            where = (*path, f"{noun}s", name)
            if not values:
                yield Found(where, "names nobody; write {entity: value, …}, or leave it out")
            if kept.per is None:
                yield Found(where, f"{noun} '{name}' is one for all; write its value alone")
                continue
            owners = roster.expand(kept.per)
            for owner in values:
                if owner not in owners:
                    message = f"there is no {noun} '{name}' of '{owner}'; it is kept for {listing(owners, 12)}"
                    yield Found((*where, owner), message, at_key=True)


def _places(test: Expectation, path: Path, scenario: Scenario) -> Iterator[Found]:
    """Yield a ranking that does not name each entrant once."""
    places = test.ranking or ()
    named = [name for place in places for name in ((place,) if isinstance(place, str) else place)]
    twice = [name for name, times in Counter(named).items() if times > 1]
    missing = [name for name in scenario.entrants if name not in named]
    if twice:
        yield Found((*path, "ranking"), f"names '{twice[0]}' more than once; each entrant has one place")
    elif places and missing and set(named) <= set(scenario.entrants):  # an unknown name says more
        yield Found((*path, "ranking"), f"does not name '{missing[0]}'; all entrants have a place in it")


def _as_written(value: Scalar) -> str:
    return f"'{value}'" if isinstance(value, str) else str(value).lower() if isinstance(value, bool) else str(value)


def _place(model: Strict, path: Path) -> Iterator[Found]:
    match model:
        case Place(layout=None, entity=None) | Place(layout=None, at=None):
            missing = " and ".join(key for key in ("entity", "at") if getattr(model, key) is None)
            yield Found(path, f"'{missing}' missing: place needs either a layout, or entity and at")
        case Place(layout=layout) if layout is not None:
            given = [key for key in ("entity", "at") if getattr(model, key) is not None]
            if given:
                yield Found((*path, given[0]), "place needs either a layout, or entity and at, not both")
            elif model.kick is not None:
                yield Found(
                    (*path, "kick"), "a layout says of each of its placements whether it kicks; write kick there"
                )
        case NumberWord(fraction=True, word=word) if not word.endswith("_s"):
            yield Found((*path, "fraction"), f"'{word}' is never rounded; leave fraction out, it is for times")
        case Kick(speed_mps=(least, most)) if least > most:
            yield Found((*path, "speed_mps"), f"no speed is at least {least:g} and at most {most:g}")
        case Looks(towards=None, heading_rad=None):
            yield Found(path, "nothing to look at; give either 'towards' or 'heading_rad'")
        case Looks(towards=towards, heading_rad=heading) if towards is not None and heading is not None:
            yield Found((*path, "heading_rad"), "looks needs either 'towards' or 'heading_rad', not both")


def _bounds(model: Strict, path: Path) -> Iterator[Found]:
    if not isinstance(model, Score | Count):
        return
    for least_key, most_key in (("at_least", "at_most"), ("keeps_at_least", "keeps_at_most")):
        least, most = getattr(model, least_key), getattr(model, most_key)
        if least is not None and most is not None and least > most:
            yield Found((*path, least_key), f"nothing is at least {least:g} and at most {most:g}")
    if not isinstance(model, Count) or model.to is None:
        return
    if model.by is not None:
        yield Found((*path, "by"), "count needs either 'by' or 'to', not both")
    for key in ("keeps_at_least", "keeps_at_most"):
        if getattr(model, key) is not None:
            message = (
                f"what is set 'to' a number neither falls nor rises to it; write {key.removeprefix('keeps_')} here"
            )
            yield Found((*path, key), message, at_key=True)


def _comparison(model: Strict, path: Path) -> Iterator[Found]:
    if not isinstance(model, Speed | Distance | WayIs | CounterIs | TimerIs | HalfIs):
        return
    least, most, equals = model.at_least, model.at_most, model.equals
    if least is None and most is None and equals is None:
        if not isinstance(model, TimerIs):
            yield Found(path, "nothing to compare with; give at least one of at_least, at_most, equals")
    elif equals is not None and (least is not None or most is not None):
        yield Found((*path, "equals"), "equals says all; leave at_least and at_most out")
    elif isinstance(least, (int, float)) and isinstance(most, (int, float)) and least > most:
        yield Found((*path, "at_least"), f"nothing is at least {least:g} and at most {most:g}")


_QUANTIFIED = (
    InZone | Speed | Distance | WayIs | Looks | IsHeld | SpotFree | CounterIs | FlagIs | TimerIs | SequenceAt | Told
)


def _quantifier(model: Strict, path: Path, roster: Roster) -> Iterator[Found]:
    if not isinstance(model, _QUANTIFIED) or not isinstance(model.of, AtLeast):
        return
    names = model.spot if isinstance(model, SpotFree) else model.entity
    if names is None:
        return  # of all that have a counter, flag, timer or sequence of their own
    count = len(roster.expand(names))
    if model.of.at_least > count:
        yield Found((*path, "of"), f"at least {model.of.at_least} of {count} can never hold")


# --- times ------------------------------------------------------------------------------------------------------------


def _lengths(match: Match, path: Path, *, at_number: bool) -> Iterator[Found]:
    """Tell of too few or too many lengths; it may be the number of halves that the file has, and its base the lengths.

    (Where only the number is changed on the command line, that many are played; the last length goes for more.)
    """
    if isinstance(match.half_s, tuple) and len(match.half_s) != match.halves:
        given, played = counted(len(match.half_s), "length"), counted(match.halves, "half", "halves")
        message = f"{given} in half_s for {played}; give each half its length, or one number for all"
        yield Found((*path, "half_s"), message, other=(*path, "halves") if at_number else ())


def _times(model: Strict, path: Path, scenario: Scenario, longest_s: float, *, half_is_set: bool) -> Iterator[Found]:
    half_s = half_length_s(scenario.match, model.half) if isinstance(model, Expectation) else longest_s
    match model:
        case Holds():
            yield from _under_a_tick(model, path, "for_s", "grace_s")
        case StaysIn():
            yield from _under_a_tick(model, path, "grace_s")
        case TimeReached(at_s=at_s) if at_s > half_s and not half_is_set:
            yield Found((*path, "at_s"), f"{at_s:g} s is never reached; a half lasts {half_s:g} s")
        case Expectation():
            yield from _script(model, path)
            stops = clock_may_stop(scenario)
            if model.lasts_s > half_s and not half_is_set and not stops:
                yield Found((*path, "lasts_s"), f"{model.lasts_s:g} s is longer than a half, {half_s:g} s")
            if model.half > scenario.match.halves and not half_is_set:
                yield Found((*path, "half"), f"there is no half {model.half}; {scenario.match.halves} are played")


def _under_a_tick(model: Strict, path: Path, *keys: str) -> Iterator[Found]:
    for key in keys:
        value = getattr(model, key)
        if 0 < value < TICK_S:
            message = f"a duration must be 0 or at least one tick ({TICK_S} s), found {value:g}"
            yield Found((*path, key), message)


def _script(test: Expectation, path: Path) -> Iterator[Found]:
    before = -1.0
    for index, frame in enumerate(test.keyframes):
        where = (*path, "keyframes", index, "at_s")
        if frame.at_s <= before:
            yield Found(where, f"{frame.at_s:g} s does not come after {before:g} s; keyframes are in order of time")
        if frame.at_s > test.lasts_s:
            yield Found(where, f"{frame.at_s:g} s comes after the end, {test.lasts_s:g} s")
        before = max(before, frame.at_s)
    for index, event in enumerate(test.events or ()):
        if event.at_s is not None and event.at_s > test.lasts_s:
            where = (*path, "events", index, "at_s")
            yield Found(where, f"{event.at_s:g} s comes after the end, {test.lasts_s:g} s")


# --- robots and entrants ----------------------------------------------------------------------------------------------


def _robots(scenario: Scenario, roster: Roster) -> Iterator[Found]:
    if not roster.entities:
        yield Found(("robots",), "nothing on the field can move; give at least one robot or one ball")
    for name, robot in scenario.robots.items():
        kit = scenario.kits.get(robot.kit)
        if kit is None:
            continue
        for index, device in enumerate(robot.without):
            if device not in kit.devices:
                known = ", ".join(kit.devices)
                plain = (name for name in kit.devices if in_plain_letters(name) == in_plain_letters(device))
                hint = next((f"; did you mean {name!r}?" for name in plain), "") or nearest(device, kit.devices)
                message = f"kit '{robot.kit}' has no device '{device}'; it has {known}{hint}"
                yield Found(("robots", name, "without", index), message)


def _entrants(scenario: Scenario) -> Iterator[Found]:
    driver: dict[str, str] = {}
    channels: dict[int, str] = {}
    for name, entrant in scenario.entrants.items():
        path: Path = ("entrants", name)
        if not entrant.robots:
            yield Found((*path, "robots"), "an entrant drives at least one robot")
        for robot, entry_points in entrant.robots.items():
            at = (*path, "robots", robot)
            if robot in driver:
                yield Found(
                    at,
                    f"'{robot}' is driven by '{driver[robot]}' already",
                    True,
                    ("entrants", driver[robot], "robots", robot),
                )
            driver.setdefault(robot, name)
            if robot in scenario.robots and scenario.robots[robot].idle:
                yield Found(at, f"'{robot}' is idle; no program drives it", True, ("robots", robot, "idle"))
            yield from _entry_points(entry_points, at)
        if entrant.radio_channel in channels:
            other = channels[entrant.radio_channel]
            taken = {one.radio_channel for one in scenario.entrants.values()}
            free = next(channel for channel in count(2) if channel not in taken)
            message = (
                f"channel {entrant.radio_channel} is that of '{other}' and of '{name}'; they would hear each other: "
                f"write another radio_channel, such as {free}"
            )
            yield Found((*path, "radio_channel"), message, other=("entrants", other, "radio_channel"))
        channels.setdefault(entrant.radio_channel, name)
    yield from _swap(scenario)


def _entry_points(given: str | tuple[str, ...], path: Path) -> Iterator[Found]:
    for index, entry_point in enumerate((given,) if isinstance(given, str) else given):
        if any(part in {"", ".", ".."} for part in entry_point.split("/")):
            where = path if isinstance(given, str) else (*path, index)
            yield Found(where, f"'{entry_point}' is no plain path inside a submission: leave '.', '..' and '//' out")


def _swap(scenario: Scenario) -> Iterator[Found]:
    if not scenario.match.swap_sides:
        return
    if len(scenario.entrants) != 2:
        count = len(scenario.entrants)
        message = f"only two entrants can change sides; there {'is' if count == 1 else 'are'} {count}"
        yield Found(("match", "swap_sides"), message)
