"""The condition ``any_of``."""

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import described
from rcj_challenges.rules.several_conditions import Alternative, all_hold, as_one, one_holds, opposites, watched_by


class AnyOf(Condition):
    """Whether at least one of several conditions holds; a list among them holds if all in it hold."""

    any_of: tuple[Alternative, ...] = described(
        ..., "conditions, each as in a rule, and lists of conditions", min_length=1
    )

    KEY = "any_of"
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions:
      # Beside a condition, a list of conditions may stand, of which all must hold.
      - any_of: [{speed: ball, at_least: 0.3}, {last_touch: ball, equals: Y3}]
    actions: [{action: score, entrant: yellow}]
expect:
  a_slow_goal_by_y3_counts_but_not_one_by_y1:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.7]}, touch: [[Y1, ball]]}
      - {at_s: 2, move: {ball: [0, 0.8]}}
      - {at_s: 3, place: {ball: [0, 0.7]}, touch: [[Y3, ball]]}
      - {at_s: 4, move: {ball: [0, 0.8]}}
    lasts_s: 5
    score: {yellow: 1}
"""

    @property
    def alternatives(self) -> tuple[Condition, ...]:
        """The conditions of which one must hold."""
        return tuple(as_one(one) for one in self.any_of)

    def is_several(self) -> bool:
        return len(self.any_of) > 1 or self.alternatives[0].is_several()

    def test(self, to: Binder) -> Test:
        tests = tuple(condition.compile(to) for condition in self.alternatives)
        return lambda: any(test() for test in tests)

    def watched(self, to: Binder) -> tuple[int, ...]:
        return watched_by(to, self.alternatives)

    def describe(self, phrases: Phrases) -> str:
        parts = self.alternatives
        if self.negate and (len(parts) == 1 or any(_is_negative(one) or one.is_several() for one in parts)):
            # None of them holds: of each the opposite does.
            return all_hold(phrases, opposites(parts))
        if self.negate:
            return "neither " + " nor ".join(one.describe(phrases) for one in parts)
        return one_holds(phrases, parts)


def _is_negative(condition: Condition) -> bool:
    """Return whether a condition says that something is not so: ``neither`` before it would deny that again."""
    return condition.negate or getattr(condition, "of", None) == "none"
