"""What all words share: how they are listed, compiled by the referee and explained by the sheet.

A word is one file: its model, what the referee makes of it, its sentence on the sheet, and its example. Such a file
knows neither the referee nor the sheet, only the protocols `Binder` and `Phrases` here.
"""

from collections.abc import Callable, Iterable, Mapping
from random import Random
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Protocol, TypeVar, Union, get_args

from pydantic import Field, GetCoreSchemaHandler
from pydantic_core import CoreSchema

from rcj_challenges.rules.fields import Name, Names, Point, Scalar, Strict, described
from rcj_challenges.rules.phrasing import Subject
from rcj_challenges.tracking.bound_rules import Act, BoundRule, Firing, HitBuffer, Test, TriggerBinding
from rcj_challenges.tracking.clock_events import ClockEvents
from rcj_challenges.tracking.contacts import Contacts
from rcj_challenges.tracking.gates import GateLine
from rcj_challenges.tracking.pose_history import PoseHistory
from rcj_challenges.tracking.sequences import SequenceTracker
from rcj_challenges.tracking.state import Clock, Number, RefereeState
from rcj_challenges.tracking.target import Target
from rcj_challenges.tracking.trackers import Tracker

if TYPE_CHECKING:
    from rcj_challenges.geometry.regions import Region

ENTITY_DESCRIPTION = "whose: an entity (a robot, a ball or a movable obstacle), a group (any of them), or each"

_T = TypeVar("_T", bound=Tracker)


class Word(Strict):
    """A word of the language.

    Attributes:
        KEY: the field that says which word it is: ``trigger``.
        EXAMPLE: sections of a scenario that show it; run as a test and printed in the reference.
        ASKS_WHERE: whether it asks where something is.
    """

    KEY: ClassVar[str]
    EXAMPLE: ClassVar[str] = ""
    ASKS_WHERE: ClassVar[bool] = False

    @classmethod
    def name(cls) -> str:
        """Return how the file writes the word."""
        return str(get_args(cls.model_fields[cls.KEY].annotation)[0])


