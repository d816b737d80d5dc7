"""The same scenario written otherwise: params and repeated rules written out by hand must come to the same."""

from __future__ import annotations

import copy
from typing import Any

from tests.whole_scenarios.staging import Data


def written_out(data: Data) -> Data:
    """Return a scenario without repeated rules, and with values where params stand for them; the params stay.

    Args:
        data: a scenario that was taken.
    """
    params = data.get("params") or {}
    rules: Data = {}
    for name, rule in (data.get("rules") or {}).items():
        rows = rule.get("repeat_for") if isinstance(rule, dict) else None
        if not rows:
            rules[name] = rule
            continue
        for row in rows:
            values = {**(rows[row] if isinstance(rows, dict) else {}), "this": row}
            values = {key: _put(value, params) for key, value in values.items()}
            bare = {key: value for key, value in rule.items() if key != "repeat_for"}
            rules[f"{name}_{row}"] = _put(copy.deepcopy(bare), values)
    whole = {**data, "rules": rules} if rules else data
    return {key: value if key in ("params", "extends", "id") else _put(value, params) for key, value in whole.items()}


def _put(node: Any, values: Data) -> Any:
    """Return a value with other values in the place of params; of those that are reckoned with as they are."""
    if isinstance(node, dict):
        if set(node) == {"param"} and isinstance(node["param"], str) and node["param"] in values:
            return values[node["param"]]
        return {key: _put(inner, values) for key, inner in node.items()}
    if isinstance(node, list):
        return [_put(inner, values) for inner in node]
    return node


def says_more_of_rows(data: Data) -> bool:
    """Return whether a repeated rule has a sentence with blanks, which are filled in when it is repeated."""
    rules = (data.get("rules") or {}).values()
    return any("repeat_for" in rule and "{" in str(rule.get("says", "")) for rule in rules if isinstance(rule, dict))
