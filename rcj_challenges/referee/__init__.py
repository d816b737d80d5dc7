"""The referee: triggers, conditions, actions, placements, sequences, and the engine that runs them.

Belongs here: everything that judges a snapshot by the rules of a scenario (`engine.Referee`), and the script that
plays the tests written in a scenario (`script`). Does not belong here: files, clocks, global random numbers, physics.
Snapshot in, output out; the same snapshots give the same outputs on every machine.

Each kind of word has one visible dict: `triggers.TRIGGERS`, `conditions.CONDITIONS`, `actions.ACTIONS`,
`places.PLACES`, `values.WORDS`.
"""
