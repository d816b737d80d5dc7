"""What actions do and what triggers wait for, as data. Readers of rules match on it, and import no word."""

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, TypeVar

from rcj_challenges.rules.fields import Name, Names, Scalar

if TYPE_CHECKING:
    from rcj_challenges.rules.base import PlaceWord
    from rcj_challenges.rules.placement import Mirror, Placement


@dataclass(frozen=True)
class Scores:
    """Points for an entrant.

    Attributes:
        entrant: its name, ``each`` or ``other``; None: the last to touch something.
        points: how many; None: known only when the rule fires.
        may_gain: whether they may be more than 0.
    """

    entrant: Name | None
    points: float | None
    may_gain: bool


@dataclass(frozen=True)
class Emits:
    """An event in the log."""

    event: str


@dataclass(frozen=True)
class Places:
    """Entities are put somewhere, mirrored by each of the mirrors, one after the other; ``how``: all the rest."""

    names: Names
    at: "PlaceWord"
    how: "Placement"
    mirrors: "tuple[Mirror, ...]" = ()


@dataclass(frozen=True)
class PlacesLayout:
    """Entities are put as in a layout, or as in one of those among which a draw decides."""

    layout: Name
    is_drawn: bool
    mirror: "Mirror | None"


@dataclass(frozen=True)
class Removes:
    """Entities leave the field; ``back_at``: where they return to after a time, None if a rule must place them."""

    names: Names
    back_at: "PlaceWord | None"


@dataclass(frozen=True)
class Holds:
    """Robots are held, for a time or until a rule releases them."""

    names: Names
    for_a_time: bool


@dataclass(frozen=True)
class Releases:
    """Held robots are released."""

    entity: Names


@dataclass(frozen=True)
class Writes:
    """An entry of ``counters``, ``flags``, ``timers`` or ``sequences`` changes."""

    section: str
    name: Name


@dataclass(frozen=True)
class Draws:
    """A draw gets a value; None: a random one."""

    draw: Name
    value: Scalar | None


@dataclass(frozen=True)
class SetsSpot:
    """A spot moves.

    Attributes:
        at: the point, the random place, or the thing that it is set to; None: the place that a robot has sent.
    """

    spot: Name
    at: "PlaceWord | Name | None"
    mirror: "Mirror | None"


@dataclass(frozen=True)
class SetsPhase:
    """A phase begins."""

    phase: Name


@dataclass(frozen=True)
class Ends:
    """The half or the match ends."""


Effect = (
    Scores | Emits | Places | PlacesLayout | Removes | Holds | Releases | Writes | Draws | SetsSpot | SetsPhase | Ends
)


@dataclass(frozen=True)
class HalfStart:
    """A half starts."""


@dataclass(frozen=True)
class PhaseStart:
    """A phase is entered."""

    phase: Name


@dataclass(frozen=True)
class AtTime:
    """A half has lasted so long."""

    at_s: float


@dataclass(frozen=True)
class EventSeen:
    """An event was emitted; ``entity``: about what, None if about anything."""

    event: str
    entity: Names | None


@dataclass(frozen=True)
class Entry:
    """An entity enters a zone."""

    entity: Names
    zone: Names


@dataclass(frozen=True)
class Passage:
    """An entity leaves a zone, or crosses a gate."""

    entity: Names


@dataclass(frozen=True)
class Touch:
    """An entity touches another thing."""

    entity: Names
    other: Names


Moment = HalfStart | PhaseStart | AtTime | EventSeen | Entry | Passage | Touch

_T = TypeVar("_T")


def declared(kind: type[_T], word: Any) -> _T:
    """Return an effect or a moment with what the fields of the same names of a word say."""
    return kind(**{one.name: getattr(word, one.name) for one in fields(kind)})  # type: ignore[arg-type]  # a dataclass
