"""The ladder's arithmetic: ratings from results.

What belongs here: functions of the results alone, without database, clock or files, so that anyone can recompute a
table.
"""
