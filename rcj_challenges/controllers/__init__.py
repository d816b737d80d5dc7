"""Processes of the teams' programs: open, launch, isolate, exchange, supervise; and the module that they import.

Belongs here: reading a team's folder or ZIP, starting one process per robot, the protocol, limits and faults, logs.
``program_side/`` is what runs in a program's own process. Does not belong here: what a sensor reads or a motor does
(devices), when a program is due (match), what a fault means for the play (referee).
"""
