"""What a rule sheet says, section by section."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from rcj_challenges.scenario.models import robots as kit_models
from rcj_challenges.scenario.models.actions import Emit, Score
from rcj_challenges.scenario.models.scenario import RankByCounter, RankByScore, RankByTime, Result, Rule, Scenario
from rcj_challenges.scenario.models.state import AnyStep, Draw, Phase, Sequence
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.sheet.blocks import Block, Heading, Items, Paragraph, Picture, Table, as_html, as_markdown
from rcj_challenges.views.sheet.deeds import action_words, placing_words
from rcj_challenges.views.sheet.edges import condition_words, trigger_words
from rcj_challenges.views.sheet.nouns import Nouns, listed, plain, quoted
from rcj_challenges.views.sheet.phrases import amount, metres, seconds, times, value


def sheet_markdown(scenario: Scenario, roster: Roster) -> str:
    """Return the rule sheet as Markdown."""
    return as_markdown(sheet_blocks(scenario, roster))


def sheet_html(scenario: Scenario, roster: Roster) -> str:
    """Return the rule sheet as one self-contained HTML page."""
    return as_html(scenario.title, sheet_blocks(scenario, roster))


def sheet_blocks(scenario: Scenario, roster: Roster) -> list[Block]:
    """Return all sections of the sheet, in order."""
    sections = (_goal, _field, _robots, _course, _scoring, _rules, _places, _told, _submission)
    nouns = Nouns(scenario, roster)
    return [block for section in sections for block in section(scenario, nouns)]


def _goal(scenario: Scenario, _nouns: Nouns) -> Iterator[Block]:
    yield Heading(1, scenario.title)
    if scenario.description:
        yield Paragraph(scenario.description)


def _field(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    field = scenario.field
    yield Heading(2, "Field")
    yield Paragraph(
        f"{field.width_m:g} m wide (x) and {field.length_m:g} m long (y) inside its walls, which are "
        f"{metres(field.wall_height_m)} high. The origin is the centre; x grows to the right, y upwards in the drawing."
    )
    yield Picture(draw_scenario(scenario, nouns.roster))
    groups = [f"{quoted(group)}: {nouns.members(group)}" for group in scenario.groups]
    if groups:
        yield Paragraph("These names stand for several:")
        yield Items(tuple(groups))


def _robots(scenario: Scenario, _nouns: Nouns) -> Iterator[Block]:
    yield Heading(2, "Robots")
    rows = [
        (name, robot.colour, "none, it stands braked" if robot.idle else _driver(scenario, name), robot.kit)
        for name, robot in scenario.robots.items()
    ]
    yield Table(("robot", "colour", "driven by", "kit"), tuple(rows))
    used = {robot.kit for robot in scenario.robots.values() if not robot.idle}
    for kit_name, kit in scenario.kits.items():
        if kit_name not in used:
            continue
        yield Heading(3, f"Kit {kit_name}")
        chassis = kit.chassis
        top = chassis.wheel_radius_m * chassis.max_wheel_radps
        yield Paragraph(
            f"A cube of {metres(chassis.size_m)} on two wheels; top speed {top:g} m/s "
            f"at {chassis.max_wheel_radps:g} rad/s. Programs take a step every {kit.control_step_ms} ms; "
            f"messages are as in version {kit.messages}."
        )
        yield Table(("device", "what it is"), tuple((name, device_words(d)) for name, d in kit.devices.items()))
    for name, robot in scenario.robots.items():
        if robot.devices or robot.without:
            changes = [f"“{device}”: {device_words(model)}" for device, model in robot.devices.items()]
            changes += [f"no “{device}”" for device in robot.without]
            yield Paragraph(f"{name} differs from its kit: {'; '.join(changes)}.")


def _driver(scenario: Scenario, robot: str) -> str:
    return next((f"program of {plain(seat)}" for seat, e in scenario.entrants.items() if robot in e.robots), "nobody")


def device_words(device: kit_models.Device) -> str:
    """Return what a device is, with its range."""
    return _DEVICES[device.device](device)


def _lidar(d: kit_models.LidarDevice) -> str:
    turning = f", turning at {d.frequency_hz:g} Hz" if d.rotating else ""
    return f"lidar, {d.points} points, {metres(d.min_range_m)} to {metres(d.max_range_m)}{turning}"


_BLANKS = {"{team}": "its team", "{measured}": "what is measured", "{limit}": "the limit"}
_DEVICES: dict[str, Callable[[Any], str]] = {
    "motor": lambda d: f"motor of the {d.wheel} wheel",
    "wheel_sensor": lambda d: f"angle of the {d.wheel} wheel",
    "gps": lambda _: "position of the robot",
    "compass": lambda _: "direction of north",
    "sonar": lambda d: f"distance sensor, bearing {round(d.bearing_rad * 57.29578)}°, up to {metres(d.range_m)}",
    "ball_receiver": lambda d: f"infra-red receiver of the ball, up to {metres(d.range_m)}",
    "supervisor_receiver": lambda d: f"receiver of the referee's packets, channel {d.channel}",
    "team_receiver": lambda _: "team radio, receives",
    "team_emitter": lambda d: f"team radio, sends, {d.baud} baud",
    "lidar": _lidar,
}


def _course(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    match = scenario.match
    yield Heading(2, "Course")
    halves = "One half" if match.halves == 1 else f"{match.halves} halves"
    swap = "; the teams change sides after each half" if match.swap_sides else ""
    first = f" A half begins in the phase {quoted(scenario.first_phase)}." if scenario.first_phase != "play" else ""
    yield Paragraph(f"{halves} of {seconds(match.half_s)}{swap}.{first} Everything is judged on every tick of 32 ms.")
    entries = [
        *(_phase_words(name, phase) for name, phase in scenario.phases.items()),
        *(
            f"The timer {quoted(name)} lasts {seconds(timer.lasts_s)}"
            + (f"; there is one for {nouns.each_of(timer.per)}" if timer.per else "")
            + ("; it starts with the half." if timer.starts else ".")
            for name, timer in scenario.timers.items()
        ),
        *(_draw_words(name, draw) for name, draw in scenario.draws.items()),
        *(_sequence_words(nouns, name, sequence) for name, sequence in scenario.sequences.items()),
    ]
    if entries:
        yield Items(tuple(entries))


def _phase_words(name: str, phase: Phase) -> str:
    lasts = f"lasts {seconds(phase.lasts_s)}" if phase.lasts_s else "lasts until a rule ends it"
    told = "; programs are told that they wait for a kick-off" if phase.waiting_for_kickoff else ""
    clock = "goes on" if phase.clock == "runs" else "stands still"
    return f"The phase {quoted(name)} {lasts}, then {quoted(phase.next)} follows; the clock {clock}{told}."


def _draw_words(name: str, draw: Draw) -> str:
    values = listed([plain(str(entry)) for entry in draw.values], "or")
    again = ", never the same twice running" if draw.not_last else ""
    keep = "once a match" if draw.keep == "match" else "when a half starts"
    return f"Chance decides {quoted(name)} {keep}: {values}{again}."


def _sequence_words(nouns: Nouns, name: str, sequence: Sequence) -> str:
    steps = [nouns.any_of(step.any_of if isinstance(step, AnyStep) else step) for step in sequence.steps]
    back = " and back to the first" if sequence.cyclic else ""
    wrong = "breaks it" if sequence.wrong_step == "break" else "changes nothing"
    way = ", then ".join(steps)
    return (
        f"The sequence {quoted(name)} is the way of {nouns.thing(sequence.entity)}: {way}{back}; a wrong step {wrong}."
    )


def _scoring(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    rows = [
        (_spoken(rule, nouns) or _when(rule, nouns), plain(action.entrant), amount(nouns, action.points))
        for rule in scenario.rules.values()
        for action in rule.actions
        if isinstance(action, Score)
    ]
    yield Heading(2, "Scoring")
    if rows:
        # Rules that say the same, one for each side of the field, are one row for the reader.
        yield Table(("when", "who", "points"), tuple(dict.fromkeys(rows)))
    else:
        yield Paragraph("No rule gives points.")
    if scenario.result != Result():
        criteria = "; if that is equal, ".join(_criterion_words(nouns, one) for one in scenario.result.rank)
        yield Paragraph(f"The better one has {criteria}.")


def _criterion_words(nouns: Nouns, criterion: RankByScore | RankByTime | RankByCounter) -> str:
    if isinstance(criterion, RankByScore):
        return "more points" if criterion.score == "descending" else "fewer points"
    if isinstance(criterion, RankByCounter):
        larger = "larger" if criterion.order == "descending" else "smaller"
        return f"a {larger} value of {nouns.kept('counter', criterion.counter, None)}"
    added = "".join(
        f", with {seconds(part.weight)} added for each count of {nouns.kept('counter', part.counter, None)}"
        for part in criterion.plus
    )
    return f"a {'shorter' if criterion.time == 'ascending' else 'longer'} time{added}"


def _rules(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    yield Heading(2, "Rules")
    yield Paragraph(
        "On each tick the rules are judged in this order; a name in brackets is the rule's name in the log."
    )
    yield Items(tuple(f"[{name}] {_sentence(rule, nouns)}" for name, rule in scenario.rules.items()), numbered=True)


def _sentence(rule: Rule, nouns: Nouns) -> str:
    says = f"{_spoken(rule, nouns)} " if rule.says else ""
    extras = []
    if rule.cooldown_s:
        extras.append(f"at most once in {seconds(rule.cooldown_s)}")
    if rule.max_executions:
        extras.append(f"at most {times(rule.max_executions)} a half")
    if rule.phases == "any":
        extras.append("in every phase")
    elif rule.phases != ("play",):
        extras.append(f"in the phase {listed([quoted(phase) for phase in rule.phases], 'or')}")
    tail = f" ({'; '.join(extras)})" if extras else ""
    actions = ", then ".join(action_words(nouns, action) for action in rule.actions)
    return f"{says}{_when(rule, nouns)}: {actions}{tail}."


def _spoken(rule: Rule, nouns: Nouns) -> str:
    """Return what a rule says, with words for what is known only when it fires."""
    spoken = rule.says.replace("{entity}", f"the {_kind_of_each(rule, nouns.roster)}")
    for blank, words in _BLANKS.items():
        spoken = spoken.replace(blank, words)
    return spoken[:1].upper() + spoken[1:]


def _kind_of_each(rule: Rule, roster: Roster) -> str:
    """Return of what kind a rule's current entity is; robots, if it is not said with ``for_each``."""
    of_each = [] if rule.for_each is None else [roster.index[name] for name in roster.expand(rule.for_each)]
    if not of_each or min(of_each) < roster.robots:
        return "robot"
    return "ball" if min(of_each) < roster.robots + roster.balls else "obstacle"


