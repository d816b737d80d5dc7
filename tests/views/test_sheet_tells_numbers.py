"""Who changes a number of a scenario reads the new one on its rule sheet, or in the drawing on it.

Of each field that is a number, a choice or a yes or no, a leaf of what is shipped is changed: of a scenario, or of an
example of the reference; by day of every sixth one. What needs no telling is listed, with the reason.
"""

from __future__ import annotations

import re
import types
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin

import pytest
from pydantic import BaseModel, ValidationError

from rcj_challenges.core.timing import TICK_MS
from rcj_challenges.rules.base import Vocabulary
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.facts import Facts
from rcj_challenges.rules.number import NumberValue, Valued
from rcj_challenges.rules.phrasing import degrees, number, seconds
from rcj_challenges.rules.ranked import Ranked
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import Loaded, load, load_resolved, load_text
from rcj_challenges.scenario.models import scenario as models
from rcj_challenges.scenario.shape import fields
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.sheet import sheet_markdown
from scripts.write_reference import read_examples
from tests.scenario.writing import in_tuples

pytestmark = pytest.mark.usefixtures("without_drawing")

_OF_TESTS = (models.Expectation, models.MatchExpectation, models.ExpectedEvent, models.Given, models.Keyframe)
"""What stands below `expect` is about the rules' tests, not about the challenge."""

_SHIPPED = ("match", "match_2021", "variants/precision_lidar_v2", "variants/fast_shooter_v2", "examples/hot_spot")
"""Beside the examples of the reference: what these do not show."""

_MAX_LEAVES = 6
"""So many leaves of a field are changed, one after the other, until one is printed."""

_NEEDS_NO_TELLING = {
    "CameraDevice.hz": "the time between pictures is given, in whole ticks",
    "BallReceiverDevice.channel": "what getChannel returns; nothing else is sent to it, whatever the number",
    "Place.max_attempts": "how often chance tries before it is said that there is no room",
    "Placing.max_attempts": "how often chance tries before it is said that there is no room",
    "Robot.number": "what stands on its lid in pictures",
    "Rule.priority": "the rules stand in the order in which they are judged",
    "Scenario.params": "the value stands wherever the param is used",
    "ToldIs.is_a": "a number or a position is asked for by its text as well",
}
"""Fields that may change without a word on the sheet, and why."""

_NAMES = {"Assign.to", "RoleIs.equals"}
"""What stands where a number may, but is always the name of a member."""

_DRAWN = ("RectZone.", "CircleZone.", "PolygonZone.", "HalfPlaneZone.", "Gate.", "Spot.")
"""What the drawing on the sheet tells, in its legend."""

_SHOWN_NOWHERE_ELSE = """
schema_version: 2
id: small
title: Small
extends: soccersim_v2
field: {goals: {yellow_goal: null}}
obstacles: {bin: {shape: cylinder, centre_m: [0.5, 0.2], radius_m: 0.05, movable: true}}
zones:
  west: {shape: circle, centre_m: [-0.4, 0], radius_m: 0.1}
  east: {shape: circle, centre_m: [0.4, 0], radius_m: 0.1}
sequences: {way: {per: robots, steps: [west, east]}}
counters: {laps: {per: robots}, best_m: {keeps: highest, initial: 2}}
flags: {out: {}}
timers: {watch: {lasts_s: 30, per: robots}}
draws: {tile: {values: [1, 2, 5]}}
roles: {hunter: {of: [Y1, Y2, Y3], order: random}}
broadcast: {fields: {version: 3}, only: {Y1: {version: 4}}}
rules:
  put:
    triggers: [{trigger: displaced, entity: ball, from: [0.15, 0.25], distance_m: 0.1, angle_rad: 0.6}, {trigger: half_started}]
    actions:
      - {action: place, entity: Y1, at: {furthest_free: neutral_spots, from: [0.1, 0.2]}, facing: {towards: [0.3, 0.4]}}
      - {action: place, entity: Y2, at: {nearest_free: neutral_spots, to: [0.1, 0.2]}}
      - {action: set_spot, spot: middle_blue, to: [0.12, 0.34]}
      - {action: place, entity: ball, at: {uniform_in: west, from: [0.1, 0.3], at_least_m: 0.3}}
      - {action: place, entity: ball, at: {choice: [[0.5, 0], [0.5, 0.1]], from: [0.1, 0.3], at_least_m: 0.3}}
      - {action: assign, role: hunter}
      - {action: place, entity: ball, at: {on_line: [[0, 0], [0.5, 0]], from: [0.1, 0.3], at_least_m: 0.3}}
      - {action: draw, draw: tile, as: 2}
      - {action: count, counter: laps, to: {distance: [ball, [0.2, 0.1]]}}
      - {action: score, entrant: blue, points: {distance: [ball, [0.2, 0.1]], times: 2, plus: {told: Y1, times: 3}}}
      - {action: count, counter: laps, by: {counter: laps, entity: Y1, otherwise: 3, times: 2, plus: 4, minus: 5, round: up}}
      - {action: count, counter: laps, by: {sum: [{told: Y1}, 11]}}
      - {action: count, counter: laps, by: {score: blue, otherwise: 3, times: 2, plus: 4, minus: 5, round: up}}
      - {action: count, counter: laps, to: {count: blue, looks: ball, within_rad: 0.3}}
  judged:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions:
      - {counter: laps, entity: blue, of: any, equals: 5}
      - {timer: watch, entity: blue, of: any, equals: 5}
      - {way: blue, at_least: 0.5}
      - {way: blue, equals: 0.5}
      - {speed: blue, equals: 0.1}
      - {distance: [blue, [0.2, 0.3]], equals: 0.4}
      - {counter: laps, entity: robots, of: {at_most: 5}, above: 5, below: 7}
      - {timer: watch, entity: robots, of: {equals: 5}, above: 5, below: 7}
      - {way: blue, above: 0.5, below: 0.7}
      - {speed: blue, above: 0.1, below: 0.2}
      - {distance: [blue, [0.2, 0.3]], above: 0.4, below: 0.5}
      - {entity: blue, looks: 0.5}
      - {entity: blue, looks: [0.2, 0.3]}
      - {entity: blue, in: west}
      - {entity: blue, held: true}
      - {any_of: [{entity: B1, held: true}], negate: true}
      - {sequence: way, entity: blue, equals: west, of: any}
      - {spot_free: neutral_spots}
      - {told: blue, text: 7}
      - {draw: tile, equals: 2}
      - {draw: tile, at_least: 2, at_most: 4}
      - {draw: tile, above: 1, below: 6}
    actions:
      - {action: set_flag, flag: out, to: opposite}
      - {action: hold, entity: Y1}
      - {action: release, entity: Y1}
      - {action: timer, timer: watch, do: add, s: 4}
      - {action: count, counter: laps, to: {timer: watch, entity: Y1}}
"""


