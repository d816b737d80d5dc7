"""Checks of phases, events and rules: what never happens, what never stops, what happens to all instead of one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rcj_challenges.rules.actions.emit import Emit
from rcj_challenges.rules.actions.end import End
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.actions.set_phase import SetPhase
from rcj_challenges.rules.conditions.half import HalfIs
from rcj_challenges.rules.triggers.event import OnEvent
from rcj_challenges.rules.triggers.half_started import HalfStarted
from rcj_challenges.rules.triggers.phase_entered import PhaseEntered
from rcj_challenges.rules.triggers.sequence_broken import SequenceBroken
from rcj_challenges.rules.values.word import WordValue
from rcj_challenges.scenario.errors import did_you_mean, listing
from rcj_challenges.scenario.lint.base import LintRule, Suspicion
from rcj_challenges.scenario.lint.context import LintContext, is_active_in
from rcj_challenges.scenario.models.scenario import Expectation, RankByCounter, RankByScore, RankByTime, Rule
from rcj_challenges.scenario.roster import EACH
from rcj_challenges.scenario.tree import Path, node_at
from rcj_challenges.scenario.walk import walk


class PhaseNeverEntered(LintRule):
    """A phase that no rule sets and no other phase leads to, or a rule that waits for a change that never comes."""

    code = "phase-never-entered"
    message = "{what} is never entered{where}"
    help = (
        "enter it by {{action: set_phase, phase: {phase}}} in a rule that can fire, or by 'next' of a phase that ends"
    )
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield phases that cannot be reached, and triggers that wait for a transition that there is not."""
        for name in ctx.scenario.phases:
            if name not in ctx.reachable_phases:
                yield self.at(("phases", name), what=f"phase '{name}'", where="", phase=name)
        for name, rule in ctx.reachable_rules():
            for index, trigger in enumerate(rule.triggers):
                if not isinstance(trigger, PhaseEntered) or not is_active_in(rule, trigger.phase):
                    continue
                from_phases = {left for left, entered in ctx.transitions if entered == trigger.phase}
                path: Path = ("rules", name, "triggers", index)
                if trigger.from_ is not None and trigger.from_ not in from_phases:
                    where = f" from '{trigger.from_}'"
                    yield self.at((*path, "from"), what=f"'{trigger.phase}'", where=where, phase=trigger.phase)
                elif trigger.from_ is None and not from_phases:
                    where = " after the start of a half (half_started)"
                    yield self.at((*path, "phase"), what=f"'{trigger.phase}'", where=where, phase=trigger.phase)


class RuleNeverFires(LintRule):
    """A rule that is inactive whenever its trigger fires, because of its phases."""

    code = "rule-never-fires"
    message = "{why}"
    help = "write phases: [{phase}], or phases: any"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield rules that no phase lets fire."""
        first = ctx.scenario.first_phase
        for name, rule in ctx.scenario.rules.items():
            if not ctx.is_reachable(rule):
                why = f"the rule is active only in phases that are never entered: {listing(rule.phases)}"
                yield self.at(("rules", name, "phases"), why=why, phase=first)
                continue
            for index, trigger in enumerate(rule.triggers):
                path: Path = ("rules", name, "triggers", index)
                if isinstance(trigger, HalfStarted) and not is_active_in(rule, first):
                    why = f"a half starts in phase '{first}', in which this rule is inactive"
                    yield self.at(path, why=why, phase=first)
                if isinstance(trigger, PhaseEntered) and not is_active_in(rule, trigger.phase):
                    why = f"when '{trigger.phase}' is entered this rule is inactive: its phases are "
                    yield self.at((*path, "phase"), why=why + listing(rule.phases), phase=trigger.phase)


class EventNeverEmitted(LintRule):
    """A rule or a test waits for an event that no rule emits, usually because of a misspelt name."""

    code = "event-never-emitted"
    message = "event '{event}' is never emitted"
    help = "{hint}correct its name, or emit it in a rule that can fire"

    _DEFAULT_IGNORED = frozenset(Expectation.model_fields["ignore"].default)

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield triggers, and the author's own tests, with unknown events."""
        emitted = {action.event: None for _, rule in ctx.reachable_rules() for action in _emits(rule)}
        for path, event in (*self._awaited(ctx), *self._in_tests(ctx)):
            if event not in emitted:
                hint = did_you_mean(event, emitted)
                yield self.at(path, event=event, hint=f"{hint} Otherwise " if hint else "")

    def _awaited(self, ctx: LintContext) -> Iterator[tuple[Path, str]]:
        for model, path in ctx.models:
            if isinstance(model, OnEvent):
                yield (*path, "event"), model.event

    def _in_tests(self, ctx: LintContext) -> Iterator[tuple[Path, str]]:
        for name, test in ctx.scenario.expect.items():
            for index, expected in enumerate(test.events or ()):
                path: Path = ("expect", name, "events", index, "event")
                if _is_own_value(ctx, path):
                    yield path, expected.event
            for index, event in enumerate(test.ignore):
                path = ("expect", name, "ignore", index)
                if event not in self._DEFAULT_IGNORED and _is_own_value(ctx, path):
                    yield path, event


