"""The replay page: one HTML file that shows a recorded run on any computer, without a network.

Belongs here: making the page of a record, finding and opening records, and the viewer itself (``viewer/``: JavaScript,
CSS and HTML without any dependency). Does not belong here: reading and writing records (records).
"""

from rcj_challenges.views.replay.browse import find_run, list_runs
from rcj_challenges.views.replay.page import write_replay

__all__ = ["find_run", "list_runs", "write_replay"]
