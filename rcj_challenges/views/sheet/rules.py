"""The rules of a rule sheet as sentences, in the order in which they are judged, and which of them exclude others."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.remove import Remove
from rcj_challenges.rules.actions.score import LastToucher
from rcj_challenges.rules.base import Word
from rcj_challenges.rules.conditions import AnyCondition
from rcj_challenges.rules.conditions.all_of import AllOf
from rcj_challenges.rules.conditions.distance import Distance
from rcj_challenges.rules.conditions.in_zone import InZone
from rcj_challenges.rules.conditions.last_touch import LastTouch
from rcj_challenges.rules.conditions.looks import Looks
from rcj_challenges.rules.conditions.speed import Speed
from rcj_challenges.rules.conditions.spot_free import SpotFree
from rcj_challenges.rules.phrasing import USUALLY_FREE_M, listed, metres, quoted, seconds, times
from rcj_challenges.rules.places.furthest_free import FurthestFree
from rcj_challenges.rules.places.nearest_free import NearestFree
from rcj_challenges.rules.triggers.half_started import HalfStarted
from rcj_challenges.rules.triggers.holds import Holds
from rcj_challenges.rules.values.last_touch import LastTouchValue
from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.models.places import Placing
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.other import meant_in, names_other, others_of
from rcj_challenges.scenario.visiting import visit
from rcj_challenges.views.sheet.blocks import Block, Heading, Items, Paragraph
from rcj_challenges.views.sheet.nouns import Nouns
from rcj_challenges.views.sheet.spoken import spoken

_Named = tuple[str, Rule]


def rule_blocks(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    """Return the section about the rules."""
    yield Heading(2, "Rules")
    yield Paragraph(
        "On each tick the rules are judged in this order; a name in brackets is the rule's name in the log."
        + _phases_words(scenario)
    )
    rules = sorted(scenario.rules.items(), key=lambda named: named[1].priority)
    yield Items(tuple(f"[{name}] {_sentence(rule, nouns)}" for name, rule in rules), numbered=True)
    exclusive = tuple(_exclusive_words(rules, nouns))
    if exclusive:
        yield Items(exclusive)
    yield from _centres(scenario)
    yield from _last_touch(scenario)
    yield from _free_spots(scenario, nouns)
    yield from _room(scenario)
    yield from _back_sooner(scenario, nouns)


def _phases_words(scenario: Scenario) -> str:
    """Return in which phase a rule counts about which nothing is said, if there are others."""
    alone = any(rule.phases == ("play",) for rule in scenario.rules.values())
    if not alone or not set(scenario.phases) - {"play"}:
        return ""
    only = "Where nothing else is said, a rule counts in the phase “play” only"
    lasting = any(
        rule.phases == ("play",) and model.OVER_TIME for rule in scenario.rules.values() for model in rule.triggers
    )
    anew = ", and what must last for a time, or move within one, is measured anew after it" if lasting else ""
    return f" {only}; what happens in another phase is not made up for later{anew}."


def when_words(rule: Rule, nouns: Nouns) -> str:
    """Return when a rule fires: ``When the ball enters the blue goal, provided that …``."""
    nouns = nouns.within(rule)
    each = f"For {nouns.each_of(rule.for_each)}, when " if rule.for_each else "When "
    edges = ", or when ".join(trigger.describe(nouns) for trigger in rule.triggers)
    levels = " and ".join(f"that {condition.describe(nouns)}" for condition in rule.conditions)
    return f"{each}{edges}" + (f", provided {levels}" if levels else "")


def _sentence(rule: Rule, nouns: Nouns) -> str:
    nouns = nouns.within(rule)
    says = f"{spoken(nouns, rule)} " if rule.says else ""
    extras = [_how_often(rule, nouns)] if rule.cooldown_s or rule.max_executions else []
    if rule.exclusive is not None and _meets_itself(rule, nouns):
        extras.append("of several touched at once only the first counts")
    if rule.phases == "any":
        extras.append("in every phase")
    elif rule.phases != ("play",):
        extras.append(f"in the phase {listed([quoted(phase) for phase in rule.phases], 'or')}")
    tail = f" ({'; '.join(extras)})" if extras else ""
    actions = ", then ".join(action.describe(nouns) for action in rule.actions)
    return f"{says}{when_words(rule, nouns)}: {actions}{tail}."


def _meets_itself(rule: Rule, nouns: Nouns) -> bool:
    """Return whether a rule may fire more than once in a tick for the same one: for each of several that it touches."""
    return names_other(rule, nouns.scenario) and len(others_of(rule, rule.for_each, nouns.roster)) > 1


def _how_often(rule: Rule, nouns: Nouns) -> str:
    """Return how often a rule counts; over each of a group it does so for each of its members."""
    limits = [
        *([f"at most once in {seconds(rule.cooldown_s)}"] if rule.cooldown_s else []),
        *([f"at most {times(rule.max_executions)} a half"] if rule.max_executions else []),
    ]
    several = rule.for_each is not None and len(nouns.roster.expand(rule.for_each)) > 1
    return ("for each of them " if several else "") + " and ".join(limits)


def _exclusive_words(rules: list[_Named], nouns: Nouns) -> Iterator[str]:
    """Return a sentence for each of the sets of rules of which only one counts in a tick."""
    for group in dict.fromkeys(rule.exclusive for _, rule in rules if rule.exclusive is not None):
        members = [(name, rule) for name, rule in rules if rule.exclusive == group]
        still = " that still may" if any(rule.cooldown_s or rule.max_executions for _, rule in members) else ""
        yield from _only_one([name for name, rule in members if rule.for_each is None], "", still)
        meeting = _sharing([(name, rule) for name, rule in members if rule.for_each is not None], nouns)
        kinds = nouns.kinds_of(tuple(rule.for_each for _, rule in meeting if rule.for_each is not None))
        yield from _only_one([name for name, _ in meeting], f" for the same {kinds}", still)


def _centres(scenario: Scenario) -> Iterator[Block]:
    """Return a sentence about what counts where rules ask where something is: whole bodies reach further."""
    if scenario.sequences or any(
        isinstance(model, Word) and model.ASKS_WHERE for model, _ in visit(tuple(scenario.rules.values()))
    ):
        yield Paragraph(
            "Where a robot, a ball or an obstacle is, its centre says: it counts for zones and gates, and distances "
            "are measured from it."
        )


def _last_touch(scenario: Scenario) -> Iterator[Block]:
    """Return a sentence about the last to touch something, if it is asked for, told, or its team gets points."""
    words = {type(model) for model, _ in visit((*scenario.rules.values(), scenario.broadcast))}
    if words & {LastTouch, LastToucher, LastTouchValue}:
        nobody = ", and its team's points go to nobody" if LastToucher in words else ""
        yield Paragraph(
            "The last to touch something is the robot that touched it last since a rule put it where it is; if none "
            f"has, there is none{nobody}."
        )


def _free_spots(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    """Return a sentence about when a spot is free, where rules ask for one that is."""
    models = [model for model, _ in visit((*scenario.rules.values(), scenario.placements))]
    asked = [model for model in models if isinstance(model, SpotFree | NearestFree | FurthestFree)]
    if not asked:
        return
    gaps_m = {model.clearance_m for model in asked}
    than = [
        *([metres(USUALLY_FREE_M)] if USUALLY_FREE_M in gaps_m else []),
        *(["the distance that is said"] if gaps_m - {USUALLY_FREE_M} else []),
    ]
    nearer = "A spot is free when the centre of no robot and of no ball is nearer to it than"
    yield Paragraph(f"{nearer} {', or '.join(than)}{_itself(scenario, nouns)}.")


def _itself(scenario: Scenario, nouns: Nouns) -> str:
    """Return what is asked of that which is put on a free spot: robots and balls count themselves, obstacles do not."""
    put = [
        (one.entity, rule)
        for rule in (*scenario.rules.values(), None)
        for one, _ in visit(scenario.placements if rule is None else rule.actions)
        if isinstance(one, Place | Placing | Remove) and one.entity is not None and _on_a_free_spot(one)
    ]
    if not put:
        return ""
    meant = {name for entity, rule in put for name in meant_in(entity, rule, nouns.roster)}
    obstacles = meant & scenario.obstacles.keys()
    if obstacles == meant:
        return "; what is to be put there must have room"
    if not obstacles:
        return "; what is to be put there counts as well where it is now, and must have room"
    return (
        "; a robot or a ball that is to be put there counts as well where it is now, and what is put there must have "
        "room"
    )


def _on_a_free_spot(one: Place | Placing | Remove) -> bool:
    return isinstance(one.back_at if isinstance(one, Remove) else one.at, NearestFree | FurthestFree)


def _room(scenario: Scenario) -> Iterator[Block]:
    """Return a sentence about what finds no room, where rules put things and do not say what happens then."""
    models = [model for model, _ in visit((*scenario.rules.values(), scenario.placements))]
    placed = (isinstance(model, Place) and model.layout is None and model.on_failure == "retry" for model in models)
    laid = (isinstance(model, Placing) and model.on_failure == "retry" for model in models)
    back = any(isinstance(model, Remove) and model.for_s is not None for model in models)
    if any(placed) or any(laid) or back:
        where = _in_its_phase(scenario, back=back)
        yield Paragraph(
            "What a rule puts somewhere waits until there is room: while something else stands there, it stays where "
            f"it is (or off the field), and it is put there as soon as the place is free{where}."
        )


def _in_its_phase(scenario: Scenario, *, back: bool) -> str:
    """Return that what a rule puts somewhere waits for its phase too, if some does not count in all of them.

    Args:
        scenario: the scenario.
        back: whether something comes back after a time, which no phase keeps off.
    """
    everywhere = {"play", *scenario.phases}
    somewhere = (rule for rule in scenario.rules.values() if rule.phases != "any" and set(rule.phases) != everywhere)
    waiting = any(
        isinstance(action, Place) and (action.layout is not None or action.on_failure == "retry")
        for rule in somewhere
        for action in rule.actions
    )
    unless = "; what comes back after its time waits for no phase" if back else ""
    return f" in a phase in which that rule counts{unless}" if waiting else ""


def _back_sooner(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    """Return a sentence about what one rule takes off and another one puts somewhere: it is back then."""
    removals = [
        (action, meant_in(action.entity, rule, nouns.roster))
        for rule in scenario.rules.values()
        for action in rule.actions
        if isinstance(action, Remove)
    ]
    gone = frozenset(one for _, members in removals for one in members)
    bringing = {name: gone & _put(rule, scenario, nouns) for name, rule in scenario.rules.items()}
    back = frozenset(one for members in bringing.values() for one in members)
    if not back:
        return
    sooner = any(action.for_s is not None and members & back for action, members in removals)
    kind = "A robot" if back <= scenario.robots.keys() else "A ball" if back <= scenario.balls.keys() else "What"
    yield Paragraph(
        f"{kind} {'' if kind == 'What' else 'that '}was taken off the field is back as soon as "
        f"{listed([f'[{name}]' for name, members in bringing.items() if members], 'or')} puts it somewhere"
        f"{', also before its time is over' if sooner else ''}."
    )


def _asks_for_presence(rule: Rule, entity: str | tuple[str, ...], nouns: Nouns) -> bool:
    """Return whether a rule never fires for what is off the field; one of a group that is on it brings all of them."""
    if entity != EACH and len(meant_in(entity, rule, nouns.roster)) > 1:
        return False
    if any(_is_of_present(condition, entity) for condition in rule.conditions):
        return True
    return all(
        _is_of_present(one.condition, entity)
        if isinstance(one, Holds)
        else one.ON_FIELD_ONLY and one.about(nouns) == entity
        for one in rule.triggers
    )


def _is_of_present(condition: AnyCondition, entity: str | tuple[str, ...]) -> bool:
    """Return whether a condition holds of something on the field only."""
    if isinstance(condition, AllOf):
        return not condition.negate and any(_is_of_present(part, entity) for part in condition.conditions)
    if not isinstance(condition, InZone | Distance | Speed | Looks) or condition.negate:
        return False
    return condition.entity == entity and condition.of != "none"


def _put(rule: Rule, scenario: Scenario, nouns: Nouns) -> frozenset[str]:
    """Return what a rule may put somewhere while that is off the field; nothing is when a half starts."""
    if all(isinstance(trigger, HalfStarted) for trigger in rule.triggers):
        return frozenset()
    found: set[str] = set()
    for action in rule.actions:
        if not isinstance(action, Place):
            continue
        if action.layout is not None:
            draw = action.layout
            layouts = (draw,) if isinstance(draw, str) else scenario.draws[draw.draw].values
            entities = [one.entity for layout in layouts for one in scenario.placements.get(str(layout), ())]
        else:
            entities = [action.entity] if action.entity is not None else []
        for entity in entities:
            if not _asks_for_presence(rule, entity, nouns):
                found.update(meant_in(entity, rule, nouns.roster))
    return frozenset(found)


def _sharing(rules: list[_Named], nouns: Nouns) -> list[_Named]:
    """Return those of the rules over each of a group that another one of them can meet: they share a member."""
    over = {name: set(nouns.roster.expand(rule.for_each)) for name, rule in rules if rule.for_each is not None}
    return [
        (name, rule)
        for name, rule in rules
        if any(other != name and over[name] & members for other, members in over.items())
    ]


def _only_one(names: list[str], whom: str, still: str) -> Iterator[str]:
    if len(names) < 2:
        return
    which = listed([f"[{name}]" for name in names], "and")
    several = "both" if len(names) == 2 else "several of"
    one = f"only the first of them in the list above counts{still}"
    yield f"When {several} {which} happen{whom} in the same tick, {one}."
