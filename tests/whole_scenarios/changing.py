"""Shipped scenarios with unintended changes: by structure, as an editor's slip, and letter by letter."""

from __future__ import annotations

import copy
import random
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from rcj_challenges.scenario.reading.yaml_strict import parse_text
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER
from rcj_challenges.scenario.tree import plain
from scripts.write_reference import read_examples
from tests.whole_scenarios.wholes import written

Holder = dict[Any, Any] | list[Any]
_ROOT = Path(__file__).resolve().parents[2]
_NUMBERS = (
    0, -1, 1, 2, 0.5, -0.0, 1e-9, 1e-320, 1e9, 1e15, 1e308, -1e308, 2**31, 2**53 + 1, 2**63 - 1, 2**63, 10**40,
    0.031, 0.032, 86_400, 86_401, 999.9, 3.1415926536, float("inf"), float("nan"),
)  # fmt: skip
_TEXTS = (
    "", " ", "each", "other", "robots", "walls", "ball", "play", "any", "start", "keep", "none", "null", "~", "yes",
    "0", "1e3", "0x1F", "a b", "ä", "Y1 ", "y1", "名前", "😀", "a\u0301", "\u202eb", "\u200b", "-", ".", "..", "{", "a: b",
    "#a", "%", "@", "'", '"', "match", "soccersim_v2", "./x.yaml", "x" * 65, "x" * 5000, "{param: x}", "$x", "*a", "&a",
    "robot.py", "../robot.py", "GOAL", "goal", "True", "[1, 2]", "1,5", "10 s", "90°", "param", "this", "con",
)  # fmt: skip
_KEYS = (
    "param",
    "each",
    "null",
    "x",
    "",
    "a b",
    "entity",
    "points",
    "for_each",
    "repeat_for",
    "extends",
    "ä",
    "1",
    "times",
)


def changed(seed: int) -> str:
    """Return the text of a shipped scenario or example to which something happened."""
    chance = random.Random(seed)  # noqa: S311 - nothing secret
    text = chance.choice(shipped())
    if chance.random() < 0.7:
        data = copy.deepcopy(_read(text))
        for _ in range(chance.choice((1, 1, 1, 2, 4))):
            chance.choice(BY_STRUCTURE)(data, chance)
        text = written(data)
    if chance.random() < 0.45:
        for _ in range(chance.choice((1, 1, 2, 5))):
            text = chance.choice(BY_LETTER)(text, chance)
    return text


