"""Plain, frozen data that the rooms exchange: time, snapshots, placements, events, faults, device traffic.

Belongs here: small dataclasses, the constants of the tick, and helpers for single texts and numbers that every room
uses: rounding scores (`amounts`), untrusted text (`sanitize`), random streams (`streams`). Does not belong here:
anything that decides, computes from a scenario, or touches processes or physics. Imports no other room.
"""
