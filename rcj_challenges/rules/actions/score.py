"""The action ``score``."""

from collections.abc import Callable
from typing import Annotated, Literal

from rcj_challenges.core.amounts import plain as plain_number
from rcj_challenges.core.amounts import round_score
from rcj_challenges.rules.actions.count import bounds_words, change_bound
from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.effects import Scores
from rcj_challenges.rules.fields import Name, Strict, described
from rcj_challenges.rules.number import takes_away
from rcj_challenges.rules.phrasing import LAST_TOUCH_NOTE, counted
from rcj_challenges.rules.refs import SCORED, THING
from rcj_challenges.rules.values import Amount, amount_words, compile_amount


class LastToucher(Strict):
    """The entrant of the robot that was the last to touch something since it was placed."""

    NOTES = (LAST_TOUCH_NOTE,)

    last_touch: Annotated[Name, THING] = described(..., "what was touched: an entity, a fixed obstacle, or each")


class Score(Action):
    """Give points to an entrant."""

    action: Literal["score"]
    entrant: Annotated[Name | LastToucher, SCORED] = described(
        ...,
        "the entrant that gets them, by its seat in this half; each, other: the entrant, or that of the robot; "
        "others: the other entrants; entrants: each of them; "
        "{last_touch: ball}: the entrant of the robot that was the last to touch the ball since "
        "the ball was placed, if any",
        union_mode="left_to_right",
    )
    points: Amount = described(1, "how many; if there is no such number, none are given")
    keeps_at_least: float | None = described(
        None, "the action does not take the entrant's score below this; a score that is already lower stays unchanged"
    )
    keeps_at_most: float | None = described(
        None, "the action does not take the entrant's score above this; a score that is already higher stays unchanged"
    )

    EXAMPLE = """
counters: {streak: {initial: 2}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      - {action: score, entrant: yellow, points: 1}
      - {action: score, entrant: blue, points: -1}
      - {action: score, entrant: yellow, points: {lowest: [{counter: streak, times: 10, plus: 5}, 24]}}
  own_touch:
    triggers: [{trigger: touches, entity: Y1, other: walls}]
    # Takes 50 points away, or all if there are fewer.
    actions: [{action: score, entrant: yellow, points: -50, keeps_at_least: 0}]
expect:
  they_are_limited_to_24:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    score: {yellow: 25, blue: -1}
  the_score_does_not_fall_below_0:
    given: {score: {yellow: 30}}
    keyframes: [{at_s: 1, touch: [[Y1, walls]]}]
    lasts_s: 2
    score: {yellow: 0}
"""

    def compile(self, to: Binder) -> Act:
        """Return a function that gives points to an entrant; to none if nothing touched what they are given for."""
        state, receivers = to.state, self._receivers(to)
        points, bounded = compile_amount(self.points, to), change_bound(self)

        def act(firing: Firing) -> None:
            wanted = points(firing)
            for entrant in () if wanted is None else receivers():
                given = bounded(wanted, state.scores[entrant])
                state.scores[entrant] = round_score(state.scores[entrant] + given)
                firing.scored[entrant] = round_score(firing.scored.get(entrant, 0) + given)

        return act

    def _receivers(self, to: Binder) -> Callable[[], tuple[str, ...]]:
        """Return the function that finds the receivers: entrants by name, or those that drive robots."""
        if isinstance(self.entrant, LastToucher):
            drivers = to.state.entrant_of
            last = to.state.contacts.follow_last(to.entities(self.entrant.last_touch)[0])

            def driver_of_the_last() -> tuple[str, ...]:
                robot = last()
                driver = None if robot is None else drivers.get(to.state.names[robot])
                return () if driver is None else (driver,)

            return driver_of_the_last
        entrants = to.entrants(self.entrant)
        return lambda: entrants

    def effects(self) -> tuple[Scores]:
        points = self.points if isinstance(self.points, int | float) else None
        entrant = self.entrant if isinstance(self.entrant, str) else None
        depends_on_the_score = self.keeps_at_least is not None or self.keeps_at_most is not None
        given = None if points is None or depends_on_the_score else plain_number(points)
        return (Scores(entrant, given, may_gain=points is None or points > 0),)

    def describe(self, phrases: Phrases) -> str:
        receiver, points, bounds = self.receiver(phrases), self.points, bounds_words(self, "score")
        if takes_away(points):
            return f"{receiver} loses points: {amount_words(phrases, points, negate=True)}{bounds}"
        if not isinstance(points, int | float):
            return f"{receiver} gets points: {amount_words(phrases, points)}{bounds}"
        return f"{receiver} {'loses' if points < 0 else 'gets'} {counted(abs(points), 'point')}{bounds}"

    def points_row(self, phrases: Phrases) -> tuple[str, str]:
        return self.receiver(phrases), f"{amount_words(phrases, self.points)}{bounds_words(self, 'score')}"

    def receiver(self, phrases: Phrases) -> str:
        """Return the receiver of the points: ``yellow``, or ``the team of the last to touch the ball``."""
        if isinstance(self.entrant, LastToucher):
            return f"the team of the last to touch {phrases.thing(self.entrant.last_touch)}"
        return phrases.entrant(self.entrant)
