"""What words need to be compiled, as protocols; the referee implements them."""

from collections.abc import Callable, Iterable, Mapping
from random import Random
from typing import Any, Protocol, TypeVar

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.regions import Region
from rcj_challenges.rules.effects import Places, PlacesLayout
from rcj_challenges.rules.fields import Name, Names, Point, Scalar
from rcj_challenges.tracking.bound_rules import Act, BoundRule, TriggerBinding
from rcj_challenges.tracking.clock_events import ClockEvents
from rcj_challenges.tracking.gates import GateLine
from rcj_challenges.tracking.places import Anchor, Poses, Target
from rcj_challenges.tracking.sequences import SequenceTracker
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import Tracker, TrackerManager

_T = TypeVar("_T", bound=Tracker)
_W = TypeVar("_W")
_F = TypeVar("_F", bound=Callable[..., Any])


class Scope(Protocol):
    """What names stand for in a rule, a layout or the broadcast."""

    @property
    def state(self) -> RefereeState:
        """The referee's memory; read it when a rule fires or something is placed, not when a word is compiled."""

    each: str | None
    """The name that ``each`` stands for; None: it is not known there."""

    roles: Mapping[str, tuple[str, ...]]
    """The members of each role."""

    def by_role(self, word: _W, compiled: Callable[[_W], _F], otherwise: Any) -> _F:
        """Compile a word, or one for all members of the roles that it names: then return the choice of those now.

        While one of these roles stands for nothing, the result of what is returned is `otherwise`.
        """

    def members(self, names: Names) -> tuple[str, ...]:
        """Return the members that names stand for: groups expanded, ``each`` replaced, without repeats, in order."""

    def group(self, names: Names) -> tuple[tuple[str, ...], Callable[[], tuple[str, ...]]]:
        """Return all members that names may stand for, and a function that finds those for which they stand now.

        ``others`` stands for those on the field, and for no entity while ``each`` is off the field.
        """

    def entities(self, names: Names) -> tuple[int, ...]:
        """Return the indices of entities, or of fixed obstacles and walls, which can be touched too."""

    def region(self, names: Names) -> Region:
        """Return the region of a zone, or of several zones taken as one."""

    def locate(self, what: Name | Point) -> Callable[[], Any]:
        """Return a function that finds the pose [x, y, yaw] of a thing, [x, y] of a spot, a zone's centre or a point.

        None while it is off the field.
        """

    def start_of(self, entity: int) -> tuple[Pose2, Point]:
        """Return the pose in which an entity starts, and the half widths of the noise on x and y, in m."""

    def owners(self, section: str, name: str, names: Names | None) -> tuple[str, ...] | None:
        """Return whose counter, flag, timer or sequence is meant; None: all of them, or the only one.

        Without names it is that of ``each`` if the rule is for its owners.
        """

    def group_of_owners(
        self, section: str, name: str, names: Names
    ) -> tuple[tuple[str, ...], Callable[[], tuple[str, ...]]]:
        """Return what `group` does of those that have a counter, flag, timer or sequence of their own."""

    def entrants(self, names: Names) -> tuple[str, ...]:
        """Return the entrants that names stand for; of a robot that for which it plays."""

    def anchor(self, what: Name | Point) -> Callable[[], Anchor]:
        """Return a function that finds the anchor of a name; of a draw's name, of what it decided."""

    def places(self, what: Names | Point) -> Callable[[Poses, int | None], list[Point]]:
        """Return a function that finds where things are: of several those on the field, without one entity."""

    def random_point(self, zones: Names) -> Callable[[Random], Point]:
        """Return a function that draws a point of zones, every one equally likely."""

    def targets(self, named: Names | Point) -> tuple[Target, ...]:
        """Return the target of a distance: what a name stands for, or a point."""


class Binder(Scope, Protocol):
    """What a trigger, a condition or an action needs to be compiled for one rule."""

    rule: BoundRule
    """The rule for which it is compiled."""

    trackers: TrackerManager
    """All trackers."""

    clock_events: ClockEvents
    """Triggers that no tracker follows."""

    drawn: Mapping[str, tuple[str, ...]]
    """For each draw that decides on a place: the places."""

    def watched(self, condition: Any) -> tuple[int, ...]:
        """Return the entities whose placement changes a condition, with all that may have its roles."""

    def gate(self, name: str) -> GateLine:
        """Return a gate."""

    def sequences(self, name: str) -> dict[str | None, SequenceTracker]:
        """Return the trackers of a sequence by whose it is; None for one that is not kept per entity."""

    def track(self, kind: type[_T], key: tuple[object, ...] | None, *args: Any) -> _T:
        """Return the tracker that follows ``key`` in the phases of the rule; rules that follow the same share it.

        A new one is made of the state and ``args``. Without a key it is not shared, with values in it not between
        the members of ``for_each``.
        """

    def reset_with_draws(self, tracker: Tracker, names: tuple[str, ...]) -> None:
        """Reset a tracker whenever one of the draws among these names decides otherwise."""

    def binding(self, about: int | str | None = None) -> TriggerBinding:
        """Return the rule's binding to the trigger that is compiled, about a thing given by its index or its name."""

    def drawn_value(self, value: Scalar) -> Scalar:
        """Return a value of a draw: ``each`` is a name where the rule is for one."""

    def free_spots(self, names: Names, clearance_m: float) -> Callable[[], Iterable[bool]]:
        """Return a function that finds for each spot whether no robot's or ball's centre is near."""

    # --- for actions ------------------------------------------------------------------------------------------------

    def set_length(self, timer: str, owner: str | None) -> None:
        """Give a clock of a timer the length that it has by now."""

    def assign(self, name: str, value: Scalar | None) -> None:
        """Give a draw a value, or a role to a member or none; trackers that depend on it are reset if it changed."""

    def assign_next(self, name: str) -> None:
        """Draw again, or give a role to the next of its order."""

    def enter_phase(self, phase: str) -> None:
        """Enter a phase, at once."""

    def emit(self, event: str, payload: dict[str, object], about: tuple[str, ...]) -> None:
        """Write an event."""

    def is_on_floor(self, point: Point) -> bool:
        """Return whether a point lies inside the walls."""

    def placing(self, effect: Places | PlacesLayout) -> Act:
        """Return a function that asks for placements, to be carried out after all actions of the tick."""

    def placement_job(self, put: Places, entity: int) -> Any:
        """Return the placement of one entity."""

    def remove(self, entity: int, back: Any = None, ticks: int = 0) -> None:
        """Ask for an entity to be taken off the field; ``back``: its placement so many ticks from now."""
