"""Actions: what a rule does when it fires, one file each."""

from typing import Annotated

from rcj_challenges.rules.actions.assign import Assign
from rcj_challenges.rules.actions.count import Count
from rcj_challenges.rules.actions.draw import DrawAction
from rcj_challenges.rules.actions.emit import Emit
from rcj_challenges.rules.actions.end import End
from rcj_challenges.rules.actions.hold import Hold
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.release import Release
from rcj_challenges.rules.actions.remove import Remove
from rcj_challenges.rules.actions.reset import Reset
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.actions.set_flag import SetFlag
from rcj_challenges.rules.actions.set_phase import SetPhase
from rcj_challenges.rules.actions.set_spot import SetSpot
from rcj_challenges.rules.actions.timer import TimerAction
from rcj_challenges.rules.base import Action, Vocabulary

ACTIONS = Vocabulary("action")
ACTIONS.add(
    Score,
    Count,
    SetFlag,
    TimerAction,
    Reset,
    SetSpot,
    DrawAction,
    Assign,
    Place,
    Remove,
    Hold,
    Release,
    SetPhase,
    Emit,
    End,
)

AnyAction = Annotated[Action, ACTIONS]
