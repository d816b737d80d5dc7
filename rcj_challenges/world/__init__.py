"""The physics: scenario to MuJoCo model, sub-steps, snapshots, placements; contact parameters with their source.

Belongs here: what bodies do. Does not belong here: what a program can sense or set (devices), what a rule makes of it
(referee), where something is to be put (the referee decides, this room sets it down).
"""
