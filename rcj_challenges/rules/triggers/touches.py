"""The trigger ``touches``."""

from collections.abc import Callable
from typing import Annotated, Literal

from rcj_challenges.core.timing import TICK_S, ticks_from_s
from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.effects import Touch
from rcj_challenges.rules.fields import Names, NotNegative, described
from rcj_challenges.rules.phrasing import seconds
from rcj_challenges.rules.refs import FIXED, MOVING, THINGS, Ref
from rcj_challenges.rules.values import Lasts, compile_limit, every_words
from rcj_challenges.tracking.bound_rules import TriggerBinding
from rcj_challenges.tracking.contacts import APART_S, Pair, substeps_apart
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import TickTracker


class Touches(Trigger):
    """Fires when two bodies come into contact."""

    trigger: Literal["touches"]
    entity: Annotated[Names, THINGS] = described(
        ...,
        "an entity (a robot, a ball or a movable obstacle), a fixed obstacle, a group (any member), or each",
    )
    other: Annotated[Names, Ref("entity or obstacle", MOVING | FIXED | {"walls"}, groups=True, each=True)] = described(
        ...,
        "what it touches: entities, obstacles, walls, or a group; if all triggers of a rule are touches, its "
        "conditions and actions can use other for the touched thing",
    )
    every_s: Lasts | None = described(
        None,
        "interval in s, read when the contact begins, at which it fires again while the contact lasts; if omitted: it "
        "fires only once, when the contact begins",
    )
    apart_s: NotNegative = described(
        APART_S,
        "a contact that is interrupted for less than this time in s is one contact; a placement ends it; 0: each "
        "interruption ends it",
    )

    BINDS_OTHER = True
    MOMENT = Touch
    EXAMPLE = """
flags: {touched: {}}
counters: {pushed: {per: robots}}
rules:
  # In a rule triggered by touches, `other` is the touched thing; the rule fires once for each.
  push:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: robots}]
    conditions: [{entity: each, looks: other, within_rad: 0.5}]
    actions: [{action: count, counter: pushed, entity: other}]
    says: '{entity} pushes {other}.'
  foul:
    for_each: yellow
    triggers: [{trigger: touches, entity: each, other: blue}]
    actions: [{action: emit, event: FOUL, payload: {robot_name: {word: robot_name}}}]
  # Without for_each, a rule fires once per tick, however many robots touch the ball. With for_each it would fire for
  # each of them, since all see the flag as it was at the start of the tick. {last_touch: ball} names one of them.
  first_touch:
    triggers: [{trigger: touches, entity: robots, other: ball}]
    conditions: [{flag: touched, negate: true}]
    actions: [{action: score, entrant: {last_touch: ball}}, {action: set_flag, flag: touched}]
  # It fires again while the contact lasts: a robot that leans on another is warned every 2 s.
  leans:
    triggers: [{trigger: touches, entity: B1, other: Y1, every_s: 2}]
    actions: [{action: emit, event: LEANS}]
expect:
  a_leaning_robot_is_warned_until_they_part:
    keyframes: [{at_s: 1, touch: [[B1, Y1]], touch_lasts_s: 5}]
    lasts_s: 10
    events: [{event: LEANS, at_s: 1}, {event: LEANS, at_s: 3.04}, {event: LEANS, at_s: 5.03}]
    ignore: [FOUL]
  a_long_touch_is_one_touch:
    keyframes:
      - {at_s: 1, touch: [[Y2, B3]]}
      - {at_s: 1.032, touch: [[Y2, B3]]}
    lasts_s: 2
    events: [{event: FOUL, payload: {robot_name: Y2}}]
  a_robot_that_faces_the_other_pushes_it:
    keyframes:
      - {at_s: 1, place: {Y1: [0, 0, 0], B1: [0.16, 0, 0], B2: [-0.16, 0, 3.14]}, touch: [[Y1, B1], [Y1, B2]]}
    lasts_s: 2
    counters: {pushed: 1}
  of_two_simultaneous_touches_one_is_first:
    keyframes: [{at_s: 1, touch: [[Y1, ball], [B2, ball]]}, {at_s: 2, touch: [[Y1, ball]]}]
    lasts_s: 3
    score: {blue: 1, yellow: 0}
"""

    def bind(self, to: Binder) -> None:
        """Bind a rule to new contacts of each pair, and with ``every_s`` to a tracker of contacts that last."""
        to.state.contacts.used = True
        apart = substeps_apart(self.apart_s)
        tracker = to.track(TouchTracker, (apart,), apart)
        names = zip(to.members(self.other), to.entities(self.other), strict=True)
        others = [index for name, index in names if to.rule.other in (None, name)]
        for entity in to.entities(self.entity):
            binding = to.binding(entity)
            for other in others:
                if other != entity:
                    pair = (min(entity, other), max(entity, other))
                    tracker.by_pair.setdefault(pair, []).append(binding)
                    if self.every_s is not None:
                        key = (pair, apart, self.every_s)
                        every_s = compile_limit(self.every_s, to, TICK_S)
                        to.track(LastingTouchTracker, key, pair, every_s, apart).bindings.append(binding)

    def describe(self, phrases: Phrases) -> str:
        again = f", and again {every_words(phrases, self.every_s)} while they touch" if self.every_s else ""
        one = f" (again after {seconds(self.apart_s)} apart)" if self.apart_s != APART_S else ""
        return f"{phrases.any_of(self.entity)} touches {phrases.another_of(self.other, than=self.entity)}{one}{again}"


class TouchTracker(TickTracker):
    """Reports the new contacts of a tick."""

    def __init__(self, state: RefereeState, apart: int) -> None:
        super().__init__(state)
        self.by_pair: dict[Pair, list[TriggerBinding]] = {}
        self._contacts = state.contacts
        self._apart = apart

    def update(self) -> None:
        for pair, gap in self._contacts.fresh:
            if gap >= self._apart:
                self._hits.report(self.by_pair.get(pair, []))


class LastingTouchTracker(TickTracker):
    """Reports at intervals that two things still touch; that they began to is reported by the `TouchTracker`."""

    def __init__(self, state: RefereeState, pair: Pair, every_s: Callable[[], float], apart: int) -> None:
        super().__init__(state)
        self._pair = pair
        self._apart = apart
        self._read_every_s = every_s
        self._every_s = 0.0
        self._began = self._times = self._due = 0
        self._contacts = state.contacts

    def reset(self) -> None:
        """Count from now on."""
        self._every_s = self._read_every_s()
        self._began = self._state.tick
        self._count(1)

    def update(self) -> None:
        if any(pair == self._pair and gap >= self._apart for pair, gap in self._contacts.fresh):
            self.reset()
        elif self._state.tick >= self._due and self._contacts.is_one_contact(self._pair, self._apart):
            self._count(self._times + 1)
            self._hits.report(self.bindings)

    def _count(self, times: int) -> None:
        # Counted from the beginning: intervals that are not whole ticks do not add up to a delay.
        self._times, self._due = times, self._began + ticks_from_s(times * self._every_s)
