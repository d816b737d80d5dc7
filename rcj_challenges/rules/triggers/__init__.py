"""Triggers: moments at which a rule may fire, one file each."""

from typing import Annotated

from rcj_challenges.rules.base import Trigger, Vocabulary
from rcj_challenges.rules.triggers.crosses import Crosses
from rcj_challenges.rules.triggers.displaced import Displaced
from rcj_challenges.rules.triggers.enters import Enters
from rcj_challenges.rules.triggers.event import OnEvent
from rcj_challenges.rules.triggers.half_ended import HalfEnded
from rcj_challenges.rules.triggers.half_started import HalfStarted
from rcj_challenges.rules.triggers.holds import Holds
from rcj_challenges.rules.triggers.leaves import Leaves
from rcj_challenges.rules.triggers.no_progress import NoProgress
from rcj_challenges.rules.triggers.phase_entered import PhaseEntered
from rcj_challenges.rules.triggers.program_fault import ProgramFault
from rcj_challenges.rules.triggers.sequence_broken import SequenceBroken
from rcj_challenges.rules.triggers.sequence_completed import SequenceCompleted
from rcj_challenges.rules.triggers.stays_in import StaysIn
from rcj_challenges.rules.triggers.tells import Tells
from rcj_challenges.rules.triggers.time_reached import TimeReached
from rcj_challenges.rules.triggers.timer_expired import TimerExpired
from rcj_challenges.rules.triggers.tips_over import TipsOver
from rcj_challenges.rules.triggers.touches import Touches

TRIGGERS = Vocabulary("trigger")
TRIGGERS.add(
    HalfStarted,
    HalfEnded,
    PhaseEntered,
    TimeReached,
    TimerExpired,
    Enters,
    Leaves,
    Crosses,
    Touches,
    Displaced,
    NoProgress,
    StaysIn,
    TipsOver,
    SequenceCompleted,
    SequenceBroken,
    OnEvent,
    ProgramFault,
    Tells,
    Holds,
)

AnyTrigger = Annotated[Trigger, TRIGGERS]