def _when(rule: Rule, nouns: Nouns) -> str:
    each = f"For {nouns.each_of(rule.for_each)}, when " if rule.for_each else "When "
    edges = ", or when ".join(trigger_words(nouns, trigger) for trigger in rule.triggers)
    levels = " and ".join(f"that {condition_words(nouns, condition)}" for condition in rule.conditions)
    return f"{each}{edges}" + (f", provided {levels}" if levels else "")


def _places(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    if scenario.placements:
        yield Heading(2, "Where things are put")
    for name, layout in scenario.placements.items():
        yield Paragraph(f"{quoted(name)}: {'; '.join(placing_words(nouns, placing) for placing in layout)}.")


def _told(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    yield Heading(2, "What programs are told")
    yield Paragraph("The referee's packet, as the kit's version has it, tells whether a kick-off is awaited.")
    if scenario.broadcast is not None:
        fields = tuple((key, value(nouns, entry)) for key, entry in scenario.broadcast.fields.items())
        every = scenario.broadcast.every_ticks
        often = "every tick" if every == 1 else f"every {every} ticks"
        yield Paragraph(f"After it, {often}, one JSON object follows on the same channel:")
        yield Table(("key", "value"), fields)
    events: dict[str, list[str]] = {}
    for rule in scenario.rules.values():
        for event in {action.event: None for action in rule.actions if isinstance(action, Emit)}:
            events.setdefault(event, []).append(_spoken(rule, nouns))
    if events:
        yield Heading(2, "Events in the log")
        meanings = {event: " Or: ".join(filter(None, dict.fromkeys(said))) for event, said in events.items()}
        yield Table(("event", "meaning"), tuple(meanings.items()))


def _submission(scenario: Scenario, _nouns: Nouns) -> Iterator[Block]:
    yield Heading(2, "What to hand in")
    rows = [
        (plain(seat), robot, " or ".join(entries) if isinstance(entries, tuple) else entries)
        for seat, entrant in scenario.entrants.items()
        for robot, entries in entrant.robots.items()
    ]
    yield Table(("who", "robot", "program"), tuple(rows))
    limits = scenario.limits
    yield Paragraph(
        f"Limits: {seconds(limits.start_s)} to the first step, {seconds(limits.step_s)} for a step "
        f"and {seconds(limits.half_s)} in all in a half (only the waiting for that program counts), "
        f"{limits.memory_mb} MB of memory, {limits.output_mb:g} MB of output. "
        "A program that exceeds one stops for the rest of the half."
    )
