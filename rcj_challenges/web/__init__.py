"""The league's web site: teams hand in, are checked by playing, and are listed at one place.

What belongs here: pages, accounts, the queue of jobs and its dispatcher, and the arithmetic of a ladder. What does not:
checking, playing and publishing themselves, which other packages do. Imported only by the commands
``site`` and ``submit``.
"""
