"""The trigger holds: a condition that has held for a time."""

from __future__ import annotations

from rcj_challenges.facts.timing import s_from_ticks, ticks_from_s, whole_ticks_within_s
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.conditions import compile_condition, watched_entities
from rcj_challenges.referee.rules import Listener, StandingRule, Test
from rcj_challenges.referee.watching import NEVER, TickWatch
from rcj_challenges.rules.triggers import Holds


def holds(model: Holds, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a condition has held for a time, and again at intervals if asked."""
    test = compile_condition(model.condition, workshop, rule.each)
    watch = HoldWatch(test, model, workshop)
    watch.phases = rule.phases
    watch.entities = watched_entities(model.condition, workshop, rule.each)
    # What it is about is known if one entity stands in the condition.
    entity = watch.entities[0] if len(watch.entities) == 1 else None
    watch.listeners.append(workshop.listener(rule, position, model.trigger, entity))
    workshop.lookout.add(watch)


class HoldWatch(TickWatch):
    """Measures how long a condition holds; an interruption of up to the grace counts as holding.

    Attributes:
        listeners: ears.
        true_before: when it last could not come true because it held already; None: it always could.
    """

    def __init__(self, test: Test, model: Holds, workshop: Workshop) -> None:
        self.listeners: list[Listener] = []
        self.true_before: int | None = None
        self._test = test
        self._for_s = model.for_s
        self._for = ticks_from_s(model.for_s)
        self._grace = whole_ticks_within_s(model.grace_s)
        self._every_s = model.every_s
        self._again = 0
        self._began: int | None = None
        self._lost: int | None = None
        self._next = NEVER
        self._state = workshop.state
        self._hits = workshop.hits

    def restart(self) -> None:
        """Begin to count now if it holds. What must hold for no time at all was true before and does not fire."""
        tick = self._state.tick
        self._lost = None
        self._began = tick if self._test() else None
        self._next, self._again = tick + self._for, 0
        if self._for == 0:
            self._next = self._next_after(tick, tick)
            if self._began is not None and self._every_s is None:
                self.true_before = tick
            elif self.true_before == tick:  # what begins with the half is put in its place in the same tick
                self.true_before = None

    def moved(self) -> None:
        """Begin anew, unless it is a matter of several and held throughout: then one of them changes nothing."""
        held = self._began is not None and self._lost is None
        if len(self.entities) == 1 or not (held and self._test()):
            self.restart()

    def look(self) -> None:
        """Report when it has held long enough."""
        tick = self._state.tick
        if not self._test():
            if self._began is not None and self._lost is None:
                self._lost = tick
            return
        if self._began is None or (self._lost is not None and tick - self._lost > self._grace):
            self._began, self._next, self._again = tick, tick + self._for, 0
        self._lost = None
        if tick >= self._next:
            self._next = self._next_after(tick, self._began)
            self._hits.report(self.listeners, s_from_ticks(tick - self._began), self._for_s)

    def _next_after(self, tick: int, began: int) -> int:
        """Return when it fires again.

        Each time is counted from the beginning: rounded up one by one, 120 intervals of 1 s would take 122.9 s.
        """
        if self._every_s is None:
            return NEVER
        after = tick
        while after <= tick:  # in phases in which nobody looks, times pass unheard
            self._again += 1
            after = began + ticks_from_s(self._for_s + self._again * self._every_s)
        return after
