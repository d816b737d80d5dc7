"""A ball that rolls away from where it is put."""

from dataclasses import replace
from typing import Annotated, Any

from pydantic import Field

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.fields import Name, Strict, described
from rcj_challenges.rules.phrasing import listed, number, quoted_measure
from rcj_challenges.rules.places import At, place_of
from rcj_challenges.rules.refs import DRAW
from rcj_challenges.rules.values import amount_words
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.tracking.places import CompiledKick

MAX_KICK_MPS = 3
"""Up to what the walls are known to hold, with a margin (ADR 2)."""
_SPEEDS = replace(DRAW, numbers=(0.001, MAX_KICK_MPS))
_KickSpeed = Annotated[float, Field(gt=0, le=MAX_KICK_MPS)]


class DrawnSpeed(Strict):
    """The speed that a draw decided, when the ball is set down."""

    draw: Annotated[Name, _SPEEDS] = described(..., "a draw whose values are speeds in m/s, over 0 and up to 3")


class Kick(Strict):
    """Makes a placed ball roll away; mirroring its place also mirrors the aim. In tests, the ball stays where it is."""

    towards: At = described(..., "where it rolls to: any form of `at`; random places are redrawn each time")
    speed_mps: (
        _KickSpeed | Annotated[tuple[_KickSpeed, _KickSpeed], Field(strict=False)] | DrawnSpeed | CounterValue
    ) = described(
        ...,
        "initial speed in m/s, above 0 and at most 3; [lowest, highest]: a random speed in "
        "between; {draw: NAME}: "
        "the drawn value; {counter: NAME}: the counter's value when the ball is placed (capped at 3; at 0 or "
        "less the ball lies still)",
        union_mode="left_to_right",
    )

    def compile(self, to: Scope, entity: int) -> CompiledKick:
        """Return the compiled aim, and what reads the speed."""
        towards, speed, state = place_of(self.towards).compile(to, entity), self.speed_mps, to.state
        match speed:
            case tuple():
                return CompiledKick(towards, lambda: speed)
            case DrawnSpeed():
                return CompiledKick(towards, lambda: _exactly(state.draws[speed.draw]))
            case CounterValue():
                whose = to.whose(speed.entity)
                return CompiledKick(towards, lambda: _exactly(min(state.counter(speed.counter, whose), MAX_KICK_MPS)))
            case _:
                return CompiledKick(towards, lambda: _exactly(speed))

    def describe(self, phrases: Phrases) -> str:
        """Return its speed and its aim in words: ``at 0.5 m/s towards the ball``."""
        return f"{self._how_fast(phrases)} towards {place_of(self.towards).aim(phrases)}"

    def _how_fast(self, phrases: Phrases) -> str:
        speed = self.speed_mps
        if isinstance(speed, DrawnSpeed):
            drawn = sorted({float(mps) for mps in phrases.draw_values(speed.draw)})
            return f"at {listed([number(mps) for mps in drawn], 'or')} m/s, as {quoted_measure(speed.draw)} is drawn,"
        if isinstance(speed, CounterValue):
            return f"at as many m/s as {amount_words(phrases, speed)} tells, {MAX_KICK_MPS} at most,"
        speeds = speed if isinstance(speed, tuple) else (speed,)
        return f"at {' to '.join(dict.fromkeys(map(number, speeds)))} m/s"


def _exactly(speed_mps: Any) -> tuple[float, float]:
    return (float(speed_mps), float(speed_mps))
