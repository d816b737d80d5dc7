"""Whole made-up scenarios: a stage, all sections on it, and the same scenario without what the loader refuses."""

from __future__ import annotations

import random
import re
from contextlib import suppress
from typing import Any

import yaml

from rcj_challenges.chassis.differential import DifferentialChassis
from rcj_challenges.devices import AnyDevice
from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.load import Loaded, load_text
from rcj_challenges.scenario.models.limits import Limits
from rcj_challenges.scenario.models.places import Placing
from rcj_challenges.scenario.models.scenario import Broadcast, Expectation, Result
from rcj_challenges.scenario.models.state import Counter, Flag, Phase, Role, Sequence, Timer
from rcj_challenges.scenario.reading.yaml_strict import parse_text
from rcj_challenges.scenario.tree import plain
from tests.whole_scenarios.making import ImpossibleError, Maker
from tests.whole_scenarios.staging import Data, Stage, made_stage, point

_STATE = (("counters", "counter", Counter), ("flags", "flag", Flag), ("timers", "timer", Timer))
_ROUNDS = 25
"""So often what is refused is taken out, before a scenario is given up."""
_STEPS = re.compile(r"([^.\[\]]+)|\[(\d+)\]")


def made_up(seed: int) -> str:
    """Return the text of a random whole scenario; much of it may be refused."""
    return written(_made(random.Random(seed)))  # noqa: S311 - nothing secret


def written(data: Data) -> str:
    """Return a scenario as YAML."""
    return yaml.dump(data, Dumper=_NoAliases, sort_keys=False, allow_unicode=True, default_flow_style=None, width=110)


def without_what_is_refused(
    text: str, refused: list[tuple[str, ScenarioError]] | None = None
) -> tuple[str, Loaded] | None:
    """Take out of a scenario what the loader refuses, until it is taken.

    Args:
        text: the scenario.
        refused: what was refused on the way is added, each text with its error.

    Returns:
        The text that is left, and what was loaded; None if nothing is left.
    """
    try:
        data = plain(parse_text(text, "made_up.yaml"))
    except ScenarioError:
        return None
    if not isinstance(data, dict):
        return None
    for _ in range(_ROUNDS):
        try:
            return text, load_text(text, file="made_up.yaml")
        except ScenarioError as error:
            if refused is not None:
                refused.append((text, error))
            paths = {place_of(problem).path for problem in error.diagnostics}
            taken = [_take_out(data, path) for path in sorted(paths, key=_last_first, reverse=True)]
            if not any(taken):
                return None
        text = written(data)
    return None


def _last_first(path: str) -> list[tuple[int, str]]:
    """Return a key to sort paths by: later entries of a list come out before earlier ones move up."""
    return [(int(number or 0), name) for name, number in _STEPS.findall(path)]


def _take_out(data: Data, path: str) -> bool:
    """Take out what stands at a path, or the nearest thing above it; returns whether anything was."""
    steps: list[Any] = [
        int(number) if number else name for name, number in _STEPS.findall(re.sub(r" \(.*?\)", "", path))
    ]
    above: list[tuple[Any, Any]] = []
    node: Any = data
    for step in steps:
        if (isinstance(node, dict) and step in node) or (
            isinstance(node, list) and isinstance(step, int) and step < len(node)
        ):
            above.append((node, step))
            node = node[step]
        else:
            break
    if not above or above[-1][1] in ("schema_version", "id", "title"):
        return False
    holder, step = above[-1]
    if len(above) == len(steps) or len(above) > 1:
        del holder[step]
        if not holder and len(above) > 1:
            del above[-2][0][above[-2][1]]
        return True
    return False


class _NoAliases(yaml.SafeDumper):
    """Writes everything out; scenarios have no aliases."""

    def ignore_aliases(self, data: Any) -> bool:
        """Say that nothing is written as an alias."""
        return True


# --- sections ---------------------------------------------------------------------------------------------------------


