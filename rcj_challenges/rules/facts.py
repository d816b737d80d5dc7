"""Facts about what is on the field: where it is, what it touches, whether it is held, what it looks at."""

from collections.abc import Callable
from math import atan2, cos, pi, sin
from typing import Annotated, Any, ClassVar

from pydantic import Field

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.fields import Name, Names, Point, Strict, Yes, described
from rcj_challenges.rules.phrasing import degrees, heading, listed
from rcj_challenges.rules.refs import SEEN, THINGS, ZONES
from rcj_challenges.tracking.contacts import APART_S, substeps_apart

Fact = Callable[[int], bool]
"""Whether something, given by its index, is so now."""


class Facts(Strict):
    """Facts of which all that are given must be true of a thing.

    Attributes:
        OWNER: the field with the things.
        OF_ROBOTS: keys that only robots have.
    """

    OWNER: ClassVar = ""
    OF_ROBOTS: ClassVar = ("held", "looks")
    REQUIRES: ClassVar[tuple[tuple[str, ...], ...]] = (("in_",), ("touching",), ("held",), ("looks",))

    in_: Annotated[Names | None, ZONES] = Field(
        None, alias="in", description="its centre is in one of these zones; false off the field"
    )
    touching: Annotated[Names | None, THINGS] = described(
        None, f"it touches one of these, or did less than {APART_S} s ago; false off the field"
    )
    held: Yes | None = described(None, "a rule or the phase holds it, on the field or off it")
    looks: Annotated[Name | Point | float | None, SEEN] = described(
        None, "its front points at this thing, spot or point, or in this direction in rad; false off the field"
    )
    within_rad: float = described(0.2, "how far off its front may point, to either side, in rad", gt=0, le=pi)

    def facts(self, to: Scope) -> tuple[Fact, ...]:
        """Return the tests of the facts that are given."""
        made: tuple[tuple[Any, Callable[[Scope, Any], Fact]], ...] = (
            (self.in_, _in_zone), (self.touching, _touching), (self.held, lambda scope, _yes: scope.state.held.holds),
            (self.looks, lambda scope, at: looks_at(scope, at, self.within_rad)),
        )  # fmt: skip
        return tuple(make(to, what) for what, make in made if what is not None)

    def describe_facts(self, phrases: Phrases) -> str:
        """Return the facts in words, as what follows ``that are``; empty: none is given."""
        said = []
        if self.in_ is not None:
            said.append(f"in {phrases.any_of(self.in_)}")
        if self.touching is not None:
            said.append(f"touching {phrases.any_of(self.touching)}")
        if self.held is not None:
            said.append("held")
        if self.looks is not None:
            at = heading(self.looks) if isinstance(self.looks, int | float) else f"towards {phrases.point(self.looks)}"
            said.append(f"looking {at} (to within {degrees(self.within_rad)})")
        return listed(said, "and")


def _in_zone(to: Scope, zones: Names) -> Fact:
    state, region = to.state, to.region(zones)

    def is_in(entity: int) -> bool:
        x, y, _ = state.poses[entity]
        return state.present[entity] and region.contains(x, y)

    return is_in


def _touching(to: Scope, names: Names) -> Fact:
    state, contacts, things, apart = to.state, to.state.contacts, to.entities(names), substeps_apart(APART_S)
    contacts.used = True

    def touches(entity: int) -> bool:
        pairs = ((min(entity, one), max(entity, one)) for one in things if one != entity)
        return state.present[entity] and any(contacts.is_one_contact(pair, apart) for pair in pairs)

    return touches


def looks_at(to: Scope, looks: Any, within_rad: float) -> Fact:
    """Return the test whether something looks at a thing, or in a direction in rad."""
    state = to.state
    if isinstance(looks, int | float):
        return lambda entity: state.present[entity] and _is_near(looks - state.poses[entity][2], within_rad)
    locate = to.locate(looks)

    def looks_there(entity: int) -> bool:
        x, y, yaw = state.poses[entity]
        at = locate() if state.present[entity] else None
        # Nothing looks at itself, also if it is what was drawn.
        return at is not None and at[:2] != (x, y) and _is_near(atan2(at[1] - y, at[0] - x) - yaw, within_rad)

    return looks_there


def _is_near(off_rad: float, within_rad: float) -> bool:
    return abs(atan2(sin(off_rad), cos(off_rad))) <= within_rad
