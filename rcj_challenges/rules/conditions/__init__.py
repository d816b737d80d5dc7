"""Conditions: what must hold when a trigger fires.

A value that is a number, with a comparison, is a condition; the files here define the others.
"""

from rcj_challenges.rules.comparison import comparison_of
from rcj_challenges.rules.conditions.any_of import AnyOf
from rcj_challenges.rules.conditions.draw import DrawIs
from rcj_challenges.rules.conditions.last_touch import LastTouchIs
from rcj_challenges.rules.conditions.role import RoleIs
from rcj_challenges.rules.conditions.sequence import SequenceIs
from rcj_challenges.rules.conditions.spot_free import SpotFree
from rcj_challenges.rules.conditions.told import ToldIs
from rcj_challenges.rules.several_conditions import CONDITIONS, AnyCondition
from rcj_challenges.rules.values import COMPARABLE
from rcj_challenges.rules.values.entity import FactValue

CONDITIONS.add(
    *map(comparison_of, COMPARABLE),
    DrawIs,
    RoleIs,
    LastTouchIs,
    ToldIs,
    SequenceIs,
    SpotFree,
    AnyOf,
    comparison_of(FactValue),  # last: the key of an entity stands beside those of others
)

__all__ = ("CONDITIONS", "AnyCondition")
