"""The condition ``last_touch``."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.phrasing import LAST_TOUCH_NOTE
from rcj_challenges.rules.refs import ROBOTS, THING
from rcj_challenges.rules.values.last_touch import LastTouchValue


class LastTouchIs(Condition):
    """Which robot was the last to touch a thing since that thing was placed."""

    last_touch: Annotated[Name, THING] = described(..., "what was touched: an entity, a fixed obstacle, or each")
    equals: Annotated[Names, ROBOTS] = described(..., "a robot, each, or a group (any member)")

    KEY = "last_touch"
    NOTES = (LAST_TOUCH_NOTE,)
    EXAMPLE = LastTouchValue.EXAMPLE

    def test(self, to: Binder) -> Test:
        (touched,), by = to.entities(self.last_touch), frozenset(to.entities(self.equals))
        last = to.state.contacts.follow_last(touched)
        return lambda: last() in by

    def about(self) -> Names:
        return self.last_touch

    def watched(self, to: Binder) -> tuple[int, ...]:
        (touched,) = to.entities(self.last_touch)
        return (touched,) if touched < len(to.state.present) else ()  # a fixed obstacle is never placed

    def describe(self, phrases: Phrases) -> str:
        last, was = f"the last to touch {phrases.thing(self.last_touch)}", "was not" if self.negate else "was"
        return f"it {was} {last}" if self.equals == "each" else f"{last} {was} {phrases.any_of(self.equals)}"
