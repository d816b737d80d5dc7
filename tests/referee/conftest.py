"""A small stage for rules: two robots a side, one ball, no rules but those of the test."""

import copy
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml

import rcj_challenges
from rcj_challenges.expect.scripted_match import ScriptedMatch, half_of
from rcj_challenges.scenario.load import Loaded, load
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.reading.extend import tree_of
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.tree import plain

PRESET = Path(rcj_challenges.__file__).parent / "scenario" / "presets" / "soccersim_v2.yaml"

_SMALL = """
id: small
title: A small stage
match: {halves: 1, half_s: 60}
robots:
  B1: {colour: blue, number: 1, kit: v2, start: {x_m: 0.4, y_m: 0.5, yaw_rad: -1.57}}
  B2: {colour: blue, number: 2, kit: v2, start: {x_m: -0.4, y_m: 0.5, yaw_rad: -1.57}}
  Y1: {colour: yellow, number: 1, kit: v2, start: {x_m: -0.4, y_m: -0.5, yaw_rad: 1.57}}
  Y2: {colour: yellow, number: 2, kit: v2, start: {x_m: 0.4, y_m: -0.5, yaw_rad: 1.57}}
entrants:
  blue: {title: Blue Moon, radio_channel: 2, robots: {B1: a.py, B2: a.py}}
  yellow: {title: Yellow Sub, radio_channel: 3, robots: {Y1: a.py, Y2: a.py}}
zones:
  left: {shape: rect, x_max_m: -0.1}
  right: {shape: rect, x_min_m: 0.1}
  middle: {shape: circle, centre_m: [0, 0], radius_m: 0.1}
gates:
  halfway: {from_m: [0.65, 0], to_m: [-0.65, 0]}
rules: {}
"""


@cache
def _read(text: str) -> dict[str, Any]:
    """Read a YAML text once: to read the preset and the stage takes longer than most of these tests."""
    return yaml.safe_load(text) or {}


def small_scenario(*sections: str) -> Scenario:
    """Return the small stage with sections (YAML) put on top of it one after the other, key by key."""
    tree = {**copy.deepcopy(_read(PRESET.read_text(encoding="utf-8"))), "schema_version": 2}
    for layer in (_SMALL, *sections):
        for key, value in copy.deepcopy(_read(layer)).items():
            # Robots and entrants of the preset are replaced as a whole by those of the stage.
            merges = isinstance(value, dict) and not (layer is _SMALL and key in {"robots", "entrants"})
            tree[key] = {**tree.get(key, {}), **value} if merges else value
    return Scenario.model_validate(plain(tree_of(tree, "small"), tuple))


@pytest.fixture(scope="session")
def small() -> Callable[..., Scenario]:
    """Return what makes a scenario of the small stage and more sections (YAML)."""
    return small_scenario


Stage = Callable[..., ScriptedMatch]


@pytest.fixture(scope="session")
def stage() -> Stage:
    """Return what begins a scripted play of the small stage with more sections (YAML)."""

    def begin(
        *sections: str, draws: dict[str, Any] | None = None, half: int = 1, seed: int = 1, **facts: Any
    ) -> ScriptedMatch:
        scenario = small_scenario(*sections)
        info = replace(half_of(scenario, half, seed), **facts)
        return ScriptedMatch(scenario, Roster.of(scenario), info, draws)

    return begin


@pytest.fixture(scope="session")
def match() -> Callable[..., Loaded]:
    """Return what loads the match, each variant once."""
    known: dict[tuple[str, ...], Loaded] = {}

    def loaded(*overrides: str) -> Loaded:
        if overrides not in known:
            known[overrides] = load("match", overrides)
        return known[overrides]

    return loaded


@pytest.fixture(scope="session")
def match_play(match: Callable[..., Loaded]) -> Stage:
    """Return what begins a scripted play of the match, yellow kicking off, with overrides."""

    def begin(
        *overrides: str, half: int = 1, seed: int = 1, kickoff: str | None = "yellow", **facts: Any
    ) -> ScriptedMatch:
        played = match(*overrides)
        info = replace(half_of(played.scenario, half, seed), **facts)
        draws = None if kickoff is None else {"first_kickoff": kickoff}
        return ScriptedMatch(played.scenario, played.roster, info, draws)

    return begin


@pytest.fixture(scope="session")
def ask() -> Callable[[ScriptedMatch], bool]:
    """Return what asks whether the condition holds in the next tick."""

    def asked(play: ScriptedMatch) -> bool:
        before = len(play.events_named("TRUE_NOW"))
        play.fail("B1")
        play.play()
        return len(play.events_named("TRUE_NOW")) > before

    return asked
