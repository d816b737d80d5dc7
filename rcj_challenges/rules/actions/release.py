"""The action ``release``."""

from typing import Annotated, Literal

from rcj_challenges.rules.actions.hold import Hold
from rcj_challenges.rules.base import Act, Action, Binder, Phrases
from rcj_challenges.rules.effects import Releases
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ROBOTS


class Release(Action):
    """Release robots that are held by rules: they can drive again from the next tick on.

    What a phase with `robots: held` holds stays held until the phase is over.
    """

    action: Literal["release"]
    entity: Annotated[Names, ROBOTS] = described(..., "what is released: robots, groups, or each")

    EFFECT = Releases
    EXAMPLE = Hold.EXAMPLE

    def compile(self, to: Binder) -> Act:
        robots, held, trackers = to.entities(self.entity), to.state.held, to.trackers
        return lambda _firing: trackers.release(held.release(robots))

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.all_of(self.entity).does('is', 'are')} let go"
