"""Plain, frozen data that the rooms hand each other: time, snapshots, placements, events, faults, device traffic.

Belongs here: small dataclasses, the constants of the tick, and what every room does alike with single texts and
numbers: how scores are rounded (`amounts`), texts of strangers shown (`shown`), random streams named (`streams`). Does
not belong here: anything that decides, computes from a scenario, or touches processes or physics. Imports no other
room.
"""
