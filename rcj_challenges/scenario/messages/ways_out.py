"""What to write instead of a name that is none in its place, where people mean something that is said otherwise."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from math import pi, radians

from rcj_challenges.scenario.catalogue import Catalogue, texts
from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.messages.named_places import SEEN, kind_of
from rcj_challenges.scenario.messages.values_instead import NUMBER_WORDS
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node, Path, child, node_at

_AT = (("at",), ("back_at",))

_TEAMS = ("entrants", "teams")
_FOR_TEAMS = {
    "for_each": "a rule for each team is written with repeat_for: {names}, where {{param: this}} is the team and the "
    "colour of all its robots; in for_each: robots entrant: each is the team of each of them",
    "per": "nothing is kept for each team; give each team one under a name of its own (a rule with repeat_for can name "
    "them), or, to rank by it, keep it per: robots and count it for one robot of the team",
}
"""By the key behind which somebody names all teams."""


def for_teams(name: str, path: Path, teams: Iterable[str]) -> str:
    """Return how a rule or a counter for each team is written; empty: that is not what was meant.

    Args:
        name: the name that is none in its place.
        path: where it stands.
        teams: those of the scenario.
    """
    names = f"[{listing(teams)}]"
    return _FOR_TEAMS.get(str(path[-1]), "").format(names=names) if name in _TEAMS else ""


def for_several(path: Path, node: Node | None) -> str:
    """Return how a rule for each of several names is written; empty: that is not what was meant."""
    if path[:1] != ("rules",) or path[2:] != ("for_each",) or isinstance(node, Leaf):
        return ""
    return "; for several, name a group of them, or write the rule once for each name with repeat_for"


def for_spots(path: Path, members: Iterable[str]) -> str:
    """Return how a rule for each of several spots is written; empty: no rule goes over them here."""
    if path[2:] != ("for_each",):
        return ""
    return f"; spots are not gone over: repeat_for: [{listing(members)}] writes the rule once for each, {{param: this}}"


_KEPT = ("counter", "flag", "timer", "sequence")
_ADDED_UP = ("points", "by", "to")


def for_group(group: str, path: Path, root: Node, catalogue: Catalogue) -> str:
    """Return how several are meant of what is kept for each, where one is named; empty: that is not what was meant.

    Args:
        group: the group.
        path: where it stands.
        root: the whole scenario.
        catalogue: its names.
    """
    node, names = node_at(root, path[:-1]), catalogue.expand(group)
    if path[-1] == "spot" and child(node, "action") is None:
        return f"; one of them by chance is written {{choice: [{group}]}}"
    kind = next((one for one in _KEPT if texts(child(node, one))), None)
    if path[-1] != "entity" or kind is None or not names:
        return ""
    (name,) = texts(child(node, kind))
    if child(node, "action") is not None:
        owners = [one for per in texts(node_at(root, (f"{kind}s", name, "per"))) for one in catalogue.expand(per)]
        if set(names) == set(owners):
            return "; leave 'entity' out: then each of them is meant"
        return f"; for several write the action once for each of them, {listing(f'entity: {one}' for one in names)}"
    if path[2:3] != ("actions",) or not any(key in path for key in _ADDED_UP):
        return ""
    parts = listing(f"{{{kind}: {name}, entity: {one}}}" for one in names)
    return f"; of several a list is added up, with a part for each: [{parts}]"


def for_word(name: str, path: Path) -> str:
    """Return how one puts something where it began, or names that for which a rule is repeated; empty: neither."""
    if name == "this" and path[:1] == ("rules",):
        return "; in a rule with repeat_for the name for which it is repeated is written {param: this}"
    return f"; where it began is written {path[-2]}: start" if name == "start" and path[-2:-1] in _AT else ""


def for_repeated(above: Path, key: str) -> str:
    """Return where ``repeat_for`` stands; empty: something else is meant."""
    if key != "repeat_for":
        return ""
    within = above[:1] == ("rules",) and len(above) > 1
    return "; repeat_for stands in a rule, beside its triggers" + ("" if within else ", and nowhere else")


def for_other_kind(name: str, kind: str, path: Path, *, each: bool) -> str:
    """Return how one writes what a param holds, or the one that a draw decided; empty: neither was meant.

    Args:
        name: the name that is none in its place.
        kind: what it names elsewhere.
        path: where it stands.
        each: whether `each` may stand there.
    """
    if kind == "param":
        return f"; what a param holds is written {{param: {name}}}"
    if kind != "draw" or path[2:3] != ("actions",):
        return ""
    if path[-1] == "layout":
        return f"; the one drawn is written layout: {{draw: {name}}}"
    if not each and "at" in path:
        placed = f"{{action: place, layout: {{draw: {name}}}}}"
        return f"; where a draw decides the place, give it layouts as values: {placed}"
    if not each:
        return ""
    return f"; to do it to the one drawn: for_each, {{condition: drawn, draw: {name}, equals: each}}, and 'each' here"


_USUAL_KEYS = {
    "when": "triggers",
    "on": "triggers",
    "if": "conditions",
    "then": "actions",
    "do": "actions",
    "team": "entrant",
    "text": "says",
    "message": "says",
    "description": "says",
    "friction": "slows_mps2",
    "rolling_friction": "slows_mps2",
    "damping": "slows_mps2",
    "range_m": "max_range_m",
    "times": "weight",
    "factor": "weight",
    "to": "as",
    "for_s": "limit_s",
    "periods": "halves",
    "after": "from",
    "set": "to",
    "teams": "entrants",
    "areas": "zones",
    "variables": "counters",
    "tests": "expect",
    "name": "title",
    "start_m": "centre_m",
    "centre_m": "start_m",
}
"""What others call a key, and how it is written here."""

_OPPOSITES = ("not", "not_in", "not_equals", "unequal", "different_from", "inverted", "inverse", "opposite")
"""What others write beside a condition that is to hold the other way round, as they do `to: false`."""

_THINGS = ("robot", "ball", "who")
"""What others call the first and the second thing that a word is about, here entity and other."""

_BY_PLACE = {
    ("min", "minimum"): ("keeps_at_least", "at_least"),
    ("max", "maximum"): ("keeps_at_most", "at_most"),
    ("position", "pos", "location", "start_pos", "at"): ("start_m", "centre_m", "start"),
    ("start",): ("start_m", "centre_m", "initial"),
    ("amount",): ("points", "by"),
    ("value",): ("points", "to", "equals", "initial"),
    ("duration", "duration_s", "length", "length_s", "seconds"): ("half_s", "lasts_s", "for_s", "limit_s"),
}
_CALLED_BY_PLACE = {key: called for keys, called in _BY_PLACE.items() for key in keys}
"""The same of keys that are called this or that, as the place may have them: of a score that grows, and of a limit."""


_MORE = "'at_least' holds from that value on, and 'more than it' is at_most with negate: true"
_LESS = "'at_most' holds up to that value, and 'less than it' is at_least with negate: true"
_COMPARED = {
    **dict.fromkeys(("more", "more_than", "greater", "greater_than", "larger_than", "above"), _MORE),
    **dict.fromkeys(("faster_than", "farther_than"), _MORE),
    **dict.fromkeys(("less", "less_than", "fewer_than", "smaller_than", "below", "under"), _LESS),
    **dict.fromkeys(("slower_than", "nearer_than"), _LESS),
}
"""Comparisons of other languages, in which the value itself does not count."""


_COORDINATES = frozenset({"x", "y", "x_m", "y_m"})

_OF_TRIGGERS = {
    "for_s": "what must last for a time is {trigger: holds, condition: {…}, for_s: …}",
    "half": "in which half it counts stands in the rule's conditions: {condition: half, equals: …}",
}
"""What others have beside a trigger's own keys."""

