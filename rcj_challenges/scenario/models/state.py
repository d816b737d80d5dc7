"""Sections ``draws``, ``counters``, ``flags``, ``timers``, ``sequences``, ``phases``."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.conditions import AnyCondition
from rcj_challenges.rules.fields import Name, Names, Scalar, Strict, described
from rcj_challenges.rules.refs import KEEP, KEEPERS, MEMBERS, ONE_ENTITY, PHASE, ROLE_OF, STEP
from rcj_challenges.rules.values import Lasts

_KEEP = (
    "half: it is reset in each half; match: it goes on in the next half{}; phase: it is reset in each phase; the "
    "name of a phase: it is reset when that phase begins{}"
)
_PER = "entrants, or a group of entities, fixed obstacles, zones or gates: each member has its own"


class Draw(Strict):
    """A random choice, made at the start of a half and at every ``draw`` action."""

    values: tuple[Scalar, ...] = described(
        ..., "the values, equally likely; a value that is listed twice is drawn twice as often", min_length=1
    )
    not_last: bool = described(
        False,
        "True: never the same value twice in a row, except that a half may start with the last value of the "
        "previous half",
    )
    not_again: Literal["half", "match"] | None = described(
        None,
        "half: within a half, no value is repeated until all have been drawn; match: the same across all halves; a "
        "value set by a rule counts as drawn; if omitted: every draw uses all values",
    )
    keep: Literal["half", "match"] = described("half", "match: the value is kept for the next half and is not redrawn")


class Role(Strict):
    """A name for the one of several that is meant now: it may stand wherever one of them may, in rules.

    While it stands for nothing, a condition that names it is false, and an action does nothing.
    """

    of: Annotated[Names, ROLE_OF] = Field(
        ..., description="those that may have it: robots, balls, obstacles, zones, gates or spots, or groups of them"
    )
    order: Literal["random", "listed"] = described(
        "random",
        "random: at the start, and at every assign, each is equally likely; listed: the first, then one by one",
    )
    cyclic: bool = described(False, "True: after the last one listed the first comes again; else it stands for nothing")
    initial: Literal["none"] | None = described(None, "none: at the start it stands for nothing")
    not_last: bool = described(False, "True: chance never brings the same one twice in a row")
    not_again: Literal["half", "match"] | None = described(
        None, "half: within a half, chance brings no one again until all have come; match: the same across all halves"
    )
    keep: Annotated[Name | None, KEEP] = described(None, _KEEP.format("", "; if omitted: half"))

    def draw(self, members: tuple[str, ...]) -> Draw:
        """Return the draw that chooses by chance among its members."""
        keep: Literal["half", "match"] = "match" if self.keep == "match" else "half"
        return Draw.model_construct(values=members, not_last=self.not_last, not_again=self.not_again, keep=keep)


class Counter(Strict):
    """A number that rules change.

    Counters and scores are exact to 9 decimals, as on paper: three times 0.1 is 0.3. None grows beyond
    1 000 000 000 000 000, nor falls under its negative: it stays there.
    """

    initial: Literal["none"] | float | None = described(
        None,
        "value at the start of a half or, with keep: match, at the start of the match; none: there is no such number "
        "yet; if omitted: 0 or, with keeps, none",
    )
    per: Annotated[Name | None, KEEPERS] = described(None, f"{_PER} counter")
    keep: Annotated[Name | None, KEEP] = described(
        None, _KEEP.format(", with the robot, not with the team", "; if omitted: half")
    )
    keeps: Literal["lowest", "highest"] | None = described(
        None, "of the values that `to` gives it, the lowest or the highest is kept; if omitted: the last one"
    )

    @property
    def first(self) -> float | None:
        """The value at the beginning; None: there is none."""
        if self.initial is None:
            return None if self.keeps else 0.0
        return None if self.initial == "none" else self.initial


class Flag(Strict):
    """A yes/no value that rules set."""

    initial: bool = described(False, "value at the start")
    per: Annotated[Name | None, KEEPERS] = described(None, f"{_PER} flag")
    keep: Annotated[Name, KEEP] = described("half", _KEEP.format("", ""))

    @property
    def first(self) -> bool:
        """The value at the beginning."""
        return self.initial


class Timer(Strict):
    """A clock that rules start and stop, or that runs while conditions hold; it expires once, at its length."""

    lasts_s: Lasts | None = described(
        None,
        "its length in s, read when the timer starts from 0 (at least one tick); with per, each is the member; if "
        "omitted, or without such a number, it runs on",
    )
    per: Annotated[Name | None, KEEPERS] = described(None, f"{_PER} timer")
    starts: bool = described(False, "True: it runs from the start, of the half or as `keep` says")
    keep: Annotated[Name | None, KEEP] = described(None, _KEEP.format("", "; if omitted: half"))
    while_: tuple[AnyCondition, ...] | None = described(
        None,
        "conditions: it runs while they all hold, and only then; with per, each is the member",
        alias="while",
        min_length=1,
    )


class AnyStep(Strict):
    """A step that can be completed at any of several places."""

    any_of: Annotated[tuple[Name, ...], STEP] = described(..., "zones or gates", min_length=1)


class Sequence(Strict):
    """Steps to complete, in order or in any order: zones to enter, gates to cross forward.

    It starts again when it is complete (a cyclic one goes on), when the action `reset` says so, and, unless it shall
    go on, when a rule puts its entity somewhere or takes it off the field.
    """

    either = ("entity", "per")
    NOTES = ("A sequence is followed in the phases of the rules that name it, and starts again after other phases.",)

    entity: Annotated[Name | None, ONE_ENTITY] = described(
        None, "which entity is tracked: one robot, ball or movable obstacle"
    )
    per: Annotated[Name | None, MEMBERS] = described(
        None,
        "instead of entity: a group of robots, balls or movable obstacles; each member has its own sequence, "
        "with its own steps and time",
    )
    steps: Annotated[tuple[Name | AnyStep, ...], STEP] = described(..., "zones or gates", min_length=2)
    order: Literal["any"] | None = described(
        None, "any: the steps may be made in any order, and none is wrong; if omitted: in the order of the list"
    )
    cyclic: bool = described(
        False, "True: the sequence is complete when its first step is reached again, and starts again there"
    )
    wrong_step: Literal["break", "ignore"] = described(
        "ignore",
        "effect of a step that is neither the last one reached nor the next; ignore: none; "
        "break: the sequence starts again if its first step has been reached",
    )
    when_placed: Literal["begins_anew", "goes_on"] | None = described(
        None,
        "effect of placing or removing its entity; goes_on: the completed steps are kept; begins_anew, or "
        "omitted: they are lost",
    )

    @property
    def followed(self) -> Name:
        """What it follows: an entity, or the group of which each member has a sequence of its own."""
        return self.per or self.entity or ""

    def places(self) -> tuple[tuple[Name, ...], ...]:
        """Return for each step the zones or gates that satisfy it."""
        return tuple(step.any_of if isinstance(step, AnyStep) else (step,) for step in self.steps)


class Phase(Strict):
    """A part of a half with its own rules. ``play`` always exists."""

    lasts_s: Lasts | None = described(
        None,
        "time in s after which the next phase begins; read on entry (at least one tick); if omitted, "
        "or without such a number: a rule must end it",
    )
    next: Annotated[Name, PHASE] = described("play", "the phase that follows")
    waiting_for_kickoff: bool = described(False, "value of the kick-off flag that programs receive during this phase")
    clock: Literal["runs", "stops"] = described("runs", "whether the clock of the half runs")
    robots: Literal["free", "held"] | None = described(
        None,
        "held: all wheels are braked; programs keep running, and their last commands take effect "
        "when the phase is over; free, or omitted: robots can drive",
    )
