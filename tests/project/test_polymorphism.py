"""Which kind a thing is, is asked of the thing: few modules import a single member of a family, each with a reason."""

from __future__ import annotations

import ast
import importlib
from collections.abc import Iterator
from pathlib import Path

import rcj_challenges
from rcj_challenges.rules.actions import ACTIONS
from rcj_challenges.rules.triggers import TRIGGERS

PACKAGE = Path(rcj_challenges.__file__).parent

FAMILIES = {
    "rcj_challenges.rules": ("actions", "conditions", "places", "triggers", "values"),
}
"""By the package within which its members may be named: the packages that have a file for each member."""

TAGS = {"action": {word.name() for word in ACTIONS.words()}, "trigger": {word.name() for word in TRIGGERS.words()}}
"""By the field that says which member it is: what stands in it."""

LISTED = {
    "rcj_challenges.referee.log_sentences": "the log names the team exactly as the value team_name does",
    "rcj_challenges.scenario.checks.consistency": "of a distance one end must be small, which neither end can see",
    "rcj_challenges.scenario.checks.ground": "a random point is the only place that needs a zone with an end",
    "rcj_challenges.scenario.checks.magnitudes": "what a counter is set to has no unit, whatever its field is called",
    "rcj_challenges.scenario.lint.values": "conditions on distance, speed and way, which measure what moves",
}
MOST = 8


def test_few_modules_name_a_single_member_of_a_family() -> None:
    found = {module: sorted(set(_named(tree, module))) for module, tree in _modules()}
    assert {module: names for module, names in found.items() if names and module not in LISTED} == {}


def test_each_module_of_the_list_still_needs_its_place_on_it() -> None:
    assert len(LISTED) <= MOST
    assert {module for module, tree in _modules() if any(_named(tree, module))} == set(LISTED)


def test_imports_and_comparisons_with_a_tag_are_both_found() -> None:
    code = """
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.triggers import TRIGGERS, Touches
scores = [one for one in actions if one.action == "score" or one.name() in ("count", "x")]
"""
    named = ["rcj_challenges.rules.actions.score", "rcj_challenges.rules.triggers.touches", "'count'", "'score'"]
    assert sorted(set(_named(ast.parse(code), "rcj_challenges.views.some"))) == sorted(named)
    assert list(_named(ast.parse(code), "rcj_challenges.rules.some"))[:2] == ["'score'", "'count'"]


def _modules() -> Iterator[tuple[str, ast.Module]]:
    for path in PACKAGE.rglob("*.py"):
        module = ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts)
        if not module.startswith(tuple(f"{family}." for family in FAMILIES)):
            yield module, ast.parse(path.read_text(encoding="utf-8"))


def _named(tree: ast.Module, module: str) -> Iterator[str]:
    """Yield the members that a module imports, and the tags that it compares with."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            yield from _imported(node, module)
        elif isinstance(node, ast.Compare):
            yield from _compared(node)


def _imported(node: ast.ImportFrom, module: str) -> Iterator[str]:
    for family, packages in FAMILIES.items():
        for package in (f"{family}.{one}" for one in packages if not module.startswith(f"{family}.")):
            if (node.module or "").startswith(f"{package}."):
                yield str(node.module)
            elif node.module == package:
                origins = (
                    getattr(getattr(importlib.import_module(package), one.name), "__module__", "") for one in node.names
                )
                yield from (origin for origin in origins if origin.startswith(f"{package}."))


def _compared(node: ast.Compare) -> Iterator[str]:
    sides = [node.left, *node.comparators]
    fields = {side.attr for side in sides if isinstance(side, ast.Attribute)}
    is_name = any(
        isinstance(one, ast.Call) and isinstance(one.func, ast.Attribute) and one.func.attr == "name" for one in sides
    )
    tags = {tag for field, known in TAGS.items() if is_name or field in fields for tag in known}
    texts = (one.value for side in sides for one in ast.walk(side) if isinstance(one, ast.Constant))
    yield from (repr(text) for text in texts if isinstance(text, str) and text in tags)
