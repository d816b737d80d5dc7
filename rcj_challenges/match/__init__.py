"""Runs matches: halves and seeds, programs in lockstep, everything recorded.

Belongs here: the order of what happens in a tick, and the calls of observers. Does not belong here: rules (referee),
physics (world), what a sensor reads (devices), how a program is started or stopped (programs), what a record looks
like (records).
"""
