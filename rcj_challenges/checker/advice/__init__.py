"""What a pupil can do about a program that failed: from the last lines of its log, and from its sources.

Belongs here: recognizing slips and saying the remedy; `hints` asks them all. Does not belong here: the
stages of a check.
"""
