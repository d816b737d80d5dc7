"""What a rule sheet says, section by section."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from rcj_challenges.scenario.models import robots as kit_models
from rcj_challenges.scenario.models.actions import Emit, Score
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.sheet.blocks import Block, Heading, Items, Paragraph, Picture, Table, as_html, as_markdown
from rcj_challenges.views.sheet.deeds import action_words, placing_words
from rcj_challenges.views.sheet.edges import condition_words, trigger_words
from rcj_challenges.views.sheet.phrases import amount, metres, named, seconds, value


def sheet_markdown(scenario: Scenario, roster: Roster) -> str:
    """Return the rule sheet as Markdown."""
    return as_markdown(sheet_blocks(scenario, roster))


def sheet_html(scenario: Scenario, roster: Roster) -> str:
    """Return the rule sheet as one self-contained HTML page."""
    return as_html(scenario.title, sheet_blocks(scenario, roster))


def sheet_blocks(scenario: Scenario, roster: Roster) -> list[Block]:
    """Return all sections of the sheet, in order."""
    sections = (_goal, _field, _robots, _course, _scoring, _rules, _places, _told, _submission)
    return [block for section in sections for block in section(scenario, roster)]


def _goal(scenario: Scenario, _roster: Roster) -> Iterator[Block]:
    yield Heading(1, scenario.title)
    if scenario.description:
        yield Paragraph(scenario.description)


def _field(scenario: Scenario, roster: Roster) -> Iterator[Block]:
    field = scenario.field
    yield Heading(2, "Field")
    yield Paragraph(
        f"{field.width_m:g} m wide (x) and {field.length_m:g} m long (y) inside its walls, which are "
        f"{metres(field.wall_height_m)} high. The origin is the centre; x grows to the right, y upwards in the drawing."
    )
    yield Picture(draw_scenario(scenario, roster))


def _robots(scenario: Scenario, _roster: Roster) -> Iterator[Block]:
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
            f"at {chassis.max_wheel_radps:g} rad/s. Programs step {kit.control_step_ms} ms; "
            f"messages as in version {kit.messages}."
        )
        yield Table(("device", "what it is"), tuple((name, device_words(d)) for name, d in kit.devices.items()))
    for name, robot in scenario.robots.items():
        if robot.devices or robot.without:
            changes = [f"{device}: {device_words(model)}" for device, model in robot.devices.items()]
            changes += [f"no {device}" for device in robot.without]
            yield Paragraph(f"{name} differs from its kit: {'; '.join(changes)}.")


def _driver(scenario: Scenario, robot: str) -> str:
    return next((f"program of {named(seat)}" for seat, e in scenario.entrants.items() if robot in e.robots), "nobody")


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


def _course(scenario: Scenario, _roster: Roster) -> Iterator[Block]:
    match = scenario.match
    yield Heading(2, "Course")
    halves = "One half" if match.halves == 1 else f"{match.halves} halves"
    swap = "; the teams change sides after each half" if match.swap_sides else ""
    yield Paragraph(f"{halves} of {seconds(match.half_s)}{swap}. Everything is judged on every tick of 32 ms.")
    phases = [
        f"{named(name)}: {seconds(phase.lasts_s) if phase.lasts_s else 'until a rule ends it'}, "
        f"then {named(phase.next)}; the clock {phase.clock}"
        + ("; programs are told that they wait for a kick-off" if phase.waiting_for_kickoff else "")
        for name, phase in scenario.phases.items()
    ]
    if phases:
        yield Items(tuple(phases))
    timers = [f"timer {named(name)}: {seconds(timer.lasts_s)}" for name, timer in scenario.timers.items()]
    draws = [f"{named(name)} is drawn from {', '.join(map(value, d.values))}" for name, d in scenario.draws.items()]
    if timers or draws:
        yield Items((*timers, *draws))


def _scoring(scenario: Scenario, roster: Roster) -> Iterator[Block]:
    rows = [
        (_spoken(rule, roster) or _when(rule), named(action.entrant), amount(action.points))
        for rule in scenario.rules.values()
        for action in rule.actions
        if isinstance(action, Score)
    ]
    yield Heading(2, "Scoring")
    if rows:
        yield Table(("when", "who", "points"), tuple(rows))
    else:
        yield Paragraph("No rule gives points.")


def _rules(scenario: Scenario, roster: Roster) -> Iterator[Block]:
    yield Heading(2, "Rules")
    yield Paragraph(
        "On each tick the rules are judged in this order; a name in brackets is the rule's name in the log."
    )
    yield Items(tuple(f"[{name}] {_sentence(rule, roster)}" for name, rule in scenario.rules.items()), numbered=True)


def _sentence(rule: Rule, roster: Roster) -> str:
    says = f"{_spoken(rule, roster)} " if rule.says else ""
    extras = []
    if rule.cooldown_s:
        extras.append(f"at most once in {seconds(rule.cooldown_s)}")
    if rule.max_executions:
        extras.append(f"at most {rule.max_executions} times a half")
    if rule.phases == "any":
        extras.append("in every phase")
    elif rule.phases != ("play",):
        extras.append("in " + ", ".join(map(named, rule.phases)))
    tail = f" ({'; '.join(extras)})" if extras else ""
    return f"{says}{_when(rule)}: {', then '.join(action_words(action) for action in rule.actions)}{tail}."


def _spoken(rule: Rule, roster: Roster) -> str:
    """Return what a rule says, with words for what is known only when it fires."""
    spoken = rule.says.replace("{entity}", f"the {_kind_of_each(rule, roster)}")
    for blank, words in _BLANKS.items():
        spoken = spoken.replace(blank, words)
    return spoken[:1].upper() + spoken[1:]


def _kind_of_each(rule: Rule, roster: Roster) -> str:
    """Return of what kind a rule's current entity is; robots, if it is not said with ``for_each``."""
    of_each = [] if rule.for_each is None else [roster.index[name] for name in roster.expand(rule.for_each)]
    if not of_each or min(of_each) < roster.robots:
        return "robot"
    return "ball" if min(of_each) < roster.robots + roster.balls else "obstacle"


