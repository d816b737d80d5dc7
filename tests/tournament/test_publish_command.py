"""``rcj-challenge tournament publish``: exit codes, what is written where, and what is not released."""

import json
from datetime import UTC, datetime, timedelta

import pytest

from rcj_challenges.core.file_names import slug
from rcj_challenges.tournament.rulings import withdraw
from tests.cli.in_this_process import here
from tests.tournament.store_helpers import LEAGUE, Home


@pytest.fixture
def publish(tmp_path, monkeypatch, capsys):
    def command(home, *arguments):
        code = here(
            monkeypatch, home.folder, "tournament", "publish", "league.yaml", "--data", str(home.data), *arguments
        )
        said = capsys.readouterr()
        return code, said.out, said.err

    return command


def released(at):
    """Return the league with a time at which its first stage is released."""
    return LEAGUE.replace("{stage: round_robin}", f'{{stage: round_robin, release: "{at:%Y-%m-%d %H:%M}"}}')


def test_before_anything_is_played_the_site_has_the_fixtures(tmp_path, publish):
    home = Home(tmp_path)
    code, out, _ = publish(home)
    assert code == 0
    assert out.startswith("0 matches published")
    league = (home.data / "site" / "stages" / "league.html").read_text("utf-8")
    assert all(f"teams/{team}.html" in league for team in ("ada", "bee", "cid"))


def test_each_match_gets_a_page_and_the_next_time_it_is_taken_over(tmp_path, publish):
    home = Home(tmp_path)
    home.play()
    assert publish(home, "--url", "https://cup.example")[1].startswith("4 matches published, 0 of them")
    assert publish(home, "--url", "https://cup.example")[1].startswith("4 matches published, 4 of them")
    feed = json.loads((home.data / "site" / "feed.json").read_text("utf-8"))
    for item in feed["items"]:
        assert (home.data / "site" / item["url"].removeprefix("https://cup.example/")).is_file()
    assert {path.name for path in (home.data / "for_teams").iterdir() if path.is_dir()} == {"ada", "bee", "cid"}
    assert (home.data / "organizer" / "likeness.html").is_file()


def test_teams_called_like_pages_have_pages_and_folders_of_their_own(tmp_path, publish):
    teams = ("index", "style", "about")
    home = Home(tmp_path, teams=teams)
    home.play()
    assert publish(home)[0] == 0
    for team in teams:
        for page in (f"site/teams/{slug(team)}.html", f"for_teams/{slug(team)}/index.html"):
            assert f"<h1><bdi>Team {team}</bdi>" in (home.data / page).read_text("utf-8")
    assert 'class="cards"' in (home.data / "site" / "teams" / "index.html").read_text("utf-8")


def test_what_is_not_released_is_not_shown_nor_what_follows_from_it(tmp_path, publish):
    home = Home(tmp_path, released(datetime.now(UTC) + timedelta(days=2)))
    home.play()
    code, out, _ = publish(home)
    assert (code, out.partition(",")[0]) == (0, "0 matches published")
    assert not (home.data / "site" / "matches").exists()
    finals = (home.data / "site" / "stages" / "finals.html").read_text("utf-8")
    assert "place 1 of league" in finals
    assert not any(f"teams/{team}.html" in finals for team in ("ada", "bee", "cid"))


def test_a_withdrawal_shows_nothing_of_matches_that_are_not_released(tmp_path, publish):
    home = Home(tmp_path, released(datetime.now(UTC) + timedelta(days=2)))
    home.play()
    with home.opened() as tournament:
        withdraw(tournament, "ada", "the robots are broken", cascade=True)
    assert publish(home)[1].startswith("0 matches published")
    assert not (home.data / "site" / "matches").exists()


def test_what_was_released_before_is_shown(tmp_path, publish):
    home = Home(tmp_path, released(datetime.now(UTC) - timedelta(days=2)))
    home.play()
    assert publish(home)[1].startswith("4 matches published")


def test_a_stage_without_a_time_of_release_has_no_premiere(tmp_path, publish):
    home = Home(tmp_path)
    code, _, err = publish(home, "--premiere", "league", "--premiere", "nothing")
    assert code == 2
    assert "error[no-release]" in err
    assert "error[unknown-stage]" in err


def test_a_folder_in_the_way_is_a_wrong_input(tmp_path, publish):
    home = Home(tmp_path)
    (home.data / "site").mkdir(parents=True)
    (home.data / "site" / "thesis.txt").touch()
    code, _, err = publish(home)
    assert code == 2
    assert "error[folder-in-the-way]" in err
