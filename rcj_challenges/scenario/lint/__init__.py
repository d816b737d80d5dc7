"""Lint: what is legal in a scenario and hardly meant; a file for each thing that is looked at, `table` lists them.

Belongs here: warnings of `rcj-challenge validate`. Does not belong here: what makes a scenario wrong (`checks`).
"""
