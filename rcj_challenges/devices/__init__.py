"""Sensors, motors and radio: what a program can read and set.

Belongs here: which devices a robot has (`fitting`), what each of them measures or does (one file per family), and
the rack that serves all robots of a half (`rack`). Does not belong here: how readings travel to a program's process
(controllers), when a program is due (match), what the referee decides (referee).

Every device measures in the frames of the rule book: x forward, y left, z up of the robot; while a robot stands, its
frame is level and heights are nominal (ADR 5).
"""