def _made(chance: random.Random) -> Data:
    stage = made_stage(chance)
    maker = Maker(chance, stage)
    _fit_out(stage, maker)
    _add_layout_names(stage, chance)
    _add_phase_names(stage, chance)
    _add_draws(stage, chance)
    _add_roles(stage, maker)
    _add_state(stage, maker)
    _add_layouts(stage, maker)
    _add_phases(stage, maker)
    for _ in range(chance.choice((1, 2, 4, 8))):
        with suppress(ImpossibleError):
            stage.add("rules", stage.fresh(chance), maker.rule())
    data = stage.data
    with suppress(ImpossibleError):
        if chance.random() < 0.4:
            data["broadcast"] = maker.model(Broadcast)
    with suppress(ImpossibleError):
        if chance.random() < 0.3:
            data["result"] = maker.model(Result)
    if chance.random() < 0.1:
        data["limits"] = maker.model(Limits)
    for _ in range(chance.choice((0, 0, 1, 2))):
        with suppress(ImpossibleError):
            stage.add("expect", stage.fresh(chance), maker.model(Expectation))
    _repeat(data, stage, chance)
    _use_params(data, chance)
    if chance.random() < 0.2:
        data["description"] = maker.chance.choice(
            ("One line.", "Two\n\nparagraphs with {p_1}.", "<script>", "- a\n- b")
        )
    return data


def _fit_out(stage: Stage, maker: Maker) -> None:
    """Give kits, robots and balls what the models allow, also at its bounds."""
    chance = maker.chance
    for kit in _given(stage, "kits"):
        if chance.random() < 0.4:
            kit["chassis"] = maker.model(DifferentialChassis, without=("size_m", "wheel_track_m"))
        for _ in range(chance.choice((0, 0, 1, 3))):
            kit["devices"][chance.choice(("more", "ball", "left", "a b"))] = maker.value(AnyDevice, "device")
    for robot in _given(stage, "robots"):
        if chance.random() < 0.2:
            robot["devices"] = {chance.choice(("more", "gps")): maker.value(AnyDevice, "device")}
    for ball in _given(stage, "balls"):
        if chance.random() < 0.3:
            ball |= {"radius_m": chance.choice((0.001, 0.03)), "mass_kg": chance.choice((1e-6, 0.001, 5))}
    for obstacle in _given(stage, "obstacles"):
        if obstacle.get("movable") and chance.random() < 0.5:
            obstacle["mass_kg"] = chance.choice((1e-6, 0.01, 50))


def _given(stage: Stage, section: str) -> list[Data]:
    """Return the entries of a section that are none of those that are removed."""
    return [entry for entry in stage.data.get(section, {}).values() if entry]


def _add_layout_names(stage: Stage, chance: random.Random) -> None:
    stage.named["placements"] += [f"layout_{number}" for number in range(chance.choice((0, 1, 2)))]


def _add_phase_names(stage: Stage, chance: random.Random) -> None:
    stage.named["phases"] += [f"phase_{number}" for number in range(chance.choice((0, 0, 1, 2)))]


def _add_draws(stage: Stage, chance: random.Random) -> None:
    of = {kind: [name for name, its in stage.kinds.items() if its == kind] for kind in set(stage.kinds.values())}
    pools: list[list[Any]] = [
        *of.values(), stage.named["placements"], [0.1, 0.5, 2], [1, 2, 3], [True, False], ["yes", "no", "perhaps"],
        [0, -1, 1e15], ["each", 1, True],
    ]  # fmt: skip
    for _ in range(chance.choice((0, 1, 2, 3))):
        pool = chance.choice(pools)
        if pool:
            values = chance.choices(pool, k=chance.choice((1, 2, 3)))
            draw: Data = {"values": values}
            more = {"not_last": True, "not_again": chance.choice(("half", "match")), "keep": "match"}
            draw |= {key: value for key, value in more.items() if chance.random() < 0.2}
            name = stage.fresh(chance)
            stage.add("draws", name, draw)
            stage.draws[name] = values


def _add_roles(stage: Stage, maker: Maker) -> None:
    chance = maker.chance
    kinds = sorted({kind for kind in stage.kinds.values() if kind != "group"})
    for _ in range(chance.choice((0, 1, 2)) if kinds else 0):
        kind = chance.choice(kinds)
        members = [name for name, its in stage.kinds.items() if its == kind]
        name = stage.fresh(chance)
        role = maker.model(Role, without=("of", "initial"), often=0.4)
        stage.add("roles", name, {"of": members} | role | ({"initial": "none"} if chance.random() < 0.2 else {}))
        stage.roles[name] = members


