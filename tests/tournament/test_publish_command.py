"""``rcj-challenge tournament publish``: exit codes, what is written where, and what is not released."""

import json
import os
import shutil
import tempfile
from contextlib import contextmanager
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from rcj_challenges.core.files import slug
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
    assert (home.data / "organizer" / "similarity.html").is_file()


@pytest.mark.parametrize("url", ["javascript:alert(1)", "file:///etc", "cup.example", "https://", "http://["])
def test_the_address_of_a_site_is_one_of_the_web(tmp_path, publish, url):
    home = Home(tmp_path)
    assert publish(home, "--url", url)[0] == 2
    assert not (home.data / "site").exists()


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


def test_a_withdrawal_is_published_with_its_reason_also_if_it_was_taken_back(tmp_path, publish):
    home = Home(tmp_path)
    home.play()
    with home.opened() as tournament:
        withdraw(tournament, "ada", "the robots are <broken>")
        withdraw(tournament, "ada", "they were repaired", undo=True)
    publish(home)
    for page in ("about.html", "teams/ada.html"):
        text = (home.data / "site" / page).read_text("utf-8")
        assert "the robots are &lt;broken&gt;" in text
        assert "they were repaired" in text


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


@pytest.mark.skipif(os.name != "posix", reason="folders of Windows have no such permission")
def test_a_data_folder_that_cannot_be_written_can_be_read_and_published_elsewhere(monkeypatch, capsys):
    def run(*arguments):
        code = here(monkeypatch, home.folder, "tournament", *arguments, "league.yaml", "--data", str(home.data))
        return code, capsys.readouterr()

    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        Path(folder).chmod(0o777)
        home = Home(Path(folder))
        home.play()
        killed = Path(folder, "killed")
        with home.opened() as tournament:  # a copy of now is what a killed command leaves
            withdraw(tournament, "ada", "the robots are broken", cascade=True)
            shutil.copytree(home.data, killed, ignore=shutil.ignore_patterns("*-shm"))
        commands = (("results",), ("status",), ("publish", "--out", f"{folder}/elsewhere"))
        before = [run(*command)[1].out for command in commands]
        shutil.rmtree(Path(folder, "elsewhere"))
        for data in (home.data, killed):
            home.data = data
            with only_reading(data):
                assert [(0, text) for text in before] == [
                    (code, said.out) for code, said in (run(*command) for command in commands)
                ]
                shutil.rmtree(Path(folder, "elsewhere"))
                code, said = run("publish")
            assert code == 2
            assert "error[site-unwritable]" in said.err


@contextmanager
def only_reading(folder):
    """Take the permission to write into a folder away; from root, which needs none, by becoming another user."""
    is_root = os.geteuid() == 0
    folder.chmod(0o555)
    if is_root:
        os.seteuid(65534)
    try:
        yield
    finally:
        if is_root:
            os.seteuid(0)
        folder.chmod(0o755)
