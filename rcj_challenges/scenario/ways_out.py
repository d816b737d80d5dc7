"""What to write instead of a name that is none in its place, where people mean something that is said otherwise."""

from __future__ import annotations

from rcj_challenges.scenario.catalogue import texts
from rcj_challenges.scenario.tree import Node, Path, child

_TEAMS = ("entrants", "teams")
_FOR_TEAMS = {
    "for_each": "there is no rule for each team; write for_each: robots, where entrant: each is the team of each "
    "of them, or a rule for each team, where its colour names all its robots",
    "per": "nothing is kept for each team; give each team one under a name of its own, or, to rank by it, keep it per: "
    "robots and count it for one robot of the team",
}
"""By the key behind which somebody names all teams."""


def for_teams(name: str, path: Path) -> str:
    """Return how a rule or a counter for each team is written; empty: that is not what was meant."""
    return _FOR_TEAMS.get(str(path[-1]), "") if name in _TEAMS else ""


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
