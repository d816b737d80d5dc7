"""Plain, frozen data that the rooms hand each other: time, snapshots, placements, events, faults, device traffic.

Belongs here: small dataclasses and the constants of the tick. Does not belong here: anything that decides, computes
from a scenario, or touches files, processes or physics. Imports no other room.
"""
