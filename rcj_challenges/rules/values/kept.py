"""What the values of counters, flags and timers share: each of them may be kept per entity."""

from collections.abc import Callable
from typing import Annotated, Any, ClassVar

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import WHOSE
from rcj_challenges.rules.values.number import NumberValue


class KeptValue(NumberValue):
    """A value of something that rules remember, once or for each of several.

    Attributes:
        IN: the attribute of the state where it is kept.
    """

    IN: ClassVar = ""
    OVER = "entity"

    entity: Annotated[Names | None, WHOSE] = described(
        None,
        "if it is kept per entity: which entity; if omitted: that of each in a rule for_each of its owners, else the "
        "sum of counters, any of the flags, the longest of timers; in highest, lowest and sum also a group or others, "
        "if omitted: all of them",
    )

    @property
    def kept(self) -> str:
        """The name of what is kept."""
        return str(getattr(self, self.KEY))

    def whose(self, to: Scope) -> str | None:
        """Return whose it is; None: of all of them, or of none.

        Raises:
            ValueError: several are named; such a scenario is refused when it is loaded.
        """
        owners = to.owners(self.IN, self.kept, self.one_entity())
        return None if owners is None else owners[0]

    def members(self, to: Scope, names: Names) -> tuple[tuple[str, ...], Callable[[], tuple[str, ...]]]:
        return to.group_of_owners(self.IN, self.kept, names)

    def names(self, to: Scope) -> Names:
        kept: Any = getattr(to.state, self.IN).get(self.kept)
        return self.entity or (tuple(kept) if isinstance(kept, dict) else ())

    def named(self) -> Names:
        return self.entity or ()

    def one_entity(self) -> str | None:
        """Return the entity that is named."""
        if isinstance(self.entity, tuple):
            message = "several entities need highest, lowest or sum"
            raise ValueError(message)  # noqa: TRY004 - refused when the scenario is loaded
        return self.entity

    def describe_each(self, phrases: Phrases) -> str:
        owners = self.entity or phrases.keepers(self.KEY, self.kept) or ()
        return f"{self.KEY} {quoted_measure(self.kept)} of {phrases.all_of(owners).text}"

    def kept_words(self, phrases: Phrases) -> str:
        """Return it with whose it is: ``the counter “laps” of Y1``."""
        return phrases.kept(self.KEY, self.kept, self.one_entity())
