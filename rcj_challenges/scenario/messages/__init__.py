"""What an author is told of a mistake: what was found, what is expected, what was probably meant.

Belongs here: words and remedies. Does not belong here: finding mistakes (`reading`, `models`, `checks`).
"""