_OF_RULES = {
    "else": "; what else is to happen is a rule of its own, whose conditions have negate: true",
    "once": "; a rule that fires once has max_executions: 1",
}
"""What other languages have beside triggers, conditions and actions."""


def for_key(key: str, above: Path, allowed: Iterable[str], root: Node) -> str:
    """Return what an unknown key is called here, or where it belongs; empty: nobody knows.

    Args:
        key: the key.
        above: where the mapping stands.
        allowed: the keys that it may have.
        root: the whole scenario.
    """
    allowed = set(allowed)
    usual = _usual_key(key, allowed, node_at(root, above))
    if usual is not None:
        return f"; it is called {usual!r} here"
    written = _written_instead(key, above, allowed) or _of_condition(key, above, allowed, node_at(root, above))
    if written:
        return written
    if above or not isinstance(root, Entries):
        return ""
    before = list(root.entries)[: list(root.entries).index(key)] if key in root.entries else []
    last = root.entries[before[-1]] if before else None
    if not isinstance(last, Leaf) or not last.empty:
        return ""
    return f"; what belongs to '{before[-1]}' above it is indented: put two blanks before it"


def _usual_key(key: str, allowed: Collection[str], node: Node | None) -> str | None:
    """Return what a key is called here, of several the first that is not given yet; None: nobody knows."""
    marks = node.key_marks if isinstance(node, Entries) else {}
    named = _of_thing(key, allowed) if key in _THINGS else (_USUAL_KEYS.get(key), *_CALLED_BY_PLACE.get(key, ()))
    meant = [one for one in named if one is not None and one in allowed]
    # What a base gives may be given anew.
    free = [one for one in meant if one not in marks or key not in marks or marks[one].file != marks[key].file]
    things = [one for one in marks if one in _THINGS and one not in allowed]
    if key in things and meant:
        return next(iter(free[things.index(key) :]), None if free else meant[0])
    return next(iter(free or meant), None)


