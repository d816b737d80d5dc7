"""A ball that rolls away from where it is put."""

from dataclasses import replace
from typing import Annotated, Any

from pydantic import Field

from rcj_challenges.rules.base import Phrases, Scope, ValueWord
from rcj_challenges.rules.fields import Name, Strict, described
from rcj_challenges.rules.phrasing import listed, number, quoted_measure
from rcj_challenges.rules.places import At, place_of
from rcj_challenges.rules.refs import DRAW
from rcj_challenges.rules.values import NUMBERS, amount_words, compile_amount
from rcj_challenges.rules.values.draw import NumberDraw
from rcj_challenges.tracking.bound_rules import NO_FIRING
from rcj_challenges.tracking.places import CompiledKick

MAX_KICK_MPS = 3
"""Up to what the walls are known to hold, with a margin (ADR 2)."""
_DRAWN_SPEEDS = replace(DRAW, numbers=(0.001, MAX_KICK_MPS))
_KickSpeed = Annotated[float, Field(gt=0, le=MAX_KICK_MPS)]


class DrawnSpeed(NumberDraw):
    """The speed that a draw decided, when the ball is set down."""

    draw: Annotated[Name, _DRAWN_SPEEDS] = described(..., "a draw whose values are speeds in m/s, over 0 and up to 3")


_SPEEDS = NUMBERS.beside(
    {"number": _KickSpeed, "pair": Annotated[tuple[_KickSpeed, _KickSpeed], Field(strict=False)]},
    lambda value: "pair" if isinstance(value, list | tuple) else "number",
    DrawnSpeed,
)


class Kick(Strict):
    """Makes a placed ball roll away; mirroring its place also mirrors the aim. In tests, the ball stays where it is."""

    towards: At = described(..., "where it rolls to: any form of `at`; random places are redrawn each time")
    speed_mps: Annotated[float | tuple[float, float] | ValueWord, _SPEEDS] = described(
        ...,
        "initial speed in m/s, above 0 and at most 3; [lowest, highest]: a random speed in between; a value is read "
        "when the ball is placed (capped at 3; at 0 or less, or without such a number, the ball lies still)",
    )

    def compile(self, to: Scope, entity: int) -> CompiledKick:
        """Return the compiled aim, and what reads the speed."""
        towards, speed = place_of(self.towards).compile(to, entity), self.speed_mps
        match speed:
            case tuple():
                return CompiledKick(towards, lambda: speed)
            case _:
                read = compile_amount(speed, to)
                return CompiledKick(towards, lambda: _exactly(min(read(NO_FIRING) or 0, MAX_KICK_MPS)))

    def describe(self, phrases: Phrases) -> str:
        """Return its speed and its aim in words: ``at 0.5 m/s towards the ball``."""
        return f"{self._how_fast(phrases)} towards {place_of(self.towards).aim(phrases)}"

    def _how_fast(self, phrases: Phrases) -> str:
        speed = self.speed_mps
        if isinstance(speed, DrawnSpeed) and not speed.is_computed():
            drawn = sorted({float(mps) for mps in phrases.draw_values(speed.draw)})
            return f"at {listed([number(mps) for mps in drawn], 'or')} m/s, as {quoted_measure(speed.draw)} is drawn,"
        if isinstance(speed, ValueWord):
            return f"at as many m/s as {amount_words(phrases, speed)} tells, {MAX_KICK_MPS} at most,"
        speeds = speed if isinstance(speed, tuple) else (speed,)
        return f"at {' to '.join(dict.fromkeys(map(number, speeds)))} m/s"


def _exactly(speed_mps: Any) -> tuple[float, float]:
    return (float(speed_mps), float(speed_mps))
