"""Triggers about bodies: touches, tips_over."""

from __future__ import annotations

from functools import partial
from math import acos, cos

from rcj_challenges.facts.timing import ticks_from_s
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.contacts import Pair
from rcj_challenges.referee.rules import Listener, StandingRule
from rcj_challenges.referee.watching import TickWatch
from rcj_challenges.rules.triggers import TipsOver, Touches


def touches(model: Touches, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when two bodies come into contact that were not in the sub-step before."""
    workshop.contacts.used = True
    watch = workshop.watch(TouchWatch, (), rule, lambda: TouchWatch(workshop))
    members = workshop.members(model.other, rule.each)
    others = [workshop.roster.index[name] for name in members if rule.other in (None, name)]
    for entity in workshop.things(model.entity, rule.each):
        listener = workshop.listener(rule, position, model.trigger, entity)
        for other in others:
            if other != entity:
                pair = (min(entity, other), max(entity, other))
                watch.listeners.setdefault(pair, []).append(listener)
                if model.every_s is not None:
                    key = (pair, model.every_s)
                    make = partial(LastingTouchWatch, pair, model.every_s, workshop)
                    workshop.watch(LastingTouchWatch, key, rule, make).listeners.append(listener)


class TouchWatch(TickWatch):
    """Hands the new contacts of a tick to those who asked for them.

    Attributes:
        listeners: ears by pair of things.
    """

    def __init__(self, workshop: Workshop) -> None:
        self.listeners: dict[Pair, list[Listener]] = {}
        self._contacts = workshop.contacts
        self._hits = workshop.hits

    def restart(self) -> None:
        """Nothing is remembered here: the contacts are."""

    def look(self) -> None:
        """Report new contacts."""
        for pair in self._contacts.fresh:
            self._hits.report(self.listeners.get(pair, []))


class LastingTouchWatch(TickWatch):
    """Reports at intervals that two things still touch; that they began to, the `TouchWatch` says.

    Attributes:
        listeners: ears.
    """

    def __init__(self, pair: Pair, every_s: float, workshop: Workshop) -> None:
        self.listeners: list[Listener] = []
        self._pair = pair
        self._every_s = every_s
        self._began = self._times = self._due = 0
        self._state = workshop.state
        self._contacts = workshop.contacts
        self._hits = workshop.hits

    def restart(self) -> None:
        """Count from now on."""
        self._began = self._state.tick
        self._count(1)

    def look(self) -> None:
        """Report when another interval is full."""
        if self._pair in self._contacts.fresh:
            self.restart()
        elif self._pair in self._contacts.touching and self._state.tick >= self._due:
            self._count(self._times + 1)
            self._hits.report(self.listeners)

    def _count(self, times: int) -> None:
        # Reckoned from the beginning: intervals that are no whole ticks do not add up to a delay.
        self._times, self._due = times, self._began + ticks_from_s(times * self._every_s)


def tips_over(model: TipsOver, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a robot tilts further than an angle."""
    for entity in workshop.entities(model.entity, rule.each):
        key = (entity, model.angle_rad)
        watch = workshop.watch(TiltWatch, key, rule, partial(TiltWatch, entity, model.angle_rad, workshop))
        watch.listeners.append(workshop.listener(rule, position, model.trigger, entity))


class TiltWatch(TickWatch):
    """Follows the tilt of an entity.

    Attributes:
        listeners: ears.
    """

    def __init__(self, entity: int, angle_rad: float, workshop: Workshop) -> None:
        self.entities = (entity,)
        self.listeners: list[Listener] = []
        self._entity = entity
        self._angle = angle_rad
        self._least = cos(angle_rad)
        self._tilted = False
        self._state = workshop.state
        self._hits = workshop.hits

    def restart(self) -> None:
        """Take the present tilt for the one before."""
        self._tilted = self._state.uprights[self._entity] < self._least

    def look(self) -> None:
        """Report when it goes beyond the angle."""
        if not self._state.present[self._entity]:
            return
        upright = self._state.uprights[self._entity]
        was, self._tilted = self._tilted, upright < self._least
        if self._tilted and not was:
            self._hits.report(self.listeners, acos(max(-1.0, min(1.0, upright))), self._angle)
