"""Checks of phases, events and rules: what never happens, what never stops, what happens to all instead of one."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.rules import effects
from rcj_challenges.rules.base import Trigger, Word
from rcj_challenges.scenario.errors import did_you_mean, listing
from rcj_challenges.scenario.lint.base import LintContext, LintRule
from rcj_challenges.scenario.models.scenario import ExpectedEvent, Rule
from rcj_challenges.scenario.roster import EACH, OTHERS, as_tuple
from rcj_challenges.scenario.walk import effects_in, triggers_in, walk

_KEPT = ("counter", "flag", "timer", "sequence")


class PhaseNeverEntered(LintRule, code="phase-never-entered"):
    """A phase that no rule sets and no other phase leads to, or a rule that waits for it."""

    message = "phase '{phase}' is never entered{where}"
    help = (
        "enter it by {{action: set_phase, phase: {phase}}} in a rule that can fire, or by 'next' of a phase that ends"
    )
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for name in ctx.scenario.phases:
            if name not in ctx.reachable_phases:
                yield self.at(("phases", name), phase=name, where="")
        first = ctx.scenario.first_phase
        for name, rule in ctx.reachable_rules() if first not in ctx.entered_phases else ():
            for trigger, path in triggers_in(name, rule):
                if trigger.moment() == effects.PhaseStart(first):
                    yield self.at((*path, "phase"), phase=first, where=" after the start of a half (half_started)")


class RuleNeverFires(LintRule, code="rule-never-fires"):
    """A rule that is inactive whenever its trigger comes: its phases are never entered, or are other ones."""

    message = "{why}"
    help = "write phases: [{phase}], or phases: any"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        first = ctx.scenario.first_phase
        for name, rule in ctx.scenario.rules.items():
            if not ctx.is_reachable(rule):
                why = f"the rule is active only in phases that are never entered: {listing(rule.phases)}"
                yield self.at(("rules", name, "phases"), why=why, phase=first)
                continue
            for trigger, path in triggers_in(name, rule):
                match trigger.moment():
                    case effects.HalfStart() if not rule.is_active_in(first):
                        why = f"a half starts in phase '{first}', in which this rule is inactive"
                        yield self.at(path, why=why, phase=first)
                    case effects.PhaseStart(phase) if not rule.is_active_in(phase):
                        why = f"when '{phase}' is entered this rule is inactive: its phases are "
                        yield self.at((*path, "phase"), why=why + listing(rule.phases), phase=phase)


class EventNeverEmitted(LintRule, code="event-never-emitted"):
    """A rule or a test waits for an event that no rule emits: mostly a misspelt name."""

    message = "event '{event}' is never emitted"
    help = "{hint} emit it in a rule that can fire"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        emitted = {effect.event: None for effect, _, _ in ctx.reachable_effects(effects.Emits)}
        for model, path in ctx.models:
            event = None
            if isinstance(model, Trigger) and isinstance(moment := model.moment(), effects.EventSeen):
                event = moment.event
            elif isinstance(model, ExpectedEvent) and ctx.is_own(path):
                event = model.event
            if event is not None and event not in emitted:
                hint = did_you_mean(event, emitted, "Otherwise, ") or "correct its name, or"
                yield self.at((*path, "event"), event=event, hint=hint)


class MissingSays(LintRule, code="missing-says"):
    """A rule on the sheet that scores or emits an event without ``says``: sheet and log cannot give a reason."""

    message = "{what} comes without a sentence"
    help = "add says: to the rule; players read it in the sheet and in the replay"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for name, rule in ctx.scenario.rules.items():
            found = [(path, f"event '{one.event}'") for one, path in effects_in(name, rule, effects.Emits)]
            found += [(path, "a change of the score") for _, path in effects_in(name, rule, effects.Scores)]
            if found and rule.sheet and not rule.says:
                path, what = min(found, key=lambda one: one[0][-1])
                yield self.at(path, what=what)


class ScoresOnce(LintRule, code="scores-once"):
    """Points for what enters, leaves or crosses, by a rule that fires once a tick, however many do so in it."""

    message = "if several of '{group}' do this in one tick, the rule gives its points once"
    help = "write for_each: {group} and entity: each"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for name, rule in ctx.scenario.rules.items():
            if rule.for_each is not None or not rule.effects(effects.Scores):
                continue
            for trigger, path in triggers_in(name, rule):
                match trigger.moment():
                    case effects.Entry(moved) | effects.Passage(moved):
                        if moved not in ctx.roster.roles and len(ctx.members(moved, rule)) > 1:
                            yield self.at(path, group=listing(as_tuple(moved)))


class EachOfNone(LintRule, code="each-of-none"):
    """``for_each`` over a group without members, such as ``obstacles`` where there are none."""

    message = "'{group}' has no members here: the rule never fires"
    help = "add something to the field that is in it, or remove the rule"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for name, rule in ctx.scenario.rules.items():
            if rule.for_each is not None and not ctx.roster.expand(rule.for_each):
                yield self.at(("rules", name, "for_each"), group=rule.for_each)


class EachNeverNamed(LintRule, code="each-never-named"):
    """``for_each`` without ``each``: whatever the rule does, it does once for every member at the same time."""

    message = "the rule fires {count} times at once, once for each of '{group}', and never names 'each'"
    help = "write entity: each where it looks or acts, or remove for_each"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for name, rule in ctx.scenario.rules.items():
            count = len(ctx.roster.keepers(rule.for_each)) if rule.for_each is not None else 0
            if count > 1 and not _names_each(rule, rule, ctx):
                yield self.at(("rules", name, "for_each"), group=rule.for_each, count=count)


class EachNotInTrigger(LintRule, code="each-not-in-trigger"):
    """A rule for each of a group whose trigger waits for any of that group: it fires for all of them at once."""

    message = "the trigger waits for any of '{group}', and the rule then fires for all {count} of them"
    help = "write {key}: each, so that it fires for that one only; or remove for_each and name the group"

    _KEYS = ("entity", "robot", "zone", "gate")

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for name, rule in ctx.reachable_rules():
            each = ctx.members(EACH, rule) if rule.for_each is not None else frozenset()
            if len(each) < 2 or _names_each(rule.conditions, rule, ctx) or not _names_each(rule, rule, ctx):
                continue
            for trigger, path in triggers_in(name, rule):
                for key in self._KEYS:
                    names = getattr(trigger, key, None)
                    if names is not None and not _names_each(trigger, rule, ctx) and ctx.members(names, rule) == each:
                        yield self.at((*path, key), group=rule.for_each, count=len(each), key=key)


class EventLoop(LintRule, code="event-loop"):
    """Rules that trigger each other through events, without anything that stops them.

    An event emitted in one tick is seen in the next. A rule that waits for its own event therefore fires in every tick
    until the half ends.
    """

    message = "rule '{rule}' triggers itself through events, tick after tick{via}"
    help = "add a condition, cooldown_s or max_executions, or wait for another event"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        rules = {name: rule for name, rule in ctx.reachable_rules() if not _is_limited(rule)}
        triggered = {name: self._listeners(rule, rules, ctx) for name, rule in rules.items()}
        after: dict[str, list[str]] = {}
        for name in rules:
            after[name] = list(triggered[name])
            for one in after[name]:
                after[name] += [other for other in triggered[one] if other not in after[name]]
        reported: set[str] = set()
        for name in rules:
            loop = [other for other in after[name] if name in after[other]]
            if loop and name not in reported:
                reported.update(loop)
                others = [repr(one) for one in loop if one != name]
                yield self.at(("rules", name), rule=name, via=f", with {listing(others)}" if others else "")

    @staticmethod
    def _listeners(rule: Rule, rules: dict[str, Rule], ctx: LintContext) -> list[str]:
        """Return the rules that every event of a rule triggers, in a phase in which both are active."""
        emitted = {effects.EventSeen(one.event, None) for one in rule.effects(effects.Emits)}
        return [
            name
            for name, other in rules.items()
            if emitted & {*other.moments(effects.EventSeen)}
            and any(rule.is_active_in(phase) and other.is_active_in(phase) for phase in ctx.reachable_phases)
        ]


class NoWayToScore(LintRule, code="no-way-to-score"):
    """The score decides, and no rule that can fire gives points."""

    message = "no rule that can fire gives points, and the score decides"
    help = "add {{action: score, …}} to a rule, or rank by another value in result:"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        by_score = ctx.scenario.result.rank[0].is_score
        if by_score and not any(ctx.reachable_effects(effects.Scores)):
            yield self.at(("rules",))


def _is_limited(rule: Rule) -> bool:
    """Return whether something may keep a rule from firing again."""
    limited = rule.conditions or rule.cooldown_s is not None or rule.max_executions is not None
    return bool(limited or rule.effects(effects.SetsPhase) or rule.effects(effects.Ends))


def _names_each(part: object, rule: Rule, ctx: LintContext) -> bool:
    """Return whether a rule, or a part of one, names ``each``, prints its name, or is about what is kept for it."""
    for model, _ in walk(part):
        if isinstance(model, Word) and (model.stands_for(EACH) or _is_own(model, rule, ctx)):
            return True
        for field in type(model).model_fields:
            value = getattr(model, field)
            if any(one == value or (isinstance(value, tuple) and one in value) for one in (EACH, OTHERS)):
                return True
    return False


def _is_own(word: Word, rule: Rule, ctx: LintContext) -> bool:
    """Return whether a word means a counter, flag, timer or sequence of ``each`` without ``entity``."""
    kept = (getattr(ctx.scenario, f"{kind}s").get(getattr(word, kind, "")) for kind in _KEPT)
    per = next((one.per for one in kept if one is not None and one.per is not None), None)
    return per is not None and not getattr(word, "entity", None) and ctx.roster.keeps(rule.for_each, per)
