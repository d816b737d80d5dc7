"""Lint of speeds that nothing here reaches: they are hardly meant in m/s, nor ways in m that nobody drives in time."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.conditions import Speed
from rcj_challenges.scenario.models.places import MAX_KICK_MPS
from rcj_challenges.scenario.models.triggers import NoProgress
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import visit

_PUSHED = 5
"""A robot that is hit or slides is faster than its wheels drive it, but not so many times."""


def check_speeds(subject: Subject) -> Iterator[Suspect]:
    """Speeds that something must have at least, and never has; ways that nobody can make in the time for them."""
    for name, rule in subject.scenario.rules.items():
        for model, path in visit(rule, ("rules", name)):
            if not isinstance(model, NoProgress | Speed):
                continue
            who = subject.members(model.entity, rule)
            if not who:
                continue  # of nobody nothing is asked
            if isinstance(model, NoProgress):
                yield from _ways(model, path, *_driven(who, subject))
                continue
            drives_mps, only_robots = _driven(who, subject)
            most_mps = _PUSHED * drives_mps if only_robots else max(_PUSHED * drives_mps, 2 * MAX_KICK_MPS)
            fastest = (
                f"a robot drives {drives_mps:g} m/s" if only_robots else f"a ball sets off with {MAX_KICK_MPS} m/s"
            )
            for key in ("at_least", "equals"):
                limit = getattr(model, key)
                if isinstance(limit, int | float) and limit > most_mps:
                    yield Suspect(
                        "speed_never_reached",
                        (*path, key),
                        f"it is never reached: {fastest} at most",
                        "correct it; speeds are in m/s",
                    )


def _driven(who: frozenset[str], subject: Subject) -> tuple[float, bool]:
    """Return how fast in m/s the fastest robot of some entities drives, and whether all of them are robots."""
    scenario = subject.scenario
    chassis = [scenario.kits[scenario.robots[one].kit].chassis for one in who if one in scenario.robots]
    drives_mps = max((one.max_wheel_radps * one.wheel_radius_m for one in chassis), default=0.0)
    return drives_mps, len(chassis) == len(who)


def _ways(model: NoProgress, path: Path, drives_mps: float, only_robots: bool) -> Iterator[Suspect]:
    most_m = (drives_mps if only_robots else MAX_KICK_MPS) * model.within_s
    if model.distance_m > most_m:
        who = "robots drive" if only_robots else "balls roll"
        yield Suspect(
            "speed_never_reached",
            (*path, "distance_m"),
            f"in {model.within_s:g} s {who} {most_m:g} m at most, so that it fires whatever they do",
            "correct it; distances are in m",
        )
