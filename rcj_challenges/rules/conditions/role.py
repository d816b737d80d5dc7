"""The condition ``role``."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Name, Scalar, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import ROLE, DrawnValue
from rcj_challenges.rules.values.role import RoleValue


class RoleIs(Condition):
    """Which of its members has a role."""

    role: Annotated[Name, ROLE] = described(..., "a role")
    equals: Annotated[Scalar, DrawnValue()] = described(
        ...,
        "the member that must have it; each: the name of the for_each member; other: the touched thing; none: no one",
    )

    KEY = "role"
    EXAMPLE = RoleValue.EXAMPLE

    def test(self, to: Binder) -> Test:
        draws, name = to.state.draws, self.role
        wanted = None if self.equals == "none" else to.drawn_value(self.equals)
        return lambda: draws[name] == wanted

    def describe(self, phrases: Phrases) -> str:
        holder = "nothing" if self.equals == "none" else phrases.holder(self.role, str(self.equals))
        return f"{holder} is {'not ' if self.negate else ''}{quoted_measure(self.role)}"
