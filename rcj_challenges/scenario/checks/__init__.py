"""What makes a well-formed scenario wrong: names, places, sizes, contradictions; `table` puts them in order.

Belongs here: errors that need more than one value to be seen. Does not belong here: the bounds of a single value
(`models`), and what is legal and hardly meant (`lint`).
"""
