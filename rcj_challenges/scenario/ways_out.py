"""What to write instead of a name that is none in its place, where people mean something that is said otherwise."""

from __future__ import annotations

from collections.abc import Iterable

from rcj_challenges.scenario.catalogue import texts
from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.tree import Leaf, Node, Path, child

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


def for_repeated(above: Path, key: str) -> str:
    """Return where ``repeat_for`` stands; empty: something else is meant."""
    if key != "repeat_for":
        return ""
    within = above[:1] == ("rules",) and len(above) > 1
    return "; repeat_for stands in a rule, beside its triggers" + ("" if within else ", and nowhere else")


def for_drawn(name: str, kind: str, path: Path, *, each: bool) -> str:
    """Return how something is done to the one that a draw decided; empty: that is not what was meant.

    Args:
        name: the name that is none in its place.
        kind: what it names elsewhere.
        path: where it stands.
        each: whether `each` may stand there.
    """
    if kind != "draw" or not each or path[2:3] != ("actions",):
        return ""
    return f"; to do it to the one drawn: for_each, {{condition: drawn, draw: {name}, equals: each}}, and 'each' here"


def for_counted(path: Path, node: Node | None) -> str:
    """Return how something lasts as long as a counter says; empty: that is not what was meant."""
    counter = texts(child(node, "counter"))
    if path[2:] != ("lasts_s",) or path[0] not in ("timers", "phases") or not counter:
        return ""
    of_timer = path[0] == "timers"
    asked = f"{{condition: timer, timer: {path[1] if of_timer else '…'}, at_least: {{counter: {counter[0]}}}}}"
    since, then = ("", "") if of_timer else (" that runs since then", " and set_phase")
    heard = f"{{trigger: holds, condition: {asked}}}"
    return f"; as long as a counter says: a long timer{since}, and a rule with {heard}{then}"
