"""The store of a tournament: one SQLite file with what was played, submitted and decided.

Belongs here: the tables, the lock of the one writer, reading and writing. Does not belong here: what an outcome means.
"""
