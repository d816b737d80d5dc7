"""What people look at: scoreboard, plain lines, replay page.

Belongs here: pictures and words made of records and of what a match tells its watchers. Does not belong here:
anything that changes a match or decides a result.
"""
