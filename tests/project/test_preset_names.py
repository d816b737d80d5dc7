"""The authoring guide names what the presets bring: an author must not have to look into the package for it."""

from pathlib import Path

import pytest

from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.resources import names_in, presets_folder

GUIDE = Path(__file__).parents[2] / "docs" / "authoring.md"
SECTIONS = ("balls", "robots", "entrants", "zones", "spots", "groups")


def told(section: str) -> str:
    """Return the row of a section in the guide's table."""
    rows = [line for line in GUIDE.read_text(encoding="utf-8").splitlines() if line.startswith(f"| `{section}` |")]
    assert len(rows) == 1, section
    return rows[0]


@pytest.mark.parametrize("section", SECTIONS)
@pytest.mark.parametrize("preset", names_in(presets_folder()))
def test_the_guide_names_all_that_a_preset_brings(preset, section):
    scenario = load(presets_folder() / f"{preset}.yaml").scenario
    row = told(section)
    assert [name for name in getattr(scenario, section) if f"`{name}`" not in row] == []
