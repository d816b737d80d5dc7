"""What a team can do about a program that failed.

Belongs here: the table of hints (`table`), what a table cannot express (`packets`, `devices`, `endings`), and the
function that combines them (`hints`). Does not belong here: the stages of a check.
"""
