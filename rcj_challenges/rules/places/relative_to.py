"""The place ``relative_to``."""

from typing import Annotated

from rcj_challenges.geometry.polygons import turned
from rcj_challenges.rules.base import Phrases, PlaceRequest, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Name, Names, Point, described
from rcj_challenges.rules.phrasing import listed, metres_alike
from rcj_challenges.rules.refs import ANCHOR
from rcj_challenges.tracking.places import point_of


class RelativeTo(PlaceWord):
    """At an offset from another entity or spot. A ball placed relative to itself with a kick changes direction."""

    relative_to: Annotated[Name, ANCHOR] = described(
        ..., "an entity, a spot, each, or a draw's name (then the thing drawn)"
    )
    offset_m: Point = described(
        (0.0, 0.0),
        "offset from it, [x, y] in m; a mirror applies to a spot together with its offset, but for an entity "
        "only to the offset",
    )
    turns: bool = described(False, "True: the offset is in the entity's own frame, x forward, and is never mirrored")

    KEY = "relative_to"
    EXAMPLE = """
rules:
  free_kick:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: place, entity: ball, at: {relative_to: Y1, offset_m: [0.1, 0], turns: true}}]
expect:
  a_tenth_of_a_metre_in_front_of_it:
    keyframes: [{at_s: 0.5, place: {Y1: [-0.5, -0.1, 0]}}]
    lasts_s: 2
    poses: {ball: [-0.4, -0.1]}
"""

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        """Return a function that finds the point beside something.

        A mirror turns the offset over; a spot is mirrored with it, an entity is not.
        """
        anchored, (dx, dy) = to.anchor(self.relative_to), self.offset_m

        def find(request: PlaceRequest) -> Point:
            anchor = anchored()
            x, y = point_of(anchor, request.board)
            if not isinstance(anchor, int):
                return request.mirrored((x + dx, y + dy))
            if self.turns:
                return turned([(dx, dy)], (x, y, request.board.poses[anchor][2]))[0]
            offset_x, offset_y = request.mirrored((dx, dy))
            return (x + offset_x, y + offset_y)

        return PlaceResolver(find)

    def describe(self, phrases: Phrases) -> str:
        thing = phrases.thing(self.relative_to)
        return self._beside(f"at {thing}", thing, thing)

    def aim(self, phrases: Phrases) -> str:
        return f"the point {self.describe(phrases)}" if any(self.offset_m) else phrases.thing(self.relative_to)

    def describe_placement(self, phrases: Phrases, entity: Names, *, plural: bool) -> str:
        """Return the placement in words; of a thing beside itself: ``put 5 cm towards +x of where it is``."""
        if entity != self.relative_to:
            return super().describe_placement(phrases, entity, plural=plural)
        return f"{'each ' if plural else ''}put {self._beside('where it is', 'where it is', 'it')}"

    def _beside(self, at: str, of: str, turned: str) -> str:
        ways = (("to the front", "to the back"), ("to the left", "to the right"))
        if not self.turns:
            ways = (("towards +x", "towards -x"), ("towards +y", "towards -y"))
        how_far = metres_alike([abs(far) for far in self.offset_m])
        steps = [
            f"{words} {way[0] if far > 0 else way[1]}"
            for far, words, way in zip(self.offset_m, how_far, ways, strict=True)
            if far
        ]
        if not steps:
            return f"right {at}"
        return f"{listed(steps, 'and')} of {of}" + (f", as {turned} is turned" if self.turns else "")

    def is_where_it_is(self, entity: Names) -> bool:
        return entity == self.relative_to and not any(self.offset_m)

    def mirrored(self, phrases: Phrases) -> str | None:
        """Return the part that a mirror changes: of a place beside an entity only the way there, if that turns not."""
        if not phrases.is_entity(self.relative_to):
            return ""
        return None if self.turns or not any(self.offset_m) else f" as seen from {phrases.thing(self.relative_to)}"
