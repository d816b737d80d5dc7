"""The action ``set_flag``."""

from typing import Annotated, Literal

from rcj_challenges.rules.actions.count import change_kept
from rcj_challenges.rules.base import Act, Action, Binder, Phrases
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.refs import WHOSE_OF, WRITTEN_FLAG


class SetFlag(Action):
    """Set or clear a flag."""

    action: Literal["set_flag"]
    flag: Annotated[Name, WRITTEN_FLAG] = described(..., "the flag")
    entity: Annotated[Names | None, WHOSE_OF] = described(
        None, "if it is kept per entity: whose; if omitted: that of each in a rule for_each of its owners, else all"
    )
    to: Literal["opposite"] | bool = described(True, "the new value; opposite: the other one than before")

    EXAMPLE = """
flags: {armed: {}, side: {}}
rules:
  arm:
    triggers: [{trigger: enters, entity: ball, zone: blue_penalty_area}]
    actions: [{action: set_flag, flag: armed}, {action: set_flag, flag: side, to: opposite}]
expect:
  both_are_true:
    keyframes: [{at_s: 1, place: {ball: [0, 0.65]}}]
    lasts_s: 2
    flags: {armed: true, side: true}
"""

    def compile(self, to: Binder) -> Act:
        flags, name, new, whose = to.state.flags, self.flag, self.to, to.owners("flags", self.flag, self.entity)

        def changed(value: bool) -> bool:
            return not value if new == "opposite" else new

        return lambda _firing: change_kept(flags, name, whose, changed)

    def describe(self, phrases: Phrases) -> str:
        done = {True: "set", False: "cleared", "opposite": "turned over"}[self.to]
        return f"{phrases.every_kept('flag', self.flag, self.entity)} is {done}"
