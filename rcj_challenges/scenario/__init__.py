"""The scenario file: models, strict loading with positions, cross references, lint, presets, JSON schema.

Belongs here: everything that turns YAML into a checked `Scenario`, and names into indices. Does not belong here:
physics, rules that run, anything that needs MuJoCo.
"""
