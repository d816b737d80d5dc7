"""The scenario file: models, strict loading with positions, cross references, lint, presets, JSON schema.

Belongs here: everything that turns YAML into a checked `Scenario`, and names into indices. Does not belong here:
physics, rules that run, anything that needs MuJoCo.

On the way from a file to a scenario: `find`, `yaml_strict` and `tree` (what is written, and where), `extend` and
`merge` (over its bases), `params` and `repeating`, `models` (its form; `explain` says what pydantic refuses), `checks`
(all else that must hold); `load` has the order. Then `lint` tells what is legal and hardly meant: one file ``lint_*``
for each family of findings; what they share stands in `lint_suspect`, `lint_logic` and `lint_shapes`.
"""
