"""The team that plays in a seat without a named one: the team made for the challenge, also in its variants, if it can drive their robots."""

import pytest

from rcj_challenges.cli.run import run
from rcj_challenges.core.errors import RcjError
from rcj_challenges.match.samples import sample_team
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER

VARIANTS = SCENARIOS_FOLDER / "variants"


@pytest.fixture
def variant(tmp_path):
    """Return a function that writes a scenario beside a copy of the fast shooter, and loads it."""
    shipped = SCENARIOS_FOLDER / "fast_shooter.yaml"
    (tmp_path / "fast_shooter.yaml").write_bytes(shipped.read_bytes())

    def write(text: str, base: str = "fast_shooter.yaml", name: str = "mine"):
        path = tmp_path / f"{name}.yaml"
        head = f"schema_version: 2\nid: {name}\ntitle: Mine\nextends: ./{base}\n"
        path.write_text(head + text, encoding="utf-8")
        return load(path)

    return write


def chosen(loaded, seat: str = "yellow") -> str | None:
    found = sample_team(loaded.scenario, seat, [load(path).scenario for path in loaded.bases])
    return found.name if found else None


def test_the_team_made_for_a_challenge_plays_it(variant):
    assert chosen(load("fast_shooter")) == "fast_shooter"
    assert chosen(load("match"), "blue") == "roles_and_radio"
    assert chosen(load("match_2021"), "blue") == chosen(load("match_2021"), "yellow") == "match_2021"


def test_a_variant_is_played_by_the_team_of_the_challenge_that_it_extends(variant):
    longer = variant("params: {goal_pause_s: 3}", name="longer")
    assert [path.name for path in longer.bases] == ["fast_shooter.yaml"]
    assert chosen(longer) == "fast_shooter"
    longest = variant("match: {half_s: 300}", base="longer.yaml", name="longest")
    assert [path.name for path in longest.bases] == ["longer.yaml", "fast_shooter.yaml"]
    assert chosen(longest) == "fast_shooter"


def test_a_team_does_not_play_a_variant_with_robots_of_another_kit(variant):
    assert chosen(variant("robots: {Y3: {kit: v2}}")) is None


@pytest.mark.parametrize(
    "change", ["packet_lists: []", "packet_lists: [Y3, Y3]", "packet_has_flag: false", 'messages: "v2.2"']
)
def test_a_team_does_not_play_a_variant_whose_packets_it_cannot_read(variant, change):
    assert chosen(variant(f"kits: {{legacy_2021: {{{change}}}}}")) is None
    assert chosen(variant("kits: {legacy_2021: {chassis: {mass_kg: 0.3}}}", name="heavier")) == "fast_shooter"


def test_the_teams_of_the_match_play_it_with_either_version_of_the_messages(tmp_path):
    path = tmp_path / "mine.yaml"
    head = "schema_version: 2\nid: mine\ntitle: Mine\nextends: match\n"
    path.write_text(head + "kits: {v2: {messages: v2.2}}\n", encoding="utf-8")
    assert (chosen(load(path), "blue"), chosen(load(path))) == ("roles_and_radio", "all_sensors")
    path.write_text(head + "robots: {Y1: {kit: other}}\nkits: {other: {messages: '2021'}}\n", encoding="utf-8")
    assert chosen(load(path)) is None


def test_a_team_without_the_programs_that_are_asked_for_does_not_play(variant):
    assert chosen(variant("entrants: {yellow: {robots: {Y3: shoot/shoot.py}}}")) is None


@pytest.mark.parametrize(
    ("name", "programs"),
    [
        ("fast_shooter_v2", ["score_goal/score_goal.py for Y3"]),
        ("pass_the_ball_v2", ["pass_ball_yellow.py for Y1 (kit v2), Y2", "pass_ball_blue.py for B1 (kit v2), B2"]),
    ],
)
def test_a_seat_without_a_sample_team_is_refused_with_the_programs_that_it_needs(name, programs, tmp_path):
    with pytest.raises(RcjError) as refused:
        run(str(VARIANTS / f"{name}.yaml"), out=tmp_path, quiet=True, replay=False)
    assert (refused.value.code, refused.value.exit_code) == ("no-sample-team", 2)
    assert "--team yellow=PATH" in refused.value.help
    assert [one for one in programs if one not in refused.value.help] == []
