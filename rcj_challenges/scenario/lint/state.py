"""Checks of what is defined and not used, read and not written, or written and not read."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.rules.effects import Holds, Releases
from rcj_challenges.rules.refs import SectionRef
from rcj_challenges.scenario.errors import place_of
from rcj_challenges.scenario.lint.base import LintContext, LintRule, Use
from rcj_challenges.scenario.models.scenario import Expectation, Given, Keyframe, MatchExpectation
from rcj_challenges.scenario.placeholders import PLACEHOLDERS, named_in, placeholders_in
from rcj_challenges.scenario.roster import EACH
from rcj_challenges.scenario.rule_effects import spots_set_by_rules
from rcj_challenges.scenario.tree import Leaf, nodes_in

_TESTS = (Expectation, MatchExpectation, Given, Keyframe)


class NeverRead(LintRule, code="never-read"):
    """A counter, flag, timer, draw, role, or spot that rules set, but on which nothing depends."""

    message = "{noun} '{name}' is never read"
    help = "use it in a condition, an action, broadcast: or result:, or remove it"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for section in ("counters", "flags", "timers", "draws", "roles"):
            for name in getattr(ctx.scenario, section):
                if not _is_read(name, section, ctx):
                    yield self.at((section, name), noun=section[:-1], name=name)
        read = _names_on_field(ctx)
        for name in spots_set_by_rules(ctx.scenario):
            if name not in read:
                yield self.at(("spots", name), noun="spot", name=name)


class NeverWritten(LintRule, code="never-written"):
    """A counter, flag, timer or role that rules read but never change, start or assign."""

    message = "{noun} '{name}' is read and never {verb}"
    help = "add {{action: {action}, {noun}: {name}}} to a rule, or remove it"
    at_key = True

    _ACTIONS = (
        ("counters", "count", "counted"),
        ("flags", "set_flag", "set"),
        ("timers", "timer", "started"),
        ("roles", "assign", "assigned"),
    )

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for section, action, verb in self._ACTIONS:
            for name, entry in getattr(ctx.scenario, section).items():
                is_written = any(use.reference.is_written for use in _uses_of(name, section, ctx))
                if _is_read(name, section, ctx) and not is_written and not _runs_by_itself(entry):
                    yield self.at((section, name), noun=section[:-1], name=name, action=action, verb=verb)


class NeverUsed(LintRule, code="never-used"):
    """A param, table, zone, gate, spot, group, sequence or layout of the author's own file that nothing names."""

    message = "{noun} '{name}' is never used"
    help = "name it in a rule, or remove it"
    at_key = True

    _SECTIONS = ("params", "tables", "gates", "zones", "spots", "groups", "sequences", "placements")

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        used = self._used(ctx)
        for section in self._SECTIONS:
            noun = "layout" if section == "placements" else section[:-1]
            for name, entry in getattr(ctx.scenario, section).items():
                is_used = name in used[section] or bool(getattr(entry, "drawn", False))
                # The group of all copies of an entry is written nowhere.
                is_used |= section == "groups" and name not in ctx.loaded.unresolved.get("groups", {})
                if not is_used and ctx.is_own((section, name)):
                    away = f"write repeat_for: {name} in an entry, or remove it" if section == "tables" else ""
                    yield self.at((section, name), help=away, noun=noun, name=name)

    def _used(self, ctx: LintContext) -> dict[str, set[str]]:
        """Return by section the names that have a use."""
        scenario = ctx.scenario
        used = dict.fromkeys(("gates", "zones", "spots"), _names_on_field(ctx) | {*spots_set_by_rules(scenario)})
        used["groups"] = {use.name for use in ctx.uses if use.is_on_field}.union(*scenario.groups.values())
        used["params"] = {one.param for one in nodes_in(ctx.tree) if isinstance(one, Leaf)}
        said = {name for rule in scenario.rules.values() for name in named_in(rule)}
        for text in (scenario.description, *(ranked.says or "" for ranked in scenario.result.rank)):
            said |= {*placeholders_in(text)}
        used["params"] |= said - {*PLACEHOLDERS}
        used["tables"] = {*_repeated_for(ctx.loaded.unresolved)}
        for section in ("sequences", "placements"):
            # To reset a sequence is no use of it if nothing depends on its steps.
            uses = (use for use in ctx.uses if not use.reference.is_written)
            used[section] = {use.name for use in uses if _may_name(use, section)}
        # A layout may be one of the values of a draw.
        used["placements"] |= {str(value) for draw in scenario.draws.values() for value in draw.values}
        return used