class MissingSays(LintRule):
    """A rule that scores or emits an event without ``says``: sheet, log and replay cannot give a reason."""

    code = "missing-says"
    message = "{what} has no sentence"
    help = "add says: to the rule; players read it in the sheet and in the replay"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield the first action of each rule that needs a sentence."""
        for name, rule in ctx.scenario.rules.items():
            for index, action in enumerate(rule.actions):
                if not rule.says and isinstance(action, Emit | Score):
                    what = f"event '{action.event}'" if isinstance(action, Emit) else "a change of the score"
                    yield self.at(("rules", name, "actions", index), what=what)
                    break


class EachOfNone(LintRule):
    """``for_each`` over a group without members, such as ``obstacles`` where there are none."""

    code = "each-of-none"
    message = "'{group}' has no members here: the rule never fires"
    help = "add a member of the group to the field, or remove the rule"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield rules for each member of an empty group."""
        for name, rule in ctx.scenario.rules.items():
            if rule.for_each is not None and not ctx.roster.expand(rule.for_each):
                yield self.at(("rules", name, "for_each"), group=rule.for_each)


class EachNeverNamed(LintRule):
    """``for_each`` without ``each``: whatever the rule does, it does once for every member at the same time."""

    code = "each-never-named"
    message = "the rule fires {count} times at once, once for each of '{group}', and never names 'each'"
    help = "write entity: each in its triggers, conditions or actions, or remove for_each"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield rules with for_each that never look at its member."""
        for name, rule in ctx.scenario.rules.items():
            count = len(ctx.roster.expand(rule.for_each)) if rule.for_each is not None else 0
            if count > 1 and not _names_each(rule):
                yield self.at(("rules", name, "for_each"), group=rule.for_each, count=count)


class EachNotInTrigger(LintRule):
    """A rule for each of a group whose trigger waits for any of that group: it fires for all of them at once."""

    code = "each-not-in-trigger"
    message = "the trigger waits for any of '{group}', and the rule then fires for all {count} of them"
    help = "write {key}: each, so that it fires for that one only; or remove for_each and name the group"

    _KEYS = ("entity", "robot", "zone", "gate")

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield triggers that name the whole group, or events, of a rule whose actions are about each."""
        for name, rule in ctx.reachable_rules():
            each = ctx.members(EACH, rule) if rule.for_each is not None else frozenset()
            if len(each) < 2 or _names_each(rule.conditions) or not _names_each(rule):
                continue
            for index, trigger in enumerate(rule.triggers):
                path: Path = ("rules", name, "triggers", index)
                for key in self._KEYS:
                    names = getattr(trigger, key, None)
                    if isinstance(names, str | tuple) and not _names_each(trigger) and ctx.members(names, rule) == each:
                        yield self.at((*path, key), group=rule.for_each, count=len(each), key=key)


