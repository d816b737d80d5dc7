"""The pydantic models of a scenario file: what may be written, with units, bounds and defaults.

Belongs here: one file per section family, each field described for the reference page. Does not belong here:
reading YAML, positions, cross references between sections (``rcj_challenges.scenario.checks``), anything that runs.
"""
