"""The action ``reset``."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from rcj_challenges.rules.actions.count import change_kept
from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.effects import Writes
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.phrasing import listed
from rcj_challenges.rules.refs import WHOSE_OF, WRITTEN_COUNTER, WRITTEN_FLAG, WRITTEN_SEQUENCE


class Reset(Action):
    """Take counters, flags and sequences back to their beginning: their first value, or before their first step.

    A sequence whose entity is at its first step begins there.
    """

    action: Literal["reset"]
    counter: Annotated[Names | None, WRITTEN_COUNTER] = described(None, "a counter, or a list of counters")
    flag: Annotated[Names | None, WRITTEN_FLAG] = described(None, "a flag, or a list of flags")
    sequence: Annotated[Names | None, WRITTEN_SEQUENCE] = described(None, "a sequence, or a list of sequences")
    entity: Annotated[Names | None, WHOSE_OF] = described(
        None,
        "for what is kept per entity: which entities; if omitted: that of the for_each member, or without one that of "
        "all of them",
    )

    REQUIRES = (("counter",), ("flag",), ("sequence",))
    EXAMPLE = """
zones:
  west: {shape: rect, x_max_m: -0.3}
  east: {shape: rect, x_min_m: 0.3}
counters: {passes: {}}
sequences:
  across: {entity: ball, steps: [west, east]}
rules:
  touched_by_blue:
    triggers: [{trigger: touches, entity: blue, other: ball}]
    actions: [{action: reset, counter: passes, sequence: across}]
  touched_by_yellow:
    triggers: [{trigger: touches, entity: yellow, other: ball}]
    actions: [{action: count, counter: passes}]
  across:
    triggers: [{trigger: sequence_completed, sequence: across}]
    actions: [{action: score, entrant: yellow, points: {counter: passes}}]
expect:
  a_touch_by_blue_undoes_the_first_step_and_the_passes:
    keyframes:
      - {at_s: 1, place: {ball: [-0.5, 0]}, touch: [[Y1, ball]]}
      - {at_s: 2, place: {ball: [0, 0]}, touch: [[B1, ball]]}
      - {at_s: 3, place: {ball: [0.5, 0]}}
    lasts_s: 4
    score: {yellow: 0}
    counters: {passes: 0}
"""

    def _named(self) -> Iterator[tuple[str, str]]:
        """Yield the kind and the name of all that is reset."""
        for kind in ("counter", "flag", "sequence"):
            names = getattr(self, kind)
            yield from ((kind, name) for name in ((names,) if isinstance(names, str) else names or ()))

    def compile(self, to: Binder) -> Act:
        trackers, values = [], []
        for kind, name in self._named():
            if kind == "sequence":
                followed = to.sequences(name)
                trackers += [followed[one] for one in self._of(kind, name, followed, to)]
            else:
                kept: Any = getattr(to.state, f"{kind}s")
                owners = to.owners(f"{kind}s", name, self.entity)
                values.append((kept, name, owners, to.state.first[f"{kind}s"][name]))

        def act(_firing: Firing) -> None:
            for kept, name, owners, first in values:
                change_kept(kept, name, owners, lambda _value: first)  # noqa: B023 - called at once
            to.trackers.reset(*trackers)

        return act

    def _of(self, kind: str, name: str, kept: Any, to: Binder) -> tuple[Any, ...]:
        """Return the owners of what is reset; None for one that is not kept for several."""
        owners = to.owners(f"{kind}s", name, self.entity)
        return tuple(kept) if owners is None else owners

    def effects(self) -> tuple[Writes, ...]:
        return tuple(Writes(f"{kind}s", name) for kind, name in self._named())

    def describe(self, phrases: Phrases) -> str:
        reset = [phrases.every_kept(kind, name, self.entity) for kind, name in self._named()]
        return f"{listed(reset, 'and')} {'start' if len(reset) > 1 else 'starts'} again"
