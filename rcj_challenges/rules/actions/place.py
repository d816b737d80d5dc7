"""The action ``place``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Act, Action, Binder, Phrases
from rcj_challenges.rules.effects import Places, PlacesLayout
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.placement import Placement, placement_words, places
from rcj_challenges.rules.refs import SectionRef
from rcj_challenges.rules.values.draw import DrawValue


class Place(Placement, Action):
    """Place entities: either a single placement or a layout, given by name."""

    action: Literal["place"]
    layout: Annotated[Name | DrawValue | None, SectionRef("layout", ("placements",))] = described(
        None, "a layout of `placements`, or {draw: NAME}, a draw whose values are layouts"
    )
    EXCLUDES = (("layout", ("entity", "at", "kick")),)
    REQUIRES = (("layout",), ("entity", "at"))
    EXAMPLE = """
rules:
  put_back:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      - {action: place, entity: ball, at: {spot: centre}}
      - {action: place, entity: Y1, at: {point: [0.4, -0.4]}, facing: {towards: centre}}
expect:
  both_are_there:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    poses: {ball: [0, 0], Y1: [0.4, -0.4]}
"""

    def compile(self, to: Binder) -> Act:
        return to.placing(*self.effects())

    def effects(self) -> tuple[Places | PlacesLayout]:
        match self.layout:
            case None:
                return (places(self),)
            case DrawValue(draw=draw):
                return (PlacesLayout(draw, is_drawn=True, mirror=self.mirror),)
            case layout:
                return (PlacesLayout(layout, is_drawn=False, mirror=self.mirror),)

    def describe(self, phrases: Phrases) -> str:
        if self.entity is not None and self.at is not None:
            return placement_words(phrases, self.entity, self.at, self)
        layout = self.layout
        which = f"the layout drawn as {quoted(layout.draw)}" if isinstance(layout, DrawValue) else quoted(layout or "")
        mirrored = "" if self.mirror is None else f", mirrored {self.mirror.describe(phrases)}"
        return f"things are put as in {which}{mirrored}"
