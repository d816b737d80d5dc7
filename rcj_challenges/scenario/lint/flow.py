"""Lint of how a match can go: phases, events, rules that never fire, points that nobody can get."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rcj_challenges.scenario.beginnings import turns
from rcj_challenges.scenario.errors import listing, nearest
from rcj_challenges.scenario.lint.about import found_by
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lives_in
from rcj_challenges.scenario.models.actions import Emit, Score
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.scenario import Expectation, RankByScore, Rule
from rcj_challenges.scenario.models.state import WordValue
from rcj_challenges.scenario.models.triggers import (
    HalfStarted,
    Holds,
    OnEvent,
    PhaseEntered,
    SequenceBroken,
    Trigger,
)
from rcj_challenges.scenario.other import names_other
from rcj_challenges.scenario.tree import Path, node_at
from rcj_challenges.scenario.visiting import visit

_OF_EACH = frozenset({"robot_name", "entity_name", "each_name", "team_name", "entrant", "score"})
"""Context words that speak of the entity for which a rule fires."""
_IGNORED_BY_DEFAULT = frozenset(Expectation.model_fields["ignore"].default)
_RANK_OTHERWISE = "rank by a counter in result:", "rank by a time or a counter in result:"
"""For several entrants, for whom a half ends at the same time, and for one alone."""


def check_phases(subject: Subject) -> Iterator[Suspect]:
    """A phase that is never entered; a rule or a trigger that waits for one."""
    for name in subject.scenario.phases:
        if name not in subject.reached:
            yield Suspect(
                "phase_never_entered",
                ("phases", name),
                f"phase '{name}' is never entered",
                f"enter it by {{action: set_phase, phase: {name}}} in a rule that can fire, or by 'next' of a phase "
                "that ends, or remove it",
                at_key=True,
            )
    left = {turn.name: turn.phases for turn in turns(subject.scenario) if not turn.lives}
    for name, rule in subject.scenario.rules.items():
        if not subject.can_live(rule):
            phases = listing(rule.phases)
            yield Suspect(
                "rule_never_fires",
                ("rules", name),
                f"it lives only in a phase that is never entered: {phases}",
                "give it a phase that is entered, or phases: any",
                at_key=True,
            )
        else:
            yield from _waiting_for_phases(name, rule, subject)
            if name in left:
                yield _left_before(name, rule, sorted(left[name]))


def _left_before(name: str, rule: Rule, entered: list[str]) -> Suspect:
    """Return that another rule leaves the first phase before a rule has its turn as a half starts."""
    index = next(index for index, trigger in enumerate(rule.triggers) if isinstance(trigger, HalfStarted))
    return Suspect(
        "rule_never_fires",
        ("rules", name, "triggers", index),
        f"as a half starts another rule enters {listing(entered)} before it, in which this rule does not live",
        f"add '{entered[0]}' to its phases, or let it come first: it needs a lower priority",
    )


def _waiting_for_phases(name: str, rule: Rule, subject: Subject) -> Iterator[Suspect]:
    for index, trigger in enumerate(rule.triggers):
        path: Path = ("rules", name, "triggers", index)
        if isinstance(trigger, HalfStarted) and not lives_in(rule, subject.scenario.first_phase):
            yield Suspect(
                "rule_never_fires",
                path,
                f"a half starts in phase '{subject.scenario.first_phase}', in which this rule does not live",
                f"add '{subject.scenario.first_phase}' to its phases",
            )
        if not isinstance(trigger, PhaseEntered):
            continue
        if not lives_in(rule, trigger.phase):
            yield Suspect(
                "rule_never_fires",
                (*path, "phase"),
                f"when '{trigger.phase}' is entered this rule does not live: it lives in {listing(rule.phases)}",
                f"write phases: [{trigger.phase}], or phases: any",
            )
        elif trigger.from_ is not None and (trigger.from_, trigger.phase) not in subject.transitions:
            yield Suspect(
                "phase_never_entered",
                (*path, "from"),
                f"'{trigger.phase}' is never entered from '{trigger.from_}'",
                "correct 'from', or leave it out",
            )
        elif trigger.from_ is None and trigger.phase not in {to for _, to in subject.transitions}:
            yield Suspect(
                "phase_never_entered",
                (*path, "phase"),
                f"'{trigger.phase}' is never entered after the start of a half",
                "wait for half_started instead, or enter the phase by set_phase",
            )


def check_events(subject: Subject) -> Iterator[Suspect]:
    """An event that is waited for and never emitted; one that is emitted without a sentence."""
    emitted = {
        action.event: None for _, rule in subject.standing() for action in rule.actions if isinstance(action, Emit)
    }
    for model, path in subject.models:
        if isinstance(model, OnEvent) and model.event not in emitted:
            hint = nearest(model.event, emitted)
            yield Suspect(
                "event_never_emitted",
                (*path, "event"),
                f"event '{model.event}' is waited for and never emitted{hint}",
                "emit it in a rule that can fire, or correct its name",
            )
    yield from _events_of_tests(emitted, subject)
    for name, rule in subject.scenario.rules.items():
        if rule.says:
            continue
        for index, action in enumerate(rule.actions):
            if isinstance(action, Emit | Score):
                what = f"event '{action.event}'" if isinstance(action, Emit) else "a change of the score"
                yield Suspect(
                    "event_without_a_sentence",
                    ("rules", name, "actions", index),
                    f"{what} comes without a sentence: sheet, log and screen cannot say why",
                    "add says: to the rule",
                )
                break


def _events_of_tests(emitted: Mapping[str, None], subject: Subject) -> Iterator[Suspect]:
    """Events that the author's own tests expect or leave out of the comparison, and that no rule emits."""
    for name, test in subject.scenario.expect.items():
        expected = [(("events", index, "event"), event.event) for index, event in enumerate(test.events or ())]
        ignored = [(("ignore", index), event) for index, event in enumerate(test.ignore)]
        for verb, keys, event in (
            *(("expected", keys, event) for keys, event in expected),
            # Whoever adds to the list that holds by default writes the whole of it.
            *(("ignored", keys, event) for keys, event in ignored if event not in _IGNORED_BY_DEFAULT),
        ):
            path: Path = ("expect", name, *keys)
            node = node_at(subject.tree, path)
            if event in emitted or node is None or node.mark.file != subject.tree.mark.file:
                continue
            yield Suspect(
                "event_never_emitted",
                path,
                f"event '{event}' is {verb} and never emitted{nearest(event, emitted)}",
                "correct its name, or emit it in a rule that can fire"
                if verb == "expected"
                else "correct its name, or leave it out",
            )


