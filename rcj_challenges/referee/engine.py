"""The referee: takes a snapshot, returns an output. The tick contract (ADR 1) as a list of steps.

Detect, then apply: all triggers are judged against the snapshot; then the rules fire in rounds (`firing_order`), and
at last things are set down. After the last tick the rules settle.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from rcj_challenges.core.changes import Change, ChangeTracker
from rcj_challenges.core.messages import number_in
from rcj_challenges.core.play import Event, Fault, HalfInfo, Placement, Pose2, RefereeOutput, Snapshot
from rcj_challenges.core.play import Firing as FiringRecord
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.referee.assembling import assemble
from rcj_challenges.referee.compiling import Broadcasting, CompileContext
from rcj_challenges.referee.firing_order import Rounds
from rcj_challenges.referee.log_sentences import no_room_sentence
from rcj_challenges.referee.placement import AT_REST, PlacementJob, apply_placements, carry_out, compile_placement
from rcj_challenges.referee.ranking import RankedValues
from rcj_challenges.referee.state import State
from rcj_challenges.rules.effects import Places
from rcj_challenges.rules.placement import AS_USUAL
from rcj_challenges.rules.places import place_of
from rcj_challenges.rules.ranked import counters_in
from rcj_challenges.scenario.draw_order import Series
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.models.state import Phase
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.shapes import start_noise_m
from rcj_challenges.tracking.trackers import NEVER, Missed

MOST_PASSES = 16
"""Settling passes after the last tick: more than any chain of rules needs that is not a loop."""


class Referee:
    """Judges one half.

    Call `start` once with the snapshot of tick 0, then `judge` with that of each tick in order, then `finish`. The
    placements of an output must be carried out exactly; the next snapshot shows their effect in the physics.

    Args:
        draws: values of draws decided beforehand (for tests): one stands until a rule draws again; of several the next
            one comes whenever the draw is drawn, and when all have come, chance decides again.
        spots: where random ``set_spot`` actions set spots, decided beforehand in the same way, in m.

    Attributes:
        scores: points by entrant, as seated in this half.
        counters, flags: by name, those kept per entity as a mapping; None: it has no value.
        draws: what the draws decided, and the holders of the roles, by name; None: nothing.
        spots: where the spots are now, by name: [x, y] in m.
        rounds: in which rules fire.
        ranked: returns the values by which entrants are ranked, as `RankedValues.read`.
        undecided, undecided_spots: return what was decided beforehand and has not come, as those of `State` do.

    Raises:
        ValueError: ``draws`` names no draw, or a value that it cannot have.
    """

    def __init__(
        self, scenario: Scenario, roster: Roster, half: HalfInfo, draws: Mapping[str, Series] | None = None,
        spots: Mapping[str, Sequence[tuple[float, float]]] | None = None,
    ) -> None:  # fmt: skip
        self._state = State(scenario, roster, half)
        self._half = half
        self.scores, self.counters, self.flags = self._state.scores, self._state.counters, self._state.flags
        self.draws, self.spots = self._state.draws, self._state.spots
        self.undecided, self.undecided_spots = self._state.undecided, self._state.undecided_spots
        self.rounds = Rounds(self._state, self._enter_phase)
        self._context = CompileContext(self._state, self._emit, self.rounds.set_phase)
        assemble(self._context)
        self._state.decide_draws(draws or {})
        self._state.decided_spots = {name: list(places) for name, places in (spots or {}).items()}
        self._trackers, self._hits = self._context.trackers, self._state.hits
        self._contacts, self._queue = self._state.contacts, self._context.queue
        self._clock_events = self._context.clock_events
        self._all_present = True
        self._clock_runs = self._clock_ran = True
        self._waiting = self._has_begun_anew = False
        self._phase_ends = NEVER
        self._entered: list[tuple[str, str]] = []
        self._emitted: list[tuple[str, tuple[str, ...]]] = []
        self._events: list[Event] = []
        self._firings = self.rounds.firings
        self._quiet: RefereeOutput | None = None
        broadcast = scenario.broadcast
        self._broadcast = None if broadcast is None else Broadcasting(broadcast, self._context)
        self._ranked_by = tuple(counters_in(scenario.result.rank))
        self.ranked = RankedValues(scenario.result.rank, self._state).read
        self._change_tracker = ChangeTracker(self._state.scores)

    # --- state for readers --------------------------------------------------------------------------------------------

    @property
    def phase(self) -> str:
        """The phase now."""
        return self._state.phase

    @property
    def held(self) -> dict[str, bool]:
        """By robot, whether it is held, by a rule or by the phase."""
        roster = self._state.roster
        return {name: self._state.held.holds(robot) for robot, name in enumerate(roster.entities[: roster.robots])}

    @property
    def missed(self) -> list[tuple[str, Missed]]:
        """What set off no rule although one seems to wait for it, each with its entity, if it is about one."""
        names, trackers = self._state.names, self._trackers.all
        return [(names[one.entities[0]] if one.entities else "", one.missed) for one in trackers if one.missed]

    @property
    def kept(self) -> dict[str, Any]:
        """What is kept for the next half, as its `HalfInfo.kept`."""
        return self._state.kept()

    @property
    def clock_ticks(self) -> int:
        """Ticks of the half's clock; the ticks of phases whose clock stops are not among them."""
        return self._state.clock

    @property
    def time_is_up(self) -> bool:
        """Whether the half has been judged in full: its clock has reached its length."""
        return self._state.clock >= self._half.ticks

    # --- the three calls ----------------------------------------------------------------------------------------------

    def start(self, snapshot: Snapshot) -> RefereeOutput:
        """Judge tick 0: layouts, arming, ``half_started``. The snapshot holds the nominal start poses."""
        state = self._state
        state.poses = state.before = list(snapshot.substeps[-1])
        state.uprights = snapshot.uprights
        state.placed_at = list(state.poses)
        state.pose_history.add(state.poses)
        self._context.set_lengths()
        self._clock_events.start()
        self._set_phase(state.phase)
        self._trackers.enter(state.phase, None)
        self._hits.report(self._clock_events.half_started)
        self._report_faults(snapshot.faults)
        self.rounds.fire()
        self._scatter_starts()
        return self._output()

    def judge(self, snapshot: Snapshot, by_hand: frozenset[int] = frozenset()) -> RefereeOutput:
        """Judge a tick; ``by_hand``: entities that a test has put elsewhere since the last one."""
        state = self._state
        state.by_hand = by_hand
        if self._has_begun_anew:  # with the phase of the tick before: timers end at another time
            self._trackers.reschedule()
            self._has_begun_anew = False
        tick = state.tick = snapshot.tick
        substeps = snapshot.substeps
        changed_phase = tick >= self._phase_ends
        if tick >= state.held.ends:
            self._trackers.release(state.held.let_go_at(tick))
        self._clock_ran = self._clock_runs
        if self._clock_ran:
            state.clock += 1
        self._take_in(snapshot)
        has_news = self._entered or self._emitted
        if changed_phase:
            self._enter_phase(state.scenario.phases[state.phase].next)
        self._trackers.advance(substeps, changed_phase=changed_phase)
        if has_news or changed_phase or snapshot.faults or self._clock_events.times:
            self._report_moments(snapshot.faults)
        if self._hits:
            self.rounds.fire()
        if self._events or self._firings or self._queue.busy or self._broadcast is not None:
            return self._output()
        return self._quiet_output()

    def _take_in(self, snapshot: Snapshot) -> None:
        """Store the snapshot's facts before anything is judged."""
        state, judged = self._state, snapshot.substeps[-1]
        state.before = state.poses
        if self._all_present:
            state.poses = judged
        else:  # what is off the field stays where it was last seen
            state.poses = [pose if state.present[i] else state.poses[i] for i, pose in enumerate(judged)]
        state.uprights = snapshot.uprights
        if state.ways:
            state.add_ways()
        if state.pose_history.used:
            state.pose_history.add(judged)
        if self._contacts.used:
            self._contacts.advance(snapshot.touches)
        if snapshot.messages:
            self._receive_messages(snapshot.messages)

    def finish(self) -> RefereeOutput:
        """Settle what the last tick set off, fire ``half_ended``, and settle again; a rule may still end the match."""
        ended = self._state.ended
        placements = self._settle()
        by = "time" if ended is None else "rule"
        self._hits.report([binding for wanted, binding in self._clock_events.half_ended if wanted in (None, by)])
        settled, self.rounds.settling = self.rounds.settling, 0
        self.rounds.fire()
        placements += self._carry_out()
        self.rounds.settling = settled
        placements += self._settle()
        if self._hits:
            self.rounds.log_unsettled()
        if not self._state.match_over:
            self._state.ended = ended  # what is over cannot end once more
        return replace(self._output(), placements=placements)

    def _settle(self) -> tuple[Placement, ...]:
        """Judge passes in which no time passes, until one fires nothing; `MOST_PASSES` in all.

        Events, phases entered, and conditions that have come true set rules off; clock, timers and windows stand.
        """
        placements: tuple[Placement, ...] = ()
        while True:
            self._report_changes()
            self._trackers.settle()
            if not self._hits or self.rounds.settling == MOST_PASSES:
                return placements
            self.rounds.settling += 1
            self.rounds.fire()
            placements += self._carry_out()

    def bring_back(self, entity: int, pose: Pose2) -> None:
        """Put what is off the field back on it, between two ticks; only tests do."""
        self._queue.forget(entity)
        apply_placements([(entity, pose, AT_REST)], self._state)
        self._note_moved({entity})

    # --- events of this tick ------------------------------------------------------------------------------------------

    def _report_moments(self, faults: tuple[Fault, ...]) -> None:
        """Report the moments of this tick: phases entered, events of the tick before, times, faults."""
        self._report_changes()
        if self._clock_ran:
            for one in self._clock_events.due_at(self._state.clock):
                self._hits.report([one.binding], one.next_s, one.at_s)
        self._report_faults(faults)

    def _report_changes(self) -> None:
        """Report phases entered and events emitted since the last time."""
        entered, self._entered = self._entered, []
        emitted, self._emitted = self._emitted, []
        for phase, left in entered:
            for wanted, binding in self._clock_events.entered.get(phase, ()):
                if wanted is None or wanted == left:
                    self._hits.report([binding])
        events = self._clock_events.events
        for name in dict.fromkeys(name for name, _ in emitted):
            self._hits.report(events.get((name, None), []))
        for heard_of in dict.fromkeys((name, one) for name, about in emitted for one in about):
            self._hits.report(events.get(heard_of, []))

    def _report_faults(self, faults: tuple[Fault, ...]) -> None:
        for fault in faults:
            self._hits.report(self._clock_events.faults.get(fault.robot, []))

    def _receive_messages(self, messages: tuple[tuple[int, str], ...]) -> None:
        """Store radio messages of robots to the referee; those of robots off the field are dropped."""
        state = self._state
        for entity, text in messages:
            if state.present[entity]:
                name = state.names[entity]
                state.messages[name] = text
                for says, binding in self._clock_events.messages.get(name, ()):
                    if says(text):
                        self._hits.report([binding], number_in(text))

    # --- events and phases --------------------------------------------------------------------------------------------

    def _emit(self, name: str, payload: dict[str, object], about: tuple[str, ...]) -> None:
        self._events.append(Event(self._state.tick, name, payload))
        self._emitted.append((name, about))

    def _enter_phase(self, phase: str) -> None:
        """Enter a phase; ``phase_entered`` fires in the next tick."""
        left = self._state.phase
        self._entered.append((phase, left))
        self._state.phase = phase
        self._has_begun_anew |= self._state.begin_phase(phase)
        self._set_phase(phase)
        self._trackers.enter(phase, left)

    def _set_phase(self, phase: str) -> None:
        model = self._state.scenario.phases.get(phase) or Phase()  # `play` need not be written
        self._clock_runs = model.clock == "runs"
        self._waiting = model.waiting_for_kickoff
        self._state.held.by_phase = model.robots == "held"
        lasts_s = self._context.length_s(model.lasts_s)
        self._phase_ends = NEVER if lasts_s is None else self._state.tick + ticks_from_s(lasts_s)

    # --- placements ---------------------------------------------------------------------------------------------------

    def _scatter_starts(self) -> None:
        """At tick 0: what has noise in its start pose and was placed by no rule starts with that noise."""
        for entity, name in enumerate(self._state.names):
            if start_noise_m(self._state.scenario, name) != (0.0, 0.0) and not self._queue.concerns(entity):
                start = Places(name, place_of("start"), AS_USUAL)
                spec = compile_placement(start, self._context.names, entity, f"placement/start/{name}")
                self._queue.ask(PlacementJob(entity, spec, None))

    def _carry_out(self) -> tuple[Placement, ...]:
        state = self._state
        jobs = self._queue.take(state)
        if not jobs:
            return ()
        placements, failed = carry_out(jobs, state, self._context.bodies)
        for job in failed:
            self._log_no_room(job)
            if job.spec is not None and job.spec.how.on_failure == "retry":
                self._queue.ask_later(replace(job, due=state.tick + 1, instead_of=None, is_logged=True))
            elif job.instead_of is not None and not state.present[job.entity]:
                # An entity that was to be removed and placed in one tick, and stays, was never off.
                self._queue.ask_later(job.instead_of)
        moved = {placement.entity for placement in placements}
        if moved:
            self._note_moved(moved)
        return tuple(placements)

    def _note_moved(self, moved: set[int]) -> None:
        self._all_present = all(self._state.present)
        self._contacts.forget(moved)
        self._trackers.on_placed(moved)

    def _log_no_room(self, job: PlacementJob) -> None:
        """Log once that a placement found no room."""
        state = self._state
        if job.is_logged or job.rule is None or job.spec is None:
            return
        says = no_room_sentence(job, job.spec, state, self._context.bodies)
        name = state.names[job.entity]
        record = FiringRecord(
            state.tick, job.rule.name, name, "place", suppressed="no_room", says=says, other=job.rule.other,
            settling=self.rounds.settling,
        )  # fmt: skip
        self._firings.append(record)

    # --- the output ---------------------------------------------------------------------------------------------------

    def _output(self) -> RefereeOutput:
        placements = self._carry_out() if self._queue.busy else ()
        events, firings = tuple(self._events), tuple(self._firings)
        broadcast = self._broadcast
        to_all, private = (None, None) if broadcast is None else broadcast.values_at(self._state.tick)
        self._events.clear()
        self._firings.clear()
        return RefereeOutput(
            events=events,
            firings=firings,
            placements=placements,
            phase=self._state.phase,
            waiting_for_kickoff=self._waiting,
            ended=self._state.ended,
            ends_match=self._state.match_over,
            broadcast=to_all,
            private_broadcasts=private,
            robots_held=self._state.held.by_phase,
            held=self._state.held.by_rules,
            changes=self._changes(),
        )

    def _changes(self) -> tuple[Change, ...]:
        state = self._state
        counters, ranked = state.counters, self._ranked_by
        return self._change_tracker.update(
            state.tick,
            phase=(state.phase, self._waiting),
            scores=state.scores,
            counters={name: dict(value) if isinstance(value := counters[name], dict) else value for name in ranked},
            held=tuple(state.names[robot] for robot in sorted(state.held.by_rules)),
        )

    def _quiet_output(self) -> RefereeOutput:
        """Return the output of an uneventful tick: one object, until the phase or the held robots change."""
        quiet, state = self._quiet, self._state
        if quiet is None or quiet.phase != state.phase or quiet.held is not state.held.by_rules:
            output = self._output()
            self._quiet = replace(output, changes=())
            return output
        return quiet
