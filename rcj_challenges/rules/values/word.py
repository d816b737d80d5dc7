"""The value ``word``: a fact of the match."""

from collections.abc import Callable
from typing import Annotated, Any, Literal, NamedTuple

from rcj_challenges.core.amounts import plain
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules import phrasing
from rcj_challenges.rules.base import Firing, Number, Phrases, Reader, Scope
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.number import NumberValue, as_number
from rcj_challenges.rules.refs import ENTRANT
from rcj_challenges.tracking.state import RefereeState


class WordValue(NumberValue):
    """A fact about the match, named by a keyword."""

    word: Literal[
        "robot_name", "entity_name", "each_name", "other_name", "team_name", "entrant", "score", "halftime", "match_id",
        "total_match_time_s", "time_s", "time_left_s", "measured", "limit", "phase", "seed_id",
    ] = described(...,
        "the keyword; times include fractions of a second; measured, limit: the value that the trigger measured and "
        "its limit (for holds, in s); each_name: the name of the for_each member; other_name: the name of the touched "
        "thing, in rules about touches")  # fmt: skip
    of: Annotated[Name | None, ENTRANT] = described(
        None, "for team_name and score: the entrant; if omitted: that of the current entity"
    )

    KEY = "word"
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{word: halftime, equals: 1}]
    actions:
      # 60 points, less 1 for each whole second: 9.9 s counts as 9.
      - {action: score, entrant: yellow, points: {word: time_s, times: -1, plus: 60, round: up}}
      - {action: emit, event: GOAL, payload: {team: {word: team_name, of: yellow}, half: {word: halftime}}}
expect:
  after_9_seconds_it_gives_51_points:
    keyframes: [{at_s: 9.9, place: {ball: [0, 0.8]}}]
    lasts_s: 11
    score: {yellow: 51}
    events: [{event: GOAL, payload: {team: Yellow, half: 1}}]
"""

    def stands_for(self, bound: str) -> bool:
        return bound == FACTS[self.word].about and (self.of is None or bound == "other")

    def as_it_is(self, to: Scope) -> Reader:
        read, of = FACTS[self.word].read, self.of
        return lambda firing: read(to, firing, of)

    def measure(self, to: Scope) -> Reader:
        read = self.as_it_is(to)
        return lambda firing: as_number(read(firing))

    def exactly(self, phrases: Phrases) -> tuple[str, ...]:
        return phrases.phases() if self.word == "phase" else ()

    def describe(self, phrases: Phrases) -> str:
        words = phrases.measured if self.word == "measured" else FACTS[self.word].says.format(half=phrases.period)
        return f"{words} of {phrasing.plain(self.of)}" if self.of else words


class NumberWord(WordValue):
    """A number of the match by its word."""

    word: Literal[
        "score", "halftime", "total_match_time_s", "time_s", "time_left_s", "measured", "limit"
    ] = described(..., "the word; measured and limit: none if nothing was measured")  # fmt: skip
    of: Annotated[Name | None, ENTRANT] = described(
        None, "for score: the entrant; if omitted: that of the current entity"
    )

    def holds_always(self, by: Compared) -> bool:
        """Return whether it holds in any half, as rules say it that count time."""
        return self._is_plain_half(by) and by.at_least == 1 and len(by.limits()) == 1 and not by.negate

    def _is_plain_half(self, by: Compared) -> bool:
        is_half = self.word == "halftime" and not self.is_computed() and by.above is None and by.below is None
        return is_half and all(isinstance(limit, int) for _, limit in by.limits())

    def describe_compared(self, phrases: Phrases, by: Compared) -> str:
        if not self._is_plain_half(by):
            return ""
        half = phrases.period
        if by.at_least is not None and by.at_least == by.at_most:
            which = f"{half} {by.at_least}"
        elif by.at_least is not None and by.at_most is not None:
            which = f"one of the {half.many} {by.at_least} to {by.at_most}"
        elif by.at_least is not None:
            which = f"{half} {by.at_least} or a later one"
        else:
            which = f"{half} {by.equals}" if by.at_most is None else f"{half} {by.at_most} or an earlier one"
        return f"it is {'not ' if by.negate else ''}{which}"


def entrant_of(state: RefereeState, firing: Firing, of: str | None) -> str:
    """Return an entrant: the named one, else that of the robot that the firing is about; an empty text if none is."""
    if of is not None:
        return of
    return firing.rule.entrant or state.entrant_of.get(firing.entity or "", "")


def team_name_of(state: RefereeState, firing: Firing, of: str | None) -> str:
    """Return the name of the team that plays as an entrant."""
    entrant = entrant_of(state, firing, of)
    return state.half.team_names.get(entrant, entrant)


def _robot_name(to: Scope, firing: Firing, _of: str | None) -> str:
    names = (name for name in (firing.rule.each, firing.entity) if name in to.state.robots)
    return next(names, "")


def _score(to: Scope, firing: Firing, of: str | None) -> Number:
    return to.state.scores.get(entrant_of(to.state, firing, of), 0)


def _rounded(number: float | None) -> Number | None:
    return None if number is None else plain(round(number, 6))


class _Fact(NamedTuple):
    read: Callable[[Scope, Firing, str | None], Any]
    says: str
    about: str = ""


FACTS: dict[str, _Fact] = {
    "robot_name": _Fact(_robot_name, "the name of the robot", "each"),
    "entity_name": _Fact(lambda _to, firing, _of: firing.subject or "", "the name of the one concerned", "each"),
    "each_name": _Fact(
        lambda _to, firing, _of: firing.rule.each or "", "the name of the one that the rule is for", "each"
    ),
    "other_name": _Fact(lambda _to, firing, _of: firing.rule.other or "", "the name of the other one", "other"),
    "team_name": _Fact(lambda to, firing, of: team_name_of(to.state, firing, of), "the team name", "each"),
    "entrant": _Fact(lambda to, firing, of: entrant_of(to.state, firing, of), "the entrant", "each"),
    "score": _Fact(_score, "the score", "each"),
    "halftime": _Fact(lambda to, _firing, _of: to.state.half.half, "the number of the {half}"),
    "match_id": _Fact(lambda to, _firing, _of: to.state.half.match_id, "the number of the match"),
    "total_match_time_s": _Fact(lambda to, _firing, _of: to.state.half_length_s, "the length of the {half} in s"),
    "time_s": _Fact(lambda to, _firing, _of: s_from_ticks(to.state.clock), "the time in s"),
    "time_left_s": _Fact(
        lambda to, _firing, _of: s_from_ticks(max(0, to.state.half.ticks - to.state.clock)), "the time left in s"
    ),
    "measured": _Fact(lambda _to, firing, _of: _rounded(firing.measured), "what was measured"),
    "limit": _Fact(lambda _to, firing, _of: _rounded(firing.limit), "the limit"),
    "phase": _Fact(lambda to, _firing, _of: to.state.phase, "the phase"),
    "seed_id": _Fact(lambda to, _firing, _of: to.state.seed_id(), "a mark of the seed"),
}
"""By word: the function that reads it, and its text on the sheet."""