def check_rules(subject: Subject) -> Iterator[Suspect]:
    """Rules for each member of a group that has none, or that do not look at it; sequences that cannot break."""
    for name, rule in subject.scenario.rules.items():
        if rule.for_each is not None and not subject.roster.expand(rule.for_each):
            yield Suspect(
                "each_of_nobody",
                ("rules", name, "for_each"),
                f"'{rule.for_each}' has no members here: the rule never fires",
                "put something on the field that is in it, or remove the rule",
            )
        if rule.for_each is not None and len(subject.roster.expand(rule.for_each)) > 1 and not _names_each(rule):
            count = len(subject.roster.expand(rule.for_each))
            yield Suspect(
                "each_never_named",
                ("rules", name, "for_each"),
                f"the rule fires {count} times at once, once for each of '{rule.for_each}', and never names 'each'",
                f"write {_key_of(rule, subject)}: each where it looks or acts, or leave for_each out",
            )
        for index, trigger in enumerate(rule.triggers):
            sequence = subject.scenario.sequences[trigger.sequence] if isinstance(trigger, SequenceBroken) else None
            if sequence is not None and sequence.wrong_step == "ignore":
                yield Suspect(
                    "sequence_never_breaks",
                    ("rules", name, "triggers", index, "sequence"),
                    "wrong steps are ignored by this sequence; it never breaks",
                    "give it wrong_step: break",
                )


def check_events_of_one(subject: Subject) -> Iterator[Suspect]:
    """An event of one that every member of ``for_each`` hears: what it does, it does to all of them."""
    emitters: dict[str, list[Rule]] = {}
    for _, rule in subject.standing():
        for action in rule.actions:
            if isinstance(action, Emit):
                emitters.setdefault(action.event, []).append(rule)
    for name, rule in subject.standing():
        if rule.for_each is None or _names_each(rule.conditions):
            continue
        members = subject.members("each", rule)
        for index, trigger in enumerate(rule.triggers):
            if not isinstance(trigger, OnEvent) or trigger.entity is not None or len(members) < 2:
                continue
            sources = emitters.get(trigger.event, [])
            if sources and all(_is_about_one_of(members, one, subject) for one in sources):
                yield Suspect(
                    "event_heard_by_each",
                    ("rules", name, "triggers", index),
                    f"'{trigger.event}' comes from one of '{rule.for_each}', and this rule fires for all "
                    f"{len(members)} of them, whoever it was",
                    "write entity: each, so that it fires for that one only, or leave for_each out and name them all",
                )


