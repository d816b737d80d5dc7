"""The action ``set_spot``."""

from collections.abc import Callable
from typing import Annotated, Literal

from rcj_challenges.core.messages import position_in
from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases, Word
from rcj_challenges.rules.effects import SetsSpot
from rcj_challenges.rules.fields import Name, Point, described
from rcj_challenges.rules.placement import Mirror
from rcj_challenges.rules.places.on_line import OnLine
from rcj_challenges.rules.places.point import AtPoint
from rcj_challenges.rules.places.uniform_in import UniformIn
from rcj_challenges.rules.refs import FIXED, MOVING, ROBOT, WRITTEN_SPOT, Ref


class SentPlace(Word):
    """The position that a robot has sent to the referee last."""

    told: Annotated[Name, ROBOT] = described(..., "a robot, or each")

    READS_MESSAGES = True


class SetSpot(Action):
    """Set a spot to where something is now. In each half, the spot starts where the file puts it.

    What is off the field leaves it where it is, and so does a message that is no position. What is placed in the same
    tick is still where it was before.
    """

    action: Literal["set_spot"]
    spot: Annotated[Name, WRITTEN_SPOT] = described(..., "the spot")
    to: Annotated[
        Name | Point | SentPlace | UniformIn | OnLine,
        Ref(
            "entity, obstacle, spot or zone",
            MOVING | FIXED | frozenset({"spot"}) | frozenset({"zone"}),
            each=True,
            drawn=True,
        ),
    ] = described(
        ...,
        "an entity, each, a spot, a zone with a centre (a circle, a rect with four sides), a draw's name, [x, y] in m, "
        "{told: NAME} (the position that a robot has sent by radio), or a random point: {uniform_in: ZONES}, "
        "{on_line: [[x, y], [x, y]]}",
    )
    mirror: Mirror | None = described(None, "sets the spot to the mirror image of that place")

    EXAMPLE = """
spots:
  # Its position in every half until a rule sets it.
  kicked_from: {x_m: 0, y_m: 0}
counters: {longest_pass_m: {}}
rules:
  kicked:
    triggers: [{trigger: touches, entity: Y1, other: ball}]
    actions:
      - {action: set_spot, spot: kicked_from, to: ball}
      - {action: emit, event: KICKED, payload: {from: {position_of: kicked_from}}}
    says: Y1 plays the ball.
  received:
    triggers: [{trigger: touches, entity: Y2, other: ball}]
    conditions: [{distance: [ball, kicked_from], at_least: {counter: longest_pass_m}}]
    actions: [{action: count, counter: longest_pass_m, to: {distance: [ball, kicked_from]}}]
expect:
  the_longer_of_two_passes_counts:
    keyframes:
      - {at_s: 1, place: {ball: [-0.3, 0]}, touch: [[Y1, ball]]}
      - {at_s: 2, place: {ball: [0.3, 0]}, touch: [[Y2, ball]]}
      - {at_s: 3, place: {ball: [0.2, -0.1]}, touch: [[Y1, ball]]}
      - {at_s: 4, place: {ball: [0.2, -0.4]}, touch: [[Y2, ball]]}
    lasts_s: 5
    counters: {longest_pass_m: 0.6}
    poses: {kicked_from: [0.2, -0.1]}
"""

    def compile(self, to: Binder) -> Act:
        """Return a function that sets a spot to a place, its mirror image, or a random place inside the walls.

        What is off the field leaves it where it is.
        """
        state, name = to.state, self.spot
        where = self._where(to)
        is_random = isinstance(self.to, UniformIn | OnLine)
        is_apart = self.to.apart(to) if isinstance(self.to, UniformIn | OnLine) else None

        def act(_firing: Firing) -> None:
            if is_random and (decided := state.decided_spots.get(name)):
                state.spots[name] = decided.pop(0)
                return
            sign_x, sign_y = (1.0, 1.0) if self.mirror is None else self.mirror.signs(state)
            for _ in range(_MAX_TRIES if is_random else 1):
                point = where()
                if point is None:
                    return
                there = (point[0] * sign_x + 0.0, point[1] * sign_y + 0.0)  # adding 0 makes no -0
                if is_apart is None or (to.is_on_floor(there) and is_apart(there, state, None)):
                    state.spots[name] = there
                    return

        return act

    def _where(self, to: Binder) -> Callable[[], tuple[float, ...] | None]:
        """Return a function that finds the place that the spot is set to; None if there is none at present."""
        match self.to:
            case SentPlace():
                messages, robot = to.state.messages, to.members(self.to.told)[0]
                return lambda: position_in(messages.get(robot, ""))
            case UniformIn() | OnLine():
                sample, state, stream = self.to.sampler(to), to.state, f"spot/{self.spot}"
                return lambda: sample(state.stream(stream))
            case _:
                return to.locate(self.to)

    def effects(self) -> tuple[SetsSpot]:
        at = AtPoint(point=self.to) if isinstance(self.to, tuple) else self.to
        return (SetsSpot(self.spot, None if isinstance(at, SentPlace) else at, self.mirror),)

    def describe(self, phrases: Phrases) -> str:
        if isinstance(self.to, SentPlace):
            where = f"the position that {phrases.thing(self.to.told)} has told the referee"
        elif isinstance(self.to, str):
            where = phrases.owned("centre" if phrases.may_be_zone(self.to) else "place", self.to)
        elif isinstance(self.to, UniformIn | OnLine):
            where = self.to.aim(phrases)
        else:
            where = phrases.point(self.to)
        mirrored = f", mirrored {self.mirror.describe(phrases)}," if self.mirror is not None else ""
        return f"{where}{mirrored} is remembered as {phrases.thing(self.spot)}"


_MAX_TRIES = 1000
"""So often chance looks for a point inside the walls, of a zone that may lie outside for the most part."""
