"""From YAML text to one finished tree: strict YAML, `extends`, overrides, params, rules written once for several.

Belongs here: all that happens before the models see the scenario. Every value keeps its place in its file.
"""
