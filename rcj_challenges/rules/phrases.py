"""What words need to be explained, as a protocol; the rule sheet implements it."""

from typing import Any, Protocol

from rcj_challenges.core.amounts import Noun
from rcj_challenges.rules.fields import Names, Scalar
from rcj_challenges.rules.phrasing import Subject


class Phrases(Protocol):
    """How the names of a scenario are written in sentences; the rule sheet implements it."""

    @property
    def measured(self) -> str:
        """What the triggers of the rule measure."""

    def any_of(self, names: Names) -> str:
        """Return the one of several that a rule is about: ``one of the robots``, ``Y1 or Y2``."""

    def another_of(self, names: Names, than: Names) -> str:
        """Return the one of several that another one meets: ``another of the robots``, if that is a robot too."""

    def all_of(self, names: Names) -> Subject:
        """Return several together: ``the blue robots and Y3``, which is plural."""

    def point(self, at: Any, measured_from: Any = None) -> str:
        """Return a named thing or a point ``(x, y)``; of a group the nearest, but nothing is measured from itself."""

    def owned(self, what: str, names: Names, name: str = "") -> str:
        """Return the phrase for what one has: ``its program``, ``the timer “rest” of one of the robots``."""

    def kept(self, kind: str, name: str, entity: Names | None) -> str:
        """Return a counter, flag, timer or sequence with whose it is: ``the counter “laps” of Y1``."""

    def owners(self, kind: str, name: str) -> str | None:
        """Return the group of which each has a counter, flag, timer or sequence of its own; None for a single one."""

    def one_of_owners(self, kind: str, name: str) -> str | None:
        """Return whose of several it is: ``each`` if the rule is for each of its owners, else the group; or None."""

    def sequence_of(self, sequence: str) -> str:
        """Return the entity that a sequence follows, or the group of which each member has one of its own."""

    def timer_of(self, timer: str) -> str | None:
        """Return the group of entities of which each has a timer of its own; None where it is not kept for such."""

    def timer_length_s(self, timer: str) -> float | None:
        """Return the length of a timer; None if a draw or a counter decides it."""

    @property
    def period(self) -> Noun:
        """What a half is called."""

    def clock_may_stop(self) -> bool:
        """Return whether a phase stops the clock of the half."""

    def thing(self, name: str) -> str:
        """Return one thing: ``Y1``, ``the ball``, ``gate 1``, ``the spot “centre”``; ``each`` is ``it``."""

    def quantified(self, of: Any, names: Names, *, negate: bool) -> Subject:
        """Return the subject for a number of several: ``none of the robots``; negated, the opposite of it."""

    def may_be_off(self) -> bool:
        """Return whether a rule takes anything off the field."""

    def drawn(self, draw: str, written: Scalar) -> str:
        """Return a value of a draw: ``“west”``; of a name that stands for something in the rule, that: ``it``."""

    def entrant(self, name: str) -> str:
        """Return an entrant: ``yellow``, ``the other team``; of a robot ``its team``."""

    def is_one_owner(self, kind: str, name: str, entity: Names) -> bool:
        """Return whether a counter, flag, timer or sequence of these names is one, not those of several."""

    def keepers(self, kind: str, name: str) -> str | None:
        """Return the names of which each has a counter, flag, timer or sequence of its own; None for a single one."""

    def holder(self, role: str, name: str) -> str:
        """Return the one that has a role: ``this team``, ``Y1``; ``each`` of things is ``it``."""

    def draw_values(self, draw: str) -> tuple[Scalar, ...]:
        """Return the values of a draw."""

    def phases(self) -> tuple[str, ...]:
        """Return the names of all phases."""

    def is_several(self, name: str) -> bool:
        """Return whether a name stands for several things."""

    def is_entity(self, name: str) -> bool:
        """Return whether a name stands for an entity, and not for a spot or a draw."""

    # --- for actions ------------------------------------------------------------------------------------------------

    def every_kept(self, kind: str, name: str, entity: Names | None) -> str:
        """Return a counter, flag, timer or sequence with whose it is, where no entity stands for all of them."""

    def may_be_zone(self, name: str) -> bool:
        """Return whether a name may stand for a zone."""
