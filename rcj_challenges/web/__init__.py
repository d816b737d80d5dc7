"""The league's web site: teams hand in, are checked by playing, and are listed at one place.

What belongs here: pages, accounts, the queue of jobs and its dispatcher. What does not: checking, playing, rating and
publishing themselves, which other packages do. Imported only by the commands ``site`` and ``submit``.
"""
