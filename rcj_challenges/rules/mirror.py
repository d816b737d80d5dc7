"""Mirrored places: formations that change ends."""

from collections.abc import Callable
from typing import Annotated, Literal

from rcj_challenges.rules.base import Phrases
from rcj_challenges.rules.fields import Name, Point, Strict, described
from rcj_challenges.rules.phrasing import listed
from rcj_challenges.rules.places import At, place_of
from rcj_challenges.rules.refs import FLAG
from rcj_challenges.tracking.state import RefereeState


class Mirror(Strict):
    """Mirrors the place and the aim but not the facing, either always or only while a flag is set."""

    axis: Literal["x", "y", "both"] = described(..., "x: x becomes -x; y: y becomes -y; both: both change sign")
    when: Annotated[Name | None, FLAG] = described(
        None, "a flag: mirrored if it is set when the action runs; if omitted: always"
    )

    def compile(self, state: RefereeState) -> Callable[[], Point]:
        """Return a function that reads the signs of x and y now."""
        flipped = (-1.0 if self.axis in {"x", "both"} else 1.0, -1.0 if self.axis in {"y", "both"} else 1.0)
        flag = self.when
        if flag is None:
            return lambda: flipped
        return lambda: flipped if state.flag(flag, None) else (1.0, 1.0)

    def describe(self, phrases: Phrases) -> str:
        """Return a mirror's effect and its condition, in brackets: ``(x becomes -x) if the flag “changed” is set``."""
        turned = listed([f"{axis} becomes -{axis}" for axis in ("x", "y") if self.axis in (axis, "both")], "and")
        return f"({turned})" + (f" if {phrases.kept('flag', self.when, None)} is set" if self.when else "")


def mirrored_words(phrases: Phrases, mirror: Mirror | None, at: At) -> str:
    """Return the mirroring of a place in words; an empty text if it is not, or if that changes nothing."""
    changed = None if mirror is None else place_of(at).mirrored(phrases)
    return "" if mirror is None or changed is None else f", mirrored{changed} {mirror.describe(phrases)}"
