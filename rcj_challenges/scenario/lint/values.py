"""Checks of numbers and texts: wrong units, limits that are never reached, blanks that nothing fills in."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi, radians
from typing import ClassVar

from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.rules.actions.hold import Hold
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.remove import Remove
from rcj_challenges.rules.conditions.distance import Distance
from rcj_challenges.rules.conditions.speed import Speed
from rcj_challenges.rules.conditions.spot_free import SpotFree
from rcj_challenges.rules.conditions.timer import TimerIs
from rcj_challenges.rules.conditions.way import WayIs
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.kick import MAX_KICK_MPS
from rcj_challenges.rules.places.furthest_free import FurthestFree
from rcj_challenges.rules.places.nearest_free import NearestFree
from rcj_challenges.rules.triggers.displaced import Displaced
from rcj_challenges.rules.triggers.holds import Holds
from rcj_challenges.rules.triggers.no_progress import NoProgress
from rcj_challenges.rules.triggers.stays_in import StaysIn
from rcj_challenges.rules.triggers.time_reached import TimeReached
from rcj_challenges.scenario.errors import choice_of
from rcj_challenges.scenario.halves import MAX_LENGTHS, clock_may_stop, longest_half_s
from rcj_challenges.scenario.lint.base import LintRule, Suspicion
from rcj_challenges.scenario.lint.context import LintContext, is_active_in, longest_s
from rcj_challenges.scenario.models.places import Placing
from rcj_challenges.scenario.models.robots import StartPose
from rcj_challenges.scenario.models.scenario import Keyframe, Rule
from rcj_challenges.scenario.models.state import Phase, Timer
from rcj_challenges.scenario.placeholders import PLACEHOLDERS, placeholders_in
from rcj_challenges.scenario.tree import Path


class LimitTooLong(LintRule):
    """A time that is longer than the half, or than the phase in which the rule is active."""

    code = "limit-too-long"
    message = "{seconds:g} s is too long: the {what} is over after {after_s:g} s"
    help = "shorten it, or let the {what} last longer"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield durations that the half, or the phases of a rule, cannot contain."""
        longest_half = longest_half_s(ctx.scenario.match)
        playing_s = longest_half * (MAX_LENGTHS if clock_may_stop(ctx.scenario) else 1)
        for model, path in ctx.models:
            for key, seconds in _durations(model, ctx):
                after_s = longest_half if isinstance(model, TimeReached) else playing_s
                # What must last longer than its limit needs one tick more.
                over = ticks_from_s(seconds) + isinstance(model, StaysIn | NoProgress) if seconds else 0
                if over > ticks_from_s(after_s):
                    yield self.at((*path, key), seconds=seconds, what="half", after_s=after_s)
                    continue
                phase_s = self._phase_s(model, path, ctx)
                if phase_s is not None and seconds and ticks_from_s(seconds) >= ticks_from_s(phase_s):
                    yield self.at((*path, key), seconds=seconds, what="phase", after_s=phase_s)

    @staticmethod
    def _phase_s(model: Strict, path: Path, ctx: LintContext) -> float | None:
        """Return how long the one phase lasts in which a window of a trigger can fill, in s; None if it is open."""
        if path[0] != "rules" or not isinstance(model, StaysIn | NoProgress | Holds):
            return None
        rule = ctx.scenario.rules[str(path[1])]
        phases = [phase for phase in ctx.reachable_phases if is_active_in(rule, phase)]
        phase = ctx.scenario.phases.get(phases[0]) if len(phases) == 1 else None
        if phase is None or phase.lasts_s is None or (phases[0], phases[0]) in ctx.transitions:
            return None
        return longest_s(phase.lasts_s, ctx.scenario)


