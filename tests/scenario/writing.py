"""Small scenarios for the tests of this folder."""

import re

import pytest

from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 2\nid: a\ntitle: A\nextends: soccersim_v2\n"
HEAD_LINES = HEAD.count("\n")
SUGGESTED = re.compile(r"did you mean '([^']+)'")


def loaded(body, overrides=(), head=HEAD):
    """Load a scenario whose sections are given, over the preset."""
    return load_text(head + body, overrides, file="a.yaml")


def scenario(body, overrides=(), head=HEAD):
    return loaded(body, overrides, head).scenario


def in_tuples(data):
    """Return plain data with its lists as tuples, which models have."""
    if isinstance(data, dict):
        return {key: in_tuples(value) for key, value in data.items()}
    return tuple(map(in_tuples, data)) if isinstance(data, list) else data


def problems_of(call, *arguments):
    """Return what a call refuses, or nothing if it refuses nothing; anything but a `ScenarioError` is a defect."""
    try:
        call(*arguments)
    except ScenarioError as error:
        return list(error.diagnostics)
    return []


def errors(body, overrides=(), head=HEAD):
    """Return the errors of a scenario that is refused."""
    with pytest.raises(ScenarioError) as caught:
        loaded(body, overrides, head)
    return list(caught.value.diagnostics)


def in_short(problem):
    """Return an error without its place in the file: ``unknown-name rules.r.triggers[0] (enters) -> blue_goal``."""
    suggested = SUGGESTED.search(problem.help)
    arrow = f"-> {suggested[1]}" if suggested else ""
    return " ".join(filter(None, (problem.code, place_of(problem).path, arrow)))


def complaints(body, overrides=(), head=HEAD):
    """Return the errors of a scenario that is refused, each `in_short`."""
    return [in_short(problem) for problem in errors(body, overrides, head)]


def findings(body):
    """Return the warnings about a scenario, as they are printed."""
    return [str(one) for one in lint(loaded(body))]


def kinds(body):
    """Return the codes of the warnings about a scenario."""
    return {one.code for one in lint(loaded(body))}


def rule(trigger="{trigger: half_started}", action="{action: end}", rest=""):
    """Return a section with one rule."""
    return f"rules:\n  r:\n    triggers: [{trigger}]\n    actions: [{action}]\n{rest}"
