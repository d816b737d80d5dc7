"""The action ``hold``."""

from math import inf
from typing import Annotated, Literal

from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.effects import Holds
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ROBOTS
from rcj_challenges.rules.values import Lasts, compile_duration, duration_words


class Hold(Action):
    """Hold robots: from the next tick on their wheels are braked, whatever their programs command.

    Programs run on, and the last command acts when the robots are released. If a robot is held already, the later end
    counts. A placement or removal does not end a hold, and its time runs on; a new half begins without holds. A phase
    with `robots: held` is independent of this: a robot stands as long as either holds it.
    """

    action: Literal["hold"]
    entity: Annotated[Names, ROBOTS] = described(..., "what is held: robots, groups, or each")
    for_s: Lasts | None = described(
        None,
        "how long in s, time off the field included; read when the action runs (0 or less, or no such number: not at "
        "all); if omitted: until a rule releases it; if two holds overlap, the "
        "later end counts",
    )

    NOTES = (
        (
            "A robot that is held still stands with braked wheels, whatever its program does, until its time is over "
            "or it is let go. Only from then on it must move."
        ),
    )
    EXAMPLE = """
counters: {penalty_s: {initial: 4}}
rules:
  frozen:
    for_each: yellow
    triggers: [{trigger: touches, entity: each, other: B1}]
    actions: [{action: hold, entity: each}]  # until a rule releases it
  freed:
    for_each: yellow
    triggers: [{trigger: touches, entity: each, other: yellow}]
    actions: [{action: release, entity: each}]
  penalty:
    triggers: [{trigger: touches, entity: B1, other: walls}]
    # A number, or the value of a counter or a draw: here, one second longer each time.
    actions: [{action: count, counter: penalty_s}, {action: hold, entity: B1, for_s: {counter: penalty_s}}]
expect:
  the_touch_of_a_team_mate_frees_a_robot:
    keyframes: [{at_s: 1, touch: [[Y1, B1], [Y2, B1]]}, {at_s: 2, touch: [[Y2, Y3]]}, {at_s: 3, touch: [[B1, walls]]}]
    lasts_s: 7
    held: {Y1: true, Y2: false, Y3: false, B1: true}
"""

    def compile(self, to: Binder) -> Act:
        state, robots = to.state, to.entities(self.entity)
        if self.for_s is None:
            return lambda _firing: state.held.hold(robots, inf)
        lasts_s = compile_duration(self.for_s, to)

        def act(firing: Firing) -> None:
            ticks = ticks_from_s(lasts_s(firing) or 0.0)
            if ticks > 0:
                state.held.hold(robots, state.tick + ticks)

        return act

    def effects(self) -> tuple[Holds]:
        return (Holds(self.entity, for_a_time=self.for_s is not None),)

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.all_of(self.entity)
        until = f"until {'they are' if subject.plural else 'it is'} let go"
        lasts = until if self.for_s is None else f"for {duration_words(phrases, self.for_s)}"
        return f"{subject.does('is', 'are')} held still {lasts}"
