"""Sections ``draws``, ``counters``, ``flags``, ``timers``, ``sequences``, ``phases``."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.fields import Name, Scalar, Strict, described
from rcj_challenges.rules.refs import KEEPERS, MEMBERS, ONE_ENTITY, PHASE, STEP
from rcj_challenges.rules.values import Lasts


class Draw(Strict):
    """A random choice at the start of a half, and again on every ``draw`` action."""

    values: tuple[Scalar, ...] = Field(
        ...,
        strict=False,
        min_length=1,
        description="the values, equally likely; one that is listed twice is drawn twice as often",
    )
    not_last: bool = described(
        False,
        "True: never the same value twice in a row; a new half may start with the previous half's last value",
    )
    not_again: Literal["half", "match"] | None = described(
        None,
        "half: in a half no value comes again before all have been drawn, then it starts again; match: in all halves "
        "together; a value that a rule sets counts as drawn. Left out: every draw uses all values",
    )
    keep: Literal["half", "match"] = described("half", "match: the value is kept for the next half and is not redrawn")


class Counter(Strict):
    """A number that rules count up and down. Scores are readable like counters, under the entrant's name.

    Both are exact to 9 decimals, as on paper: three times 0.1 is 0.3. Neither grows beyond 1 000 000 000 000 000, nor
    falls under its negative: it stays there.
    """

    initial: float = described(0.0, "value at the start of a half; with keep: match at the start of the match")
    per: Annotated[Name | None, KEEPERS] = described(
        None, "a group, also of fixed obstacles, zones or gates: one counter for each of its members"
    )
    keep: Literal["half", "match"] | None = described(
        None, "match: the value is kept for the next half, with the robot, not the team; half, or left out: it is not"
    )


class Flag(Strict):
    """A yes or no that rules set."""

    initial: bool = described(False, "value at the start")
    per: Annotated[Name | None, KEEPERS] = described(
        None, "a group, also of fixed obstacles, zones or gates: one flag for each of its members"
    )
    keep: Literal["half", "match"] = described("half", "match: the value is kept for the next half")


class Timer(Strict):
    """A clock that rules start and stop; it expires once when it reaches its length."""

    lasts_s: Lasts = described(
        ...,
        "its length in s, or {draw: NAME} or {counter: NAME}: its value when the timer starts from 0 (of a counter "
        "at least one tick); with per, entity: each uses that member's counter",
    )
    per: Annotated[Name | None, KEEPERS] = described(
        None, "a group, also of fixed obstacles, zones or gates: one timer for each of its members"
    )
    starts: bool = described(False, "True: it runs from the start of the half")


class AnyStep(Strict):
    """A step that several places satisfy."""

    any_of: Annotated[tuple[Name, ...], STEP] = Field(..., strict=False, min_length=1, description="zones or gates")


class Sequence(Strict):
    """Steps to be made in order: zones are entered, gates are crossed forward.

    It starts again when it is complete (a cyclic one goes on), when the action `sequence` says so, and, unless it shall
    go on, when a rule puts its entity somewhere or takes it off the field.
    """

    either = ("entity", "per")

    entity: Annotated[Name | None, ONE_ENTITY] = described(
        None, "which entity is tracked: one robot, ball or movable obstacle"
    )
    per: Annotated[Name | None, MEMBERS] = described(
        None,
        "in place of entity: a group of robots, balls or movable obstacles: one sequence for each of its members, each "
        "with its own steps and time",
    )
    steps: Annotated[tuple[Name | AnyStep, ...], STEP] = Field(
        ..., strict=False, min_length=2, description="zones or gates in order"
    )
    cyclic: bool = described(False, "True: complete on re-entering the first step, and begins again there")
    wrong_step: Literal["break", "ignore"] = described(
        "ignore",
        "the effect of a wrong step, one that is neither the last reached nor the next: ignore: nothing; "
        "break: after the first step, the sequence starts again",
    )
    when_placed: Literal["begins_anew", "goes_on"] | None = described(
        None,
        "what becomes of it when a rule puts its entity somewhere or takes it off: goes_on: the steps made are kept; "
        "begins_anew, or left out: they are lost",
    )

    def places(self) -> tuple[tuple[Name, ...], ...]:
        """Return for each step the zones or gates that satisfy it."""
        return tuple(step.any_of if isinstance(step, AnyStep) else (step,) for step in self.steps)


class Phase(Strict):
    """A time in which only the rules that are active in it run. ``play`` always exists."""

    lasts_s: Lasts | None = described(
        None,
        "after this time in s the next phase is entered; {draw: NAME} or {counter: NAME}: its value on entry (of a "
        "counter at least one tick); left out: until a rule ends it",
    )
    next: Annotated[Name, PHASE] = described("play", "the phase that follows")
    waiting_for_kickoff: bool = described(False, "the flag that programs receive meanwhile")
    clock: Literal["runs", "stops"] = described("runs", "whether the time of the half goes on")
    robots: Literal["free", "held"] | None = described(
        None,
        "held: all wheels stand braked meanwhile; programs run on, and their commands take effect when the phase is "
        "over; "
        "free, or left out: robots drive",
    )
