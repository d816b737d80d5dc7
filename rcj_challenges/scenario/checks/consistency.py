"""What is well formed and contradicts itself: within rules, times, draws, tests, kits, entrants and guidelines."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from rcj_challenges.chassis.base import CHASSIS, Chassis
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.devices.base import DEVICES, Device
from rcj_challenges.rules.base import Condition, PlaceWord, Trigger, Vocabulary
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.effects import AtTime, Draws, SetsSpot
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.phrasing import spelled
from rcj_challenges.rules.placement import Kick
from rcj_challenges.rules.quantifier import HowMany
from rcj_challenges.rules.ranked import counters_in
from rcj_challenges.rules.values.distance import DistanceValue
from rcj_challenges.scenario import codes
from rcj_challenges.scenario.draw_order import never_drawn
from rcj_challenges.scenario.errors import choice_of, listing
from rcj_challenges.scenario.halves import clock_may_stop, half_length_s, in_half, longest_half_s
from rcj_challenges.scenario.models.designs import Part
from rcj_challenges.scenario.models.field import Match, Wall
from rcj_challenges.scenario.models.scenario import Expectation, Given, MatchExpectation, Rule, Scenario
from rcj_challenges.scenario.models.state import Draw, Sequence
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.shapes import centre_of
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.walk import effects_in, walk

_RANGES = (
    *((least, most) for least in ("at_least", "above") for most in ("at_most", "below")),
    ("keeps_at_least", "keeps_at_most"),
)


def check_consistency(scenario: Scenario, *, is_half_set: bool, is_length_set: bool) -> Iterator[Diagnostic]:
    """Yield contradictions.

    With halves set on the command line, what comes after a shortened half is no mistake; with lengths set, there must
    be as many as halves.
    """
    roster = Roster.of(scenario)
    longest_s = longest_half_s(scenario.match)
    for model, path in walk(scenario):
        yield from _keys(model, path)
        yield from _numbers(model, path, roster)
        match model.moment() if isinstance(model, Trigger) and not is_half_set else None:
            case AtTime(at_s) if isinstance(at_s, int | float) and at_s > longest_s:
                yield issue(
                    codes.TOO_LATE, (*path, "at_s"), f"{at_s:g} s is never reached; a half lasts {longest_s:g} s"
                )
        if isinstance(model, Match) and (is_length_set or not is_half_set):
            yield from _lengths(model, path, is_of_file=not is_length_set)
        if isinstance(model, Expectation):
            yield from _of_a_half(model, path, scenario if not is_half_set else None)
            yield from _script(model, path)
            yield from _decided(model, path, scenario)
        if isinstance(model, Expectation | MatchExpectation | Given):
            yield from _owners(model, path, scenario, roster)
    for name, rule in scenario.rules.items():
        yield from _measured(rule, ("rules", name), rule, scenario, roster)
    yield from _measured(scenario.broadcast, ("broadcast",), None, scenario, roster)
    yield from _robots(scenario, roster)
    yield from dict.fromkeys(_kits_of_teams(scenario))
    for name, guideline in scenario.guidelines.items():
        yield from _parts(guideline.drives, CHASSIS, ("guidelines", name, "drives"))
        yield from _parts(guideline.devices, DEVICES, ("guidelines", name, "devices"))
    yield from _entrants(scenario)
    yield from _ranking(scenario)


# --- within one mapping -----------------------------------------------------------------------------------------------


def _keys(model: Strict, path: Path) -> Iterator[Diagnostic]:
    """Yield keys of one mapping that exclude each other, and the lack of all of several."""
    for key, others in (*model.EXCLUDES, *((key, model.either[at:]) for at, key in enumerate(model.either, 1))):
        also = next((one for one in others if getattr(model, one) is not None), None)
        if also is not None and getattr(model, key) is not None:
            message = f"'{key}' and '{also}' cannot be given together"
            at, other = (*path, also), (*path, key)
            yield issue(codes.CONFLICTING_KEYS, at, message, "leave one of them out", at_key=True, other=other)
    for key, beside, value in model.TOGETHER:
        other = getattr(model, beside)
        if (getattr(model, key) is not None) != (other is not None if value is None else other == value):
            what = beside if value is None else f"{beside}: {value}"
            yield issue(codes.MISSING_KEY, path, f"'{key.rstrip('_')}' belongs to '{what}'", "give both, or neither")
    choices = model.REQUIRES or tuple((key,) for key in model.either)
    if choices and not any(all(getattr(model, key) is not None for key in keys) for keys in choices):
        needed = ", or ".join(" and ".join(keys) for keys in choices).replace("in_", "in")
        yield issue(codes.MISSING_KEY, path, f"needs {needed}")
    if isinstance(model, Draw) and len(set(map(repr, model.values))) == 1:
        for key in (one for one in ("not_last", "not_again") if getattr(model, one)):
            message = "one value alone comes again every time"
            yield issue(codes.CONFLICTING_KEYS, (*path, key), message, "give two different values")
    if isinstance(model, Sequence) and model.order == "any" and model.wrong_step == "break":
        message = "in any order no step is wrong"
        yield issue(codes.CONFLICTING_KEYS, (*path, "wrong_step"), message, "leave out 'wrong_step' or 'order'")
    if isinstance(model, Rule) and isinstance(model.phases, tuple) and "any" in model.phases:
        message = "'any' cannot stand in a list of phases"
        yield issue(codes.WRONG_VALUE, (*path, "phases"), message, "any phase is written phases: any, without brackets")


def _numbers(model: Strict, path: Path, roster: Roster) -> Iterator[Diagnostic]:
    """Yield ranges that hold no number, more of a group than it has, and durations below a tick."""
    for least_key, most_key in _RANGES:
        least, most = getattr(model, least_key, None), getattr(model, most_key, None)
        if not isinstance(least, int | float) or not isinstance(most, int | float):
            continue
        if least > most or (least == most and {least_key, most_key} & {"above", "below"}):
            message = f"nothing is {least_key.replace('_', ' ')} {least:g} and {most_key.replace('_', ' ')} {most:g}"
            yield issue(codes.EMPTY_RANGE, (*path, least_key), message)
    match model:
        case Kick(speed_mps=(least, most)) if least > most:
            yield issue(codes.EMPTY_RANGE, (*path, "speed_mps"), f"no speed is at least {least:g} and at most {most:g}")
    of = getattr(model, "of", None)
    names = model.grouped() if isinstance(model, Condition) else None
    is_number = isinstance(of, HowMany) and (of.at_least or of.equals)
    if isinstance(of, HowMany) and is_number and names is not None and of.number > len(roster.expand(names)):
        count = len(roster.expand(names))
        yield issue(codes.NEVER_HOLDS, (*path, "of"), f"{of.describe(negate=False)} of {count} can never hold")
    if isinstance(model, Compared) and of is not None and not model.VALUE.OVER:
        yield issue(
            codes.NOT_PER_ENTITY, (*path, "of"), "this is one number, not one for each of a group", "leave 'of' out"
        )
    for key in ("for_s", "grace_s"):
        seconds = getattr(model, key, None)
        if isinstance(seconds, int | float) and 0 < seconds < TICK_S:
            message = f"a duration must be 0 or at least one tick ({TICK_S} s), found {seconds:g}"
            yield issue(codes.WRONG_VALUE, (*path, key), message)


def _measured(part: object, path: Path, rule: Rule | None, scenario: Scenario, roster: Roster) -> Iterator[Diagnostic]:
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
                yield issue(codes.WRONG_KIND, (*at, "distance"), message, help_)
    for spot, at in effects_in(str(path[1]), rule, SetsSpot) if rule is not None else ():
        for name in roster.may_be(spot.at, rule) if isinstance(spot.at, str) else ():
            if name in scenario.zones and centre_of(scenario.zones[name]) is None:
                help_ = "set the spot to an entity, a spot or [x, y]"
                yield issue(codes.NO_CENTRE, (*at, "to"), f"zone '{name}' has no centre", help_)


# --- times ------------------------------------------------------------------------------------------------------------


def _lengths(match: Match, path: Path, *, is_of_file: bool) -> Iterator[Diagnostic]:
    """Yield too few or too many lengths: if only the number is set on the command line, the last one goes for more."""
    if isinstance(match.half_s, tuple) and len(match.half_s) != match.halves:
        given, played = counted(len(match.half_s), "length"), match.period.counted(match.halves)
        help_ = f"give each {match.period} its length, or one number for all"
        other = (*path, "halves") if is_of_file else ()
        yield issue(codes.WRONG_VALUE, (*path, "half_s"), f"{given} in half_s for {played}", help_, other=other)


def _of_a_half(test: Expectation, path: Path, scenario: Scenario | None) -> Iterator[Diagnostic]:
    """Yield what stands in a half of a test, and is of the whole; of a scenario also what comes after its halves."""
    half, at = (int(path[-1]) + 1, path) if path[-2] == "halves" else (test.half, (*path, "half"))
    for key in ("seed", "half", "ranking") if at is path else ():
        if getattr(test, key) != Expectation.model_fields[key].default:
            message = f"'{key}' is not of one half"
            yield issue(codes.CONFLICTING_KEYS, (*path, key), message, "leave it out", at_key=True)
    if scenario is None:
        return
    half_s = half_length_s(scenario.match, half)
    if test.lasts_s > half_s and not clock_may_stop(scenario):
        yield issue(codes.TOO_LATE, (*path, "lasts_s"), f"{test.lasts_s:g} s is longer than a half, {half_s:g} s")
    if half > scenario.match.halves:
        yield issue(codes.TOO_LATE, at, f"there is no half {half}; {scenario.match.halves} are played")


# --- tests ------------------------------------------------------------------------------------------------------------


def _script(test: Expectation, path: Path) -> Iterator[Diagnostic]:
    before = -1.0
    for index, frame in enumerate(test.keyframes):
        if frame.at_s <= before:
            message, help_ = (
                f"{frame.at_s:g} s does not come after {before:g} s",
                "keyframes stand in the order of time",
            )
            yield issue(codes.TOO_EARLY, (*path, "keyframes", index, "at_s"), message, help_)
        before = max(before, frame.at_s)
    moments = [(("keyframes", index), frame.at_s) for index, frame in enumerate(test.keyframes)]
    moments += [(("events", i), event.at_s) for i, event in enumerate(test.events or ()) if event.at_s is not None]
    for where, at_s in moments:
        if at_s > test.lasts_s:
            yield issue(codes.TOO_LATE, (*path, *where, "at_s"), f"{at_s:g} s comes after the end, {test.lasts_s:g} s")


def _decided(test: Expectation, path: Path, scenario: Scenario) -> Iterator[Diagnostic]:
    """Yield values of draws that cannot be drawn in the order of a test, and spots that no rule sets at random."""
    set_by_rules = {one.draw for one in scenario.effects(Draws) if one.value is not None}
    for name, decided in test.draws.items():
        draw = scenario.draws.get(name)
        if draw is None or name in set_by_rules or not isinstance(decided, tuple):
            continue
        index = never_drawn(draw, decided)
        if index is not None and decided[index] in draw.values:
            why = "not_last" if draw.not_last and decided[index] == decided[index - 1] else "not_again"
            message = f"{spelled(decided[index])} is not drawn again here ({why})"
            yield issue(codes.NEVER_DRAWN, (*path, "draws", name, index), message)
    random = {one.spot for one in scenario.effects(SetsSpot) if isinstance(one.at, PlaceWord) and one.at.IS_SPREAD}
    for name in (one for one in test.spots or {} if one in scenario.spots and one not in random):
        help_ = "where it is at the end is compared under poses"
        yield issue(codes.NEVER_DRAWN, (*path, "spots", name), f"no rule sets '{name}' at random", help_, at_key=True)


def _owners(
    test: Expectation | MatchExpectation | Given, path: Path, scenario: Scenario, roster: Roster
) -> Iterator[Diagnostic]:
    """Yield values of single owners for a counter or flag that has no such owners."""
    flags = {} if isinstance(test, MatchExpectation) else test.flags
    for noun, tested, known in (("counter", test.counters, scenario.counters), ("flag", flags, scenario.flags)):
        for name, values in tested.items():
            kept, at = known.get(name), (*path, f"{noun}s", name)
            if kept is None or not isinstance(values, dict):
                continue
            if kept.per is None:
                message = f"{noun} '{name}' is not kept per entity"
                yield issue(codes.NOT_PER_ENTITY, at, message, "write its value alone")
            elif not values:
                yield issue(codes.WRONG_VALUE, at, "names nothing", "write {entity: value, …}, or leave it out")
            owners = roster.keepers(kept.per) if kept.per is not None else values
            for owner in (one for one in values if one not in owners):
                message = f"there is no {noun} '{name}' of '{owner}'"
                yield issue(codes.UNKNOWN_NAME, (*at, owner), message, choice_of(owner, owners), at_key=True)


# --- robots and entrants ----------------------------------------------------------------------------------------------


def _robots(scenario: Scenario, roster: Roster) -> Iterator[Diagnostic]:
    if not roster.entities:
        help_ = "give at least one robot or one ball"
        yield issue(codes.NOTHING_MOVES, ("robots",), "nothing on the field can move", help_)
    for name, kit in scenario.kits.items():
        at: Path = ("kits", name)
        yield from (issue(codes.WRONG_VALUE, (*at, "chassis", key), text) for key, text in kit.chassis.contradictions())
        yield from _devices(kit.devices, kit.chassis, at)
    for name, robot in scenario.robots.items():
        devices = scenario.kits[robot.kit].devices if robot.kit in scenario.kits else robot.without
        for index, device in enumerate(robot.without):
            if device not in devices:
                message, help_ = f"kit '{robot.kit}' has no device '{device}'", choice_of(device, devices)
                yield issue(codes.UNKNOWN_NAME, ("robots", name, "without", index), message, help_)


def _kits_of_teams(scenario: Scenario) -> Iterator[Diagnostic]:
    """Yield the mistakes in kits that teams bring along, and in devices of robots on the chassis that they have."""
    for name, entrant in scenario.entrants.items():
        if entrant.kits and len(entrant.kits) != len(entrant.robots):
            message, help_ = f"{len(entrant.kits)} kits for {len(entrant.robots)} robots", "give one for each, in order"
            yield issue(codes.WRONG_VALUE, ("entrants", name, "kits"), message, help_)
    for half in (1, 2):
        for name, robot in in_half(scenario, half).robots.items():
            if robot.kit in scenario.kits:
                yield from _devices(robot.devices, scenario.kits[robot.kit].chassis, ("robots", name))


def _devices(devices: Mapping[str, Device], chassis: Chassis, path: Path) -> Iterator[Diagnostic]:
    for name, device in devices.items():
        for key, message in device.contradictions(chassis):
            yield issue(codes.WRONG_VALUE, (*path, "devices", name, key), message)


def _entrants(scenario: Scenario) -> Iterator[Diagnostic]:
    driver: dict[str, str] = {}
    channels: dict[int, str] = {}
    for name, entrant in scenario.entrants.items():
        path: Path = ("entrants", name)
        if not entrant.robots:
            yield issue(codes.ENTRANT_WITHOUT_ROBOTS, (*path, "robots"), "an entrant drives at least one robot")
        for robot in entrant.robots:
            at = (*path, "robots", robot)
            first = driver.setdefault(robot, name)
            if first != name:
                other: Path = ("entrants", first, "robots", robot)
                yield issue(codes.DRIVEN_TWICE, at, f"'{robot}' is driven by '{first}' already", "", True, other)
            if robot in scenario.robots and scenario.robots[robot].idle:
                other = "robots", robot, "idle"
                yield issue(codes.DRIVEN_TWICE, at, f"'{robot}' is idle, so no program drives it", "", True, other)
        first = channels.setdefault(entrant.radio_channel, name)
        if first != name:
            message = f"'{first}' and '{name}' have the same radio channel, {entrant.radio_channel}"
            other = ("entrants", first, "radio_channel")
            yield issue(codes.SAME_CHANNEL, (*path, "radio_channel"), message, "give each its own", other=other)
    if scenario.match.swap_sides and len(scenario.entrants) != 2:
        message = f"only two entrants can change sides; there are {listing(scenario.entrants) or 'none'}"
        yield issue(codes.CANNOT_SWAP, ("match", "swap_sides"), message, "write swap_sides: false")


def _ranking(scenario: Scenario) -> Iterator[Diagnostic]:
    """Yield counters of the whole match to which a half adds nothing that could be summed or compared."""
    for at, ranked in enumerate(scenario.result.rank):
        for name in counters_in([ranked]) if ranked.over != "last" else ():
            counter = scenario.counters.get(name)
            if counter is not None and counter.keep == "match" and (counter.keeps or counter.first is None):
                message = f"counter '{name}' of the match keeps a value, or begins with none: halves do not add to it"
                yield issue(codes.WRONG_VALUE, ("result", "rank", at), message, "write over: last")


# --- guidelines -------------------------------------------------------------------------------------------------------


def _parts(parts: Mapping[str, Part], words: Vocabulary, path: Path) -> Iterator[Diagnostic]:
    """Yield the mistakes in what a guideline allows of one kind."""
    known = {word.name(): word for word in words.words()}
    for name, part in parts.items():
        if name not in known:
            message = f"there is no {words.key} '{name}'"
            yield issue(codes.UNKNOWN_WORD, (*path, name), message, choice_of(name, known), at_key=True)
            continue
        fields = [field for field in known[name].model_fields if field != words.key]
        for field, allowance in part.limits.items():
            at: Path = (*path, name, "limits", field)
            if field not in fields:
                message = f"{name} has no field '{field}'"
                yield issue(codes.UNKNOWN_NAME, at, message, choice_of(field, fields), at_key=True)
            steps = [up_to for up_to, _ in allowance.prices]
            if any(one >= other for one, other in pairwise(steps)):
                yield issue(codes.WRONG_VALUE, (*at, "prices"), "the values must increase from step to step")