class AngleInDegrees(LintRule):
    """An angle of more than a full turn: angles are in rad."""

    code = "angle-in-degrees"
    message = "{angle:g} rad is more than a full turn, which is {full_turn:.4f}"
    help = "for {angle:g} degrees write {radians:.4f}"

    _FULL_TURN_RAD = 6.3  # as authors round it

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield angles that only make sense in degrees."""
        for model, path in ctx.models:
            for angle, at in _angles(model, path):
                if abs(angle) > self._FULL_TURN_RAD:
                    yield self.at(at, angle=angle, full_turn=2 * pi, radians=radians(angle))


class NeverReached(LintRule):
    """A distance that is larger than the field, or a speed that nothing here has: lengths are in m, speeds in m/s."""

    code = "never-reached"
    message = "{limit:g} {unit} is never reached: {why}"
    help = "correct it; the unit is {unit}"

    _PUSHED = 5  # times as fast as it drives a robot may slide after a hit
    _GAPS: ClassVar = {
        Place: "min_clearance_m",
        Placing: "min_clearance_m",
        NearestFree: "clearance_m",
        FurthestFree: "clearance_m",
        SpotFree: "clearance_m",
        Displaced: "distance_m",
    }

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield limits beyond what field and robots allow."""
        field = ctx.scenario.field
        depth_m = max((goal.depth_m for goal in field.goals.values()), default=0.0)
        across_m = (field.width_m**2 + (field.length_m + 2 * depth_m) ** 2) ** 0.5
        too_far = f"the field is {field.width_m:g} m by {field.length_m:g} m"
        for model, path in ctx.models:
            gap = self._GAPS.get(type(model))
            limits = [(gap, getattr(model, gap))] if gap else []
            if isinstance(model, Distance):
                limits = [(key, getattr(model, key)) for key in ("at_least", "equals")]
            if isinstance(model, Place | Placing | StartPose):
                limits += [("noise_m", max(model.noise_m))]
            for key, limit in limits:
                if isinstance(limit, int | float) and limit > across_m:
                    yield self.at((*path, key), limit=limit, unit="m", why=too_far)
            if isinstance(model, Speed | NoProgress) and path[0] == "rules":
                yield from self._too_fast(model, path, ctx)

    def _too_fast(self, model: Speed | NoProgress, path: Path, ctx: LintContext) -> Iterator[Suspicion]:
        rule = ctx.scenario.rules[str(path[1])]
        drives_mps, only_robots = _top_speed_mps(ctx.members(model.entity, rule), ctx)
        fastest_mps = self._PUSHED * drives_mps if only_robots else max(self._PUSHED * drives_mps, 2 * MAX_KICK_MPS)
        why = f"the fastest robot drives {drives_mps:g} m/s"
        if isinstance(model, NoProgress):
            if only_robots and drives_mps and model.distance_m > drives_mps * model.within_s:
                yield self.at((*path, "distance_m"), limit=model.distance_m, unit="m", why=why)
            return
        for key in ("at_least", "equals"):
            limit = getattr(model, key)
            if isinstance(limit, int | float) and limit > fastest_mps:
                yield self.at((*path, key), limit=limit, unit="m/s", why=why)


class ExactMeasurement(LintRule):
    """``equals`` with a speed, a distance or a way: a moving thing passes the value between two ticks."""

    code = "exact-measurement"
    message = "a measured value equals {limit:g} only by chance in a tick"
    help = "write at_least or at_most"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield conditions that compare a measured value for equality."""
        for model, path in ctx.models:
            limit = getattr(model, "equals", None)
            measured = isinstance(model, Speed) or (isinstance(model, Distance | WayIs | TimerIs) and limit != 0)
            if measured and isinstance(limit, int | float):
                ticks = ticks_from_s(limit) if limit > 0 else 0
                if not isinstance(model, TimerIs) or abs(ticks * 0.032 - limit) > 1e-9:
                    yield self.at((*path, "equals"), limit=limit)


class UnknownPlaceholder(LintRule):
    """``{…}`` in ``says`` or in the description that is neither a placeholder nor a param: it is printed as it is."""

    code = "unknown-placeholder"
    message = "'{{{blank}}}' is not filled in"
    help = "{known}"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield unknown blanks of sentences, and names in the description that are no param."""
        params = tuple(ctx.scenario.params)
        for name, rule in ctx.scenario.rules.items():
            repeated = ctx.repeated[name].known if name in ctx.repeated else ()
            known = (*PLACEHOLDERS, *repeated, *params)
            for blank in placeholders_in(rule.says):
                if blank not in known:
                    yield self._unknown(("rules", name, "says"), blank, known)
        for blank in placeholders_in(ctx.scenario.description):
            if blank not in params and blank.strip().isidentifier():
                yield self._unknown(("description",), blank, params)

    def _unknown(self, path: Path, blank: str, known: tuple[str, ...]) -> Suspicion:
        # A blank of a stranger's file may hold braces of its own only as text, so the texts are filled in by hand.
        return self.at(path, blank=blank, known=choice_of(blank.strip(), known))


