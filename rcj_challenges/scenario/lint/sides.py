"""Lint of sides: what a draw for the whole match means where the teams keep theirs."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect


def check_sides(subject: Subject) -> Iterator[Suspect]:
    """Draws of an entrant for the whole match, where no team ever changes its seat."""
    scenario = subject.scenario
    match = scenario.match
    if match.halves == 1 or match.swap_sides:
        return
    for name, draw in scenario.draws.items():
        if draw.keep == "match" and set(draw.values) == set(scenario.entrants) and len(draw.values) > 1:
            yield Suspect(
                "same_entrant_in_every_half",
                ("match", "swap_sides"),
                f"draw '{name}' is drawn once for all {match.halves} halves, and the teams keep their sides: "
                "the same team is drawn in each half",
                f"write '{name}: {{keep: half, not_again: match}}' under draws, so that the next half has "
                "the other one",
            )
