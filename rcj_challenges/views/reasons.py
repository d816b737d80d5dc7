"""Reasons for firings, for people: which trigger fired, and what the referee measured."""

from __future__ import annotations

from rcj_challenges.core.amounts import distinct_decimals, number_words
from rcj_challenges.core.play import Firing
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.scenario.models.scenario import Scenario

_DECIMALS = 3


class Reasons:
    """Formats why rules of a scenario fired."""

    def __init__(self, scenario: Scenario) -> None:
        self._rules = scenario.rules
        self._entities = {*scenario.robots, *scenario.balls, *scenario.obstacles}

    def about(self, cause: Firing | None) -> str:
        """Return the sentence of a rule; if it leaves open which of several triggers fired, the reason."""
        rule = self._rules.get(cause.rule) if cause is not None else None
        reason = self.reason(cause) if rule is not None and len(rule.triggers) > 1 else ""
        return reason or ("" if cause is None else cause.says)

    def reason(self, cause: Firing | None) -> str:
        """Return the reason of a firing: ``Y1 made no progress: 0.497 m in 15 s, at least 0.5 m``; or nothing."""
        rule = self._rules.get(cause.rule) if cause is not None else None
        if cause is None or rule is None:
            return ""
        fired = [one for one in rule.triggers if one.name() == cause.trigger]
        if len(fired) != 1 or not fired[0].REASON or (cause.measured is None and fired[0].LIMIT):
            return ""
        fields = {key: quoted(value) if isinstance(value, str) else value for key, value in fired[0]}
        measures = {"measured": cause.measured, "limit": cause.limit}
        decimals = distinct_decimals(cause.measured, cause.limit, _DECIMALS)
        numbers = {key: number_words(value, decimals) for key, value in measures.items() if value is not None}
        reason: str = fired[0].REASON.format(**{**fields, **numbers})
        entity = cause.entity or getattr(fired[0], "entity", "")
        reason = f"{entity} {reason}" if entity in self._entities else reason
        return reason[0].upper() + reason[1:]
