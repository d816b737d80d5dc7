"""The action ``toggle_flag``."""

from typing import Annotated, Literal

from rcj_challenges.rules.actions.set_flag import SetFlag, change_flag
from rcj_challenges.rules.base import Act, Action, Binder, Phrases
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import WHOSE, WRITTEN_FLAG


class ToggleFlag(Action):
    """Invert a flag."""

    action: Literal["toggle_flag"]
    flag: Annotated[Name, WRITTEN_FLAG] = described(..., "the flag")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a flag kept per entity: which entity, or each; if omitted: all of them"
    )

    EXAMPLE = SetFlag.EXAMPLE
    SENTENCE = "the flag “side” is turned over"

    def compile(self, to: Binder) -> Act:
        return change_flag(to, self.flag, self.entity, lambda value: not value)

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.every_kept('flag', self.flag, self.entity)} is turned over"
