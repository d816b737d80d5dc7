"""The live view: a match in the browser while it is played, on this machine only.

Belongs here: the feed, the server, and the pace of the match. Does not belong here: the viewer (views/replay/viewer).
"""

from rcj_challenges.views.live.pace import MAX_SPEED, Pace
from rcj_challenges.views.live.show import LiveShow

__all__ = ["MAX_SPEED", "LiveShow", "Pace"]
