"""Conditions: what must hold when a trigger fires.

A value that is a number, with a comparison, is a condition; the files here say what is particular to some of them, and
define what is no number.
"""

from rcj_challenges.rules.comparison import comparison_of
from rcj_challenges.rules.conditions.any_of import AnyOf
from rcj_challenges.rules.conditions.counter import CounterIs
from rcj_challenges.rules.conditions.distance import DistanceIs
from rcj_challenges.rules.conditions.draw import DrawIs
from rcj_challenges.rules.conditions.entity import FactIs
from rcj_challenges.rules.conditions.flag import FlagIs
from rcj_challenges.rules.conditions.last_touch import LastTouchIs
from rcj_challenges.rules.conditions.role import RoleIs
from rcj_challenges.rules.conditions.score import ScoreIs
from rcj_challenges.rules.conditions.sequence import SequenceIs
from rcj_challenges.rules.conditions.speed import SpeedIs
from rcj_challenges.rules.conditions.spot_free import SpotFree
from rcj_challenges.rules.conditions.timer import TimerIs
from rcj_challenges.rules.conditions.told import ToldIs
from rcj_challenges.rules.conditions.vocabulary import CONDITIONS, AnyCondition
from rcj_challenges.rules.conditions.way import WayIs
from rcj_challenges.rules.conditions.word import WordIs
from rcj_challenges.rules.values.count import CountValue
from rcj_challenges.rules.values.highest import HighestValue
from rcj_challenges.rules.values.lowest import LowestValue
from rcj_challenges.rules.values.sum import SumValue

CONDITIONS.add(
    comparison_of(CountValue),
    comparison_of(HighestValue),
    comparison_of(LowestValue),
    comparison_of(SumValue),
    CounterIs,
    ScoreIs,
    FlagIs,
    TimerIs,
    DistanceIs,
    SpeedIs,
    WayIs,
    DrawIs,
    RoleIs,
    LastTouchIs,
    ToldIs,
    SequenceIs,
    WordIs,
    SpotFree,
    AnyOf,
    FactIs,  # last: the key of an entity stands beside those of others
)

__all__ = ("CONDITIONS", "AnyCondition")
