"""Benchmarks: each a command of its own; `python -m benchmarks` prints all rows of the table of bars."""
