"""Lint of conditions on speeds that nothing here reaches: they are hardly meant in m/s."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.conditions import Speed
from rcj_challenges.scenario.models.places import MAX_KICK_MPS
from rcj_challenges.scenario.visiting import visit

_PUSHED = 5
"""A robot that is hit or slides is faster than its wheels drive it, but not so many times."""


def check_speeds(subject: Subject) -> Iterator[Suspect]:
    """Speeds that something must have at least, and never has."""
    scenario = subject.scenario
    for name, rule in scenario.rules.items():
        for model, path in visit(rule, ("rules", name)):
            if not isinstance(model, Speed):
                continue
            who = subject.members(model.entity, rule)
            chassis = [scenario.kits[scenario.robots[one].kit].chassis for one in who if one in scenario.robots]
            drives_mps = max((one.max_wheel_radps * one.wheel_radius_m for one in chassis), default=0.0)
            only_robots = len(chassis) == len(who)
            most_mps = _PUSHED * drives_mps if only_robots else max(_PUSHED * drives_mps, 2 * MAX_KICK_MPS)
            fastest = (
                f"a robot drives {drives_mps:g} m/s" if only_robots else f"a ball sets off with {MAX_KICK_MPS} m/s"
            )
            for key in ("at_least", "equals"):
                limit = getattr(model, key)
                if who and isinstance(limit, int | float) and limit > most_mps:
                    yield Suspect(
                        "speed_never_reached",
                        (*path, key),
                        f"it is never reached: {fastest} at most",
                        "correct it; speeds are in m/s",
                    )