def _when(rule: Rule) -> str:
    each = f"For each of {named(rule.for_each)}: when " if rule.for_each else "When "
    conditions = "".join(f", if {condition_words(condition)}" for condition in rule.conditions)
    return each + ", or ".join(trigger_words(trigger) for trigger in rule.triggers) + conditions


def _places(scenario: Scenario, _roster: Roster) -> Iterator[Block]:
    if scenario.placements:
        yield Heading(2, "Where things are put")
    for name, layout in scenario.placements.items():
        yield Paragraph(f"{named(name)}: {'; '.join(placing_words(placing) for placing in layout)}.")


def _told(scenario: Scenario, roster: Roster) -> Iterator[Block]:
    yield Heading(2, "What programs are told")
    yield Paragraph("The referee's packet, as the kit's version has it, tells whether a kick-off is awaited.")
    if scenario.broadcast is not None:
        fields = tuple((key, value(entry)) for key, entry in scenario.broadcast.fields.items())
        every = scenario.broadcast.every_ticks
        yield Paragraph(f"After it, every {every} tick{'s' if every > 1 else ''}, one JSON object on the same channel:")
        yield Table(("key", "value"), fields)
    events: dict[str, list[str]] = {}
    for rule in scenario.rules.values():
        for event in {action.event: None for action in rule.actions if isinstance(action, Emit)}:
            events.setdefault(event, []).append(_spoken(rule, roster))
    if events:
        yield Heading(2, "Events in the log")
        meanings = {event: " Or: ".join(filter(None, dict.fromkeys(said))) for event, said in events.items()}
        yield Table(("event", "meaning"), tuple(meanings.items()))


def _submission(scenario: Scenario, _roster: Roster) -> Iterator[Block]:
    yield Heading(2, "What to hand in")
    rows = [
        (named(seat), robot, " or ".join(entries) if isinstance(entries, tuple) else entries)
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