@cache
def shipped() -> tuple[str, ...]:
    """Return what authors may begin with: scenarios, and examples from the documents."""
    texts = [path.read_text(encoding="utf-8") for path in sorted(SCENARIOS_FOLDER.rglob("*.yaml"))]
    texts += [example.whole for example in read_examples()]
    for page in sorted((_ROOT / "docs").glob("*.md")):
        blocks = re.findall(r"^```yaml\n(.*?)^```$", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
        texts += [block for block in blocks if "schema_version" in block]
    return tuple(texts)


@cache
def _read(text: str) -> Any:
    return plain(parse_text(text, "shipped.yaml"))


# --- by structure -----------------------------------------------------------------------------------------------------


def _places(node: Any, found: list[tuple[Holder, Any]]) -> list[tuple[Holder, Any]]:
    for key, value in list(node.items()) if isinstance(node, dict) else list(enumerate(node)):
        found.append((node, key))
        if isinstance(value, dict | list):
            _places(value, found)
    return found


def _somewhere(data: Any, chance: random.Random) -> tuple[Holder, Any]:
    """Return a place: any of them, or in a section that was chosen first, so that long lists do not have it all."""
    places = _places(data, [])
    if chance.random() < 0.5:
        section = chance.choice(list(data) or [""])
        places = _places(data[section], []) if isinstance(data.get(section), dict | list) else places
    return chance.choice(places) if places else (data, "title")


def drop(data: Any, chance: random.Random) -> None:
    """Leave something out; what names it stays."""
    holder, key = _somewhere(data, chance)
    if isinstance(holder, list) or key in holder:
        del holder[key]


def duplicate(data: Any, chance: random.Random) -> None:
    """Write something twice, under another name if it has one."""
    holder, key = _somewhere(data, chance)
    if isinstance(holder, list):
        holder.insert(key, copy.deepcopy(holder[key]))
    else:
        holder[f"{key}_again"] = copy.deepcopy(holder.get(key))


def rename(data: Any, chance: random.Random) -> None:
    """Call something otherwise."""
    holder, key = _somewhere(data, chance)
    if isinstance(holder, dict) and key in holder:
        new = chance.choice(
            (*_KEYS, f"{key}s", str(key).upper(), str(key)[:-1], f"{key}_s", str(key).replace("_", "-"))
        )
        holder[new] = holder.pop(key)


def put(data: Any, chance: random.Random) -> None:
    """Put some value in the place of another."""
    holder, key = _somewhere(data, chance)
    value: Any = chance.choice(
        (chance.choice(_NUMBERS), chance.choice(_TEXTS), None, True, False, [], {}, [[]], {"x": 1})
    )
    holder[key] = value


def put_number(data: Any, chance: random.Random) -> None:
    """Put an extreme number in the place of another."""
    places = [
        (holder, key) for holder, key in _places(data, [])
        if isinstance(holder[key], int | float) and not isinstance(holder[key], bool)
    ]  # fmt: skip
    if places:
        holder, key = chance.choice(places)
        holder[key] = chance.choice((*_NUMBERS, -holder[key], holder[key] * 10, holder[key] / 1000, str(holder[key])))


def put_name(data: Any, chance: random.Random) -> None:
    """Put another name of the scenario in the place of a text."""
    places = _places(data, [])
    names = [key for _, key in places if isinstance(key, str)]
    texts = [(holder, key) for holder, key in places if isinstance(holder[key], str)]
    if texts and names:
        holder, key = chance.choice(texts)
        holder[key] = chance.choice((*names, *(holder[key] for holder, key in texts), *_TEXTS[:12]))


def _at(holder: Holder, key: Any) -> Any:
    return holder.get(key) if isinstance(holder, dict) else holder[key]


def wrap(data: Any, chance: random.Random) -> None:
    """Put a list or a mapping around something, or many."""
    holder, key = _somewhere(data, chance)
    for _ in range(chance.choice((1, 1, 2, 40))):
        holder[key] = [_at(holder, key)] if chance.random() < 0.7 else {chance.choice(_KEYS): _at(holder, key)}


def transplant(data: Any, chance: random.Random) -> None:
    """Put a part of another scenario somewhere."""
    holder, key = _somewhere(data, chance)
    other, there = _somewhere(copy.deepcopy(_read(chance.choice(shipped()))), chance)
    if isinstance(holder, dict) and isinstance(other, dict) and chance.random() < 0.7:
        holder[there] = _at(other, there)
    else:
        holder[key] = _at(other, there)


def use_param(data: Any, chance: random.Random) -> None:
    """Let a param stand for a value."""
    holder, key = _somewhere(data, chance)
    value = _at(holder, key)
    use: dict[str, Any] = {"param": chance.choice(("p", "p", "q", "this"))}
    use |= {"times": chance.choice((*_NUMBERS, "2"))} if chance.random() < 0.3 else {}
    use |= {"plus": chance.choice(_NUMBERS)} if chance.random() < 0.2 else {}
    holder[key] = use
    if isinstance(data.get("params", {}), dict):
        data["params"] = {**data.get("params", {}), "p": value}


def remove(data: Any, chance: random.Random) -> None:
    """Remove something of the base."""
    section = chance.choice(
        ("robots", "zones", "balls", "kits", "entrants", "spots", "groups", "field", "rules", "counters")
    )
    names = {"robots": "Y1", "zones": "blue_goal", "balls": "ball", "kits": "v2", "entrants": "blue", "spots": "centre",
             "groups": "penalty_areas", "field": "goals"}  # fmt: skip
    if isinstance(data.get(section, {}), dict):
        data[section] = {**data.get(section, {}), names.get(section, "x"): None}


def repeat(data: Any, chance: random.Random) -> None:
    """Repeat a rule."""
    rules = data.get("rules")
    if isinstance(rules, dict) and rules:
        rule = rules[chance.choice(list(rules))]
        if isinstance(rule, dict):
            rows = (
                {"yellow": {}, "blue": {}},
                {"x" * 64: {}},
                {},
                {"yellow": {"v": "blue"}},
                {"a": None},
                ["a"],
                "blue",
            )
            data["tables"] = {"t": chance.choice(rows), "u": {"one": {"w": 1}, "two": {"w": 2}}}
            rule["repeat_for"] = chance.choice(("t", "t", "t", ["t", "u"], ["t", "t"], "unknown", [], {"a": {}}))
            holder, key = chance.choice(_places(rule, []))
            holder[key] = {"param": chance.choice(("this", "v", "unknown"))}


BY_STRUCTURE: tuple[Callable[[Any, random.Random], None], ...] = (
    drop, drop, drop, duplicate, rename, rename, put, put, put, put_number, put_number, put_name, put_name, put_name,
    wrap, transplant, transplant, use_param, remove, repeat,
)  # fmt: skip


# --- by letter --------------------------------------------------------------------------------------------------------

_PIECES = (
    "\t", " ", "  ", "\n", "'", '"', ":", ": ", "- ", "#", "{", "}", "[", "]", ",", "&a ", "*a", "!!int ", "!x ", "---\n",
    "...\n", "%YAML 1.2\n", "|\n", ">-\n", "? ", "<<: *a\n", "\r", "\r\n", "\u2028", "\x85", "\xa0", "\ufeff", "\x00", "\x1b",
    "[" * 3000, "{a: " * 900, "- " * 2000, "\x7f", "\ud800", "😀", "“", "\u2212", "null", "~", "=", "@", "`", "\\", "$", "null: 1\n", "0", "e", ".", "-",
)  # fmt: skip


def insert(text: str, chance: random.Random) -> str:
    """Write something somewhere."""
    at = chance.randrange(len(text) + 1)
    return text[:at] + chance.choice(_PIECES) + text[at:]


def delete(text: str, chance: random.Random) -> str:
    """Delete some letters."""
    at = chance.randrange(len(text) + 1)
    return text[:at] + text[at + chance.choice((1, 1, 2, 10, 100)) :]


def _lines(text: str, chance: random.Random) -> tuple[list[str], int]:
    lines = text.split("\n")
    return lines, chance.randrange(len(lines))


def indent(text: str, chance: random.Random) -> str:
    """Move a line, or all from it on, to the right or to the left."""
    lines, at = _lines(text, chance)
    last = chance.choice((at + 1, at + 3, len(lines)))
    by = chance.choice((" ", "  ", "\t", ""))
    lines[at:last] = [by + line if by else line.removeprefix(" ") for line in lines[at:last]]
    return "\n".join(lines)


def lose_a_line(text: str, chance: random.Random) -> str:
    """Leave a line out."""
    lines, at = _lines(text, chance)
    del lines[at]
    return "\n".join(lines)


def cut(text: str, chance: random.Random) -> str:
    """Write only the beginning, or only the end."""
    at = chance.randrange(len(text) + 1)
    return text[:at] if chance.random() < 0.7 else text[at:]


BY_LETTER: tuple[Callable[[str, random.Random], str], ...] = (
    insert, insert, insert, insert, delete, delete, indent, indent, lose_a_line, cut
)  # fmt: skip
