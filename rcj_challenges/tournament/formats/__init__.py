"""The kinds of stages: from the teams and the outcomes so far to fixtures, tables, brackets and places.

Each module has a function that returns the state of a stage. They are pure, and know the file and the store of results
only through a `StageContext`.
"""
