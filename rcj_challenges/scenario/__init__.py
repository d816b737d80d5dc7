"""The scenario file: models, strict loading with positions, cross references, lint, presets, JSON schema.

Belongs here: everything that turns YAML into a checked `Scenario`, and names into indices. Does not belong here:
physics, rules that run, anything that needs MuJoCo.

On the way from a file to a scenario: `reading` (what is written, and where; bases, params, entries that are repeated),
`models` (its form), `checks` (all else that must hold), `messages` (the words of errors); `load` has the
order. `lint` warns about valid scenarios that are probably mistakes.
"""
