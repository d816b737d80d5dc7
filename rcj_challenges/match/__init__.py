"""The loop of a match, halves and seeds."""
