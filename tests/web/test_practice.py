"""Practice: a team tries its program against others without a rating."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from rcj_challenges.web import dispatcher, matchmaking, seasons
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.models import Basis, Entry, Job, JobState, Match, MatchKind, State, Submission
from rcj_challenges.web.tables import standings_of
from tests.checker.small_team import PLAYER
from tests.web.club import new_client
from tests.web.conftest import NOW
from tests.web.test_matches import accepted, begun

if TYPE_CHECKING:
    from django.test import Client


@pytest.fixture
def own(site: SiteConfig) -> Submission:
    """Return the program of a team in a season that has begun."""
    begun(site)
    return accepted(site, "Own")


def client_of(submission: Submission) -> Client:
    from rcj_challenges.web.accounts import give_card

    client = new_client()
    client.post("/enter", {"code": give_card(submission.team)})
    return client


def play(client: Client, against: Submission) -> int:
    return int(client.post("/my/practice/new", {"opponent": str(against.pk)}).status_code)


def test_match_against_a_sample_team_is_played_and_does_not_count(site: SiteConfig, own: Submission) -> None:
    client = client_of(own)
    sample = Submission.objects.get(via="sample", team__name="Ball Chaser")
    assert f'value="{sample.pk}"' in client.get("/my/practice").content.decode()
    assert play(client, sample) == 302
    assert dispatcher.Dispatcher(site, lambda: NOW).do_next()
    match = Match.objects.get()
    assert (match.kind, match.played_at, match.blue, match.yellow) == (MatchKind.PRACTICE, NOW, own, sample)
    assert Job.objects.get().team == own.team  # its lane time is that of the team
    assert standings_of(Basis.objects.get()).published.matches == []
    assert client.get(f"/matches/{match.pk}/replay").status_code == 200
    assert client.get(f"/matches/{match.pk}/log/B1").status_code in {200, 404}
    assert new_client().get(f"/matches/{match.pk}").status_code == 404


def test_sample_teams_of_other_scenarios_are_no_opponents(own: Submission) -> None:
    names = set(Submission.objects.filter(via="sample").values_list("team__name", flat=True))
    assert names == {"All Sensors", "Ball Chaser", "Roles and Radio"}  # other robots: match_2021, workshop


def test_both_teams_see_their_practice(site: SiteConfig, own: Submission) -> None:
    other = accepted(site, "Open", "# open\n" + PLAYER)
    clients = [client_of(own), client_of(other), client_of(accepted(site, "Third", "# third\n" + PLAYER))]
    clients[1].post("/my/practice/allow", {"allow": "yes"})
    assert play(clients[0], other) == 302
    Match.objects.update(played_at=NOW, blue_goals=2, yellow_goals=1)
    shown = [client.get("/my/practice").content.decode().count("2 : 1") for client in clients]
    assert shown == [1, 1, 0]


def test_opponents_are_samples_own_older_programs_and_teams_that_allow_it(site: SiteConfig, own: Submission) -> None:
    shy, open_ = accepted(site, "Shy", "# shy\n" + PLAYER), accepted(site, "Open", "# open\n" + PLAYER)
    older = Submission.objects.create(
        team=own.team, season=own.season, number=9, sha256=own.sha256, size_bytes=1, begun_at=NOW, received_at=NOW,
        via="page", state=State.ACCEPTED, digest="0" * 64,
    )  # fmt: skip
    rejected = Submission.objects.create(
        team=own.team, season=own.season, number=10, sha256="1" * 64, size_bytes=1, begun_at=NOW, received_at=NOW,
        via="page", state=State.REJECTED,
    )  # fmt: skip
    client = client_of(own)
    assert client_of(open_).post("/my/practice/allow", {"allow": "yes"}).status_code == 302
    assert [play(client, one) for one in (shy, rejected, own, older, open_)] == [409, 409, 409, 302, 302]
    assert client_of(open_).post("/my/practice/allow", {"allow": "no"}).status_code == 302
    assert play(client, open_) == 409
    assert client.post("/my/practice/new", {"opponent": "x"}).status_code == 409


def test_few_practice_matches_of_a_team_wait_at_a_time(own: Submission) -> None:
    client = client_of(own)
    samples = list(Submission.objects.filter(via="sample"))
    assert len(samples) >= 3
    assert [play(client, samples[0]) for _ in range(4)] == [302, 302, 302, 409]
    Match.objects.filter(number=1).update(played_at=NOW)
    Job.objects.filter(match__number=2).update(state=JobState.STUCK)  # our fault
    assert [play(client, samples[0]) for _ in range(3)] == [302, 302, 409]
    assert Match.objects.filter(number=5).exists()


def test_page_of_practice_loads_itself_again_only_while_a_match_waits(own: Submission) -> None:
    client = client_of(own)
    play(client, Submission.objects.filter(via="sample")[0])
    shown = client.get("/my/practice").content.decode()
    assert ('http-equiv="refresh"' in shown, shown.count("waiting</td>")) == (True, 1)
    Match.objects.update(void="a team was deleted")
    shown = client.get("/my/practice").content.decode()
    assert ('http-equiv="refresh"' in shown, shown.count("waiting"), shown.count("void</span>")) == (False, 0, 1)


def test_practice_goes_before_the_ladder_and_ends_with_the_season(site: SiteConfig, own: Submission) -> None:
    accepted(site, "Other", "# other\n" + PLAYER)
    (basis,) = Basis.objects.all()
    matchmaking.fill(1, NOW, [basis.pk])
    Job.objects.update(kind="ladder", priority=4)
    client = client_of(own)
    assert play(client, Submission.objects.filter(via="sample")[0]) == 302
    from rcj_challenges.web import jobs

    job = jobs.claim("one", NOW, bases=[basis.pk])
    assert job is not None
    assert job.kind == "practice"
    seasons.end(basis.season, NOW)
    assert play(client, Submission.objects.filter(via="sample")[0]) == 409
    assert client.get("/my/practice").status_code == 200


def test_sample_teams_are_in_no_table_and_a_team_that_hands_one_in_is(site: SiteConfig, own: Submission) -> None:
    basis = Basis.objects.get()
    sample = Submission.objects.filter(via="sample").first()
    assert sample is not None
    assert list(seasons.playing_now(basis.season)) == [own.digest]
    Submission.objects.filter(pk=own.pk).update(digest=sample.digest)
    assert list(seasons.playing_now(basis.season)) == [sample.digest]
    assert Entry.objects.count() == 1
