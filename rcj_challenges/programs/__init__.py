"""The processes of the teams' programs: launched, isolated, supplied with readings, supervised.

Belongs here: one process per robot, the protocol, limits and faults, logs; ``program_side/`` runs inside a process.
Does not belong here: reading what a team handed in (submissions), what a sensor reads or a motor does (devices), when a
program is due (match), what a fault means for the play (referee).
"""
