"""Registers a word of each kind and prints what the package makes of each, as JSON."""

import json

from rcj_challenges.expect.runner import run_test
from rcj_challenges.rules.actions import ACTIONS
from rcj_challenges.rules.base import Word
from rcj_challenges.rules.conditions import CONDITIONS
from rcj_challenges.rules.places import PLACES
from rcj_challenges.rules.triggers import TRIGGERS
from rcj_challenges.rules.values import NUMBERS, VALUES
from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.json_schema import scenario_schema
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.sheet import sheet_markdown
from tests.rules.toys.double import Double
from tests.rules.toys.on_circle import OnCircle
from tests.rules.toys.right_of import RightOf
from tests.rules.toys.strays import Strays
from tests.rules.toys.y_of import YOf

TRIGGERS.add(Strays)
CONDITIONS.add(RightOf)
ACTIONS.add(Double)
PLACES.add(OnCircle)
VALUES.add(YOf)
NUMBERS.add(YOf)


def report(word: type[Word], name: str) -> dict[str, object]:
    """Return what validation, referee, sheet, drawing, schema and reference make of a word.

    Args:
        word: the word.
        name: a name in its example that is misspelt to see it refused.
    """
    from scripts.write_reference import Example, page

    loaded = load_text(Example("", (), word.EXAMPLE).whole)
    [test] = loaded.scenario.expect
    draw_scenario(loaded.scenario, loaded.roster)
    try:
        load_text(Example("", (), word.EXAMPLE.replace(name, f"{name}x")).whole)
        refused = []
    except ScenarioError as error:
        refused = [(one.code, place_of(one).path) for one in error.diagnostics]
    return {
        "differences": run_test(loaded, test).differences,
        "refused": refused,
        "sheet": sheet_markdown(loaded.scenario, loaded.roster),
        "schema": list(scenario_schema()["$defs"][word.__name__]["properties"]),
        "reference": page().partition(f"### {word.name()}")[2].partition("\n### ")[0],
    }


print(
    json.dumps(
        {
            "trigger": report(Strays, "strays, entity: ball"),
            "condition": report(RightOf, "beside: ball"),
            "action": report(Double, "counter: stake"),
            "place": report(OnCircle, "on_circle: middle_yellow"),
            "value": report(YOf, "y_m: {y_of: ball"),
        }
    )
)