class HeldForever(LintRule, code="held-forever"):
    """A rule holds robots without ``for_s``, no rule releases them, and no test expects any of them to be held."""

    message = "robots are held without for_s, and no rule releases {robots}"
    help = "give it for_s, add a rule with {{action: release, entity: …}}, or a test with held: {{{first}: true}}"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        left = {robot for entrant in ctx.scenario.entrants.values() for robot in entrant.robots}
        for effect, rule, _ in ctx.reachable_effects(Releases):
            left -= ctx.members(effect.entity, rule)
        tests = (test for test, _ in ctx.models if isinstance(test, Expectation))
        on_purpose = {robot for test in tests for robot, is_held in (test.held or {}).items() if is_held}
        for held, rule, path in ctx.reachable_effects(Holds):
            robots = () if held.for_a_time else sorted(ctx.members(held.names, rule) & left)
            if robots and on_purpose.isdisjoint(robots):
                yield self.at(path, robots=", ".join(robots), first=robots[0])


class InheritedTestLeftOut(LintRule, code="inherited-test-left-out"):
    """Inherited tests that do not fit this scenario; they are not run."""

    message = "{count} inherited tests do not fit this scenario and are left out: {names} ({reason})"
    help = "remove each by 'NAME: null' under expect, or all by 'inherited: null', and write tests of your own"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        if ctx.loaded.left_out:
            first = next(iter(ctx.loaded.left_out.values()))
            place = place_of(first)
            reason = f"{place.file}:{place.line}: {first.message}"
            yield self.at((), count=len(ctx.loaded.left_out), names=", ".join(ctx.loaded.left_out), reason=reason)


def _repeated_for(data: object) -> Iterator[str]:
    """Yield the tables for whose rows something is repeated."""
    parts = data.values() if isinstance(data, dict) else data if isinstance(data, list) else ()
    for part in parts:
        yield from _repeated_for(part)
    tables = data.get("repeat_for", ()) if isinstance(data, dict) else ()
    yield from (tables,) if isinstance(tables, str) else tables


def _runs_by_itself(entry: object) -> bool:
    is_by_chance = getattr(entry, "order", None) == "random" and getattr(entry, "initial", None) is None
    return bool(getattr(entry, "starts", False) or getattr(entry, "while_", None) or is_by_chance)


def _uses_of(name: str, section: str, ctx: LintContext) -> list[Use]:
    return [use for use in ctx.uses if use.name == name and _may_name(use, section)]


def _is_read(name: str, section: str, ctx: LintContext) -> bool:
    """Return whether something depends on an entry; tests are no use of it."""
    rules = ctx.scenario.rules.values() if section in ("counters", "draws", "roles") else ()
    uses = (use for use in _uses_of(name, section, ctx) if not use.reference.is_written)
    return any(name in named_in(rule) for rule in rules) or any(use.model not in _TESTS for use in uses)


def _may_name(use: Use, section: str) -> bool:
    if isinstance(use.reference, SectionRef):
        # Whatever `each` may stand for, a role may.
        return section in use.reference.sections or (section == "roles" and EACH in use.reference.words)
    return use.reference.takes_roles if section == "roles" else section == "draws" and use.reference.drawn


def _names_on_field(ctx: LintContext) -> set[str]:
    """Return the names on the field that are read, members of groups and values of draws included; tests are no use."""
    draws = ctx.scenario.draws
    uses = (use for use in ctx.uses if use.is_on_field and use.model not in _TESTS)
    named = {use.name for use in uses if not use.reference.is_written}
    named |= {str(value) for name in named & draws.keys() for value in draws[name].values}
    return named | set(ctx.roster.expand(tuple(named)))
