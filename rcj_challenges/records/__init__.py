"""Reflog, trajectory, result and digest: write and read."""
