"""The ground of a made-up scenario: field, machines and places that mostly fit, and the names by which rules call them.

Positions come from a grid, so that most scenarios can be played; what does not fit is refused and taken out later.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from rcj_challenges.scenario.load import load_text

Data = dict[str, Any]

BASES = (
    "soccersim_v2", "soccersim_v2", "empty_field", "soccersim_2021", None, None, "match", "match_2021", "pass_the_ball",
    "fast_shooter", "precision_lidar",
)  # fmt: skip
COLOURS = ("blue", "yellow", "red", "Gold", "rebeccapurple", "#12aBcF", "white", "black")
TEAM_COLOURS = ("blue", "yellow", "red", "teal")
NAMES = (
    "a", "b", "ball_2", "Goal", "zone_1", "the_den", "start", "keep", "play_2", "entity", "team", "measured", "limit",
    "points", "True", "class", "_", "__init__", "x" * 64, "A" * 40, "null_", "this", "self", "yes_no", "on_",
    "Z9", "param", "counter", "score", "robot", "ball_", "red_1", "left_of_the_blue_goal", "e5", "_1e3", "no_room",
    "play", "half", "match_", "told", "distance", "way", "constructor", "__proto__", "toString", "lastIndex", "nan_",
)  # fmt: skip
"""Names that may stand anywhere: plain ones, long ones, and words of the language, of Python and of JavaScript."""
CELL_M = 0.2


@dataclass
class Stage:
    """What has been made so far.

    Attributes:
        data: the sections of the file.
        kinds: what each name on the field is, as `Roster.kinds` has it.
        groups: members of each group.
        kept: of counters, flags, timers and sequences by name: for which group there is one each, or None.
        draws: values of each draw.
        roles: members of each role.
        steps: zones or gates of each sequence.
        events: names of events that are emitted, or only waited for.
        named: the names of the other sections.
    """

    data: Data = field(default_factory=dict)
    kinds: dict[str, str] = field(default_factory=dict)
    groups: dict[str, tuple[str, ...]] = field(default_factory=dict)
    kept: dict[tuple[str, str], str | None] = field(default_factory=dict)
    draws: dict[str, list[Any]] = field(default_factory=dict)
    roles: dict[str, list[Any]] = field(default_factory=dict)
    steps: dict[str, list[str]] = field(default_factory=dict)
    events: list[str] = field(default_factory=lambda: ["GOAL", "A", "X_1", "NEVER"])
    named: dict[str, list[str]] = field(default_factory=dict)

    def add(self, section: str, name: str, entry: Data) -> None:
        """Add an entry to a section."""
        self.data.setdefault(section, {})[name] = entry
        self.named.setdefault(section, []).append(name)

    def fresh(self, chance: random.Random) -> str:
        """Return a name that nothing has yet, in any section."""
        taken = {*self.kinds, *self.groups, *(name for names in self.named.values() for name in names)}
        folded = {name.casefold() for name in taken}
        name = chance.choice(NAMES)
        while name.casefold() in folded:
            name = f"{chance.choice('abcdefgh')}_{chance.randrange(1000)}"
        return name


@cache
def base_of(name: str) -> Data:
    """Return what a preset or a shipped scenario brings, as plain data."""
    head = f"schema_version: 2\nid: a\ntitle: A\nextends: {name}\n"
    return load_text(head).resolved


def made_stage(chance: random.Random) -> Stage:
    """Return a field with machines and places on it."""
    stage = Stage({"schema_version": 2, "id": stage_id(chance), "title": "Made up"})
    base = chance.choice(BASES)
    if base is not None:
        stage.data["extends"] = base
    brought: Data = base_of(base) if base is not None else {}
    _take_over(stage, brought)
    if base is None:
        _add_field_and_kit(stage, chance)
    _add_bodies(stage, chance, brought)
    _add_places(stage, chance)
    _add_groups(stage, chance)
    if chance.random() < 0.5:
        stage.data["match"] = _match(chance)
    if brought and chance.random() < 0.2:
        _remove(stage, chance, brought)
    return stage


def _remove(stage: Stage, chance: random.Random, brought: Data) -> None:
    """Remove something that the base brings; what names it stays, and is refused."""
    section = chance.choice(
        ("robots", "balls", "zones", "spots", "groups", "entrants", "rules", "counters", "expect", "kits")
    )
    if brought.get(section):
        stage.data.setdefault(section, {})[chance.choice(list(brought[section]))] = None


def stage_id(chance: random.Random) -> str:
    """Return an id."""
    return chance.choice(("made_up", "a", "_", "B2", "x" * 64))


def _match(chance: random.Random) -> Data:
    halves = chance.choice((1, 1, 2, 3))
    half_s: Any = chance.choice((2, 5.5, 10, 60, 600))
    if chance.random() < 0.2:
        half_s = [chance.choice((0.032, 1, 4, 20)) for _ in range(halves)]
    return {"halves": halves, "half_s": half_s, "swap_sides": chance.random() < 0.4}


def _take_over(stage: Stage, brought: Data) -> None:
    singular = {"robots": "robot", "balls": "ball", "zones": "zone", "gates": "gate", "spots": "spot"}
    for section, kind in singular.items():
        for name in brought.get(section, {}):
            stage.kinds[name] = kind
    for robot, entry in brought.get("robots", {}).items():
        stage.groups[entry["colour"]] = (*stage.groups.get(entry["colour"], ()), robot)
    for name, members in brought.get("groups", {}).items():
        stage.groups[name] = tuple(members)
    _take_over_state(stage, brought)


def _take_over_state(stage: Stage, brought: Data) -> None:
    for section in (
        "entrants",
        "kits",
        "counters",
        "flags",
        "timers",
        "sequences",
        "draws",
        "roles",
        "placements",
        "phases",
    ):
        stage.named[section] = list(brought.get(section, {}))
    for section, kind in (("counters", "counter"), ("flags", "flag"), ("timers", "timer"), ("sequences", "sequence")):
        for name, entry in brought.get(section, {}).items():
            stage.kept[kind, name] = entry.get("per")
    for name, entry in brought.get("draws", {}).items():
        stage.draws[name] = entry["values"]
    for name, entry in brought.get("roles", {}).items():
        stage.roles[name] = [entry["of"]] if isinstance(entry["of"], str) else list(entry["of"])
    for name, entry in brought.get("sequences", {}).items():
        stage.steps[name] = [
            one for step in entry["steps"] for one in ([step] if isinstance(step, str) else step["any_of"])
        ]
    for rule in brought.get("rules", {}).values():
        stage.events += [action["event"] for action in rule["actions"] if action["action"] == "emit"]


def _add_field_and_kit(stage: Stage, chance: random.Random) -> None:
    if chance.random() < 0.7:
        width_m, length_m = chance.choice(((1.3, 1.5), (2, 3), (0.9, 0.9), (10, 10), (4, 1)))
        stage.data["field"] = {"width_m": width_m, "length_m": length_m}
        if chance.random() < 0.5:
            stage.data["field"] |= {
                "corner_cut_m": chance.choice((0, 0.06, 0.3)),
                "friction": chance.choice((0, 0.3, 1, 2)),
                "restitution": chance.choice((0, 0.5, 0.95)),
            }
        goals = [
            {"end": end, "colour": chance.choice(COLOURS), "width_m": chance.choice((0.2, 0.4, 0.7))}
            for end in ("positive_y", "negative_y")
            if chance.random() < 0.5
        ]
        stage.data["field"]["goals"] = {f"goal {number}": goal for number, goal in enumerate(goals)}
        stage.data["field"]["walls"] = bool(goals) or chance.random() < 0.5
    devices: Data = {
        "left": {"device": "motor", "wheel": "left"},
        "right": {"device": "motor", "wheel": "right", "direction": chance.choice((1, -1))},
        "gps": {"device": "gps", "frame": chance.choice(("field", "legacy"))},
        "näher, bitte": {"device": "sonar", "bearing_rad": chance.uniform(-4, 4)},
        "ball": {"device": "ball_receiver", "range_m": chance.choice((0.01, 0.6, 5))},
        "referee": {"device": "supervisor_receiver"},
        "out": {"device": "team_emitter"},
        "in": {"device": "team_receiver"},
        "lidar": {"device": "lidar", "points": chance.choice((1, 7, 360)), "rotating": chance.random() < 0.5},
        "north": {"device": "compass", "noise_rad": chance.choice((0, 0.1))},
        "turned": {"device": "wheel_sensor", "wheel": "left"},
    }
    kept = {name: device for name, device in devices.items() if chance.random() < 0.7}
    kit: Data = {"messages": chance.choice(("v2.1", "v2.2", "2021")), "devices": kept}
    if chance.random() < 0.3:
        kit["chassis"] = {"size_m": chance.choice((0.03, 0.075, 0.12)), "mass_kg": chance.choice((0.01, 0.2, 3))}
    if chance.random() < 0.3:
        kit["packet_every_ticks"] = chance.choice((1, 2, 7))
    stage.add("kits", "kit", kit)


def _add_bodies(stage: Stage, chance: random.Random, brought: Data) -> None:
    """Put robots, balls and obstacles on free cells of a grid."""
    size = stage.data.get("field", {})
    half_x = size.get("width_m", 1.3) / 2 - 0.15
    half_y = size.get("length_m", 1.5) / 2 - 0.15
    taken = [(r["start"]["x_m"], r["start"]["y_m"]) for r in brought.get("robots", {}).values()]
    taken += [tuple(ball["start_m"]) for ball in brought.get("balls", {}).values()]
    columns, rows = min(8, int(2 * half_x / CELL_M) + 1), min(8, int(2 * half_y / CELL_M) + 1)
    cells = [
        (round(-half_x + column * CELL_M, 3), round(-half_y + row * CELL_M, 3))
        for column in range(columns)
        for row in range(rows)
    ]
    cells = [(x, y) for x, y in cells if all(abs(x - a) + abs(y - b) > 0.15 for a, b in taken)]
    chance.shuffle(cells)
    kits = stage.named.setdefault("kits", [])
    own: list[str] = []
    for number in range(chance.choice((0, 1, 2, 6)) if brought else chance.choice((0, 1, 2, 4))):
        if not cells:
            break
        x_m, y_m = cells.pop()
        name, colour = stage.fresh(chance), chance.choice(TEAM_COLOURS)
        start = {"x_m": x_m, "y_m": y_m, "yaw_rad": round(chance.uniform(-7, 7), 2)}
        if chance.random() < 0.2:
            start["noise_m"] = [chance.choice((0, 0.05, 5)), chance.choice((0, 0.05, 5))]
        stage.add("robots", name, {"colour": colour, "number": number, "kit": chance.choice(kits), "start": start})
        stage.kinds[name] = "robot"
        stage.groups[colour] = (*stage.groups.get(colour, ()), name)
        own.append(name)
    for _ in range(chance.choice((0, 0, 1, 3))):
        if cells:
            ball = {"start_m": list(cells.pop()), "radius_m": chance.choice((0.005, 0.021, 0.05))}
            ball |= {"slows_mps2": chance.choice((0.1, 5))} if chance.random() < 0.4 else {}
            ball |= {"emits": False, "mass_kg": chance.choice((0.001, 1))} if chance.random() < 0.3 else {}
            name = stage.fresh(chance)
            stage.add("balls", name, ball)
            stage.kinds[name] = "ball"
    for _ in range(chance.choice((0, 0, 1, 3))):
        if cells:
            _add_obstacle(stage, chance, cells.pop())
    _add_entrants(stage, chance, own, alone=not brought)


def _add_obstacle(stage: Stage, chance: random.Random, cell: tuple[float, float]) -> None:
    name, shape = stage.fresh(chance), chance.choice(("box", "cylinder", "wall"))
    movable = shape != "wall" and chance.random() < 0.5
    entry: Data = {"shape": shape}
    if shape == "wall":
        entry |= {"from_m": list(cell), "to_m": [round(cell[0] + 0.1, 3), cell[1]]}
    else:
        entry |= {"centre_m": list(cell), "movable": movable}
        entry |= {"size_m": [0.05, chance.choice((0.02, 0.1))]} if shape == "box" else {"radius_m": 0.04}
        if shape == "box" and chance.random() < 0.5:
            entry["yaw_rad"] = round(chance.uniform(-4, 4), 2)
    stage.add("obstacles", name, entry)
    stage.kinds[name] = "obstacle" if movable else "fixed obstacle"


def _add_entrants(stage: Stage, chance: random.Random, robots: list[str], *, alone: bool) -> None:
    seats = stage.data.setdefault("entrants", {})
    own = [f"seat_{number}" for number in range(chance.choice((1, 2, 3)))]
    for robot in robots:
        if chance.random() < 0.8:
            seats.setdefault(chance.choice(own), {"robots": {}})["robots"][robot] = "robot.py"
        elif chance.random() < 0.5:
            stage.data["robots"][robot]["idle"] = True
    for number, name in enumerate(seats):
        seats[name]["radio_channel"] = 10 + number
        seats[name] |= {"title": chance.choice(("Äpfel & <Birnen>", "T", ""))} if chance.random() < 0.5 else {}
    stage.named["entrants"] = [*stage.named.get("entrants", []), *seats]
    if not seats and not alone:
        del stage.data["entrants"]
    stage.data.setdefault("robots", {})


def _add_places(stage: Stage, chance: random.Random) -> None:
    for _ in range(chance.choice((0, 1, 2, 5))):
        name = stage.fresh(chance)
        stage.add("zones", name, _zone(chance))
        stage.kinds[name] = "zone"
    entities = [name for name, kind in stage.kinds.items() if kind in ("robot", "ball", "obstacle")]
    for _ in range(chance.choice((0, 1, 2))):
        gate: Data = {"from_m": point(chance), "to_m": point(chance)}
        if entities and chance.random() < 0.3:
            gate["anchor"] = chance.choice(entities)
        name = stage.fresh(chance)
        stage.add("gates", name, gate)
        stage.kinds[name] = "gate"
    for _ in range(chance.choice((0, 1, 3))):
        name, (x_m, y_m) = stage.fresh(chance), point(chance)
        stage.add("spots", name, {"x_m": x_m, "y_m": y_m})
        stage.kinds[name] = "spot"


def point(chance: random.Random) -> list[float]:
    """Return a point, mostly on the field."""
    reach_m = chance.choice((0.6, 0.6, 0.6, 0.6, 2.0)) if chance.random() < 0.97 else 999
    return [round(chance.uniform(-reach_m, reach_m), 2), round(chance.uniform(-reach_m, reach_m), 2)]


def _zone(chance: random.Random) -> Data:
    shape = chance.choice(("rect", "circle", "polygon", "half_plane"))
    x, y = point(chance)
    size = chance.choice((0.02, 0.2, 0.5, 3))
    entry: Data = {"shape": shape}
    if shape == "rect":
        sides = {"x_min_m": x - size, "x_max_m": x + size, "y_min_m": y - size, "y_max_m": y + size}
        entry |= {key: round(value, 3) for key, value in sides.items() if chance.random() < 0.9}
    elif shape == "circle":
        entry |= {"centre_m": [x, y], "radius_m": size}
    elif shape == "polygon":
        entry["points_m"] = [[x, y], [round(x + size, 2), y], [x, round(y + size, 2)]]
    else:
        entry |= {"through_m": [x, y], "normal": point(chance)}
    entry |= {"inverted": True} if chance.random() < 0.2 else {}
    entry |= {"drawn": True} if chance.random() < 0.5 else {}
    entry |= {"colour": chance.choice(COLOURS)} if chance.random() < 0.3 else {}
    return entry


_FAMILIES = (("robot", "ball", "obstacle", "fixed obstacle"), ("robot",), ("ball",), ("zone",), ("gate",), ("spot",))


def _add_groups(stage: Stage, chance: random.Random) -> None:
    if stage.groups and chance.random() < 0.1:
        group, name = chance.choice(list(stage.groups)), stage.fresh(chance)
        stage.data.setdefault("groups", {})[name] = [group]
        stage.groups[name] = stage.groups[group]
    for _ in range(chance.choice((0, 1, 3))):
        family = chance.choice(_FAMILIES)
        alike = [name for name, kind in stage.kinds.items() if kind in family]
        if alike:
            members = chance.sample(alike, min(len(alike), chance.choice((1, 2, 3))))
            name = stage.fresh(chance)
            stage.data.setdefault("groups", {})[name] = members
            stage.groups[name] = tuple(members)
    of = {kind: tuple(name for name, its in stage.kinds.items() if its == kind) for kind in ("robot", "ball")}
    obstacles = tuple(name for name, kind in stage.kinds.items() if kind.endswith("obstacle"))
    stage.groups |= {"robots": of["robot"], "balls": of["ball"], "obstacles": obstacles}
