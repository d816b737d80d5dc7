"""What people look at: scoreboard, replay page, live view, video, statistics; the drawing and the sheet of a scenario.

Belongs here: pictures and words made of scenarios, of records and of the calls that a match makes to observers. Does
not belong here: anything that changes a match or decides a result.
"""
