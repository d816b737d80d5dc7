"""The live view: a match in the browser while it is played, on this machine only.

Belongs here: the feed of what happened so far, the server that hands it to any number of spectators, and the pace at
which the match runs for them. Does not belong here: the viewer itself (views/replay/viewer), the match (match).
"""

from rcj_challenges.views.live.pace import MAX_SPEED, Pace
from rcj_challenges.views.live.show import LiveShow, PortTakenError

__all__ = ["MAX_SPEED", "LiveShow", "Pace", "PortTakenError"]
