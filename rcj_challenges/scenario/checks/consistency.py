"""What is well formed and contradicts itself: within rules, times, draws, tests, kits and entrants."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from itertools import count, product
from typing import Any

from rcj_challenges.core.amounts import counted
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.devices.base import Device
from rcj_challenges.geometry.polygons import Point, distance_to_segment_m
from rcj_challenges.rules.actions.count import Count
from rcj_challenges.rules.actions.draw import DrawAction
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.actions.set_spot import SetSpot
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.conditions.half import HalfIs
from rcj_challenges.rules.conditions.looks import Looks
from rcj_challenges.rules.conditions.spot_free import SpotFree
from rcj_challenges.rules.conditions.timer import TimerIs
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.kick import Kick
from rcj_challenges.rules.mirror import Mirror
from rcj_challenges.rules.places.on_line import OnLine
from rcj_challenges.rules.places.uniform_in import UniformIn
from rcj_challenges.rules.quantifier import AtLeast
from rcj_challenges.rules.triggers.holds import Holds
from rcj_challenges.rules.triggers.stays_in import StaysIn
from rcj_challenges.rules.triggers.time_reached import TimeReached
from rcj_challenges.rules.values.distance import DistanceValue
from rcj_challenges.rules.values.word import NumberWord
from rcj_challenges.scenario.centres import centre_of
from rcj_challenges.scenario.draw_order import never_drawn, places_of
from rcj_challenges.scenario.errors import choice_of, in_plain_letters, listing
from rcj_challenges.scenario.floor import floor_parts, on_floor
from rcj_challenges.scenario.floor_shapes import lies_in
from rcj_challenges.scenario.halves import clock_may_stop, half_length_s, longest_half_s
from rcj_challenges.scenario.messages.wording import spelled
from rcj_challenges.scenario.models.field import Match, Wall
from rcj_challenges.scenario.models.scenario import Expectation, Given, Rule, Scenario
from rcj_challenges.scenario.models.state import Draw, Sequence
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.walk import Issue, walk

_ON_LINE_M = 0.001
"""A point is on a line that is no farther away: authors round to the millimetre."""


def check_consistency(scenario: Scenario, *, is_half_set: bool, is_length_set: bool) -> Iterator[Issue]:
    """Yield contradictions.

    Args:
        scenario: the models.
        is_half_set: whether number or length of the halves was changed on the command line: what would come after a
            shortened half is no mistake then.
        is_length_set: whether their lengths were: then there must be as many as halves.
    """
    roster = Roster.of(scenario)
    longest_s = longest_half_s(scenario.match)
    for model, path in walk(scenario):
        yield from _keys(model, path)
        yield from _ranges(model, path)
        yield from _quantifier(model, path, roster)
        yield from _short_times(model, path)
        if isinstance(model, TimeReached) and model.at_s > longest_s and not is_half_set:
            yield Issue("too-late", (*path, "at_s"), f"{model.at_s:g} s is never reached; a half lasts {longest_s:g} s")
        if isinstance(model, Match) and (is_length_set or not is_half_set):
            yield from _lengths(model, path, is_of_file=not is_length_set)
        if isinstance(model, Expectation):
            yield from _script(model, path)
            yield from _series(model, path, scenario)
            yield from _ranking(model, path, scenario)
            yield from _decided_spots(model, path, scenario, roster)
            yield from _told(model, path, scenario, roster)
            if not is_half_set:
                yield from _length(model, path, scenario)
        if isinstance(model, Expectation | Given):
            yield from _owners(model, path, scenario, roster)
    for name, rule in scenario.rules.items():
        yield from _measured(rule, ("rules", name), rule, scenario, roster)
    yield from _measured(scenario.broadcast, ("broadcast",), None, scenario, roster)
    yield from _robots(scenario, roster)
    yield from _entrants(scenario)


# --- keys that go together --------------------------------------------------------------------------------------------


def _keys(model: Strict, path: Path) -> Iterator[Issue]:
    """Yield keys of one mapping that exclude each other, and the lack of all of several."""
    for kinds, check in _BY_MODEL:
        if isinstance(model, kinds):
            yield from check(model, path)


def _place(model: Place, path: Path) -> Iterator[Issue]:
    given = [key for key in ("entity", "at", "kick") if getattr(model, key) is not None]
    missing = [key for key in ("entity", "at") if key not in given]
    if model.layout is not None and given:
        help_ = "a layout says of each of its placements what is put where, and whether it kicks"
        yield _both((*path, given[0]), "layout", given[0], help_)
    elif model.layout is None and missing:
        message = f"'{' and '.join(missing)}' missing"
        yield Issue("missing-key", path, message, "place needs either a layout, or entity and at")


def _looks(model: Looks, path: Path) -> Iterator[Issue]:
    if model.towards is None and model.heading_rad is None:
        yield Issue("missing-key", path, "nothing to look at", "give either 'towards' or 'heading_rad'")
    elif model.towards is not None and model.heading_rad is not None:
        yield _both((*path, "heading_rad"), "towards", "heading_rad")


def _comparison(model: Compared | HalfIs, path: Path) -> Iterator[Issue]:
    bounds = [key for key in ("at_least", "at_most", "equals") if getattr(model, key) is not None]
    if not bounds and not isinstance(model, TimerIs):
        yield Issue("missing-key", path, "nothing to compare with", "give at_least, at_most or equals")
    if "equals" in bounds and len(bounds) > 1:
        yield _both((*path, "equals"), "equals", bounds[0])


def _sequence(model: Sequence, path: Path) -> Iterator[Issue]:
    if model.entity is None and model.per is None:
        help_ = "give 'entity', or 'per': a group, with a sequence for each of its members"
        yield Issue("missing-key", path, "nothing follows this sequence", help_)
    elif model.entity is not None and model.per is not None:
        yield _both((*path, "per"), "entity", "per")._replace(other=(*path, "entity"))


def _count(model: Count, path: Path) -> Iterator[Issue]:
    for key in ("by", "keeps_at_least", "keeps_at_most") if model.to is not None else ():
        if getattr(model, key) is not None:
            yield _both((*path, key), "to", key)


def _draw(model: Draw, path: Path) -> Iterator[Issue]:
    for key in ("not_last", "not_again") if len(set(map(repr, model.values))) == 1 else ():
        if getattr(model, key):
            message = "one value alone comes again every time"
            yield Issue("conflicting-keys", (*path, key), message, "give two different values")


def _phases(model: Rule, path: Path) -> Iterator[Issue]:
    if isinstance(model.phases, tuple) and "any" in model.phases:
        message = "'any' cannot stand in a list of phases"
        yield Issue("wrong-value", (*path, "phases"), message, "any phase is written phases: any, without brackets")


def _word(model: NumberWord, path: Path) -> Iterator[Issue]:
    if model.fraction and not model.word.endswith("_s"):
        yield Issue("conflicting-keys", (*path, "fraction"), f"'{model.word}' is never rounded", "leave fraction out")


def _device(model: Device, path: Path) -> Iterator[Issue]:
    yield from (Issue("wrong-value", (*path, key), message) for key, message in model.contradictions())


_BY_MODEL: tuple[tuple[Any, Callable[[Any, Path], Iterator[Issue]]], ...] = (
    (Place, _place),
    (Looks, _looks),
    ((Compared, HalfIs), _comparison),
    (Sequence, _sequence),
    (Count, _count),
    (Draw, _draw),
    (Rule, _phases),
    (NumberWord, _word),
    (Device, _device),
)


def _both(path: Path, one: str, other: str, help_: str = "leave one of them out") -> Issue:
    return Issue("conflicting-keys", path, f"'{one}' and '{other}' cannot be given together", help_, at_key=True)


def _ranges(model: Strict, path: Path) -> Iterator[Issue]:
    """Yield ranges that hold no number."""
    pairs = [("at_least", "at_most"), ("keeps_at_least", "keeps_at_most")]
    for least_key, most_key in pairs if isinstance(model, Score | Count | Compared | HalfIs) else ():
        least, most = getattr(model, least_key, None), getattr(model, most_key, None)
        if isinstance(least, int | float) and isinstance(most, int | float) and least > most:
            yield Issue("empty-range", (*path, least_key), f"nothing is at least {least:g} and at most {most:g}")
    match model:
        case Kick(speed_mps=(least, most)) if least > most:
            yield Issue("empty-range", (*path, "speed_mps"), f"no speed is at least {least:g} and at most {most:g}")


def _quantifier(model: Strict, path: Path, roster: Roster) -> Iterator[Issue]:
    of = getattr(model, "of", None)
    names = model.spot if isinstance(model, SpotFree) else getattr(model, "entity", None)
    if not isinstance(of, AtLeast) or names is None:  # of all that have one of their own
        return
    count = len(roster.expand(names))
    if of.at_least > count:
        yield Issue("never-holds", (*path, "of"), f"at least {of.at_least} of {count} can never hold")


def _measured(part: object, path: Path, rule: Rule | None, scenario: Scenario, roster: Roster) -> Iterator[Issue]:
    """Yield distances between two zones, gates or walls, and spots that are set to a zone without a centre."""
    wide = {*scenario.zones, *scenario.gates}
    wide |= {name for name, obstacle in scenario.obstacles.items() if isinstance(obstacle, Wall)}
    for model, at in walk(part, path):
        if isinstance(model, DistanceValue):
            ends = [roster.may_be(end, rule) if isinstance(end, str) else () for end in model.distance]
            firsts = [next((name for name in end if name in wide), None) for end in ends]
            if None not in firsts:
                message = f"no distance is measured between '{firsts[0]}' and '{firsts[1]}'"
                help_ = "one end of a distance is an entity, a spot or [x, y]"
                yield Issue("wrong-kind", (*at, "distance"), message, help_)
        if isinstance(model, SetSpot) and isinstance(model.to, str):
            for name in roster.may_be(model.to, rule):
                if name in scenario.zones and centre_of(scenario.zones[name]) is None:
                    help_ = "set the spot to an entity, a spot or [x, y]"
                    yield Issue("no-centre", (*at, "to"), f"zone '{name}' has no centre", help_)


# --- times ------------------------------------------------------------------------------------------------------------


def _short_times(model: Strict, path: Path) -> Iterator[Issue]:
    for key in ("for_s", "grace_s") if isinstance(model, Holds | StaysIn) else ():
        if 0 < getattr(model, key, 0) < TICK_S:
            message = f"a duration must be 0 or at least one tick ({TICK_S} s), found {getattr(model, key):g}"
            yield Issue("wrong-value", (*path, key), message)


def _lengths(match: Match, path: Path, *, is_of_file: bool) -> Iterator[Issue]:
    """Yield too few or too many lengths: if only the number is set on the command line, the last one goes for more."""
    if isinstance(match.half_s, tuple) and len(match.half_s) != match.halves:
        given, played = counted(len(match.half_s), "length"), counted(match.halves, "half", "halves")
        help_ = "give each half its length, or one number for all"
        other = (*path, "halves") if is_of_file else ()
        yield Issue("wrong-value", (*path, "half_s"), f"{given} in half_s for {played}", help_, other=other)


def _length(test: Expectation, path: Path, scenario: Scenario) -> Iterator[Issue]:
    half_s = half_length_s(scenario.match, test.half)
    if test.lasts_s > half_s and not clock_may_stop(scenario):
        yield Issue("too-late", (*path, "lasts_s"), f"{test.lasts_s:g} s is longer than a half, {half_s:g} s")
    if test.half > scenario.match.halves:
        yield Issue("too-late", (*path, "half"), f"there is no half {test.half}; {scenario.match.halves} are played")


# --- tests ------------------------------------------------------------------------------------------------------------


def _script(test: Expectation, path: Path) -> Iterator[Issue]:
    before = -1.0
    for index, frame in enumerate(test.keyframes):
        at = (*path, "keyframes", index, "at_s")
        if frame.at_s <= before:
            message = f"{frame.at_s:g} s does not come after {before:g} s"
            yield Issue("too-early", at, message, "keyframes stand in the order of time")
        before = max(before, frame.at_s)
    moments = [(("keyframes", index), frame.at_s) for index, frame in enumerate(test.keyframes)]
    moments += [(("events", i), event.at_s) for i, event in enumerate(test.events or ()) if event.at_s is not None]
    for where, at_s in moments:
        if at_s > test.lasts_s:
            yield Issue("too-late", (*path, *where, "at_s"), f"{at_s:g} s comes after the end, {test.lasts_s:g} s")


def _series(test: Expectation, path: Path, scenario: Scenario) -> Iterator[Issue]:
    """Yield values that a test decides for a draw, and that chance could not bring in this order."""
    actions = (action for rule in scenario.rules.values() for action in rule.actions)
    set_by_rules = {action.draw for action in actions if isinstance(action, DrawAction) and action.as_ is not None}
    for name, decided in test.draws.items():
        draw = scenario.draws.get(name)
        if draw is None or name in set_by_rules or not isinstance(decided, tuple):
            continue
        index = never_drawn(draw, decided)
        if index is not None and decided[index] in draw.values:
            why = "not_last" if draw.not_last and decided[index] == decided[index - 1] else "not_again"
            message = f"{spelled(decided[index])} is not drawn again here ({why})"
            yield Issue("never-drawn", (*path, "draws", name, index), message)


def _told(test: Expectation, path: Path, scenario: Scenario, roster: Roster) -> Iterator[Issue]:
    """Yield values that a test expects in the broadcast to robots, and that the broadcast never contains."""
    broadcast = scenario.broadcast
    only = (broadcast.only or {}) if broadcast is not None else {}
    for name, told in (test.told or {}).items():
        for robot in roster.expand(name):
            fields = [list(keys) for group, keys in only.items() if robot in roster.expand(group)]
            known = dict.fromkeys(sum(fields, list(broadcast.fields if broadcast is not None else ())))
            for key in (one for one in told if one not in known):
                message = f"the broadcast never tells '{robot}' {key}"
                yield Issue(
                    "unknown-name", (*path, "told", name, key), message, choice_of(key, known, "broadcast"), True
                )


def _owners(test: Expectation | Given, path: Path, scenario: Scenario, roster: Roster) -> Iterator[Issue]:
    """Yield values of single owners for a counter or flag that has no such owners."""
    for noun, tested, known in (("counter", test.counters, scenario.counters), ("flag", test.flags, scenario.flags)):
        for name, values in tested.items():
            kept, at = known.get(name), (*path, f"{noun}s", name)
            if kept is None or not isinstance(values, dict):
                continue
            if kept.per is None:
                yield Issue("not-per-entity", at, f"{noun} '{name}' is not kept per entity", "write its value alone")
                continue
            if not values:
                yield Issue("wrong-value", at, "names nothing", "write {entity: value, …}, or leave it out")
            owners = roster.expand(kept.per)
            for owner in (one for one in values if one not in owners):
                message = f"there is no {noun} '{name}' of '{owner}'"
                yield Issue("unknown-name", (*at, owner), message, choice_of(owner, owners), at_key=True)


def _ranking(test: Expectation, path: Path, scenario: Scenario) -> Iterator[Issue]:
    """Yield a ranking that does not name each entrant once."""
    places = test.ranking or ()
    named = Counter(name for place in places for name in ((place,) if isinstance(place, str) else place))
    twice = next((name for name, times in named.items() if times > 1), None)
    missing = [name for name in scenario.entrants if name not in named]
    if twice or (places and missing and named.keys() <= scenario.entrants.keys()):  # an unknown name says more
        message = f"names '{twice}' more than once" if twice else f"does not name '{missing[0]}'"
        yield Issue("wrong-value", (*path, "ranking"), message, "each entrant has one place in it")


def _decided_spots(test: Expectation, path: Path, scenario: Scenario, roster: Roster) -> Iterator[Issue]:
    """Yield the places that a test decides for a spot and to which chance never sets it."""
    actions = [action for rule in scenario.rules.values() for action in rule.actions if isinstance(action, SetSpot)]
    for name, decided in (test.spots or {}).items():
        at = (*path, "spots", name)
        setting = [one for one in actions if one.spot == name and isinstance(one.to, UniformIn | OnLine)]
        if not setting and name in scenario.spots:
            help_ = "where it is at the end is compared under poses"
            yield Issue("never-drawn", at, f"chance never sets '{name}'", help_, at_key=True)
        for index, point in enumerate(places_of(decided) if setting else ()):
            if not any(_may_be_set(point, action, scenario, roster) for action in setting):
                message = f"chance never sets '{name}' to ({point[0]:g}, {point[1]:g})"
                yield Issue("never-drawn", at if decided is point else (*at, index), message)


def _may_be_set(point: Point, action: SetSpot, scenario: Scenario, roster: Roster) -> bool:
    if not on_floor(point, floor_parts(scenario.field)):
        return False
    points = [(point[0] * sign_x, point[1] * sign_y) for sign_x, sign_y in _signs(action.mirror)]
    match action.to:
        case OnLine(on_line=(start, end)):
            return any(distance_to_segment_m(*one, *start, *end) <= _ON_LINE_M for one in points)
        case UniformIn(uniform_in=names):
            zones = [scenario.zones.get(name) for name in roster.expand(names)]
            # What is not a zone is reported where it is written; nothing is wrong here then.
            return any(zone is None or lies_in(one, zone) for one, zone in product(points, zones))
    return False


def _signs(mirror: Mirror | None) -> list[tuple[int, int]]:
    """Return by what x and y may be multiplied: with a flag, or not."""
    if mirror is None:
        return [(1, 1)]
    turned = (-1 if mirror.axis in ("x", "both") else 1, -1 if mirror.axis in ("y", "both") else 1)
    return [turned] if mirror.when is None else [turned, (1, 1)]


# --- robots and entrants ----------------------------------------------------------------------------------------------


def _robots(scenario: Scenario, roster: Roster) -> Iterator[Issue]:
    if not roster.entities:
        yield Issue(
            "nothing-moves", ("robots",), "nothing on the field can move", "give at least one robot or one ball"
        )
    for name, robot in scenario.robots.items():
        devices = scenario.kits[robot.kit].devices if robot.kit in scenario.kits else {}
        for index, device in enumerate(robot.without if robot.kit in scenario.kits else ()):
            if device not in devices:
                alike = next((one for one in devices if in_plain_letters(one) == in_plain_letters(device)), device)
                message = f"kit '{robot.kit}' has no device '{device}'"
                yield Issue("unknown-name", ("robots", name, "without", index), message, choice_of(alike, devices))


def _entrants(scenario: Scenario) -> Iterator[Issue]:
    driver: dict[str, str] = {}
    channels: dict[int, str] = {}
    for name, entrant in scenario.entrants.items():
        path: Path = ("entrants", name)
        if not entrant.robots:
            yield Issue("entrant-without-robots", (*path, "robots"), "an entrant drives at least one robot")
        for robot, entry_points in entrant.robots.items():
            at = (*path, "robots", robot)
            first = driver.setdefault(robot, name)
            if first != name:
                other: Path = ("entrants", first, "robots", robot)
                yield Issue("driven-twice", at, f"'{robot}' is driven by '{first}' already", "", True, other)
            if robot in scenario.robots and scenario.robots[robot].idle:
                other = "robots", robot, "idle"
                yield Issue("driven-twice", at, f"'{robot}' is idle, so no program drives it", "", True, other)
            for index, entry_point in enumerate((entry_points,) if isinstance(entry_points, str) else entry_points):
                if any(part in {"", ".", ".."} for part in entry_point.split("/")):
                    where = at if isinstance(entry_points, str) else (*at, index)
                    message = f"'{entry_point}' is not a plain path inside a submission"
                    yield Issue("wrong-value", where, message, "leave '.', '..' and '//' out")
        first = channels.setdefault(entrant.radio_channel, name)
        if first != name:
            free = next(
                one for one in count(2) if all(one != other.radio_channel for other in scenario.entrants.values())
            )
            message = f"'{first}' and '{name}' have the same radio channel, {entrant.radio_channel}"
            other = ("entrants", first, "radio_channel")
            yield Issue("same-channel", (*path, "radio_channel"), message, f"{free} is free", other=other)
    if scenario.match.swap_sides and len(scenario.entrants) != 2:
        message = f"only two entrants can change sides; there are {listing(scenario.entrants) or 'none'}"
        yield Issue("cannot-swap", ("match", "swap_sides"), message, "write swap_sides: false")
