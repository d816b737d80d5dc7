"""Every field that holds a name says what it names."""

import typing

from rcj_challenges.rules.actions.emit import Emit
from rcj_challenges.rules.fields import Name, Names
from rcj_challenges.rules.refs import refs_of
from rcj_challenges.scenario.models import designs, robots, scenario
from rcj_challenges.scenario.shape import bare, fields, is_model, members, without_none
from tests.whole_scenarios.models import all_models


def names_something(shape):
    """Whether a field's shape holds a name, outside of models (which have entries of their own)."""
    shape = without_none(shape)
    if shape in (Name, Names):
        return True
    kind = bare(shape).kind
    if is_model(kind):
        return False
    inner = members(shape) if members(shape) != (shape,) else typing.get_args(kind)
    return any(names_something(part) for part in inner if part is not Ellipsis)


DEFINING = {
    *((scenario.Scenario, name) for name in scenario.Scenario.model_fields if name != "first_phase"),
    (robots.Robot, "colour"),
    (scenario.Rule, "exclusive"),
    (Emit, "payload"),
    (scenario.Broadcast, "fields"),
    (scenario.ExpectedEvent, "payload"),
    (designs.Guideline, "drives"),
    (designs.Guideline, "devices"),
    (designs.Part, "limits"),
    (designs.RobotFile, "designs"),
    (designs.RobotFile, "robots"),
}
"""Fields whose names are chosen there."""


def test_every_field_that_holds_a_name_declares_what_it_names():
    found = {(model, key) for model in all_models() for key, shape in fields(model).items() if names_something(shape)}
    referring = {(model, key) for model in all_models() for _, key, _ in refs_of(model)}
    assert len(found) > 70
    assert {f"{model.__name__}.{key}" for model, key in found - referring - DEFINING} == set()
    assert {f"{model.__name__}.{key}" for model, key in referring - found} == set()
