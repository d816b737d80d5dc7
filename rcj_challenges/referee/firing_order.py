"""Fires the rules of a tick in rounds (ADR 1, line 4): in each, conditions are judged on one truth, then actions run.

A round is a priority: first the rules that something on the field set off, then, in a round of their own, those that a
time set off. A phase that an action sets is entered when its round ends.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby

from rcj_challenges.core.play import Firing as FiringRecord
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.referee.log_sentences import fill_blanks
from rcj_challenges.referee.state import State
from rcj_challenges.tracking.bound_rules import BoundRule, Denial, Denied, Firing, TriggerHit


class Rounds:
    """Judges and fires the rules whose triggers fired.

    Attributes:
        firings: for the referee's log, in order; the engine takes them.
        settling: the number of the settling pass; 0: an ordinary tick.
        denied: what kept triggered rules from firing; None: it is not noted (only tests need it).
    """

    def __init__(self, state: State, enter_phase: Callable[[str], None]) -> None:
        self.firings: list[FiringRecord] = []
        self.settling = 0
        self.denied: Denied | None = None
        self._state = state
        self._hits = state.hits
        self._enter_phase = enter_phase
        self._next_phase: str | None = None
        self._lost_phase = False

    def fire(self) -> None:
        """Fire in rounds, and forget what set them off."""
        hits = self._hits.first_by_rule()
        self._hits.clear()
        at_start = self._state.phase
        won: set[tuple[str, str | None]] = set()
        denied: list[tuple[BoundRule, int]] = []
        for _, group in groupby(hits, key=lambda hit: hit.round):
            chosen = self._chosen([hit for hit in group if hit.binding.rule.is_active_in(at_start)], denied)
            for hit in chosen:
                self._run(hit, won)
            if self._next_phase is not None:
                phase, self._next_phase = self._next_phase, None
                self._enter_phase(phase)
        if self.denied is not None:  # of several that a rule is for, what kept the first of them
            for rule, place in denied:
                denial = Denial(place, held_after=rule.tests[place]())
                self.denied.setdefault(rule.name, {}).setdefault(self._state.tick, denial)

    def set_phase(self, phase: str) -> None:
        """Let a phase begin when the round ends; of several that differ the first."""
        if self._next_phase is None:
            self._next_phase = phase
        elif self._next_phase != phase:
            self._lost_phase = True

    def log_unsettled(self) -> None:
        """Log what would fire after the last settling pass."""
        for hit in self._hits.first_by_rule():
            self._log(self._firing(hit), "unsettled")
        self._hits.clear()

    def _chosen(self, hits: list[TriggerHit], denied: list[tuple[BoundRule, int]]) -> list[TriggerHit]:
        """Return the hits of a round whose conditions hold."""
        chosen = []
        for hit in hits:
            if hit.is_past is not None and hit.is_past():
                continue
            tests = hit.binding.rule.tests
            failed = next((place for place, test in enumerate(tests) if not test()), None)
            if failed is None:
                chosen.append(hit)
            elif self.denied is not None:
                denied.append((hit.binding.rule, failed))
        return chosen

    def _run(self, hit: TriggerHit, won: set[tuple[str, str | None]]) -> None:
        rule, firing = hit.binding.rule, self._firing(hit)
        suppressed = self._suppressed(rule, won)
        self._lost_phase = False
        if suppressed is None:
            if rule.exclusive is not None:
                won.add(rule.exclusive)
            rule.past.executions += 1
            if rule.cooldown_s is not None:
                rule.past.rests_until = self._state.tick + ticks_from_s(rule.cooldown_s(firing) or 0.0)
            for act in rule.actions:
                act(firing)
        self._log(firing, suppressed)
        if self._lost_phase:
            self._log(Firing(rule, firing.entity, "set_phase"), "phase_taken")

    @staticmethod
    def _firing(hit: TriggerHit) -> Firing:
        return Firing(hit.binding.rule, hit.binding.entity, hit.binding.trigger, hit.measured, hit.limit)

    def _log(self, firing: Firing, suppressed: str | None) -> None:
        rule, state = firing.rule, self._state
        self.firings.append(
            FiringRecord(
                tick=state.tick,
                rule=rule.name,
                entity=firing.subject,
                other=rule.other,
                trigger=firing.trigger,
                measured=firing.measured,
                limit=firing.limit,
                scored=firing.scored,
                suppressed=suppressed,
                says=fill_blanks(rule.says, state, firing),
                place=firing.place,
                settling=self.settling,
            )
        )

    def _suppressed(self, rule: BoundRule, won: set[tuple[str, str | None]]) -> str | None:
        if not rule.is_active_in(self._state.phase):
            return "phase"
        if rule.exclusive in won:
            return "exclusive"
        if self._state.tick < rule.past.rests_until:
            return "cooldown"
        if rule.max_executions is not None and rule.past.executions >= rule.max_executions:
            return "max_executions"
        return None
