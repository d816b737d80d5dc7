"""Writes and reads the record of a run: reflog, referee's log, trajectory, result, digest.

Belongs here: formats, files, folders, and what makes them survive a kill. Does not belong here: anything that decides a
result, physics, pages and pictures (views). ``docs/records.md`` describes every file.
"""
