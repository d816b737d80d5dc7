"""The action ``set_flag``."""

from collections.abc import Callable
from typing import Annotated, Literal

from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import WHOSE, WRITTEN_FLAG


class SetFlag(Action):
    """Set or clear a flag."""

    action: Literal["set_flag"]
    flag: Annotated[Name, WRITTEN_FLAG] = described(..., "the flag")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a flag kept per entity: which entity, or each; if omitted: all of them"
    )
    to: bool = described(True, "the new value")

    EXAMPLE = """
flags: {armed: {}, side: {}}
rules:
  arm:
    triggers: [{trigger: enters, entity: ball, zone: blue_penalty_area}]
    actions: [{action: set_flag, flag: armed, to: true}, {action: toggle_flag, flag: side}]
expect:
  both_are_true:
    keyframes: [{at_s: 1, place: {ball: [0, 0.65]}}]
    lasts_s: 2
    flags: {armed: true, side: true}
"""
    SENTENCE = "the flag “armed” is set"

    def compile(self, to: Binder) -> Act:
        new = self.to
        return change_flag(to, self.flag, self.entity, lambda _value: new)

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.every_kept('flag', self.flag, self.entity)} is {'set' if self.to else 'cleared'}"


def change_flag(to: Binder, name: str, entity: str | None, new: Callable[[bool], bool]) -> Act:
    """Return a function that changes a flag, of one or of all that have one."""
    flags, whose = to.state.flags, to.whose(entity)

    def act(_firing: Firing) -> None:
        value = flags[name]
        if isinstance(value, dict):
            for member in value if whose is None else (whose,):
                value[member] = new(value[member])
        else:
            flags[name] = new(value)

    return act