def _is_about_one_of(members: frozenset[str], rule: Rule, subject: Subject) -> bool:
    """Return whether the events of a rule are about one of these: it is for each of some, or each trigger finds one."""
    things = {*subject.roster.things}
    each = frozenset() if rule.for_each is None else subject.members("each", rule)
    if each & members or each & things:
        return bool(each & members)
    found = [found_by(trigger, rule, subject) & members & things for trigger in rule.triggers]
    return all(found) and len(frozenset().union(*found)) > 1


def check_any_for_each(subject: Subject) -> Iterator[Suspect]:
    """A trigger that waits for any of the group over which its rule goes: the rule fires for all, whoever it was."""
    for name, rule in subject.standing():
        each = frozenset() if rule.for_each is None else subject.members("each", rule)
        # Of a rule that never names `each`, `check_rules` says so.
        if len(each) < 2 or _names_each(rule.conditions) or not _names_each(rule):
            continue
        for index, trigger in enumerate(rule.triggers):
            key = None if _names_each(trigger) else _key_of_any(trigger, each, rule, subject)
            if key is None:
                continue
            yield Suspect(
                "any_heard_by_each",
                ("rules", name, "triggers", index, *(("condition",) if isinstance(trigger, Holds) else ()), key),
                f"it waits for any of '{rule.for_each}', and fires for all {len(each)} of them, whoever it was",
                f"write {key}: each, so that it fires for that one only, or leave for_each out and name them all",
            )


_WHO = ("entity", "robot", "zone", "gate", "other")
"""Under these keys a trigger says who or what it waits for."""


def _key_of_any(trigger: Trigger, each: frozenset[str], rule: Rule, subject: Subject) -> str | None:
    """Return under which key a trigger waits for any of those over which its rule goes; None: under none."""
    part: Strict = trigger
    if isinstance(trigger, Holds):
        part = trigger.condition
        if getattr(part, "of", None) != "any" or getattr(part, "negate", False):
            return None  # true of all of them, or of none: it is about nobody in particular
    for key in _WHO:
        names = getattr(part, key, None)
        # Who asks or does something about the other one has thought of both.
        if key == "other" and names_other(rule, subject.scenario):
            continue
        if isinstance(names, str | tuple) and subject.members(names, rule) == each:
            return key
    return None


def _key_of(rule: Rule, subject: Subject) -> str:
    """Return under which key the members of ``for_each`` are named: of events all of them are called entity."""
    if all(isinstance(trigger, OnEvent) for trigger in rule.triggers):
        return "entity"
    (first, *_), scenario = sorted(subject.members("each", rule)), subject.scenario
    return "gate" if first in scenario.gates else "zone" if first in scenario.zones else "entity"


def _names_each(part: object) -> bool:
    """Return whether a rule, or a part of one, names ``each`` or tells of it."""
    for model, _ in visit(part):
        if isinstance(model, WordValue) and model.word in _OF_EACH and model.of is None:
            return True
        for field in type(model).model_fields:
            value = getattr(model, field)
            if value == "each" or (isinstance(value, tuple) and "each" in value):
                return True
    return False


def check_scoring(subject: Subject) -> Iterator[Suspect]:
    """No way to score, although scores decide."""
    rank = subject.scenario.result.rank
    if not isinstance(rank[0], RankByScore):
        return
    if any(isinstance(action, Score) for _, rule in subject.standing() for action in rule.actions):
        return
    others = any(not isinstance(criterion, RankByScore) for criterion in rank)
    alone = len(subject.scenario.entrants) == 1
    yield Suspect(
        "no_way_to_score",
        ("rules",),
        "no rule that can fire gives points, and the score decides" + (" first" if others else ""),
        "add {action: score, …} to a rule, or "
        + ("leave 'score' out of result:, so that what follows it decides" if others else _RANK_OTHERWISE[alone]),
        at_key=True,
    )