class Vocabulary:
    """The words of one kind, in the order in which the schema and the reference list them.

    It stands in annotations, ``Annotated[Trigger, TRIGGERS]``, where it is the union of its words, told apart by their
    key. That is built when a model is first used, so words can be added until then.

    Args:
        key: the field that says which word it is.
        words: the words, a list that may be shared.
        without: those that are left out of it.
    """

    def __init__(self, key: str, words: list[type[Word]] | None = None, without: frozenset[str] = frozenset()) -> None:
        self.key = key
        self._words = [] if words is None else words
        self._without = without

    def add(self, *words: type[Word]) -> None:
        """Add words at the end."""
        self._words += words

    def words(self) -> tuple[type[Word], ...]:
        """Return all words."""
        return tuple(word for word in self._words if word.name() not in self._without)

    def without(self, word: str) -> "Vocabulary":
        """Return the same words but one, also those that are added later."""
        return Vocabulary(self.key, self._words, self._without | {word})

    @property
    def shape(self) -> Any:
        """The union of the words, as a type annotation."""
        return Annotated[Union[self.words()], Field(discriminator=self.key)]  # noqa: UP007 - built at run time

    def __get_pydantic_core_schema__(self, _source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return the schema of the union."""
        return handler.generate_schema(self.shape)


class Binder(Protocol):
    """What a word needs to be compiled for one rule; the referee's compiler implements it."""

    @property
    def rule(self) -> BoundRule:
        """The rule for which it is compiled."""

    @property
    def state(self) -> RefereeState:
        """The referee's memory; read it when the rule is judged, not when it is compiled."""

    @property
    def hits(self) -> HitBuffer:
        """Where trackers report."""

    @property
    def contacts(self) -> Contacts:
        """What touches what."""

    @property
    def pose_history(self) -> PoseHistory:
        """Judged poses of the past."""

    @property
    def clock_events(self) -> ClockEvents:
        """Triggers that no tracker follows."""

    @property
    def drawn(self) -> Mapping[str, tuple[str, ...]]:
        """For each draw that decides on a place: the places."""

    def members(self, names: Names) -> tuple[str, ...]:
        """Return what names stand for: groups expanded, ``each`` replaced, without repeats, in order."""

    def entities(self, names: Names) -> tuple[int, ...]:
        """Return the indices of entities."""

    def things(self, names: Names) -> tuple[int, ...]:
        """Return the indices of what can be touched: entities, fixed obstacles, walls."""

    def index_of(self, name: str) -> int | None:
        """Return the index of something that can be touched; None for anything else."""

    def name_of(self, entity: int) -> str:
        """Return the name of an entity."""

    def region(self, names: Names) -> "Region":
        """Return the region of a zone, or of several zones taken as one."""

    def gate(self, name: str) -> GateLine:
        """Return a gate."""

    def sequences(self, name: str) -> dict[str | None, SequenceTracker]:
        """Return the trackers of a sequence by whose it is; None for one that is not kept per entity."""

    def track(self, kind: type[_T], key: tuple[object, ...], make: Callable[[], _T]) -> _T:
        """Return the tracker that follows ``key`` in the phases of the rule; rules that follow the same share it."""

    def track_alone(self, tracker: Tracker) -> None:
        """Follow a tracker that is not shared, in the phases of the rule."""

    def reset_with_draws(self, tracker: Tracker, names: tuple[str, ...]) -> None:
        """Reset a tracker whenever one of the draws among these names decides otherwise."""

    def binding(self, entity: int | None = None) -> TriggerBinding:
        """Return the rule's binding to the trigger that is compiled.

        Args:
            entity: the index of what it is about.
        """

    def thing(self, name: str) -> int:
        """Return the index of one thing that can be touched."""

    def whose(self, name: str | None) -> str | None:
        """Return whose counter, flag, timer or sequence a name stands for; None: all of them, or the only one."""

    def drawn_value(self, value: Scalar) -> Scalar:
        """Return a value of a draw: ``each`` is a name where the rule is for one."""

    def targets(self, named: Name | Point) -> tuple[Target, ...]:
        """Return what a distance is measured to: what a name stands for, or a point."""

    def locate(self, what: Name | Point) -> Callable[[], Point | None]:
        """Return what finds where a thing, a spot, a zone's centre or a point is; None while it is off the field."""

    def free_spots(self, names: Names, clearance_m: float) -> Callable[[], Iterable[bool]]:
        """Return what finds for each of some spots whether no robot's or ball's centre is near."""

    def bound(self, bound: Any) -> Callable[[], Number]:
        """Return what reads what is compared with: a number, a counter, or the lowest or highest of others."""

    # --- for actions ------------------------------------------------------------------------------------------------

    def points(self, points: Any) -> Callable[[Firing], Number]:
        """Return what reads a number of points: one amount, or the sum of numbers and weighted ones."""

    def value(self, value: Any) -> Callable[[Firing], Any]:
        """Return what reads a value of an event's payload."""

    def ticks(self, lasts_s: Any) -> Callable[[], int]:
        """Return what reads how many ticks something lasts: a number, or what a draw or a counter says."""

    def wind_up(self, timer: str, clock: Clock, owner: str | None) -> None:
        """Give a clock of a timer its length, as its draw has decided or its counter says by now."""

    def timers_changed(self) -> None:
        """Reschedule the trackers after a timer was started or stopped."""

    def reset(self, tracker: Tracker) -> None:
        """Reset a tracker, because a rule says so."""

    def release(self, robots: tuple[int, ...]) -> None:
        """Let robots go that rules hold."""

    def decide_draw(self, draw: str, value: Scalar | None) -> None:
        """Draw anew, or set a draw to a value; what follows the draw is reset if it changed."""

    def draw_values(self, draw: str) -> tuple[Scalar, ...]:
        """Return the values of a draw."""

    def enter_phase(self, phase: str) -> None:
        """Enter a phase, at once."""

    def emit(self, event: str, payload: dict[str, object], about: tuple[str, ...]) -> None:
        """Write an event."""

    def random_point(self, place: Any) -> Callable[[Random], Point]:
        """Return what draws a point of zones or of a segment, every one equally likely."""

    def mirror_signs(self, mirror: Any) -> Callable[[], Point]:
        """Return what reads the signs of x and y that a mirror gives now; without one they are positive."""

    def decided_place(self, spot: str) -> Point | None:
        """Return where a test has decided that chance sets a spot this time; None: chance decides."""

    def is_on_floor(self, point: Point) -> bool:
        """Return whether a point lies inside the walls."""

    def layout_jobs(self, layout: str, mirror: Any) -> list[Any]:
        """Return the placements of a layout, in order."""

    def placement_job(self, placing: Any, entity: int) -> Any:
        """Return the placement of one entity."""

    def place(self, jobs: list[Any]) -> None:
        """Ask for placements, to be carried out after all actions of the tick."""

    def place_later(self, job: Any, ticks: int) -> None:
        """Ask for a placement so many ticks from now, of what is off the field until then."""

    def remove(self, entity: int) -> None:
        """Ask for an entity to be taken off the field."""


class Phrases(Protocol):
    """How the names of a scenario are written in sentences; the rule sheet implements it."""

    def any_of(self, names: Names) -> str:
        """Return the one of several that a rule is about: ``one of the robots``, ``Y1 or Y2``."""

    def another_of(self, names: Names, than: Names) -> str:
        """Return the one of several that another one meets: ``another of the robots``, if that is a robot too."""

    def all_of(self, names: Names) -> Subject:
        """Return several together: ``the blue robots and Y3``."""

    def point(self, at: Any, measured_from: Any = None) -> str:
        """Return a named thing or a point ``(x, y)``; of a group the nearest of it is meant."""

    def owned(self, what: str, names: Names, name: str = "") -> str:
        """Return what belongs to one of several: ``its program``, ``the timer “rest” of one of the robots``."""

    def kept(self, kind: str, name: str, entity: str | None) -> str:
        """Return a counter, flag, timer or sequence with whose it is: ``the counter “laps” of Y1``."""

    def owners(self, kind: str, name: str) -> str | None:
        """Return the group of which each has a counter, flag, timer or sequence of its own; None for a single one."""

    def one_of_owners(self, kind: str, name: str) -> str | None:
        """Return whose of several it is: ``each`` if the rule is for each of its owners, else the group; or None."""

    def sequence_of(self, sequence: str) -> str:
        """Return what a sequence follows: an entity, or the group of which each member has one of its own."""

    def timer_of(self, timer: str) -> str | None:
        """Return the group of entities of which each has a timer of its own; None where it is not kept for such."""

    def timer_length_s(self, timer: str) -> float | None:
        """Return the length of a timer; None if a draw or a counter decides it."""

    def stands_fast(self, names: Names) -> bool:
        """Return whether names stand for nothing but fixed obstacles."""

    def meeting_zones(self, names: Names) -> int:
        """Return how many zones names stand for if any two of them may meet, else 0."""

    def clock_may_stop(self) -> bool:
        """Return whether a phase stops the clock of the half."""

    def thing(self, name: str) -> str:
        """Return one thing: ``Y1``, ``the ball``, ``the spot “centre”``; ``each`` is ``it``."""

    def quantified(self, of: Any, names: Names, *, negate: bool) -> Subject:
        """Return how many of several must do something: ``none of the robots``; negated, the opposite of it."""

    def of_those_there(self, of: Any, names: Names, *, negate: bool) -> Subject:
        """Return the same where nothing is asked of what is off the field."""

    def may_be_off(self, names: Any) -> bool:
        """Return whether a rule takes any of what names stand for off the field; of a point none does."""

    def off_as_a_whole(self, at: Any, measured_from: Any = None) -> Subject | None:
        """Return what must be off the field for nothing to be measured to it; None: some of it is always on it."""

    def drawn(self, draw: str, written: Scalar) -> str:
        """Return a value of a draw: ``“west”``."""

    def is_set(self, draw: str) -> bool:
        """Return whether a draw is what rules set, from the start of each half."""

    def is_entrant(self, name: str) -> bool:
        """Return whether a name is that of an entrant."""

    def keepers(self, kind: str, name: str) -> str:
        """Return the group of which each has a counter, flag, timer or sequence of its own."""

    def sequence_step(self, sequence: str, step: str) -> str:
        """Return a step of a sequence, with what it means if it is the last."""

    def clearance(self, clearance_m: float) -> str:
        """Return within which distance a spot must be free, if it is not the usual one: `` within 5 cm``."""

    def amount(self, value: Any) -> str:
        """Return points, counts or limits: a number, a counter, a sum of weighted parts, or the most or least."""

    def what_drawn(self, draw: str) -> str:
        """Return what a draw decided: ``what was drawn as “target”``."""

    # --- for actions ------------------------------------------------------------------------------------------------

    def every_kept(self, kind: str, name: str, entity: str | None) -> str:
        """Return a counter, flag, timer or sequence with whose it is, where no entity stands for all of them."""

    def value(self, value: Any) -> str:
        """Return a value of an event's payload in words."""

    def lasting(self, lasts_s: Any) -> str:
        """Return how long something lasts: ``15 s``, ``5 s or 8 s, as “pause” is drawn``."""

    def placing(self, placing: Any) -> str:
        """Return a placement as a clause."""

    def put_back(self, removal: Any) -> str:
        """Return where what is removed comes back to: ``put on the spot “centre”, facing the ball``."""

    def aim(self, at: Any) -> str:
        """Return a place as what is aimed at: ``a random point of the blue goal``."""

    def may_be_zone(self, name: str) -> bool:
        """Return whether a name may stand for a zone."""

    def mirrored(self, mirror: Any, at: Any) -> str:
        """Return how a place is mirrored; an empty text where it is not, or where that changes nothing."""

    def mirrored_layout(self, action: Any) -> str:
        """Return how all places of a layout are mirrored, and what its kicks are aimed at."""


class Trigger(Word):
    """A moment at which a rule may fire.

    Attributes:
        MEASURED: what it measures, as the sheet says it; empty: nothing.
        LIMIT: the field with the limit that it measures against; empty: none.
        ON_FIELD_ONLY: whether it never fires for what is off the field.
        OVER_TIME: whether it measures over a time, which begins when the rule becomes active.
    """

    KEY = "trigger"
    MEASURED: ClassVar[str] = ""
    LIMIT: ClassVar[str] = ""
    ON_FIELD_ONLY: ClassVar[bool] = False
    OVER_TIME: ClassVar[bool] = False

    def bind(self, to: Binder) -> None:
        """Bind a rule to this trigger: to a tracker, or to the clock's events.

        Args:
            to: the rule's binder.
        """
        raise NotImplementedError

    def describe(self, phrases: Phrases) -> str:
        """Return the part of a sentence that follows ``When``."""
        raise NotImplementedError

    def about(self, _phrases: Phrases) -> Names | None:
        """Return what it can be about; None: nothing."""
        names: Names | None = getattr(self, "entity", None)
        return names

    def limit(self, _phrases: Phrases) -> float | None:
        """Return what it measures against; None: nothing, or it is not known before."""
        return float(getattr(self, self.LIMIT)) if self.LIMIT else None

    def measures_its_limit(self) -> bool:
        """Return whether what it measures is always the limit: it fires when something has lasted so long."""
        return False


class Condition(Word):
    """What must hold when a trigger fires."""

    KEY = "condition"

    negate: bool = described(False, "True: the opposite must hold")

    def compile(self, to: Binder) -> Test:
        """Return the test of the condition, turned over if it is negated.

        Args:
            to: the rule's binder.
        """
        test = self.test(to)
        return (lambda: not test()) if self.negate else test

    def test(self, to: Binder) -> Test:
        """Return the test of the condition as it is without ``negate``."""
        raise NotImplementedError

    def watched(self, _to: Binder) -> tuple[int, ...]:
        """Return the entities whose placement changes it: a trigger that follows it is reset then."""
        return ()

    def describe(self, phrases: Phrases) -> str:
        """Return the condition, or the opposite of a negated one, as the part of a sentence that follows ``if``."""
        raise NotImplementedError

    def about(self) -> Names | None:
        """Return the entities whose place it reads, if it names them."""
        return None

    def is_always(self) -> bool:
        """Return whether it holds at any time."""
        return False

    def is_several(self) -> bool:
        """Return whether it is made of more than one condition."""
        return False

    def compares_with_counter(self) -> bool:
        """Return whether it compares with a counter, or with those of others."""
        return False


class Action(Word):
    """What a rule does when it fires."""

    KEY = "action"

    def compile(self, to: Binder) -> Act:
        """Return what carries out the action when its rule fires.

        Args:
            to: the rule's binder.
        """
        raise NotImplementedError

    def describe(self, phrases: Phrases) -> str:
        """Return the action as a clause: ``yellow gets 1 point``."""
        raise NotImplementedError
