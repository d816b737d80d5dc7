"""The site of a tournament: whole, incremental, safe with names of strangers, and silent about what is private."""

import csv
import html
import io
import json
import re
import shutil
from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.records.folder import SCENARIO, SENSORS
from rcj_challenges.tournament.played import Submission
from rcj_challenges.tournament.season import Outcome, Ruled
from rcj_challenges.tournament.site import Published, SiteSource, hidden_fixtures, publish
from rcj_challenges.tournament.site.model import Season
from rcj_challenges.tournament.site.podium import ordinal
from rcj_challenges.tournament.site.public import read_replay
from rcj_challenges.tournament.site.schedule import Heading, appointments, as_csv, as_ics
from tests.tournament.site_play import HOSTILE, NOW, SECRET, MadeUpSeason, make_season

ROUNDS = {"groups": 5, "finals": 1, "super": 1, "skills": 1}


@pytest.fixture(scope="session")
def season(tmp_path_factory: pytest.TempPathFactory) -> MadeUpSeason:
    return make_season(tmp_path_factory.mktemp("season"), ticks=500)


@pytest.fixture(scope="session")
def source(season: MadeUpSeason) -> SiteSource:
    return season.source(season.outcomes(ROUNDS), url="https://cup.example/")


@pytest.fixture(scope="session")
def data(source: SiteSource, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("published")
    publish(source, folder)
    return folder


@pytest.fixture(scope="session")
def site(data: Path) -> Path:
    return data / "site"


def texts(folder: Path) -> Iterator[tuple[Path, str]]:
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            yield path, path.read_text("utf-8")


class Links(HTMLParser):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.tags: list[str] = []
        self.handlers: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.found += [value or "" for name, value in attrs if name in ("href", "src", "action", "xlink:href")]
        self.handlers += [name for name, _ in attrs if name.startswith("on") or name == "style"]


def pages(site: Path) -> list[Path]:
    return [page for page in sorted(site.rglob("*.html")) if page.name != "replay.html"]


def test_every_link_leads_to_a_file_or_to_nowhere_outside(data: Path) -> None:
    broken = []
    for page in [*pages(data / "site"), *pages(data / "for_teams"), *pages(data / "organizer")]:
        for link in Links(page.read_text("utf-8")).found:
            parts = urlsplit(link)
            outside = parts.scheme not in ("", "data") or link.startswith("/")
            target = (page.parent / unquote(parts.path)).resolve()
            if outside or (parts.path and not parts.scheme and not target.is_file()):
                broken.append((page.name, link))
    assert broken == []


def test_all_pages_can_be_reached_from_the_overview(site: Path) -> None:
    reached, waiting = set(), [site / "index.html"]
    while waiting:
        page = waiting.pop()
        if page in reached:
            continue
        reached.add(page)
        if page.suffix == ".html" and page.name != "replay.html":
            links = Links(page.read_text("utf-8")).found
            waiting += [(page.parent / unquote(urlsplit(link).path)).resolve() for link in links if ":" not in link]
    assert {page.resolve() for page in site.rglob("*.html")} <= {page.resolve() for page in reached}


def test_no_script_runs_and_nothing_of_a_name_becomes_markup(data: Path) -> None:
    for page in [*pages(data / "site"), *pages(data / "for_teams")]:
        text = page.read_text("utf-8")
        parsed = Links(text)
        assert "script" not in parsed.tags, page
        assert "img" not in parsed.tags, page
        assert parsed.handlers == [], page
        assert "default-src 'none'" in html.unescape(text)
    for path, text in texts(data / "site"):
        if path.name != "replay.html":
            assert HOSTILE not in text or path.suffix in (".json", ".ics", ".csv"), path


def test_marks_of_direction_and_control_characters_are_taken_out_of_names(site: Path) -> None:
    for path, text in texts(site):
        assert not re.search("[\x00-\x08\x0b-\x1f\u202a-\u202e\u2066-\u2069]", text.replace("\r\n", "")), path


def test_nothing_of_programs_is_public(data: Path) -> None:
    for folder in ("site", "premieres"):
        for path, text in texts(data / folder):
            assert SECRET not in text, path
            assert "Traceback" not in text, path
            assert "printed this" not in text, path
            assert "sensors-1" not in text, path


def test_faults_are_public_by_kind(site: Path, source: SiteSource) -> None:
    match = next(match for match in Season(source).released if match.fixture.stage == "groups")
    text = (site / "matches" / match.slug / "index.html").read_text("utf-8")
    assert "The program of Y1 crashed." in text


def test_a_team_gets_faults_and_sensors_of_its_own_programs_and_no_others(data: Path, source: SiteSource) -> None:
    match = next(match for match in Season(source).released if match.fixture.stage == "groups")
    # Y1 crashes, and B1 and Y2 are recorded, in both halves; the sides are changed in between.
    recorded = {"1": ["B1"], "2": ["Y2"]}, {"1": ["Y2"], "2": ["B1"]}
    for team, crashed_in, sensed in zip(match.teams, (2, 1), recorded, strict=True):
        page = (data / "for_teams" / team / match.slug / "replay.html").read_text("utf-8")
        facts = read_replay(page).facts
        assert {half: [robot["name"] for robot in one["robots"]] for half, one in facts["sensors"].items()} == sensed
        assert all(f'id="{block}-{half}"' in page for half in sensed for block in ("sensors", "output"))
        details = {half["half"] for half in facts["halves"] if SECRET in str(half["faults"])}
        assert details <= {crashed_in}
        events = {event["half"] for event in facts["events"] if SECRET in str(event)}
        assert events == {crashed_in}
    assert SECRET in (data / "for_teams" / match.teams[1] / "index.html").read_text("utf-8")


def test_each_team_has_the_logs_of_its_own_robots_only(data: Path, source: SiteSource) -> None:
    match = next(match for match in Season(source).released if match.fixture.stage == "groups")
    logs = {
        team: sorted(one.name for one in (data / "for_teams" / team / match.slug).glob("*.log")) for team in match.teams
    }
    assert logs == {match.teams[0]: ["B1.log", "B2.log", "B3.log"], match.teams[1]: ["Y1.log", "Y2.log", "Y3.log"]}


def test_sensors_that_are_recorded_later_come_into_what_a_team_gets(season: MadeUpSeason, tmp_path: Path) -> None:
    record = Path(shutil.copytree(season.record, tmp_path / "record"))
    sensors = (record / SENSORS).rename(tmp_path / "later")
    outcomes = season.outcomes({"groups": 1})
    source = replace(season, record=record).source(dict([next(iter(outcomes.items()))]))
    (match,) = Season(source).released
    folder = tmp_path / "published" / "for_teams" / match.teams[0] / match.slug
    publish(source, tmp_path / "published")
    assert not (folder / "replay.html").exists()
    sensors.rename(record / SENSORS)
    publish(source, tmp_path / "published")
    assert 'id="sensors-1"' in (folder / "replay.html").read_text("utf-8")


def test_halves_have_the_name_that_the_scenario_gives_them(season: MadeUpSeason, tmp_path: Path) -> None:
    record = Path(shutil.copytree(season.record, tmp_path / "record"))
    scenario = json.loads((record / SCENARIO).read_text("utf-8"))
    scenario["match"]["called"] = ["inning", "innings"]
    (record / SCENARIO).write_text(json.dumps(scenario), "utf-8")
    outcomes = season.outcomes({"groups": 1})
    source = replace(season, record=record).source(dict([next(iter(outcomes.items()))]))
    (match,) = Season(source).released
    publish(source, tmp_path / "published")
    page = (tmp_path / "published" / "site" / "matches" / match.slug / "index.html").read_text("utf-8")
    for_team = (tmp_path / "published" / "for_teams" / match.teams[1] / "index.html").read_text("utf-8")
    assert not re.search(r"(?i)\bhalf [1-9]", page + for_team)
    assert all(f"inning {number}" in page.lower() for number in (1, 2))
    assert "inning 1, " in for_team


def test_in_a_super_team_each_team_has_the_log_of_its_robot(data: Path, source: SiteSource) -> None:
    match = next(match for match in Season(source).released if match.fixture.stage == "super")
    for side in match.fixture.sides:
        for number, team in enumerate(side.teams, 1):
            names = {one.name for one in (data / "for_teams" / team / match.slug).glob("*.log")}
            assert names == {f"{side.seat[0].upper()}{number}.log"}


def test_the_page_of_a_corrected_match_shows_the_correction_with_its_reason(site: Path, source: SiteSource) -> None:
    ruled = [match for match in Season(source).released if match.ruled]
    assert ruled
    for match in ruled:
        text = (site / "matches" / match.slug / "index.html").read_text("utf-8")
        assert "score corrected" in text
        assert "was not in goal" in text
    assert "was not in goal" in (site / "about.html").read_text("utf-8")


def test_places_of_a_table_in_which_nothing_was_played_are_not_shown(site: Path, source: SiteSource) -> None:
    (skills,) = [stage for stage in source.state.stages if stage.name == "skills"]
    assert [table.has_begun for table in skills.tables] == [True, False, True]
    assert "Shooting: <b>" in re.sub("</?bdi>", "", (site / "teams" / "ada.html").read_text("utf-8"))
    assert "Lidar: <b>" not in re.sub("</?bdi>", "", (site / "teams" / "ada.html").read_text("utf-8"))


def test_submissions_for_a_challenge_are_on_the_page_of_the_team_with_their_report(
    season: MadeUpSeason, tmp_path: Path
) -> None:
    source = season.source({})
    report = tmp_path / "report"
    report.mkdir()
    (report / "fast_shooter.html").write_text("a report", "utf-8")
    own = Submission("ada", "7" * 64, tmp_path / "lost.zip", NOW, "skills/shooting", report)
    submissions = (*source.played.submissions, own)
    publish(replace(source, played=replace(source.played, submissions=submissions)), tmp_path / "data")
    page = (tmp_path / "data" / "site" / "teams" / "ada.html").read_text("utf-8")
    assert all(digest in page for digest in ("a" * 64, "7" * 64))
    assert "Shooting" in page
    assert (tmp_path / "data" / "for_teams" / "ada" / "check" / ("7" * 12) / "fast_shooter.html").is_file()
    assert "ada" in (tmp_path / "data" / "organizer" / "similarity.html").read_text("utf-8")


def test_what_others_played_in_the_place_of_a_match_is_not_shown(season: MadeUpSeason) -> None:
    source = season.source(season.outcomes({"groups": 1}))
    name, match = next(iter(source.played.matches.items()))
    stranger = replace(match, submissions={"koi": "k" * 64, "zoe": "z" * 64})
    shown = Season(replace(source, played=replace(source.played, matches={name: stranger}))).matches[name]
    assert shown.outcome is not None
    assert shown.played is not None
    assert (shown.played.record, dict(shown.played.result)) == (None, {})


# --- what is released ------------------------------------------------------------------------------------------------


def test_a_result_is_hidden_until_its_release_and_with_a_premiere_until_that_is_over(season: MadeUpSeason) -> None:
    source = season.source(season.outcomes({"groups": 5}))
    fixtures = source.state.stages[0].fixtures[:1]
    releases = {fixtures[0].id: NOW}
    premiere = timedelta(seconds=2 * 500 * 0.032 + 30)

    def hidden(after: timedelta, premieres: tuple[str, ...] = ()) -> bool:
        return bool(hidden_fixtures(fixtures, source.played, releases, NOW + after, premieres))

    assert hidden(timedelta(seconds=-1))
    assert not hidden(timedelta())
    assert hidden(premiere - timedelta(seconds=1), ("groups",))
    assert not hidden(premiere, ("groups",))
    assert not hidden_fixtures(fixtures, source.played, {}, NOW)


def test_no_page_reveals_the_result_of_an_unreleased_match(season: MadeUpSeason, tmp_path: Path) -> None:
    outcomes = season.outcomes({"groups": 1})
    known = next(iter(outcomes))
    source = season.source(outcomes)
    shown = season.engine.state({one: outcome for one, outcome in outcomes.items() if one != known})
    publish(replace(source, state=shown, releases={known: NOW + timedelta(hours=1)}), tmp_path)
    season_of_site = Season(replace(source, state=shown))
    match = season_of_site.matches[known]
    assert match.outcome is None
    assert match.played is None
    assert not (tmp_path / "site" / "matches" / match.slug).exists()
    assert not any(match.slug in str(path) for path in (tmp_path / "for_teams").rglob("*"))
    played = {row.team: row.played for table in shown.stages[0].tables for row in table.rows}
    assert [played[team] for team in match.teams] == [0, 0]


def test_the_seed_is_hashed_before_the_end_and_shown_after_it(season: MadeUpSeason, tmp_path: Path) -> None:
    from rcj_challenges.tournament.seeds import seed_hash

    before = season.source(season.outcomes({"groups": 1}))
    publish(before, tmp_path)
    assert all(before.seed not in text for _, text in texts(tmp_path))
    assert seed_hash(before.seed) in (tmp_path / "site" / "about.html").read_text("utf-8")
    after = season.source(season.outcomes({"groups": 5, "finals": 9, "super": 9, "skills": 9}), recorded=False)
    publish(after, tmp_path)
    assert after.is_over
    about = (tmp_path / "site" / "about.html").read_text("utf-8")
    assert after.seed in about
    assert seed_hash(before.seed) in about


# --- schedule and feed -----------------------------------------------------------------------------------------------


def test_the_feed_has_the_newest_result_first_with_its_address(site: Path, source: SiteSource) -> None:
    feed = json.loads((site / "feed.json").read_text("utf-8"))
    assert feed["version"] == "https://jsonfeed.org/version/1.1"
    dates = [item["date_published"] for item in feed["items"]]
    assert dates == sorted(dates, reverse=True)
    for item in feed["items"]:
        assert (site / item["url"].removeprefix(source.url)).is_file()
    assert len({item["id"] for item in feed["items"]}) == len(feed["items"])


@pytest.fixture(scope="module")
def scheduled(season: MadeUpSeason) -> Season:
    source = season.source(season.outcomes({"groups": 1}))
    # The clocks of Berlin are put back in this night.
    first = datetime(2026, 10, 25, 0, 30, tzinfo=UTC)
    releases = {
        fixture.id: first + timedelta(hours=at) for at, fixture in enumerate(source.state.stages[0].fixtures[:12])
    }
    return Season(replace(source, releases=releases))


def test_times_of_the_table_are_local_and_in_utc(scheduled: Season) -> None:
    rows = list(csv.DictReader(io.StringIO(as_csv(scheduled, appointments(scheduled)))))
    assert [(row["time"], row["utc"][11:16]) for row in rows[:3]] == [
        ("02:30", "00:30"),
        ("02:30", "01:30"),
        ("03:30", "02:30"),
    ]
    assert {row["time_zone"] for row in rows} == {"Europe/Berlin"}


def test_no_name_is_a_formula_in_a_spreadsheet(scheduled: Season) -> None:
    rows = list(csv.reader(io.StringIO(as_csv(scheduled, appointments(scheduled)))))
    assert any("cmd|" in cell for row in rows for cell in row)
    assert not [cell for row in rows for cell in row if cell.startswith(("=", "+", "-", "@"))]


def test_the_calendar_keeps_to_its_format(scheduled: Season) -> None:
    source = scheduled.source
    heading = Heading(source.id, source.title, source.time_zone, source.now, source.url)
    text = as_ics(heading, appointments(scheduled))
    lines = text.split("\r\n")
    assert lines[0] == "BEGIN:VCALENDAR"
    assert lines[-2:] == ["END:VCALENDAR", ""]
    assert max(len(line.encode()) for line in lines) <= 75
    unfolded = text.replace("\r\n ", "")
    assert unfolded.count("BEGIN:VEVENT") == unfolded.count("END:VEVENT") == 12
    assert re.findall(r"DTSTART:(\S+)", unfolded)[:2] == ["20261025T003000Z", "20261025T013000Z"]
    for line in unfolded.split("\r\n"):
        if line.startswith("SUMMARY:"):
            assert not re.search(r"(?<!\\)[,;]", line.removeprefix("SUMMARY:"))


# --- again -----------------------------------------------------------------------------------------------------------


def published(season: MadeUpSeason, folder: Path, **rulings: Outcome) -> Published:
    return publish(season.source(season.outcomes({"groups": 1}) | rulings), folder)


def test_what_has_not_changed_is_taken_over(season: MadeUpSeason, tmp_path: Path) -> None:
    first = published(season, tmp_path)
    replay = next((tmp_path / "site").rglob("replay.html"))
    before = replay.stat().st_mtime_ns
    again = published(season, tmp_path)
    assert (first.reused, again.reused) == (0, again.matches)
    assert replay.stat().st_mtime_ns == before


def test_a_ruling_changes_the_page_of_its_match(season: MadeUpSeason, tmp_path: Path) -> None:
    published(season, tmp_path)
    fixture = next(iter(season.outcomes({"groups": 1})))
    again = published(season, tmp_path, **{fixture: Outcome((9.0, 0.0), Ruled.FORFEIT, "did not come")})
    assert again.reused == again.matches - 1
    text = (tmp_path / "site" / "matches" / fixture.replace("/", ".") / "index.html").read_text("utf-8")
    assert "did not come" in text
    assert "9 : 0" in text


def test_a_match_that_does_not_count_any_more_leaves_the_site(season: MadeUpSeason, tmp_path: Path) -> None:
    published(season, tmp_path)
    publish(season.source({}), tmp_path, may_shrink=True)
    assert not (tmp_path / "site" / "matches").exists()


def test_a_site_that_cannot_be_finished_leaves_the_old_one(
    season: MadeUpSeason, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    published(season, tmp_path)
    before = dict(texts(tmp_path / "site"))

    def full_disk(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("rcj_challenges.tournament.site.publishing.publish_teams", full_disk)
    with pytest.raises(OSError, match="No space"):
        publish(season.source({}), tmp_path, may_shrink=True)
    assert dict(texts(tmp_path / "site")) == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["for_teams", "organizer", "premieres", "site"]


def test_a_folder_with_something_else_in_it_is_not_replaced(season: MadeUpSeason, tmp_path: Path) -> None:
    (tmp_path / "site").mkdir()
    (tmp_path / "site" / "thesis.txt").write_text("years of work", "utf-8")
    with pytest.raises(DiagnosticError) as caught:
        published(season, tmp_path)
    assert [one.code for one in caught.value.diagnostics] == ["folder-in-the-way"]
    assert (tmp_path / "site" / "thesis.txt").read_text("utf-8") == "years of work"


def test_a_record_that_is_damaged_or_gone_leaves_the_result(season: MadeUpSeason, tmp_path: Path) -> None:
    source = season.source(season.outcomes({"groups": 1}))
    damaged = tmp_path / "damaged"
    damaged.mkdir()
    (damaged / "replay.html").write_bytes(b"\xff<html>cut off")
    (damaged / "stats.json").write_bytes(b"{")
    (damaged / "trajectory.chunks").write_bytes(b"PK")
    # What the store knows of a match whose result.json is damaged.
    summary = {
        "score": {"blue": 1, "yellow": 0},
        "digest": "0" * 64,
        "faults": [{"robot": "B1", "team": "blue", "kind": "crash"}],
    }
    played = {name: replace(match, record=damaged, summary=summary) for name, match in source.played.matches.items()}
    publish(replace(source, played=replace(source.played, matches=played)), tmp_path / "data")
    match = Season(source).released[0]
    folder = tmp_path / "data" / "site" / "matches" / match.slug
    assert sorted(one.name for one in folder.iterdir()) == ["index.html", "result.json"]
    assert " : ".join(match.scores) in (folder / "index.html").read_text("utf-8")


OVER = {"groups": 9, "finals": 9, "super": 9, "skills": 9}


def places_on(page: str) -> list[tuple[str, str]]:
    """Return place and team of each certificate of a page."""
    found = re.findall(
        r'<p class="team"><bdi>(.*?)</bdi>.*?<p class="place"><b>(.*?) place</b>( \(shared\))?', page, re.DOTALL
    )
    return [(place + shared, html.unescape(team)) for team, place, shared in found]


def test_the_podium_has_the_first_three_places_of_finals_that_have_finished(
    season: MadeUpSeason, tmp_path: Path
) -> None:
    source = season.source(season.outcomes(OVER | {"skills": 0}))
    publish(source, tmp_path)
    text = (tmp_path / "site" / "index.html").read_text("utf-8")
    assert text.count('<ol class="podium">') == 1, "only of the finals while others go on"
    finals = next(stage for stage in source.state.stages if stage.name == "finals")
    shown = re.findall(r'<li class="place-(\d)">.*?teams/(\w+)\.html', text, re.DOTALL)
    assert shown == [(str(row.place), row.team) for row in finals.places[:3]]


def test_each_team_of_a_finished_stage_has_a_certificate_and_a_shared_place_is_marked(
    season: MadeUpSeason, tmp_path: Path
) -> None:
    source = season.source(season.outcomes(OVER | {"finals": 0}))
    state = source.state
    stages = {stage.name: stage for stage in state.stages}
    shared = [replace(row, place=1, shared=True) if row.place == 2 else row for row in stages["skills"].places]
    skills = replace(stages["skills"], places=tuple(replace(row, shared=row.place == 1) for row in shared))
    publish(replace(source, state=replace(state, stages=(*state.stages[:-1], skills))), tmp_path)
    folder = tmp_path / "site" / "certificates"
    assert sorted(page.name for page in folder.iterdir()) == ["groups.html", "skills.html", "super.html"]
    found = {page.stem: places_on(page.read_text("utf-8")) for page in folder.iterdir()}
    names = Season(source)
    assert sorted(found["skills"]) == sorted(
        (f"{ordinal(row.place)}{' (shared)' if row.shared else ''}", names.name(row.team)) for row in skills.places
    )
    assert [len(found[name]) for name in ("groups", "super")] == [
        len(stages["groups"].teams),
        len(stages["super"].teams),
    ]


def test_a_match_that_a_lot_decided_shows_the_winner_on_its_page_and_its_card(
    season: MadeUpSeason, tmp_path: Path
) -> None:
    outcomes = season.outcomes({"groups": 5})
    final = next(one for one in season.engine.state(outcomes).open_fixtures() if one.stage == "finals")
    outcomes[final.id] = Outcome((1.0, 1.0))
    source = season.source(outcomes)
    publish(source, tmp_path)
    match = Season(source).matches[final.id]
    for path in (f"matches/{match.slug}/index.html", "stages/finals.html"):
        text = (tmp_path / "site" / path).read_text("utf-8")
        assert f"won by lot: <bdi>{html.escape(Season(source).name(match.lot_winner))}</bdi>" in text
    assert match.lot_winner in match.teams
