"""Conditions: what must hold when a trigger fires, one file each."""

from typing import Annotated

from rcj_challenges.rules.base import Condition
from rcj_challenges.rules.conditions.all_of import AllOf
from rcj_challenges.rules.conditions.any_of import AnyOf
from rcj_challenges.rules.conditions.counter import CounterIs
from rcj_challenges.rules.conditions.distance import Distance
from rcj_challenges.rules.conditions.drawn import Drawn
from rcj_challenges.rules.conditions.flag import FlagIs
from rcj_challenges.rules.conditions.half import HalfIs
from rcj_challenges.rules.conditions.held import IsHeld
from rcj_challenges.rules.conditions.in_zone import InZone
from rcj_challenges.rules.conditions.last_touch import LastTouch
from rcj_challenges.rules.conditions.looks import Looks
from rcj_challenges.rules.conditions.sequence_at import SequenceAt
from rcj_challenges.rules.conditions.speed import Speed
from rcj_challenges.rules.conditions.spot_free import SpotFree
from rcj_challenges.rules.conditions.timer import TimerIs
from rcj_challenges.rules.conditions.told import Told
from rcj_challenges.rules.conditions.vocabulary import CONDITIONS
from rcj_challenges.rules.conditions.way import WayIs

CONDITIONS.add(
    InZone,
    Speed,
    Distance,
    WayIs,
    Looks,
    IsHeld,
    CounterIs,
    FlagIs,
    Drawn,
    TimerIs,
    LastTouch,
    Told,
    SpotFree,
    SequenceAt,
    HalfIs,
    AnyOf,
    AllOf,
)

AnyCondition = Annotated[Condition, CONDITIONS]
