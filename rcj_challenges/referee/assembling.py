"""Compiles the rules of a scenario: one bound rule for each member of ``for_each``, in the order of firing.

A rule that names ``other`` is also compiled once for each thing that may be touched.
"""

from __future__ import annotations

from dataclasses import replace

from rcj_challenges.referee.binding import RuleBinder
from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.rules.base import Condition
from rcj_challenges.rules.several_conditions import as_one
from rcj_challenges.rules.values import compile_duration
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.placeholders import fill_params
from rcj_challenges.scenario.roster import ENTRANTS, OTHERS
from rcj_challenges.scenario.rule_effects import for_other, names_other
from rcj_challenges.tracking.bound_rules import BoundRule
from rcj_challenges.tracking.state import Clock
from rcj_challenges.tracking.trackers import RunsWhile


def assemble(context: CompileContext) -> None:
    """Compile all rules of the context's scenario into it: lower priority first, then file order, then entity order."""
    rules = context.scenario.rules
    bound = [
        (rule.priority, number, place, turn, one)
        for number, (name, rule) in enumerate(rules.items())
        for place, each in enumerate(_members(rule, context))
        for turn, one in enumerate(_for_others(rule, _bound_rule(name, rule, each, context), context))
    ]
    bound.sort(key=lambda entry: entry[:4])
    for rank, (*_, rule) in enumerate(bound):
        rule.rank = rank
    for *_, rule in bound:
        _compile(rules[rule.name], rule, context)
    for name, timer in context.scenario.timers.items():
        if timer.while_ is not None:
            _run_while(as_one(timer.while_), context.state.timers[name], timer.per, context)


def _run_while(condition: Condition, clocks: dict[str | None, Clock], per: str | None, context: CompileContext) -> None:
    """Let the clocks of a timer run while a condition holds, each for its owner."""
    for owner, clock in clocks.items():
        binder = RuleBinder(context, BoundRule("", owner), per)
        test = condition.compile(binder)
        context.track(RunsWhile, None, None, clock, test, context.trackers.reschedule)


def _members(rule: Rule, context: CompileContext) -> tuple[str | None, ...]:
    if rule.for_each is None:
        return (None,)
    keepers = context.roster.keepers(rule.for_each)
    # Entity order is that of the roster; entrants, zones and gates keep the order of their group.
    index = {} if rule.for_each == ENTRANTS else context.roster.index
    return tuple(sorted(keepers, key=lambda name: index.get(name, 0)))


def _for_others(model: Rule, rule: BoundRule, context: CompileContext) -> list[BoundRule]:
    """Return a rule for each thing that ``other`` may stand for; they share one history, and so its limits."""
    if not names_other(model, context.scenario):
        return [rule]
    return [replace(rule, other=other) for other in context.roster.others(model, rule.each)]


def _bound_rule(name: str, rule: Rule, each: str | None, context: CompileContext) -> BoundRule:
    keep, most = rule.limit
    entrant = each if rule.for_each == ENTRANTS else context.state.entrant_of.get(each or "")
    return BoundRule(
        name=name,
        each=each,
        about=each if entrant != each and each in context.roster.things else None,
        entrant=entrant,
        phases=None if rule.phases == "any" else frozenset(rule.phases),
        exclusive=None if rule.exclusive is None else (rule.exclusive, each),
        max_executions=most,
        says=fill_params(rule, context.scenario.params, rule.says),
        priority=rule.priority,
        past=context.state.history(keep, name, each),
        others=context.roster.of_rule(OTHERS, rule.for_each, each),
    )


def _compile(model: Rule, rule: BoundRule, context: CompileContext) -> None:
    if rule.other is not None:
        model = for_other(model, rule.other)
    binder = RuleBinder(context, rule, model.for_each)
    for position, trigger in enumerate(model.triggers):
        binder.bind(position, trigger)
    rule.cooldown_s = None if model.cooldown_s is None else compile_duration(model.cooldown_s, binder)
    rule.tests = tuple(condition.compile(binder) for condition in model.conditions)
    rule.actions = tuple(binder.by_role(one, lambda act: act.compile(binder), None) for one in model.actions)
