"""The action ``count``."""

from typing import Annotated, Literal

from rcj_challenges.core.amounts import round_score
from rcj_challenges.rules.base import Act, Action, Binder, Firing, Number, Phrases
from rcj_challenges.rules.bounds import amount_bound, bounds_words, change_bound, subtracted_parts
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import WHOSE, WRITTEN_COUNTER
from rcj_challenges.rules.values import Points, amount_words, compile_points


class Count(Action):
    """Change a counter."""

    action: Literal["count"]
    counter: Annotated[Name, WRITTEN_COUNTER] = described(..., "the counter")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a counter kept per entity: which entity, or each; if omitted: all of them"
    )
    by: Points | None = described(
        None,
        "what is added: a number, {counter, flag, draw, timer, way or word: NAME}, {distance: [A, B]}, or a "
        "list of these, which may have weights, to be summed; 1 if neither `by` nor `to` is given",
    )
    to: Points | None = described(
        None,
        "the new value: a number, {counter, flag, draw, timer, way or word: NAME}, {distance: [A, B]}, or a "
        "list of these, which may have weights, to be summed",
    )
    at_least: float | None = described(None, "smallest amount of `by` or `to`, whatever the sum is")
    at_most: float | None = described(None, "largest amount of `by` or `to`, whatever the sum is")
    keeps_at_least: float | None = described(
        None, "with `by`: the counter does not fall below this; a value that is already lower stays unchanged"
    )
    keeps_at_most: float | None = described(
        None, "with `by`: the counter does not rise above this; a value that is already higher stays unchanged"
    )

    EXCLUDES = (("to", ("by", "keeps_at_least", "keeps_at_most")),)
    EXAMPLE = """
counters: {rounds: {}}
rules:
  round:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # Actions read current values: the first round gives 1 point, the second 2.
    actions: [{action: count, counter: rounds, by: 1}, {action: score, entrant: yellow, points: {counter: rounds}}]
expect:
  two_rounds_give_three_points:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.8]}}
      - {at_s: 2, place: {ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    score: {yellow: 3}
    counters: {rounds: 2}
"""
    SENTENCE = "the counter “rounds” grows by 1"

    def compile(self, to: Binder) -> Act:
        """Return a function that changes a counter: first ``to``, then ``by``."""
        counters, name, whose = to.state.counters, self.counter, to.whose(self.entity)
        new = None if self.to is None else compile_points(self.to, to)
        by = 1 if self.by is None and self.to is None else self.by
        step = None if by is None else compile_points(by, to)
        within, bounded = amount_bound(self), change_bound(self)

        def changed(value: Number, firing: Firing) -> Number:
            value = value if new is None else within(new(firing))
            return round_score(value if step is None else value + bounded(step(firing), value))

        def act(firing: Firing) -> None:
            value = counters[name]
            if isinstance(value, dict):
                for member in value if whose is None else (whose,):
                    value[member] = changed(value[member], firing)
            else:
                counters[name] = changed(value, firing)

        return act

    def describe(self, phrases: Phrases) -> str:
        counter = phrases.every_kept("counter", self.counter, self.entity)
        bounds = bounds_words(self, "counter")
        if self.to is not None:
            return f"{counter} is set to {amount_words(phrases, self.to)}{bounds}"
        if isinstance(self.by, int | float) and self.by < 0:
            return f"{counter} falls by {amount_words(phrases, -self.by)}{bounds}"
        if taken := subtracted_parts(self, self.by):
            return f"{counter} falls by {amount_words(phrases, taken)}{bounds}"
        return f"{counter} grows by {amount_words(phrases, 1 if self.by is None else self.by)}{bounds}"
