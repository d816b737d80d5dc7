"""Small scenarios for the tests of this folder."""

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 1\nid: a\ntitle: A\nextends: soccersim_v2\n"
HEAD_LINES = HEAD.count("\n")


def loaded(body, overrides=(), head=HEAD):
    """Load a scenario whose sections are given, over the preset."""
    return load_text(head + body, overrides, file="a.yaml")


def scenario(body, overrides=(), head=HEAD):
    return loaded(body, overrides, head).scenario


def complaints(body, overrides=(), head=HEAD):
    """Return what is said about it: each problem as path and message, without its place."""
    with pytest.raises(ScenarioError) as caught:
        loaded(body, overrides, head)
    return [": ".join(part for part in (p.path, p.message) if part) for p in caught.value.problems]


def findings(body):
    """Return what lint says about it, with its place."""
    return [str(one) for one in lint(loaded(body))]


def kinds(body):
    """Return the kinds of what lint finds."""
    return {one.code for one in lint(loaded(body))}


def problems_of(call, *arguments):
    """Return what a call refuses, or an empty list if it refuses nothing; anything but a `ScenarioError` is a defect."""
    try:
        call(*arguments)
    except ScenarioError as error:
        return error.problems
    return []


def rule(trigger="{trigger: half_started}", action="{action: end}", rest=""):
    """Return a section with one rule."""
    return f"rules:\n  r:\n    triggers: [{trigger}]\n    actions: [{action}]\n{rest}"