class EventLoop(LintRule):
    """Rules that trigger each other through events, without anything that stops them.

    An event emitted in one tick is seen in the next. A rule that waits for its own event therefore fires in every tick
    until the half ends.
    """

    code = "event-loop"
    message = "rule '{rule}' triggers itself through event {event}{via}; it will fire every {ticks} ticks"
    help = "add a condition, cooldown_s or max_executions, or wait for another event"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield one rule of each loop."""
        rules = {name: rule for name, rule in ctx.reachable_rules() if not _is_limited(rule)}
        triggers = {name: self._listeners(rule, rules, ctx) for name, rule in rules.items()}
        reported: set[str] = set()
        for name, rule in rules.items():
            loop = _shortest_loop(name, triggers)
            if loop is None or reported & set(loop):
                continue
            reported.update(loop)
            awaited = {trigger.event for trigger in rule.triggers if isinstance(trigger, OnEvent)}
            event = next(action.event for action in _emits(rules[loop[-1]]) if action.event in awaited)
            via = f" via {listing([repr(one) for one in loop[1:]])}" if len(loop) > 1 else ""
            yield self.at(("rules", name), rule=name, event=event, via=via, ticks=len(loop))

    @staticmethod
    def _listeners(rule: Rule, rules: Mapping[str, Rule], ctx: LintContext) -> list[str]:
        """Return the rules that every event of a rule triggers, in a phase in which both are active."""
        emitted = {action.event for action in _emits(rule)}
        return [
            name
            for name, other in rules.items()
            if any(
                isinstance(trigger, OnEvent) and trigger.event in emitted and trigger.entity is None
                for trigger in other.triggers
            )
            and any(is_active_in(rule, phase) and is_active_in(other, phase) for phase in ctx.reachable_phases)
        ]


class SequenceNeverBreaks(LintRule):
    """``sequence_broken`` for a sequence that ignores wrong steps."""

    code = "sequence-never-breaks"
    message = "sequence '{sequence}' ignores wrong steps: it never breaks"
    help = "give the sequence wrong_step: break"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield triggers that never fire."""
        for model, path in ctx.models:
            if isinstance(model, SequenceBroken) and ctx.scenario.sequences[model.sequence].wrong_step == "ignore":
                yield self.at((*path, "sequence"), sequence=model.sequence)


class NoWayToScore(LintRule):
    """The score decides, and no rule that can fire gives points."""

    code = "no-way-to-score"
    message = "no rule that can fire gives points, and the score decides"
    help = "add {{action: score, …}} to a rule, or rank by a counter or a time in result:"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield the section of rules."""
        by_score = isinstance(ctx.scenario.result.rank[0], RankByScore)
        if by_score and not any(isinstance(one, Score) for _, rule in ctx.reachable_rules() for one in rule.actions):
            yield self.at(("rules",))


class CriterionAlwaysEqual(LintRule):
    """``result`` ranks several entrants by a value that is the same for all of them."""

    code = "criterion-always-equal"
    message = "{what} is the same for every entrant"
    help = "rank by a counter that is kept {{per: robots}}, or remove the criterion"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield criteria that distinguish no entrants."""
        if len(ctx.scenario.entrants) < 2:
            return
        for index, criterion in enumerate(ctx.scenario.result.rank):
            if isinstance(criterion, RankByCounter) and ctx.scenario.counters[criterion.counter].per is None:
                yield self.at(("result", "rank", index), what=f"counter '{criterion.counter}', which is not kept per,")
            if isinstance(criterion, RankByTime) and not criterion.plus:
                yield self.at(("result", "rank", index), what="the time at which a half ends")


class HalfNeverPlayed(LintRule):
    """A condition on a half beyond ``match.halves``."""

    code = "half-never-played"
    message = "the match has {halves} halves: the condition {holds} holds"
    help = "correct the number of the half, or raise match.halves"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield such conditions."""
        halves = ctx.scenario.match.halves
        for model, path in ctx.models:
            if isinstance(model, HalfIs) and (model.equals or model.at_least or 1) > halves:
                yield self.at(path, halves=halves, holds="always" if model.negate else "never")


def _emits(rule: Rule) -> list[Emit]:
    return [action for action in rule.actions if isinstance(action, Emit)]


def _is_own_value(ctx: LintContext, path: Path) -> bool:
    node = node_at(ctx.tree, path)
    return node is not None and node.mark.file == ctx.tree.mark.file


def _is_limited(rule: Rule) -> bool:
    """Return whether something may keep a rule from firing again."""
    limited = rule.conditions or rule.cooldown_s is not None or rule.max_executions is not None
    return bool(limited) or any(isinstance(action, SetPhase | End) for action in rule.actions)


def _shortest_loop(name: str, triggers: Mapping[str, list[str]]) -> list[str] | None:
    """Return the shortest path from a rule back to itself, the rule first; None if there is none."""
    paths, seen = [[name]], {name}
    for path in paths:
        for following in triggers[path[-1]]:
            if following == name:
                return path
            if following not in seen:
                seen.add(following)
                paths.append([*path, following])
    return None


_WORDS_OF_EACH = frozenset({"robot_name", "entity_name", "each_name", "team_name", "entrant", "score"})


def _names_each(part: object) -> bool:
    """Return whether a rule, or a part of one, names ``each`` or prints its name."""
    for model, _ in walk(part):
        if isinstance(model, WordValue) and model.word in _WORDS_OF_EACH and model.of is None:
            return True
        for field in type(model).model_fields:
            value = getattr(model, field)
            if value == EACH or (isinstance(value, tuple) and EACH in value):
                return True
    return False
