"""Triggers about bodies: touches, tips_over."""

from __future__ import annotations

from functools import partial
from math import acos, cos

from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.contacts import Pair
from rcj_challenges.referee.rules import Listener, StandingRule
from rcj_challenges.referee.watching import TickWatch
from rcj_challenges.scenario.models import triggers as models


def touches(model: models.Touches, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when two bodies come into contact that were not in the sub-step before."""
    workshop.contacts.used = True
    watch = workshop.watch(TouchWatch, (), rule, lambda: TouchWatch(workshop))
    others = [workshop.roster.index[name] for name in workshop.members(model.other, rule.each)]
    for entity in workshop.entities(model.entity, rule.each):
        listener = workshop.listener(rule, position, model.trigger, entity)
        for other in others:
            if other != entity:
                pair = (min(entity, other), max(entity, other))
                watch.listeners.setdefault(pair, []).append(listener)


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


def tips_over(model: models.TipsOver, rule: StandingRule, position: int, workshop: Workshop) -> None:
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
