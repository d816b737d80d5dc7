"""All models of the scenario language."""

import sys
from collections.abc import Iterator

from rcj_challenges.rules.fields import Strict
from rcj_challenges.scenario.models import scenario  # noqa: F401 - imports all others


def all_models() -> Iterator[type[Strict]]:
    """Yield each model that a scenario may contain, by module."""
    for name in sorted(sys.modules):
        if name.startswith(("rcj_challenges.rules.", "rcj_challenges.scenario.models.")):
            for value in vars(sys.modules[name]).values():
                own = isinstance(value, type) and issubclass(value, Strict) and value.__module__ == name
                if own and not value.__name__.startswith("_") and value is not Strict:
                    yield value
