"""Triggers, conditions, actions, placements, sequences and the engine that runs them. Pure: no I/O, no clock, no global random."""
