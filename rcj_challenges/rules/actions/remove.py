"""The action ``remove``."""

from typing import Annotated, Literal

from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.effects import Places, Removes
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.phrasing import WAITING_NOTE
from rcj_challenges.rules.placement import Facing, Placement, looks_words, put_words
from rcj_challenges.rules.places import At, place_of
from rcj_challenges.rules.refs import ENTITIES
from rcj_challenges.rules.values import Lasts, compile_duration, duration_words


class Remove(Action):
    """Take an entity off the field: it is parked, silent and invisible until a placement brings it back."""

    action: Literal["remove"]
    entity: Annotated[Names, ENTITIES] = described(..., "what is taken off: entities, groups, or each")
    for_s: Lasts | None = described(
        None,
        "time in s after which it comes back, read when the action "
        "runs (0 or less: one tick); if omitted: when a rule places it; if it is already off the field, the "
        "later action decides",
    )
    back_at: At = described("start", "where it comes back to")
    facing: Facing = described("start", "direction in which it faces when it comes back")

    NOTES = (
        WAITING_NOTE,
        (
            "What is off the field is in no zone and does not move, nothing is measured to it, and “all” are all that "
            "are on the field. It is back as soon as its time is over or a rule puts it somewhere."
        ),
    )
    EXAMPLE = """
rules:
  penalty:
    triggers: [{trigger: touches, entity: yellow, other: walls}]
    actions: [{action: remove, entity: Y1, for_s: 2, back_at: {spot: middle_yellow}}]
expect:
  it_is_back_after_2_s:
    keyframes:
      - {at_s: 0.5, place: {Y3: [0.5, -0.5]}}
      - {at_s: 1, touch: [[Y1, walls]]}
    lasts_s: 4
    poses: {Y1: [0, -0.2]}
  before_that_it_is_off_the_field:
    keyframes: [{at_s: 1, touch: [[Y1, walls]]}]
    lasts_s: 2
    off: [Y1]
"""

    def compile(self, to: Binder) -> Act:
        away_s = None if self.for_s is None else compile_duration(self.for_s, to)
        back = Places(self.entity, place_of(self.back_at), Placement.model_construct(facing=self.facing))
        returns = {entity: to.placement_job(back, entity) for entity in to.entities(self.entity)}

        def act(firing: Firing) -> None:
            seconds = None if away_s is None else away_s(firing)
            if away_s is not None and seconds is None:
                return
            for entity, job in returns.items():
                if seconds is None:
                    to.remove(entity)
                else:
                    to.remove(entity, job, max(1, ticks_from_s(seconds)))

        return act

    def effects(self) -> tuple[Removes]:
        return (Removes(self.entity, None if self.for_s is None else place_of(self.back_at)),)

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.all_of(self.entity)
        gone = f"{subject.does('is', 'are')} taken off the field"
        if not self.for_s:
            return gone
        back = put_words(phrases, self.entity, self.back_at)
        looks = looks_words(phrases, self.entity, self.back_at, self.facing)
        return f"{gone} and after {duration_words(phrases, self.for_s)} {back}{looks}"