class Leaf(NamedTuple):
    """A single value of a scenario.

    Attributes:
        scenario: which of the scenarios.
        path: where it is.
        value: what it is; None: it is left out.
        annotation: what it may be.
    """

    scenario: int
    path: tuple[str | int, ...]
    value: Any
    annotation: Any


def _parts(annotation: Any) -> Iterator[Any]:
    """Yield the types of which an annotation is made, without names' texts."""
    origin = get_origin(annotation)
    if origin is Annotated:
        kind, *extras = get_args(annotation)
        words = next((extra for extra in extras if isinstance(extra, Vocabulary)), None)
        yield from _parts(kind if words is None else words.shape)
    elif origin is Literal:
        yield annotation
    elif origin in (Union, types.UnionType, tuple, list, dict):
        for part in get_args(annotation):
            yield from _parts(part)
    else:
        yield annotation


def _owner(model: type[BaseModel], name: str) -> str:
    """Return the name of the model that a field is of: of one that many words have, that of the class they share."""
    shared = (
        part for part in (Compared, Ranked, NumberValue, Facts) if issubclass(model, part) and name in part.model_fields
    )
    own = model.VALUE if issubclass(model, Valued) and name in model.VALUE.model_fields else model
    return next(shared, own).__name__


def _fields(model: type[BaseModel], seen: set[type[BaseModel]]) -> Iterator[str]:
    """Yield the fields below a model that are numbers, choices or yes or no: ``Ball.radius_m``."""
    if model in seen or model in _OF_TESTS:
        return
    seen.add(model)
    for name, field in model.model_fields.items():
        parts = list(_parts(fields(model)[field.alias or name]))
        choices = [get_args(part) for part in parts if get_origin(part) is Literal]
        if not field.exclude and (
            any(part in (int, float, bool) for part in parts) or any(len(c) > 1 for c in choices)
        ):
            yield f"{_owner(model, name)}.{field.alias or name}"
        for part in parts:
            if isinstance(part, type) and issubclass(part, BaseModel):
                yield from _fields(part, seen)


FIELDS = sorted(set(_fields(models.Scenario, set())) - _NAMES)


@cache
def _loaded() -> tuple[Loaded, ...]:
    """Return what is shipped."""
    shipped = Path(__file__).resolve().parents[2] / "scenarios"
    return (
        load_text(_SHOWN_NOWHERE_ELSE),
        load_text("schema_version: 2\nid: open\ntitle: Open\nextends: empty_field\nfield: {walls: false}\n"),
        *(load(shipped / f"{name}.yaml") for name in _SHIPPED),
        *(load_text(example.whole) for example in read_examples()),
    )


@cache
def _leaves() -> dict[str, list[Leaf]]:
    """Return the leaves of what is shipped by their field."""
    found: dict[str, list[Leaf]] = {}
    for index, loaded in enumerate(_loaded()):
        for field, leaf in _below(index, loaded.scenario, ()):
            found.setdefault(field, []).append(leaf)
    return found


