"""What makes a well-formed scenario wrong: names, places, sizes, contradictions; `run` puts them in order.

Belongs here: errors that need more than one value to be seen. Does not belong here: the bounds of a single value
(`models`), and what is valid but probably a mistake (`lint`).
"""
