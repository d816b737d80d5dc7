"""Error messages about mistakes in scenarios: what was found, what was expected, and a suggestion.

Belongs here: texts of messages and help. Does not belong here: finding mistakes (`reading`, `models`, `checks`).
"""
