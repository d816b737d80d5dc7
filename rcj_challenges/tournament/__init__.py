"""Tournaments: from a YAML file and a folder of submissions to tables, brackets and a site.

Belongs here: the tournament file, pairings and tables, the store of what was played, the runner, rulings, publishing.
Does not belong here: how a match is played (``match``), checked (``checker``) or drawn (``views``).
"""