def _below(scenario: int, node: Any, path: tuple[str | int, ...], field: str = "", shape: Any = None) -> Any:
    if isinstance(node, _OF_TESTS):
        return
    if isinstance(node, BaseModel):
        for name, info in type(node).model_fields.items():
            key = info.alias or name
            inner = getattr(node, name)
            yield from _below(scenario, inner, (*path, key), f"{_owner(type(node), name)}.{key}", info.annotation)
    elif isinstance(node, dict):
        for key, inner in node.items():
            yield from _below(scenario, inner, (*path, key), field, shape)
    elif isinstance(node, tuple):
        for place, inner in enumerate(node):
            yield from _below(scenario, inner, (*path, place), field, shape)
    else:
        yield field, Leaf(scenario, path, node, shape)


def _others(leaf: Leaf) -> Iterator[Any]:
    """Yield other values for a leaf; not all of them may be valid."""
    parts = list(_parts(leaf.annotation))
    value = leaf.value
    if isinstance(value, bool) or (value is None and bool in parts):
        yield not value
    elif isinstance(value, int | float):
        # Unusual values, so that the sheet does not contain them by chance.
        yield from (value + 3, value - 3) if isinstance(value, int) else ()
        yield from (round(value * 1.13 + 0.0017, 4), round(value * 0.87 - 0.0017, 4), value + 0.137, value + 1.37)
    elif value is None and (int in parts or float in parts):
        yield from (0.137, 1.37, 13, 7, 1)
    yield from (one for one in _choices(leaf.annotation) if one != value)


def _choices(annotation: Any) -> list[Any]:
    return [one for part in _parts(annotation) if get_origin(part) is Literal for one in get_args(part)]


def _changed(leaf: Leaf, value: Any) -> Loaded | None:
    """Return the scenario with another value in place of a leaf; None if it may not be there."""
    data = _with(_untested(leaf.scenario), leaf.path, value)
    try:
        models.Scenario.model_validate(in_tuples(data))  # says no sooner, if less politely
        return load_resolved(data)
    except (ValidationError, ScenarioError):
        return None


@cache
def _untested(scenario: int) -> dict[str, Any]:
    return {**_loaded()[scenario].resolved, "expect": {}}


def _with(node: Any, path: tuple[str | int, ...], value: Any) -> Any:
    """Return data with another value at one place; nothing else is copied but what holds it."""
    if not path:
        return value
    step, *further = path
    if isinstance(node, dict):
        return {**node, step: _with(node.get(step), tuple(further), value)}
    return [_with(one, tuple(further), value) if place == step else one for place, one in enumerate(node)]


def _words(text: str) -> Counter[str]:
    return Counter(re.findall(r"[^\s,;:()\[\]“”|<>&]+", text.replace("\\", "")))


def _shown(loaded: Loaded, *, drawn: bool) -> Counter[str]:
    show = draw_scenario if drawn else sheet_markdown
    return _words(show(loaded.scenario, loaded.roster))


@cache
def _shown_before(scenario: int, *, drawn: bool) -> Counter[str]:
    # Read as the changed ones are: what was left out and what was written with its default are one there.
    return _shown(load_resolved(_untested(scenario)), drawn=drawn)


def _new_words(leaf: Leaf, changed: Loaded, *, drawn: bool) -> Counter[str]:
    """Return what the sheet, or the drawing on it, says in the changed scenario only."""
    old, new = _shown_before(leaf.scenario, drawn=drawn), _shown(changed, drawn=drawn)
    return new - old or Counter({"something left out": 1} if new != old else {})


def _tells(words: Counter[str], value: Any, annotation: Any) -> bool:
    """Return whether words tell a value: in its unit, in cm, as a diameter in cm, in degrees, in %, of ticks in ms."""
    if isinstance(value, bool | str) or value in _choices(annotation):
        return bool(words)
    amounts = (value, 100 * value, 200 * value, value * TICK_MS)
    printed = {number(abs(amount)) for amount in amounts}
    printed |= {degrees(abs(value)).removesuffix("°"), seconds(abs(value)).split()[0]}
    return bool(printed & {re.sub(r"^[-±]+|[.°s]+$", "", word) for word in words})


def _telling(leaf: Leaf, *, drawn: bool) -> tuple[bool, list[Any]]:
    """Return whether another value of a leaf is printed, and which were tried."""
    tried: list[Any] = []
    for value in _others(leaf):
        changed = _changed(leaf, value)
        if changed is not None:
            tried.append(value)
            if _tells(_new_words(leaf, changed, drawn=drawn), value, leaf.annotation):
                return True, tried
            if not isinstance(value, str):
                break
    return False, tried


@pytest.mark.parametrize(
    "field", [pytest.param(field, marks=[pytest.mark.nightly] if at % 6 else []) for at, field in enumerate(FIELDS)]
)
def test_a_changed_number_is_on_the_sheet(field):
    untold = []
    for leaf in _leaves().get(field, []):
        printed, tried = _telling(leaf, drawn=field.startswith(_DRAWN))
        if printed:
            assert field not in _NEEDS_NO_TELLING
            return
        if tried:
            untold.append((leaf.path, leaf.value, tried))
        if len(untold) >= _MAX_LEAVES:
            break
    assert untold, "nothing that is shipped shows this field"
    assert field in _NEEDS_NO_TELLING, untold


def test_the_list_of_what_needs_no_telling_names_fields():
    assert set(_NEEDS_NO_TELLING) <= set(FIELDS)