def _of_thing(thing: str, allowed: Collection[str]) -> tuple[str, ...]:
    """Return the keys for what a word is about, in the order in which they are given."""
    # Of a last touch the ball is what was touched, and who it was stands under a key of its own.
    return ("by",) if "by" in allowed and thing != "ball" else ("entity", "other")


def _written_instead(key: str, above: Path, allowed: set[str]) -> str:
    """Return how something is written for which there is no key; empty: nobody knows."""
    if key in _COMPARED and {"at_least", "negate"} <= allowed:
        return f"; {_COMPARED[key]}"
    if key in _COORDINATES and {"at", "x_min_m"} & allowed:
        bounds = f"{key[0]}_min_m and {key[0]}_max_m"
        rect = f"; its bounds are {bounds}, and each may be left out" if "x_min_m" in allowed else ""
        return "; a place is written at: {point: [x, y]}" if "at" in allowed else rect
    if key in _OF_TRIGGERS and "trigger" in allowed:
        return f"; {_OF_TRIGGERS[key]}"
    if above[:1] == ("rules",) and len(above) == 2:
        return _OF_RULES.get(key, "")
    if above[:1] == ("draws",) and key.startswith(("weight", "probabilit")):
        return "; a value that shall come more often is written more than once: values: [a, a, a, b]"
    return ""


def _of_condition(key: str, above: Path, allowed: set[str], node: Node | None) -> str:
    """Return how a condition is turned over, counts a group or must last; empty: something else is meant."""
    if "condition" not in allowed:
        return ""
    value = child(node, key)
    is_false = isinstance(value, Leaf) and value.value is False
    if "negate" in allowed and (key in _OPPOSITES or is_false):
        return "; the opposite of a condition is written negate: true"
    if key in ("all", "any", "none") and "of" in allowed:
        return f"; how many of them is written of: {key}"
    if key == "at_least" and "of" in allowed and isinstance(value, Leaf):
        return f"; how many of them is written of: {{at_least: {value.value}}}"
    if key in ("for_s", "every_s", "grace_s") and above[-1:] == ("condition",):
        written = f"{{trigger: holds, condition: {{…}}, {key}: …}}"
        return f"; it stands beside 'condition', in the trigger: {written}"
    return ""


def for_plural(name: str, known: Collection[str]) -> str:
    """Return how several are named together whose plural was written: `crates` of crate_1 and crate_2; else empty.

    Args:
        name: the name that is none, where a group's may stand.
        known: those that may stand there.
    """
    stem = name.casefold().removesuffix("s")
    several = [one for one in known if one.casefold().rstrip("0123456789").rstrip("_") == stem]
    if stem == name.casefold() or len(several) < 2:
        return ""
    return f"; several under one name are a group: groups: {{{name}: [{listing(several)}]}}"


