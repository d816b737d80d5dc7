"""Scenario to MuJoCo model, stepping, snapshots, placements; contact parameters with their source."""