class PlaceholderNeverFilled(LintRule):
    """``{each}``, ``{limit}`` or ``{points}`` in a rule that has no for_each, no limit or no points."""

    code = "placeholder-never-filled"
    message = "'{{{blank}}}' stays empty: {why}"
    help = "write the text itself, or remove it"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield blanks that this rule cannot fill in."""
        for name, rule in ctx.scenario.rules.items():
            for blank in placeholders_in(rule.says):
                why = self._why_empty(blank, rule)
                if why and blank not in ctx.scenario.params:
                    yield self.at(("rules", name, "says"), blank=blank, why=why)

    @staticmethod
    def _why_empty(blank: str, rule: Rule) -> str:
        if blank == "each" and rule.for_each is None:
            return "this rule has no for_each"
        if blank == "limit" and not any(hasattr(one, "limit_s") or _has_limit(one) for one in rule.triggers):
            return "no trigger of this rule has a limit"
        if blank == "points" and not any(action.name() == "score" for action in rule.actions):
            return "this rule gives no points"
        return ""


def _has_limit(trigger: Strict) -> bool:
    return getattr(trigger, "trigger", "") in {
        "displaced",
        "no_progress",
        "stays_in",
        "tips_over",
        "holds",
        "time_reached",
        "timer_expired",
    }


def _durations(model: Strict, ctx: LintContext) -> Iterator[tuple[str, float]]:
    """Yield the times of a model that must be over before a half is, with their keys."""
    match model:
        case StaysIn():
            yield "limit_s", model.limit_s
        case NoProgress():
            yield "within_s", model.within_s
        case Holds():
            yield "for_s", model.for_s
        case TimeReached():
            yield "at_s", model.at_s
        case Timer(lasts_s=lasts_s) | Phase(lasts_s=lasts_s) if lasts_s is not None:
            seconds = longest_s(lasts_s, ctx.scenario)
            if seconds is not None:
                yield "lasts_s", seconds
        case Remove(for_s=for_s) | Hold(for_s=for_s) if for_s is not None:
            seconds = longest_s(for_s, ctx.scenario)
            if seconds is not None:
                yield "for_s", seconds
        case Rule(cooldown_s=cooldown_s) if cooldown_s is not None:
            yield "cooldown_s", cooldown_s


def _angles(model: Strict, path: Path) -> Iterator[tuple[float, Path]]:
    for name in type(model).model_fields:
        value = getattr(model, name)
        # `facing` is the one angle whose key does not name its unit: it need not be a number.
        if (name.endswith("_rad") or name == "facing") and isinstance(value, int | float):
            yield value, (*path, name)
    if isinstance(model, Keyframe):
        for key, poses in (("place", model.place), ("move", model.move)):
            for entity, pose in poses.items():
                for yaw_rad in pose[2:]:
                    yield yaw_rad, (*path, key, entity, 2)


def _top_speed_mps(names: frozenset[str], ctx: LintContext) -> tuple[float, bool]:
    """Return how fast the fastest robot of some entities drives, in m/s, and whether all of them are robots."""
    scenario = ctx.scenario
    chassis = [scenario.kits[scenario.robots[one].kit].chassis for one in names if one in scenario.robots]
    return max((one.max_wheel_radps * one.wheel_radius_m for one in chassis), default=0.0), len(chassis) == len(names)
