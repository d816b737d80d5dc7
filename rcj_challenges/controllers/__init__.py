"""Processes of the teams' programs: launch, isolate, exchange, supervise; the module they import."""
