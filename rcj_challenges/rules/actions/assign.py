"""The action ``assign``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import WRITTEN_ROLE, DrawnValue
from rcj_challenges.rules.values import Value, compile_value, value_words


class Assign(Action):
    """Give a role to another of its members."""

    action: Literal["assign"]
    role: Annotated[Name, WRITTEN_ROLE] = described(..., "the role")
    to: Annotated[Value, DrawnValue(is_set=True)] = described(
        "next",
        "its holder from now on: next: the next in its order; the name of a member; each, other, of two entrants "
        "others; none: it stands for nothing; or a value that is a name, such as {last_touch: ball}: if that is no "
        "member's, nothing changes",
    )

    EXAMPLE = """
roles: {thrower: {of: [Y1, B1], order: listed, cyclic: true}}
rules:
  thrown:
    triggers: [{trigger: touches, entity: thrower, other: ball}]
    actions: [{action: score, entrant: thrower}, {action: assign, role: thrower}]
expect:
  they_throw_in_turn:
    keyframes:
      - {at_s: 1, touch: [[B1, ball]]}
      - {at_s: 2, touch: [[Y1, ball]]}
      - {at_s: 3, touch: [[Y1, ball]]}
      - {at_s: 4, touch: [[B1, ball]]}
    lasts_s: 5
    score: {yellow: 1, blue: 1}
    roles: {thrower: Y1}
"""

    def compile(self, to: Binder) -> Act:
        role, given = self.role, self.to
        if given == "next":
            return lambda _firing: to.assign_next(role)
        if given == "none":
            return lambda _firing: to.assign(role, None)
        read = compile_value(given if isinstance(given, ValueWord) else to.drawn_value(given), to)
        members = to.roles[role]

        def act(firing: Firing) -> None:
            name = read(firing)
            if name in members:
                to.assign(role, name)

        return act

    def describe(self, phrases: Phrases) -> str:
        role = quoted_measure(self.role)
        if self.to in ("next", "none"):
            return f"{'the next of them' if self.to == 'next' else 'nothing'} becomes {role}"
        name = self.to if isinstance(self.to, str) else None
        return f"{phrases.holder(self.role, name) if name else value_words(phrases, self.to)} becomes {role}"
