"""Checks of numbers and texts: wrong units, limits that are never reached, blanks that nothing fills in."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot, pi, radians

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.rules.base import Trigger
from rcj_challenges.rules.effects import Scores
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.placement import MAX_KICK_MPS
from rcj_challenges.rules.values import longest_s
from rcj_challenges.rules.values.distance import DistanceValue
from rcj_challenges.rules.values.speed import SpeedValue
from rcj_challenges.rules.values.way import WayValue
from rcj_challenges.scenario.errors import choice_of
from rcj_challenges.scenario.halves import MAX_LENGTHS, clock_may_stop, longest_half_s
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.lint.base import LintContext, LintRule
from rcj_challenges.scenario.models.scenario import Keyframe, Rule
from rcj_challenges.scenario.placeholders import PLACEHOLDERS, named_in, placeholders_in
from rcj_challenges.scenario.tree import Path


class LimitTooLong(LintRule, code="limit-too-long"):
    """A time that is longer than the half, or than the phase in which the rule is active."""

    message = "{seconds:g} s is too long: the {what} is over after {after_s:g} s"
    help = "shorten it, or let the {what} last longer"

    _KEYS = ("limit_s", "within_s", "for_s", "at_s", "lasts_s", "cooldown_s")

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        longest_half = longest_half_s(ctx.scenario.match)
        playing_s = longest_half * (MAX_LENGTHS if clock_may_stop(ctx.scenario) else 1)
        for model, path in ctx.models:
            for key in self._KEYS if path[:1] in (("rules",), ("timers",), ("phases",)) else ():
                seconds = longest_s(getattr(model, key, None), ctx.scenario.draws)
                if not seconds:
                    continue
                after_s = longest_half if key == "at_s" else playing_s
                # What must last longer than its limit needs one tick more.
                over = ticks_from_s(seconds) + (isinstance(model, Trigger) and model.MUST_EXCEED)
                phase_s = self._phase_s(ctx, path) if isinstance(model, Trigger) and key != "at_s" else None
                if over > ticks_from_s(after_s):
                    yield self.at((*path, key), seconds=seconds, what="half", after_s=after_s)
                elif phase_s is not None and seconds >= phase_s:
                    yield self.at((*path, key), seconds=seconds, what="phase", after_s=phase_s)

    @staticmethod
    def _phase_s(ctx: LintContext, path: Path) -> float | None:
        """Return the duration in s of the one phase in which a rule is active; None if that is open."""
        rule = ctx.scenario.rules[str(path[1])]
        phases = [phase for phase in ctx.reachable_phases if rule.is_active_in(phase)]
        phase = ctx.scenario.phases.get(phases[0]) if len(phases) == 1 else None
        return None if phase is None else longest_s(phase.lasts_s, ctx.scenario.draws)


class AngleInDegrees(LintRule, code="angle-in-degrees"):
    """An angle of more than a full turn: angles are in rad."""

    message = "{angle:g} rad is more than a full turn, which is {full_turn:.4f}"
    help = "for {angle:g} degrees write {radians:.4f}"

    _FULL_TURN_RAD = 6.3  # as authors round it

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for model, path in ctx.models:
            for angle, at in _angles(model, path):
                if abs(angle) > self._FULL_TURN_RAD:
                    yield self.at(at, angle=angle, full_turn=2 * pi, radians=radians(angle))


def _angles(model: Strict, path: Path) -> Iterator[tuple[float, Path]]:
    for name in type(model).model_fields:
        value = getattr(model, name)
        # `facing` is the one angle whose key does not name its unit: it need not be a number.
        if (name.endswith("_rad") or name == "facing") and isinstance(value, int | float):
            yield value, (*path, name)
    for key in ("place", "move") if isinstance(model, Keyframe) else ():
        for entity, pose in getattr(model, key).items():
            for yaw_rad in pose[2:]:
                yield yaw_rad, (*path, key, entity, 2)


class NeverReached(LintRule, code="never-reached"):
    """A distance that is larger than the field, or a speed that nothing here has: lengths are in m, speeds in m/s."""

    message = "{limit:g} {unit} is never reached: {why}"
    help = "correct it; the unit is {unit}"

    _LENGTHS = ("min_clearance_m", "clearance_m", "distance_m", "at_least_m")
    _PUSHED = 5  # times as fast as it drives a robot may slide after a hit

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        field = ctx.scenario.field.bounds
        across_m = 2 * hypot(*field.reach_m)
        too_far = f"the floor is {field.width_m:g} m by {field.length_m:g} m"
        chassis = (chassis_of(ctx.scenario, robot) for robot in ctx.scenario.robots)
        drives_mps = max((one.top_speed_mps for one in chassis), default=0.0)
        fastest_mps = max(self._PUSHED * drives_mps, 2 * MAX_KICK_MPS)
        too_fast = f"the fastest robot drives {drives_mps:g} m/s"
        for model, path in ctx.models:
            is_speed = isinstance(model, SpeedValue)
            keys = ("at_least", "above", "equals") if is_speed or isinstance(model, DistanceValue) else self._LENGTHS
            most, unit, why = (fastest_mps, "m/s", too_fast) if is_speed else (across_m, "m", too_far)
            for key in keys if path[:1] in (("rules",), ("placements",)) else ():
                limit = getattr(model, key, None)
                if isinstance(limit, int | float) and limit > most:
                    yield self.at((*path, key), limit=limit, unit=unit, why=why)


class ExactMeasurement(LintRule, code="exact-measurement"):
    """``equals`` with a speed, a distance or a way: a moving thing passes the value between two ticks."""

    message = "a measured value equals {limit:g} only by chance in a tick"
    help = "write at_least or at_most"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for model, path in ctx.models:
            limit = getattr(model, "equals", None)
            is_measured = isinstance(model, SpeedValue) or (isinstance(model, DistanceValue | WayValue) and limit != 0)
            if is_measured and isinstance(limit, int | float):
                yield self.at((*path, "equals"), limit=limit)


class UnknownPlaceholder(LintRule, code="unknown-placeholder"):
    """``{…}`` in ``says`` or in the description that is neither a placeholder nor a param: it is printed as it is."""

    message = "'{{{blank}}}' is not filled in"
    help = "{known}"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        scenario = ctx.scenario
        params = tuple(scenario.params)
        texts: list[tuple[Path, str, tuple[str, ...]]] = [
            (("description",), blank, params) for blank in placeholders_in(scenario.description)
        ]
        for name, rule in scenario.rules.items():
            copy = ctx.loaded.repeated.get(("rules", name))
            repeated = () if copy is None else copy.known
            known = (*PLACEHOLDERS, *repeated, *params, *scenario.counters, *scenario.draws, *scenario.roles)
            texts += [(("rules", name, key), blank, known) for blank, key in named_in(rule).items()]
        for at, ranked in enumerate(scenario.result.rank):
            texts += [(("result", "rank", at, "says"), blank, params) for blank in placeholders_in(ranked.says or "")]
        for path, blank, known in texts:
            # A description may hold braces of its own.
            if blank not in known and (path[0] != "description" or blank.strip().isidentifier()):
                yield self.at(
                    path,
                    blank=blank,
                    known=choice_of(blank.strip(), known) or "define it under params, or leave the braces out",
                )


class PlaceholderOfTwo(LintRule, code="placeholder-of-two"):
    """``{…}`` in ``says`` or ``sheet`` that is a param and a counter, draw or role too: the param is shown."""

    message = "'{{{blank}}}' is a param, and not the {kind} of the same name"
    help = "rename one of them"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        scenario = ctx.scenario
        for name, rule in scenario.rules.items():
            for blank, key in named_in(rule).items() if scenario.params else ():
                kind = next((one for one in ("counter", "draw", "role") if blank in getattr(scenario, f"{one}s")), "")
                if kind and blank in scenario.params and blank not in PLACEHOLDERS:
                    yield self.at(("rules", name, key), blank=blank, kind=kind)


class PlaceholderNeverFilled(LintRule, code="placeholder-never-filled"):
    """``{each}``, ``{limit}`` or ``{points}`` in a rule that has no for_each, no limit or no points."""

    message = "'{{{blank}}}' stays empty: {why}"
    help = "write the text itself, or remove it"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        for name, rule in ctx.scenario.rules.items():
            for blank, key in named_in(rule).items():
                why = self._why_empty(blank, rule)
                if why and blank not in ctx.scenario.params:
                    yield self.at(("rules", name, key), blank=blank, why=why)

    @staticmethod
    def _why_empty(blank: str, rule: Rule) -> str:
        if blank in ("each", "others") and rule.for_each is None:
            return "this rule has no for_each"
        limits = (getattr(one, one.LIMIT, None) or one.measures_its_limit() for one in rule.triggers)
        if blank == "limit" and not any(limits):
            return "no trigger of this rule has a limit"
        if blank == "points" and not rule.effects(Scores):
            return "this rule gives no points"
        return ""
