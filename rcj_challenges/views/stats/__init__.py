"""Statistics of runs: possession, distance, speeds, shots, time in the own half, faults and referee calls.

Belongs here: pure functions from records to figures, and the words that define each figure. Does not belong here:
reading records (records), tables for a terminal (cli).
"""

from rcj_challenges.views.stats.figures import DEFINITIONS, stats_as_json
from rcj_challenges.views.stats.run import run_stats
from rcj_challenges.views.stats.tally import Stats, merge_stats

__all__ = ["DEFINITIONS", "Stats", "merge_stats", "run_stats", "stats_as_json"]