def _add_state(stage: Stage, maker: Maker) -> None:
    chance = maker.chance
    for section, kind, model in _STATE:
        for _ in range(chance.choice((0, 1, 2))):
            with suppress(ImpossibleError):
                entry = maker.model(model, often=0.4)
                name = stage.fresh(chance)
                stage.add(section, name, entry)
                stage.kept[kind, name] = entry.get("per")
    for _ in range(chance.choice((0, 0, 1))):
        with suppress(ImpossibleError):
            entry = maker.model(Sequence, often=0.4)
            entry.pop("entity" if "per" in entry else "per", None)
            if "per" not in entry and "entity" not in entry:
                entry["per"] = "robots"
            steps = [name for step in entry["steps"] for name in ([step] if isinstance(step, str) else step["any_of"])]
            name = stage.fresh(chance)
            stage.add("sequences", name, entry)
            stage.kept["sequence", name] = entry.get("per")
            stage.steps[name] = steps


def _own(stage: Stage, section: str) -> list[str]:
    return [name for name in stage.named[section] if name.startswith(("layout_", "phase_"))]


def _add_layouts(stage: Stage, maker: Maker) -> None:
    for name in _own(stage, "placements"):
        with suppress(ImpossibleError):
            layout = [maker.model(Placing) for _ in range(maker.chance.choice((1, 2, 3)))]
            stage.data.setdefault("placements", {})[name] = layout


def _add_phases(stage: Stage, maker: Maker) -> None:
    for name in _own(stage, "phases"):
        phase = maker.model(Phase, often=0.5)
        if phase.get("clock") == "stops" and "lasts_s" not in phase:
            phase["lasts_s"] = 0.5
        stage.data.setdefault("phases", {})[name] = phase
    if stage.named["phases"] and maker.chance.random() < 0.3:
        stage.data["first_phase"] = maker.chance.choice(stage.named["phases"])


# --- params and repeats -----------------------------------------------------------------------------------------------


def _leaves(node: Any, found: list[tuple[Any, Any]]) -> list[tuple[Any, Any]]:
    for key, value in list(node.items()) if isinstance(node, dict) else list(enumerate(node)):
        if isinstance(value, dict | list):
            _leaves(value, found)
        elif key not in ("trigger", "condition", "action", "says", "shape", "start", "random"):
            found.append((node, key))
    return found


def _use_params(data: Data, chance: random.Random) -> None:
    params: Data = {}
    spots = _leaves({key: data[key] for key in ("rules", "zones", "phases", "expect", "broadcast") if key in data}, [])
    for number in range(chance.choice((0, 0, 1, 3))):
        if spots:
            node, key = chance.choice(spots)
            if isinstance(node[key], dict):
                continue
            name, value = f"p_{number}", node[key]
            use: Data = {"param": name}
            if isinstance(value, int | float) and not isinstance(value, bool) and chance.random() < 0.5:
                use |= {"times": chance.choice((1, -1, 0.5, 1e9))} if chance.random() < 0.7 else {}
                use |= {"plus": chance.choice((0, 0.1, -3))} if chance.random() < 0.5 else {}
            params[name] = value
            node[key] = use
    if params:
        data["params"] = params


def _repeat(data: Data, stage: Stage, chance: random.Random) -> None:
    if "rules" not in data or chance.random() > 0.3:
        return
    rule = chance.choice([rule for rule in data["rules"].values() if rule] or [{"says": ""}])
    node, key = chance.choice(_leaves(rule, []) or [(rule, "says")])
    value = node.get(key) if isinstance(node, dict) else node[key]
    rows = chance.sample([*stage.kinds, "one", "two", "x" * 60], k=2)
    if isinstance(value, str) and value in stage.kinds and chance.random() < 0.5:
        kind = stage.kinds[value]
        rows = [one for one, its in stage.kinds.items() if its == kind][:3]
        node[key] = {"param": "this"}
        table: Data = {row: {} for row in rows}
    else:
        table = {row: {"v": value, "unused": point(chance)} if chance.random() < 0.2 else {"v": value} for row in rows}
        node[key] = {"param": "v"}
    data["tables"] = {"rows": table}
    rule["repeat_for"] = "rows"
