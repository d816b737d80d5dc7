"""The physics: scenario to MuJoCo model, sub-steps, snapshots, placements; contact parameters with their source.

Belongs here: the motion of bodies. Does not belong here: what a program can sense or set (devices), rules (referee),
where something is placed (the referee decides, this room only moves it).
"""
