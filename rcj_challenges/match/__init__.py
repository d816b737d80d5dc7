"""The loop of a match: halves, seats and seeds, programs in lockstep, everything recorded.

Belongs here: who plays where in which half, the order of what happens in a tick, and what is told to those who
watch. Does not belong here: rules (referee), physics (world), what a sensor reads (devices), how a program is started
or stopped (controllers), what a record looks like (records).
"""
