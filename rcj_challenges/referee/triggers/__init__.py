"""Triggers: edges, one file per family. One visible dict: `TRIGGERS`.

A trigger's compiler gives its rule an ear: at a watch that follows something on the field, or at a moment.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.rules import StandingRule
from rcj_challenges.referee.triggers import bodies, holding, moments, progress, ways, zones

TRIGGERS: dict[str, Callable[[Any, StandingRule, int, Workshop], None]] = {
    "half_started": moments.half_started,
    "half_ended": moments.half_ended,
    "phase_entered": moments.phase_entered,
    "time_reached": moments.time_reached,
    "timer_expired": moments.timer_expired,
    "event": moments.event,
    "program_fault": moments.program_fault,
    "tells": moments.tells,
    "enters": zones.enters,
    "leaves": zones.leaves,
    "stays_in": zones.stays_in,
    "displaced": zones.displaced,
    "crosses": ways.crosses,
    "sequence_completed": ways.sequence_completed,
    "sequence_broken": ways.sequence_broken,
    "no_progress": progress.no_progress,
    "touches": bodies.touches,
    "tips_over": bodies.tips_over,
    "holds": holding.holds,
}
"""Every word of a trigger, with what compiles it: gets the model, the rule, its place in the rule, the workshop."""