def for_coordinates(path: Path, node: Node | None, keys: Collection[str]) -> str:
    """Return how a place is written where numbers in a list stand for a mapping, or a name for the numbers.

    Args:
        path: where it stands.
        node: what stands there.
        keys: those of the mapping that is expected; none where it is no mapping.
    """
    if path[:1] == ("expect",) and path[-2:-1] in (("place",), ("move",)) and isinstance(node, Leaf | Entries):
        return "; a place is written [x, y] or [x, y, yaw], in m and rad"
    numbers = [item.value for item in node.items if isinstance(item, Leaf)] if isinstance(node, Items) else []
    known = [key for key in ("x_m", "y_m", "yaw_rad") if key in keys]
    if not 2 <= len(numbers) <= len(known) or any(isinstance(one, bool | str | None) for one in numbers):
        return ""
    return f"; write {{{', '.join(f'{key}: {one}' for key, one in zip(known, numbers, strict=False))}}}"


def for_pair(path: Path, node: Node | None, root: Node) -> str:
    """Return how two that belong together are written; empty: something else is meant."""
    if path[-1:] == ("distance",) and isinstance(node, Entries):
        two = [one for part in node.entries.values() for one in texts(part)]
        return f"; the two are written [{listing(two)}]" if len(two) == 2 else ""
    if path[:1] != ("expect",) or path[-2:-1] != ("touch",) or not isinstance(node, Leaf):
        return ""
    pair = node_at(root, path[:-1])
    two = [one for item in pair.items for one in texts(item)] if isinstance(pair, Items) else []
    return f"; each touch is a pair, also one alone: [[{listing(two)}]]" if len(two) == 2 else ""


def for_rank(path: Path, node: Node | None, root: Node) -> str:
    """Return how entrants are ranked by a counter whose name stands as a key, as `score` and `time` do."""
    if path[:2] != ("result", "rank") or not isinstance(node, Entries):
        return ""
    counters = child(root, "counters")
    known = counters.entries if isinstance(counters, Entries) else {}
    name, order = next(((key, one) for key, one in node.entries.items() if key in known), ("", None))
    ways = [way for way in texts(order) if way in ("ascending", "descending")]
    return f"; a counter is written {{counter: {name}, order: {ways[0] if ways else '…'}}}" if name else ""


def for_param(node: Node | None, root: Node) -> str:
    """Return how the value of a param is written where its name stands as a text; empty: it is no param's name."""
    params = child(root, "params")
    if isinstance(node, Entries) and len(node.entries) == 1:
        (written,) = node.entries
    elif isinstance(node, Leaf) and isinstance(node.value, str):
        written = node.value
    else:
        return ""
    name = written.strip("${}() ")
    known = isinstance(params, Entries) and name in params.entries
    return f"; the value of that param is written {{param: {name}}}" if known else ""


_VALUES = {"counter": "counters", "draw": "draws", "timer": "timers", "flag": "flags"}
"""Where the names stand whose value is written ``{counter: NAME}``."""
_SCORE = ("counter", "entrants")
"""A score is read like a counter."""


def for_named(path: Path, node: Node | None, root: Node, said: str) -> str:
    """Return how the value of something is written where its name stands alone; empty: it is the name of nothing.

    Args:
        path: where the name stands.
        node: what stands there.
        root: the whole scenario.
        said: what is said to be expected there, such as ``expected a number or {counter: …}``.
    """
    if not isinstance(node, Leaf) or not isinstance(node.value, str):
        return ""
    name = node.value
    if path[-1] == "facing":
        is_seen = kind_of(name, root) in SEEN
        return f"; to look at it is written {{towards: {name}}}" if is_seen else ""
    named = (key for key, section in (*_VALUES.items(), _SCORE) if child(child(root, section), name) is not None)
    keys = [*named, *(["word"] if name in NUMBER_WORDS else [])]
    key = next((key for key in keys if f"{{{key}: …}}" in said), None)
    return f"; its value is written {{{key}: {name}}}" if key else ""


def for_degrees(path: Path, node: Node | None, kind: str) -> str:
    """Return an angle of more than a turn as it would be written in rad; empty: it is no such angle.

    Args:
        path: where it stands.
        node: what stands there.
        kind: pydantic's type of the error.
    """
    if kind not in ("less_than", "less_than_equal") or not str(path[-1]).endswith("_rad"):
        return ""
    value = node.value if isinstance(node, Leaf) else None
    if isinstance(value, bool) or not isinstance(value, int | float) or value <= 2 * pi:
        return ""
    return f"; angles are in rad: if degrees are meant, write {radians(value):.4f}"
