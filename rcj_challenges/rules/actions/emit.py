"""The action ``emit``."""

from typing import Literal

from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.effects import Emits
from rcj_challenges.rules.fields import EventName, Name, described
from rcj_challenges.rules.values import Value, compile_value, value_words


class Emit(Action):
    """Write an event to the reflog, for people and other rules (which see it one tick later)."""

    action: Literal["emit"]
    event: EventName = described(..., "its name")
    payload: dict[Name, Value] = described({}, "data of the event: literals, {counter: NAME} or any other value")

    EFFECT = Emits
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      - {action: score, entrant: yellow}
      - action: emit
        event: GOAL
        payload:
          team_name: {word: team_name, of: yellow}
          score: {word: score, of: yellow}
          points: 1
expect:
  the_payload_shows_the_new_score:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    events: [{event: GOAL, payload: {team_name: Yellow, score: 1, points: 1}}]
"""

    def compile(self, to: Binder) -> Act:
        name = self.event
        payload = {key: compile_value(value, to) for key, value in self.payload.items()}

        # What an entrant emits is about its robots.
        own = () if to.rule.each is None else to.members("each")

        def act(firing: Firing) -> None:
            about = own if firing.subject is None else tuple(dict.fromkeys((firing.subject, *own)))
            to.emit(name, {key: read(firing) for key, read in payload.items()}, about)

        return act

    def describe(self, phrases: Phrases) -> str:
        entries = ", ".join(f"{key}: {value_words(phrases, entry)}" for key, entry in self.payload.items())
        return f"{self.event} is announced" + (f" ({entries})" if entries else "")
