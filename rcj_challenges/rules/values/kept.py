"""What the values of counters, flags and timers share: each of them may be kept per entity."""

from collections.abc import Callable
from typing import Annotated, Any

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.phrasing import Subject, quoted_measure
from rcj_challenges.rules.quantifier import Quantifier
from rcj_challenges.rules.refs import WHOSE


class KeptValue(NumberValue):
    """A value of something that rules remember, once or for each of several."""

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
        """Return whose it is; None: of all of them, or of none."""
        owners = to.owners(f"{self.KEY}s", self.kept, self.entity)
        return None if owners is None else owners[0]

    def members(self, to: Scope, names: Names) -> tuple[tuple[str, ...], Callable[[], tuple[str, ...]]]:
        return to.group_of_owners(f"{self.KEY}s", self.kept, names)

    def names(self, to: Scope) -> Names:
        kept: Any = getattr(to.state, f"{self.KEY}s").get(self.kept)
        return self.entity or (tuple(kept) if isinstance(kept, dict) else ())

    def named(self) -> Names:
        return self.entity or ()

    def describe_each(self, phrases: Phrases) -> str:
        owners = self.entity or phrases.keepers(self.KEY, self.kept) or ()
        return f"{self.KEY} {quoted_measure(self.kept)} of {phrases.all_of(owners).text}"

    def kept_words(self, phrases: Phrases) -> str:
        """Return it with whose it is: ``the counter “laps” of Y1``; of one of several without that."""
        return phrases.kept(self.KEY, self.kept, self.entity if isinstance(self.entity, str) else None)

    def several(self, phrases: Phrases, by: Compared) -> Subject | None:
        """Return the owners of whose values a condition is; None where one value is read, or all as one."""
        return owners_asked(phrases, self.KEY, self.kept, self.entity, by.of, negate=by.negate)


def owners_asked(
    phrases: Phrases, kind: str, name: str, entity: Names | None, of: Quantifier | None, *, negate: bool
) -> Subject | None:
    """Return the names of several that have a value each; None where one value is read, or all as one."""
    if of is None and entity is None and phrases.one_of_owners(kind, name) == "each":
        return None
    together = of is None and entity is None and kind != "counter" and phrases.owners(kind, name) is not None
    is_one = entity is None or phrases.is_one_owner(kind, name, entity)
    if (of is None and is_one and not together) or entity == "each":
        return None
    return phrases.quantified(of or "any", entity or phrases.keepers(kind, name) or (), negate=negate)
