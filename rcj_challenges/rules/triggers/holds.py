"""The trigger ``holds``."""

from collections.abc import Callable
from typing import Literal

from rcj_challenges.core.timing import TICK_S, s_from_ticks, ticks_from_s, whole_ticks_within_s
from rcj_challenges.rules.base import Binder, Condition, Phrases, Test, Trigger
from rcj_challenges.rules.conditions import AnyCondition
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.several_conditions import as_one
from rcj_challenges.rules.values import Lasts, Waits, compile_limit, duration_words, every_words
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import NEVER, Missed, TickTracker


class Holds(Trigger):
    """Fires when conditions have held for a given time and, with ``every_s``, again at intervals."""

    trigger: Literal["holds"]
    conditions: tuple[AnyCondition, ...] = described(..., "the conditions, which must all hold", min_length=1)
    for_s: Waits = described(
        0.0,
        "how long they must hold, in s, read when they begin to; 0: it fires as soon as they become true, but not if "
        "they were already true when the rule became active, or if a placement or removal made them true (spot_free, "
        "sequence and comparisons with lowest or highest notice that one tick later)",
    )
    grace_s: Waits = described(0.0, "interruptions of up to this time, in s, do not count")
    every_s: Lasts | None = described(
        None,
        "interval in s at which it fires again while they hold, counted from the end of for_s; if "
        "omitted: it fires once",
    )

    MEASURED = "the time in s for which that has held"
    LIMIT = "for_s"
    EXAMPLE = """
rules:
  point_for_each_second_in_the_middle:
    triggers:
      - trigger: holds
        conditions: [{distance: [ball, centre], at_most: 0.1}]
        for_s: 1
        every_s: 1
    actions: [{action: score, entrant: yellow}]
expect:
  three_seconds_give_three_points:
    keyframes:
      - {at_s: 1, place: {ball: [0.05, 0]}}
      - {at_s: 3.5, place: {ball: [0.5, 0]}}
    lasts_s: 5
    score: {yellow: 3}
"""

    @property
    def condition(self) -> Condition:
        """The conditions as one."""
        return as_one(self.conditions)

    def bind(self, to: Binder) -> None:
        condition, every = self.condition, self.every_s
        limits = (
            compile_limit(self.for_s, to),
            compile_limit(self.grace_s, to, none=0.0),
            None if every is None else compile_limit(every, to, TICK_S),
        )
        tracker = to.track(HoldTracker, None, to.watched(condition), condition.compile(to), *limits)
        # What it is about is known if one entity stands in the condition.
        tracker.bindings.append(to.binding(tracker.entities[0] if len(tracker.entities) == 1 else None))

    def describe(self, phrases: Phrases) -> str:
        if self.every_s and self.condition.is_always():
            # Without for_s it was true before when it begins: it comes for the first time after the first interval.
            first = duration_words(phrases, self.for_s or self.every_s)
            return f"{first} have passed, and again {every_words(phrases, self.every_s)}"
        for_s = f"for {duration_words(phrases, self.for_s)}" if self.for_s else ""
        held = self.condition.describe(phrases)
        grace = (
            f" (interruptions of up to {duration_words(phrases, self.grace_s)} do not count)" if self.grace_s else ""
        )
        again = f", and again {every_words(phrases, self.every_s)} while that lasts" if self.every_s else ""
        # Behind several it would read as if only the last of them had to last, behind a counter as if that said it.
        before = self.condition.is_several() or self.condition.compares_with_value()
        lasting = " ".join(filter(None, (for_s, held) if before else (held, for_s)))
        return f"{lasting}{grace}{again}"

    def about(self, _phrases: Phrases) -> Names | None:
        return self.condition.about()

    def measures_its_limit(self) -> bool:
        """Return whether it fires once, as soon as the condition has held for so long without interruption."""
        return bool(self.for_s) and not self.every_s and not self.grace_s


class HoldTracker(TickTracker):
    """Measures how long a condition holds; an interruption of up to the grace counts as holding."""

    def __init__(
        self, state: RefereeState, entities: tuple[int, ...], test: Test,
        for_s: Callable[[], float], grace_s: Callable[[], float], every_s: Callable[[], float] | None,
    ) -> None:  # fmt: skip
        super().__init__(state, *entities)
        self._test = test
        self._limits = for_s, grace_s, every_s
        self._for_s, self._every_s = 0.0, None if every_s is None else 0.0
        self._for = self._grace = self._again = 0
        self._began: int | None = None
        self._lost: int | None = None
        self._next = NEVER

    def reset(self) -> None:
        """Begin to count now if it holds. What must hold for no time at all was true before and does not fire."""
        tick = self._state.tick
        self._lost = None
        self._begin(tick)
        self._began = tick if self._test() else None
        if self._for == 0:
            self._next = self._next_after(tick, tick)
            if self._began is not None and self._every_s is None:
                self.missed = Missed(tick, "true", bindings=self.bindings)
            elif self.missed is not None and self.missed.tick == tick:  # it is put in its place as the half begins
                self.missed = None

    def _begin(self, tick: int) -> None:
        for_s, grace_s, every_s = self._limits
        self._for_s, self._every_s = for_s(), None if every_s is None else every_s()
        self._for, self._grace = ticks_from_s(self._for_s), whole_ticks_within_s(grace_s())
        self._began, self._next, self._again = tick, tick + self._for, 0

    def moved(self) -> None:
        """Reset, unless the condition is about several entities and held throughout."""
        held = self._began is not None and self._lost is None
        if len(self.entities) == 1 or not (held and self._test()):
            self.reset()

    def update(self) -> None:
        tick = self._state.tick
        if not self._test():
            if self._grace == 0:
                self._began = None
            elif self._began is not None and self._lost is None:
                self._lost = tick
            return
        if self._began is None or (self._lost is not None and tick - self._lost > self._grace):
            self._begin(tick)
        self._lost = None
        if tick >= self._next and self._began is not None:
            self._next = self._next_after(tick, self._began)
            self._hits.report(self.bindings, s_from_ticks(tick - self._began), self._for_s)

    def settle(self) -> None:
        """Report a condition that has come true although no time passed; what must last needs time."""
        if self._for == 0:
            self.update()

    def _next_after(self, tick: int, began: int) -> int:
        """Return when it fires again.

        Each time is counted from the beginning: rounded up one by one, 120 intervals of 1 s would take 122.9 s.
        """
        if self._every_s is None:
            return NEVER
        after = tick
        while after <= tick:  # in phases in which it is not active, times pass
            self._again += 1
            after = began + ticks_from_s(self._for_s + self._again * self._every_s)
        return after
