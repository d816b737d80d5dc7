"""What plays in an event is what was active at its deadline, and nothing that came later, whatever the clock says."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any
from zoneinfo import ZoneInfo

import pytest

from rcj_challenges.tournament.load import load_tournament
from rcj_challenges.tournament.seeds import seed_hash
from rcj_challenges.web import deadlines, events, jobs
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.models import Audit, Event, Job, JobState, Match, Season, State, Submission
from rcj_challenges.web.views.events import EventForm
from tests.checker.small_team import PLAYER
from tests.web.club import new_client
from tests.web.conftest import NOW, make_team, use_site
from tests.web.handing_in import hand_in
from tests.web.test_matches import accepted, add, begun
from tests.web.test_organizers import organizer

SECOND = timedelta(seconds=1)
COMPLETE = NOW + timedelta(minutes=3) + SECOND
"""Then no upload can come any more that began before the deadline."""
FORM = {
    "title": "Spring cup", "deadline": "2099-03-14T13:00", "first": "groups", "groups": 1, "rounds": 2, "finalists": 2,
    "seeds": 1, "premiere": "", "minutes_between": 0,
}  # fmt: skip


def make_event(deadline: datetime = NOW, **choices: Any) -> Event:
    """Make an event of the season of the site that this process works on."""
    given = {"title": "Cup", "deadline": deadline, "address": "http://club/", "finalists": 2, **choices}
    event = Event.objects.create(season=Season.objects.get(), **given)
    return Event.objects.get(pk=event.pk)


def check(submission: Any, now: datetime = NOW, state: State = State.ACCEPTED) -> None:
    """Store a verdict as a dispatcher does."""
    submission.refresh_from_db()
    with jobs.writing():
        deadlines.close(now)
        jobs.store_verdict(submission, jobs.Verdict(state, "passed", f"{submission.pk:064d}", {"level": "passed"}))


def frozen(now: datetime = COMPLETE) -> dict[int, str] | None:
    """Let the dispatcher look; return what plays by team, None if it is not fixed yet."""
    events.attend(now)
    event = Event.objects.get()
    if event.frozen_at is None:
        return None
    folder = events.event_folder(event)
    lines = [line.split("  ") for line in (folder / events.HASHES).read_text(encoding="utf-8").splitlines()]
    for sha256, path in lines:
        assert hashlib.sha256((folder / path).read_bytes()).hexdigest() == sha256
    assert {path for _, path in lines} == {f"frozen/{path.name}" for path in (folder / "frozen").iterdir()}
    return {int(Path(path).stem.removeprefix("team")): sha256 for sha256, path in lines}


def hash_of(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def test_what_plays_is_what_was_active_at_the_deadline_and_uploads_that_began_in_time(any_site: SiteConfig) -> None:
    one, other, third, fourth = (make_team(name)[0] for name in ("One", "Other", "Third", "Fourth"))
    event = make_event()
    check(hand_in(any_site, one, b"old"))
    check(hand_in(any_site, other, b"only"))
    rejected = hand_in(any_site, other, b"worse")
    slow = hand_in(any_site, one, b"slow", now=NOW + 90 * SECOND, begun_at=NOW)
    late = hand_in(any_site, one, b"late", now=NOW + SECOND, begun_at=NOW + 0.1 * SECOND)
    check(hand_in(any_site, fourth, b"late only", now=NOW + 2 * SECOND))
    assert (slow.late_for, late.late_for) == (None, event)
    check(late, NOW + 3 * SECOND)
    check(slow, NOW + 100 * SECOND)
    check(rejected, NOW + 100 * SECOND, State.REJECTED)
    assert frozen(NOW + 120 * SECOND) is None
    assert frozen() == {one.pk: hash_of(b"slow"), other.pk: hash_of(b"only")}
    assert third.pk not in frozen()
    check(hand_in(any_site, third, b"later", now=COMPLETE))
    assert third.pk not in frozen(COMPLETE + SECOND)


def test_freeze_waits_for_the_checks_of_what_was_in_time_and_late_uploads_do_not_replace_them(site: SiteConfig) -> None:
    team, _ = make_team()
    make_event()
    in_time, newer = hand_in(site, team, b"1"), hand_in(site, team, b"2")
    late = hand_in(site, team, b"late", now=NOW + SECOND)
    assert [Submission.objects.get(pk=one.pk).state for one in (in_time, newer, late)] == [
        State.SUPERSEDED, State.QUEUED, State.QUEUED,
    ]  # fmt: skip
    check(late, COMPLETE)
    assert frozen() is None
    check(newer, COMPLETE)
    assert frozen() == {team.pk: hash_of(b"2")}


def test_submission_that_cannot_be_checked_holds_the_freeze_up_until_an_organizer_decides(site: SiteConfig) -> None:
    team, _ = make_team()
    event = make_event()
    Submission.objects.filter(pk=hand_in(site, team, b"1").pk).update(state=State.UNCHECKED)
    check(hand_in(site, make_team("Other")[0], b"2"))
    assert frozen() is None
    client = organizer()
    assert b"no. 1" in client.get(f"/desk/events/{event.pk}").content
    assert client.post(f"/desk/events/{event.pk}/change", {"act": "freeze"}).status_code == 302
    assert list(frozen().values()) == [hash_of(b"2")]


def test_choice_of_the_team_counts_as_it_was_at_the_deadline(site: SiteConfig) -> None:
    team, code = make_team()
    make_event(deadline=datetime.now(UTC) - SECOND)
    first, second = hand_in(site, team, b"1"), hand_in(site, team, b"2")
    check(first, NOW)
    check(second, NOW)
    client = new_client()
    client.post("/enter", {"code": code})
    Event.objects.update(deadline=datetime.now(UTC) + timedelta(hours=1))
    assert client.post(f"/my/submissions/{first.pk}/activate").status_code == 302
    Event.objects.update(deadline=datetime.now(UTC) - SECOND)
    assert client.post(f"/my/submissions/{second.pk}/activate").status_code == 302
    assert frozen(datetime.now(UTC) + timedelta(minutes=4)) == {team.pk: hash_of(b"1")}


def test_clock_that_is_set_back_after_the_deadline_lets_nothing_more_in(any_site: SiteConfig) -> None:
    team, _ = make_team()
    event = make_event()
    check(hand_in(any_site, team, b"in time"))
    late = hand_in(any_site, team, b"late", now=NOW + SECOND)
    check(late, NOW + SECOND)
    back = NOW - timedelta(hours=1) + 2 * SECOND
    again = hand_in(any_site, team, b"after it was set back", now=back)
    assert (late.late_for, again.late_for) == (event, event)
    check(again, back)
    assert frozen(back) == {team.pk: hash_of(b"in time")}  # at once: the order of receipts cannot be trusted any more
    third = hand_in(any_site, team, b"before the deadline comes once more", now=NOW - SECOND)
    assert third.late_for == event
    check(third, NOW - SECOND)
    assert frozen() == {team.pk: hash_of(b"in time")}


def test_clock_that_is_set_back_before_the_deadline_changes_nothing(site: SiteConfig) -> None:
    team, _ = make_team()
    make_event(deadline=NOW + timedelta(minutes=1))
    check(hand_in(site, team, b"1"))
    later = hand_in(site, team, b"2", now=NOW - timedelta(hours=1))
    assert later.late_for is None
    check(later, NOW)
    assert frozen(NOW) is None
    assert frozen(COMPLETE + timedelta(minutes=1)) == {team.pk: hash_of(b"2")}


@pytest.mark.parametrize(
    ("local", "last"),
    [
        # The night in which 2:00 becomes 3:00, and that in which 3:00 becomes 2:00.
        ("2099-03-29T03:00", datetime(2099, 3, 29, 1, 0, tzinfo=UTC)),
        ("2099-10-25T03:00", datetime(2099, 10, 25, 2, 0, tzinfo=UTC)),
        ("2099-03-29T02:30", None),
        ("2099-10-25T02:30", None),
    ],
)
def test_deadline_is_one_moment_in_the_zone_of_the_site(
    folder: Callable[..., SiteConfig], local: str, last: datetime | None
) -> None:
    with use_site(folder(time_zone="Europe/Berlin")) as _:
        team, _ = make_team()
        answer = organizer().post("/desk/events/new", {**FORM, "deadline": local})
        assert answer.status_code == (400 if last is None else 302)
        if last is None:
            assert not Event.objects.exists()
            return
        event = Event.objects.get()
        assert event.deadline == last
        assert event.deadline.astimezone(ZoneInfo("Europe/Berlin")).strftime("%H:%M") == "03:00"
        site = events.current_site()
        check(hand_in(site, team, b"in time", now=last), last)
        assert hand_in(site, team, b"late", now=last + timedelta(microseconds=1000)).late_for == event


def test_seed_is_kept_secret_and_its_hash_shown_from_the_beginning(site: SiteConfig) -> None:
    make_team()
    client = organizer()
    assert client.post("/desk/events/new", FORM).status_code == 302
    event = Event.objects.get()
    assert event.seed_hash == seed_hash(event.seed)
    for address in ("/events", f"/events/{event.pk}", f"/desk/events/{event.pk}", "/desk", "/"):
        body = client.get(address).content.decode()
        assert event.seed not in body
        assert "Spring cup" in body
    assert event.seed_hash in new_client().get(f"/events/{event.pk}").content.decode()


@pytest.mark.parametrize(
    ("choices", "stages"),
    [
        ({"first": "groups", "groups": 2, "finalists": 2}, ["round_robin", "knock_out"]),
        ({"first": "swiss", "rounds": 3, "finalists": 4}, ["swiss", "knock_out"]),
        ({"first": "swiss", "rounds": 3, "finalists": 0}, ["swiss"]),
        ({"first": "finals"}, ["knock_out"]),
        ({"first": "challenge", "seeds": 3}, ["challenge"]),
    ],
)
def test_tournament_file_of_each_format_can_be_played(
    site: SiteConfig, choices: dict[str, Any], stages: list[str]
) -> None:
    teams = [make_team(f"Team: {number}, 'quoted'")[0] for number in range(6)]
    if choices["first"] == "challenge":
        Season.objects.update(scenario="fast_shooter", overrides=[])
    for team in teams:
        check(hand_in(site, team, f"{team.pk}".encode()))
    event = make_event(**choices, premiere=datetime(2026, 3, 15, 18, tzinfo=UTC), minutes_between=20)
    frozen()
    loaded = load_tournament(events.event_folder(event) / events.FILE)
    assert [one.stage for one in loaded.tournament.stages.values()] == stages
    assert list(loaded.tournament.stages.values())[-1].release == "2026-03-15 18:00"
    assert {team.name for team in loaded.teams().values()} == {f"Team {team.pk}" for team in teams}
    assert loaded.tournament.seed == event.seed


def test_pots_follow_the_ladder(site: SiteConfig) -> None:
    basis = begun(site)
    best, middle, worst = (accepted(site, name, f"# {name}\n{PLAYER}") for name in ("Best", "Middle", "Worst"))
    matches = add(basis, *[(best, middle), (best, worst), (middle, worst)] * 2)
    Match.objects.filter(pk__in=[one.pk for one in matches]).update(played_at=NOW, blue_goals=3, yellow_goals=0)
    without = make_team("New")[0]
    check(hand_in(site, without, b"new"))
    make_event(first="groups", groups=2)
    frozen()
    teams = load_tournament(events.event_folder(Event.objects.get()) / events.FILE).entries
    pots = [(best.team_id, 1), (middle.team_id, 1), (worst.team_id, 2), (without.pk, 0)]
    assert [(name, one.pot) for name, one in teams.items()] == [(f"team{team}", pot) for team, pot in pots]


def test_pots_are_of_what_plays_however_many_programs_the_ladder_has(site: SiteConfig) -> None:
    teams = [make_team(name)[0] for name in "ABCD"]
    for team in teams:
        check(hand_in(site, team, team.name.encode()))
    event = make_event(first="groups", groups=2)
    frozen()
    event.refresh_from_db()
    places = (91, 3, 900, 40)
    event.frozen = [(team, sha256, place) for (team, sha256, _), place in zip(event.frozen, places, strict=True)]
    events.write(event)
    found = load_tournament(events.event_folder(event) / events.FILE).entries
    order = [teams[1], teams[3], teams[0], teams[2]]
    assert [(name, one.pot) for name, one in found.items()] == [
        (f"team{team.pk}", pot) for team, pot in zip(order, (1, 1, 2, 2), strict=True)
    ]


@pytest.mark.parametrize("zone", ["Pacific/Auckland", "America/New_York"])
@pytest.mark.parametrize("wrong", ["0001-01-01T00:00", "0026-03-14T13:00", "2026-11-29T13:00", "9999-12-31T23:59"])
def test_time_that_has_passed_or_whose_year_was_mistyped_is_refused(
    folder: Callable[..., SiteConfig], zone: str, wrong: str
) -> None:
    with use_site(folder(time_zone=zone)):
        make_team()
        client = organizer()
        for name in ("deadline", "premiere"):
            assert client.post("/desk/events/new", {**FORM, name: wrong}).status_code == 400
        assert client.post("/desk/events/new", FORM).status_code == 302
        assert new_client().get("/calendar.ics").status_code == 200


def test_form_can_be_changed_until_the_matches_begin_and_the_deadline_until_it_has_passed(site: SiteConfig) -> None:
    for name in "ABCD":
        check(hand_in(site, make_team(name)[0], name.encode()))
    event = make_event(groups=3)
    client, address = organizer(), f"/desk/events/{event.pk}"
    frozen()
    assert b"too few" in client.get(address).content
    form = {**FORM, "groups": "2", "deadline": "2099-01-01T12:00"}
    assert client.post(address, {**form, "groups": "0"}).status_code == 400
    assert client.post(address, form).status_code == 302
    assert b"too few" not in client.get(address).content
    assert Event.objects.get().deadline == NOW
    (events.event_folder(event) / events.DATA).mkdir()
    assert client.post(address, {**form, "groups": "1"}).status_code == 409
    assert Event.objects.get().groups == 2


def test_page_of_a_form_that_is_refused_shows_the_event_as_it_is(site: SiteConfig) -> None:
    make_team()
    event = make_event(deadline=datetime(2099, 3, 14, 13, tzinfo=UTC))
    answer = organizer().post(f"/desk/events/{event.pk}", {**FORM, "groups": "0", "deadline": "2098-01-01T12:00"})
    page = answer.content.decode()
    assert answer.status_code == 400
    assert "<bdi>Cup</bdi>" in page
    assert "2099-03-14 13:00" in page


def test_deadline_that_passes_while_its_form_is_open_is_not_moved(
    site: SiteConfig, monkeypatch: pytest.MonkeyPatch
) -> None:
    make_team()
    event, client = make_event(deadline=datetime(2099, 3, 14, 13, tzinfo=UTC)), organizer()
    clean = EventForm.clean_title

    def passes(form: EventForm) -> str:
        Event.objects.update(closed_at=NOW)
        return clean(form)

    monkeypatch.setattr(EventForm, "clean_title", passes)
    assert client.post(f"/desk/events/{event.pk}", {**FORM, "deadline": "2099-05-05T12:00"}).status_code == 409
    assert Event.objects.get().title == "Cup"


def test_freeze_comes_at_the_deadline_at_the_earliest(site: SiteConfig) -> None:
    make_team()
    event, client = make_event(deadline=datetime(2099, 3, 14, 13, tzinfo=UTC)), organizer()
    assert client.post(f"/desk/events/{event.pk}/change", {"act": "freeze"}).status_code == 409
    assert not Audit.objects.exists()


def test_event_is_deleted_while_it_has_not_been_played(site: SiteConfig) -> None:
    team, _ = make_team()
    check(hand_in(site, team, b"in time"))
    event = make_event()
    late = hand_in(site, team, b"late", now=NOW + SECOND)
    frozen()
    client, folder, change = organizer(), events.event_folder(event), f"/desk/events/{event.pk}/change"
    gone = {"act": "delete", "confirm": "Cup"}
    assert client.post(change, {**gone, "confirm": "cup"}).status_code == 409
    (folder / events.DATA).mkdir()
    assert client.post(change, gone).status_code == 409
    (folder / events.DATA).rmdir()
    client.post(change, {"act": "play"})
    assert client.post(change, gone).status_code == 409
    assert not events.delete(event)  # as it was before somebody else had it played
    client.post(change, {"act": "pause"})
    assert client.post(change, gone).status_code == 302
    late.refresh_from_db()
    assert (Event.objects.count(), folder.exists(), late.late_for) == (0, False, None)


def test_title_of_an_event_can_be_typed_as_it_is_seen(site: SiteConfig) -> None:
    make_team()
    client = organizer()
    client.post("/desk/events/new", {**FORM, "title": "Spring  \t cup"})
    gone = {"act": "delete", "confirm": "Spring cup"}
    assert client.post(f"/desk/events/{Event.objects.get().pk}/change", gone).status_code == 302


def test_format_that_the_scenario_does_not_have_is_refused(site: SiteConfig) -> None:
    make_team()
    assert organizer().post("/desk/events/new", {**FORM, "first": "challenge"}).status_code == 400


@pytest.mark.parametrize("premiere", [None, NOW])
def test_number_of_matches_is_not_shown_before_a_premiere_as_extra_time_is_one(
    site: SiteConfig, premiere: datetime | None
) -> None:
    make_team()
    event = make_event(premiere=premiere)
    with jobs.writing():
        jobs.enqueue("event", event, NOW)
    Job.objects.update(state=JobState.RUNNING, progress="11/12")
    assert (b"11/12" in new_client().get(f"/events/{event.pk}").content) == (not premiere)
    assert b"11/12" in organizer().get("/desk").content


def test_folder_of_a_freeze_that_was_cut_off_is_written_later(
    site: SiteConfig, monkeypatch: pytest.MonkeyPatch
) -> None:
    check(hand_in(site, make_team()[0], b"1"))
    make_event()

    def die(_: Event) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as cut_off:
        cut_off.setattr(events, "write", die)
        with pytest.raises(KeyboardInterrupt):
            events.attend(COMPLETE)
    assert organizer().get(f"/desk/events/{Event.objects.get().pk}").status_code == 200
    assert list(frozen().values()) == [hash_of(b"1")]


def test_receipt_that_waited_for_its_turn_while_the_deadline_passed_is_in_time(site: SiteConfig) -> None:
    team, _ = make_team()
    make_event()
    events.attend(NOW + 2 * SECOND)
    assert hand_in(site, team, b"x", now=NOW + SECOND, begun_at=NOW - SECOND).late_for is None
